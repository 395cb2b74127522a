/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the scanner cannot read in, the message about it and the parser's error token out. */
#include "lang/scanner.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/syntax.h"
#include "lang/page/words.h"

/* `1st`, `21st`, `4th`; not `3st`, of which `Row 1: k 3st` has stitches. */
static bool is_ordinal(const char *text)
{
    int n = words_number(text);

    return words_ordinal_length(text) && (n % 10 == 1 && n % 100 != 11) == words_is(text + strspn(text, "0123456789"), "st");
}

int scanner_bad_unit(struct scanner *scanner, struct span span, const char *text)
{
    int digits = (int)strspn(text, "0123456789.");

    span.start += (unsigned)digits;
    diag_error(scanner->parse->diag, CODE_NUMBER, span, "'%s' is no unit", text + digits);
    if (is_ordinal(text))
        diag_hint(scanner->parse->diag, "a row begins its line: `%s row: k2, p2`; rows are repeated by `Repeat rows 1-2 3 times`", text);
    else if (words_are(text + digits, WORDS_STITCH | WORDS_ROW))
        diag_hint(scanner->parse->diag, "stitches and rows are counted without a unit: `%.*s`", digits, text);
    else
        diag_hint(scanner->parse->diag, "units are %%, mm, cm, m and in; a product is written with '*'");
    return TOKEN_KNIT_error;
}

int scanner_fraction(struct scanner *scanner, struct span span, const char *text)
{
    diag_error(scanner->parse->diag, CODE_WHOLE, span, "a whole number is needed here, not %s", text);
    return TOKEN_KNIT_error;
}

bool scanner_is_lettered(const struct scanner *scanner, const char *word)
{
    return scanner->statement == TOKEN_ROW && scanner->previous == TOKEN_NUMBER && isalpha((unsigned char)*word) && !word[1] && *SCANNER_TEXT(scanner) == ':';
}

bool scanner_is_scanned(const struct scanner *scanner, const char *word)
{
    return scanner->statement == TOKEN_ROW && scanner->previous == TOKEN_ROW && strchr("lIO", *word) && !word[1];
}

int scanner_lettered(struct scanner *scanner, struct span span)
{
    diag_error(scanner->parse->diag, CODE_ROW_NUMBER, span, "a row's number has no letter");
    diag_hint(scanner->parse->diag, "number all rows in the order they are worked: `Row 1`, `Row 2` ..");
    return TOKEN_KNIT_error;
}

int scanner_scanned(struct scanner *scanner, struct span span)
{
    char c = span.source->text[span.start], figure = strchr("oO", c) ? '0' : '1';

    diag_error(scanner->parse->diag, CODE_SYNTAX, span, "expected a number, found the letter '%c'", c);
    diag_hint(scanner->parse->diag, "in a scanned text the letter %c may stand for %c", c, figure);
    return TOKEN_KNIT_error;
}

int scanner_needle(struct scanner *scanner, struct span span)
{
    diag_error(scanner->parse->diag, CODE_SYNTAX, span, "whether a needle is a row, or a part of a round, is not said");
    diag_hint(scanner->parse->diag, "`Row 1: ...` for each needle; or `Rnd 1: ...` with the stitches of all needles");
    return TOKEN_KNIT_error;
}

int scanner_no_stitches(struct scanner *scanner, struct span span, const char *word)
{
    if (scanner->previous == TOKEN_NUMBER && !word[1] && strchr("oOlI", *word))
        return scanner_scanned(scanner, span);
    if (words_is(word, "pegs") && (scanner->parse->facts.pegs || scanner->parse->facts.rounds))
        return scanner_token(scanner, TOKEN_STS);
    if (!words_is(word, "needles") && !words_is(word, "pegs"))
        return syntax_unknown_word(scanner->parse, span, "a number of sts");
    diag_error(scanner->parse->diag, CODE_ELSEWHERE, span, "a machine knits every row from one side, and here the sides take turns");
    diag_hint(scanner->parse->diag, "`Cast on 40 sts`; what `knit 20 rows` makes on a machine is `Work 20 rows in st st`");
    return TOKEN_KNIT_error;
}

int scanner_open_string(struct scanner *scanner, struct span span)
{
    diag_error(scanner->parse->diag, CODE_STRING, span, "this text has no closing quote on its line");
    return TOKEN_KNIT_error;
}

size_t scanner_strange_length(const struct scanner *scanner, const char *text)
{
    size_t n = 0;

    while (scanner->complained && ((unsigned char)text[n] >= 0x80 || (n > 0 && text[n] == ' ')))
        n++;
    return n ? n : 1;
}

/* One complaint per line: what follows a strange character is often strange too. */
int scanner_character(struct scanner *scanner, struct span span)
{
    struct diag *diag = scanner->parse->diag;
    const struct source *source = span.source;
    unsigned char c = (unsigned char)source->text[span.start];

    if (c >= 0xC0)
        while (span.end < source->size && ((unsigned char)source->text[span.end] & 0xC0) == 0x80)
            span.end++;
    if (scanner->complained)
        return TOKEN_KNIT_error;
    scanner->complained = true;
    if (c < 0x20 || c == 0x7F || (c >= 0x80 && span.end == span.start + 1))
        diag_error(diag, CODE_CHARACTER, span, "the byte 0x%02X is no character of a script", c);
    else
        diag_error(diag, CODE_CHARACTER, span, "the character '%.*s' has no meaning here",
                   (int)(span.end - span.start), source->text + span.start);
    return TOKEN_KNIT_error;
}

int scanner_size_list(struct scanner *scanner, struct span span)
{
    if (scanner->previous == TOKEN_CAST_ON) {
        diag_error(scanner->parse->diag, CODE_RANGE, span, "a cast-on is a positive count of stitches");
        return TOKEN_KNIT_error;
    }
    diag_error(scanner->parse->diag, CODE_MANY_SIZES, span, "the numbers of several sizes: which is to be knitted is open");
    diag_hint(scanner->parse->diag, "keep the number of one size");
    return TOKEN_KNIT_error;
}

bool scanner_sizes(struct scanner *scanner, struct span bracket)
{
    const char *text = scanner->parse->text + bracket.start, *behind;
    unsigned at = bracket.start;
    int n;
    size_t length = strchr("([", *text) ? prose_sizes_length(text, &n) : 0;

    while (at > 0 && scanner->parse->text[at - 1] == ' ')
        at--;
    if (!length || at == 0 || !isdigit((unsigned char)scanner->parse->text[at - 1]))
        return false;

    /* One number alone may be the row's count, which ends it. */
    behind = text + length + strspn(text + length, " \t");
    if (n == 1 && !isalnum((unsigned char)*behind) && *behind != ',')
        return false;
    bracket.end = bracket.start + (unsigned)length;
    diag_error(scanner->parse->diag, CODE_MANY_SIZES, bracket, "the numbers of several sizes: which is to be knitted is open");
    diag_hint(scanner->parse->diag, "keep the number of one size, and leave the brackets out");
    return true;
}
