/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a printed book in, what stands for it plainly out: `_Second row._--The same.`
 * is `2nd row: as 1`. */
#include "lang/page/printed.h"

#include <stdio.h>

#include "lang/page/printed_parts.h"

enum { LABEL = 40, MARKED = 200 };

/* ---- marks of a typed book ---- */

static bool opens_italics(const char *text, size_t at)
{
    return text[at] == '_' && (at == 0 || !(isalnum((unsigned char)text[at - 1]) || strchr("_}\"", text[at - 1]))) && isalnum((unsigned char)text[at + 1]);
}

static bool closes_italics(const char *text, size_t at)
{
    return text[at] == '_' && at > 0 && (isalnum((unsigned char)text[at - 1]) || strchr(".,:;)", text[at - 1])) && !isalnum((unsigned char)text[at + 1]) && text[at + 1] != '_';
}

/* Whether the underscores that stand here mark several words, or one with its stop: a name has neither. */
static bool marks_words(const char *text, size_t open, size_t close)
{
    return close > open + 1 && close - open < MARKED && (memchr(text + open, ' ', close - open) || strchr(".,:;", text[close - 1]));
}

static bool is_italics(const char *text, size_t at)
{
    size_t other = at;

    if (opens_italics(text, at)) {
        for (other++; text[other] && other - at < MARKED && !closes_italics(text, other) && !opens_italics(text, other);)
            other++;
        return closes_italics(text, other) && marks_words(text, at, other);
    }
    if (!closes_italics(text, at))
        return false;
    for (other--; other > 0 && at - other < MARKED && !opens_italics(text, other) && !closes_italics(text, other);)
        other--;
    return opens_italics(text, other) && marks_words(text, other, at);
}

/* `=1st row.=--Plain` at the beginning of a line. */
static bool is_bold(const char *text, size_t at)
{
    size_t line = print_line_start(text, at), close = line + 1;

    if (text[line] != '=' || !isalpha((unsigned char)text[line + 1]))
        return false;
    close += strcspn(text + close, "=\r\n");
    return text[close] == '=' && text[close + 1] != '=' && text[close - 1] != ' ' && !print_sentence_ends(text + close + 1) && (at == line || at == close);
}

/* `[Illustration: ..]`, `[Pg 12]` */
static size_t note_length(const char *text)
{
    static const char *const word[] = {"illustration", "pg", "page", "footnote", "transcriber"};
    size_t close = 1;

    if (words_find(text + 1, word, sizeof word / sizeof *word) < 0)
        return 0;
    while (close < MARKED && text[close] && !strchr("]={}", text[close]))
        close++;
    if (text[close] != ']')
        return 0;
    return words_length(text + 1) > 4 || isdigit((unsigned char)text[1 + words_length(text + 1) + 1]) ? close + 1 : 0;
}

size_t printed_mark(const char *text, size_t at)
{
    switch (text[at]) {
    case '_':
        return is_italics(text, at);
    case '=':
        return is_bold(text, at);
    case '[':
        return note_length(text + at);
    default:
        return 0;
    }
}

/* ---- full stops and dashes ---- */

/* Whether a figure follows that counts stitches: `K. 2`, `P.1`; not `K. 2nd row`, nor `K. 2. P.` of a numbered list. */
static bool counts_stitches(const char *text)
{
    size_t at = print_blanks(text), n = strspn(text + at, "0123456789");
    int number;

    if (!n || print_ordinal_length(text + at, &number))
        return false;
    at += n;
    if (text[at] != '.' || !strchr("kKpP", text[at + 1 + print_blanks(text + at + 1)]))
        return true;
    at += 2 + print_blanks(text + at + 1);
    at += text[at] == '.';
    return isalnum((unsigned char)text[at + print_blanks(text + at)]);
}

/* Whether a label of a few words ends here, or a row's head: the dash behind it is its colon. */
static bool is_label(const char *text, size_t at)
{
    size_t line = print_line_start(text, at), words = 0;

    if (words_are_rows(text + print_word_before(text, at)) && print_word_before(text, at) < at)
        return true;
    for (size_t i = line; i < at; i++) {
        words += isalpha((unsigned char)text[i]) && print_begins_word(text, i);
        if (strchr(",:;*", text[i]) || print_dash_length(text + i))
            return false;
    }
    return words > 0 && words < 5 && at - line < LABEL;
}

static bool has_figure(const char *text, size_t from, size_t to)
{
    while (from < to && !isdigit((unsigned char)text[from]))
        from++;
    return from < to;
}

/* Whether the head of a row follows: ` 6th and 7th rows--`. */
static bool row_follows(const char *text)
{
    text += print_blanks(text);
    return print_rows_length(text) && print_head_ends(text + print_rows_length(text));
}

/* A full stop and what goes with it. */
static size_t stop_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    static const char *const no[] = {"no", "nos"}, *const referring[] = {"rep", "as", "work", "then", "from", "and", "patt"};
    size_t word = print_word_before(text, at), dash = print_dash_length(text + at + 1), behind = at + 1 + print_blanks(text + at + 1);
    bool letter = word + 1 == at && print_begins_word(text, word) && strchr("kKpP", text[word]);

    if (text[at + 1] == ')')
        return 1;
    dash += !dash && text[at + 1] == '-' && words_are_rows(text + word);
    if (letter && counts_stitches(text + at + 1))
        return 1;
    if (dash) {
        strcpy(plain, is_label(text, at) ? ":" : ".");
        return 1 + dash;
    }
    if (words_find(text + word, no, 2) >= 0 && isdigit((unsigned char)text[behind]))
        return 1;
    if (behind > at + 1 && row_follows(text + behind) && words_find(text + word, referring, 7) < 0) {
        strcpy(plain, "\n");
        return 1;
    }
    if (print_cast_on_follows(text + at + 1) && is_label(text, at) && !has_figure(text, print_line_start(text, at), at)) {
        strcpy(plain, "\n");
        return 1;
    }
    return 0;
}

/* `:--`, `:-`, a printer's colon. */
static size_t colon_length(const char *text)
{
    size_t dash = print_dash_length(text + 1);

    dash += !dash && text[1] == '-' && strchr(" \t\r\n", text[2]);
    return dash ? 1 + dash : 0;
}

/* `, then` that ends a line. */
static size_t then_length(const char *text)
{
    size_t at = 1 + print_blanks(text + 1);
    const char *behind = text + at + 4;

    if (!words_is(text + at, "then"))
        return 0;
    behind += print_blanks(behind);
    behind += *behind == ':';
    return !*behind || strchr("\r\n", *behind) ? (size_t)(behind - text) : 0;
}

/* `First row`: `1st row`. */
static size_t in_figures(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const ends[] = {"th", "st", "nd", "rd"};
    int number;
    size_t length = strchr("fstenlFSTENI", *text) && print_rows_length(text) ? print_letters_length(text, &number) : 0;

    if (length)
        snprintf(plain, PRINTED_PLAIN, "%d%s", number, ends[number % 10 < 4 && number / 10 != 1 ? number % 10 : 0]);
    return length;
}

/* `of the pattern` within a row's head, `Row 1 of pattern--`. */
static size_t of_pattern_length(const char *text, size_t at)
{
    static const char *const pattern[] = {"pattern", "patt", "pat"};
    size_t number = at, n = at + 2 + print_blanks(text + at + 2);

    while (number > 0 && strchr(" 0123456789-", text[number - 1]))
        number--;
    n += words_is(text + n, "the") ? 3 + print_blanks(text + n + 3) : 0;
    if (!words_row(text + print_word_before(text, number)) || words_find(text + n, pattern, 3) < 0)
        return 0;
    n += words_length(text + n);
    return print_head_ends(text + n) ? n - at : 0;
}

size_t printed_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    const char *here = text + at;
    size_t length;

    *plain = '\0';
    if (*here == '.')
        return at > 0 ? stop_length(text, at, plain) : 0;
    if (*here == '(' && (length = print_sample_length(text, at))) {
        strcpy(plain, "\n");
        return length;
    }
    if (*here == ',' && then_length(here))
        return then_length(here);
    if (*here == ';' && row_follows(here + 1)) {
        strcpy(plain, "\n");
        return 1;
    }
    if (*here == ':' && colon_length(here)) {
        strcpy(plain, ":");
        return colon_length(here);
    }
    if (!isalnum((unsigned char)*here) || !print_begins_word(text, at))
        return 0;
    if (words_is(here, "of"))
        return of_pattern_length(text, at);
    length = print_word_length(text, at, plain);
    return length || isdigit((unsigned char)*here) ? length : in_figures(here, plain);
}
