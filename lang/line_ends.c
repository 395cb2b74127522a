/* SPDX-License-Identifier: GPL-3.0-or-later
 * The end of a line in; out, whether the statement goes on behind it. */
#include "lang/scanner.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/page_chart.h"
#include "lang/page/prose.h"
#include "lang/page/repeats.h"
#include "lang/syntax.h"
#include "lang/page/words.h"

/* Whether a statement begins here: one of its words and behind it what may follow one. */
static bool statement_follows(const struct scanner *scanner, const char *text)
{
    static const char *const rows[] = {"row",    "rows", "rnd",   "rnds", "round",
                                       "rounds", "the",  "these", "this", "last"};
    size_t length = words_name_length(text);
    const char *behind = text + length + strspn(text + length, " \t");

    if (!length)
        return false;
    if (words_is_name(text, "rep") || words_is_name(text, "repeat")) {
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
            if (words_is_name(behind, rows[i]))
                return true;
        return false;
    }
    /* `k2,` and on the next line `knit 2`. */
    if (scanner->comma && words_is_name(text, "knit"))
        return false;
    /* `1` and on the next line `stitch before marker`. */
    if (words_is_name(text, "stitch") && prose_is_keyword(text))
        return false;
    for (int i = 0; i < nstatement_words; i++)
        if (words_is_name(text, statement_word[i]))
            return isalnum((unsigned char)*behind) || strchr("\"{:(", *behind);
    return false;
}

/* The same behind the mark of a list: `- Row 2: k4`. */
static bool item_follows(const struct scanner *scanner, const char *text)
{
    static const char *const marks[] = {"- ", "* ", "\xE2\x80\xA2 ", "\xC2\xB7 ", "\xE2\x80\x93 "};

    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (strncmp(text, marks[i], strlen(marks[i])) == 0)
            return words_row(text + strlen(marks[i])) && statement_follows(scanner, text + strlen(marks[i]));
    return false;
}

/* A token after which an expression must go on. */
static bool goes_on(int token)
{
    static const int open_ended[] = {
        '=',
        ',',
        ':',
        '?',
        '+',
        '-',
        '*',
        '/',
        '<',
        '>',
        '!',
        TOKEN_IN,
        TOKEN_BY,
        TOKEN_MOD,
        TOKEN_DOTS,
        TOKEN_LESS_EQUAL,
        TOKEN_GREATER_EQUAL,
        TOKEN_EQUAL,
        TOKEN_UNEQUAL,
        TOKEN_AND_AND,
        TOKEN_OR_OR,
    };

    for (size_t i = 0; i < sizeof open_ended / sizeof *open_ended; i++)
        if (token == open_ended[i])
            return true;
    return false;
}

/* What ends a row, behind `end`: `k1`, `with k1`; not `heart`. */
static bool ends_row(const char *text)
{
    static const char *const words[] = {"with", "in", "last", "after", "on", "knit", "purl", "row", "rnd", "round", "rep", "repeat"};

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words_is_name(text, words[i]))
            return true;
    return syntax_is_row(text);
}

/* `2, knit 2` behind `purl` at a line's end; not `2. Knit 3` of a numbered list. */
static bool is_count(const char *text)
{
    size_t digits = strspn(text, "0123456789");
    const char *behind = text + digits + strspn(text + digits, " \t");

    return digits && (*behind == ',' || *behind == ';' || (behind > text + digits && words_are_stitches(behind)));
}

/* Where a row goes on to, behind `to`: `end`, `last 2 sts`; not `knit flat`. */
static bool goes_to(const char *text)
{
    static const char *const words[] = {"the", "end", "last", "within", "marker", "m", "next"};

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words_is_name(text, words[i]))
            return true;
    return isdigit((unsigned char)*text) || strchr("{*", *text);
}

/* `Repeat B:` above rows. */
static bool ends_in_colon(const char *text)
{
    return words_sign_before(text, words_line_length(text), " \t") == ':' && !words_line_has_sign(text, "*");
}

/* In a row: after a comma, an open star or a colon, and before `rep from`. */
static bool row_goes_on(const struct scanner *scanner, const char *text)
{
    static const char *const words[] = {"st", "sts", "stitch", "stitches", "across", "last", "from"};
    size_t length = words_name_length(text);

    /* `rep from *`, `rep to end`; not `repeat for pattern`, `rep 1st and 2nd rows`. */
    if (words_is_name(text, "rep") || words_is_name(text, "repeat"))
        return !prose_repeats_rows(text + length) && !ends_in_colon(text) && !(scanner_row_is_full(scanner) && repeats_so_often(words_next(text)));
    if (words_is_name(text, "end") || words_is_name(text, "ending"))
        return ends_row(text + length + strspn(text + length, " \t"));
    if (words_is_name(text, "to"))
        return goes_to(text + length + strspn(text + length, " \t"));
    if (words_is_name(text, "last") && prose_rows_follow(text + length + strspn(text + length, " \t")))
        return false;   /* `Last 2 rows form the pattern` */
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words_is_name(text, words[i]))
            return !prose_fabric_follows(text + length + strspn(text + length, " \t"));
    /* `*(k1, p1)` and on the next line `x 2; rep from *`. */
    if (scanner->star && tolower((unsigned char)*text) == 'x' && isdigit((unsigned char)*words_skip_blanks(text + 1)))
        return true;
    if (scanner->comma && !scanner->star && (words_are(text, WORDS_BIND | WORDS_CAST) || (words_are(text, WORDS_PLAIN | WORDS_WORK) && prose_rows_follow(words_next(text)))))
        return false;   /* a comma at the row's end */
    return scanner->comma || ((scanner->star || scanner->stops) && syntax_is_row(text)) || scanner->previous == ':' ||
           (!scanner->bare && scanner_in_row_head(scanner) && prose_row_line(text)) || scanner->previous == TOKEN_TO_LAST || scanner->previous == TOKEN_UNTIL ||
           (scanner->previous == TOKEN_NAME && is_count(text));
}

bool scanner_ends_line(struct scanner *scanner, bool in_row, bool in_expression)
{
    const char *next = SCANNER_TEXT(scanner);

    if (!*next || scanner_stars(scanner, next) || item_follows(scanner, next) || page_chart_line(scanner->parse->chart, scanner->at).source || (statement_follows(scanner, next) && !(in_row && scanner_in_row_head(scanner) && prose_row_line(next))))
        return true;
    if (scanner_in_bracket(scanner))
        return false;
    if (in_row)
        return *next == '}' || !row_goes_on(scanner, next);
    if (scanner->previous == '}' && words_is_name(next, "else"))
        return false;
    if (*next == '{')
        return false;
    if (!scanner->statement)
        return true;
    return !goes_on(scanner->previous) && !(in_expression ? strchr("?:*/+-&|<>=", *next) != NULL : *next == '=');
}

bool scanner_is_repeat(const struct scanner *scanner)
{
    return scanner->statement == TOKEN_REPEAT_ROWS || scanner->statement == TOKEN_REPEAT_LAST || scanner->statement == TOKEN_REPEAT_THEM ||
           scanner->statement == TOKEN_REPEAT_ALL || scanner->statement == TOKEN_REPEAT_STARRED;
}

bool scanner_repeats_several(const struct scanner *scanner)
{
    const char *text = scanner->parse->text;
    size_t at = scanner->token_end;

    if (scanner->previous == TOKEN_ROW_WORD)
        return scanner->statement == TOKEN_REPEAT_LAST;
    if (scanner->previous != TOKEN_NUMBER || scanner->statement != TOKEN_REPEAT_ROWS)
        return false;
    while (at > 0 && (isdigit((unsigned char)text[at - 1]) || text[at - 1] == ' '))
        at--;
    return at > 0 && (strchr("-&", text[at - 1]) || words_is(text + words_before(text, at), "and"));
}

bool scanner_said_how_often(const struct scanner *scanner)
{
    static const int last[] = {TOKEN_TIMES, TOKEN_TWICE, TOKEN_MORE, TOKEN_TOTAL, TOKEN_ROW_WORD};

    for (size_t i = 0; i < sizeof last / sizeof *last; i++)
        if (scanner->previous == last[i])
            return scanner->statement != TOKEN_ROW && scanner->statement != TOKEN_NEXT_ROWS;
    return false;
}

bool scanner_repeat_goes_on(const struct scanner *scanner)
{
    static const char *const words[] = {"until", "till", "for"};
    const char *text = SCANNER_TEXT(scanner);

    if (!scanner_is_repeat(scanner) || (scanner->previous != TOKEN_NUMBER && scanner->previous != TOKEN_ROW_WORD && scanner->previous != scanner->statement))
        return false;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words_is_name(text, words[i]))
            return true;
    return prose_times_follow(text);
}
