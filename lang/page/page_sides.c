/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the side that its sentences give to row 1 out. */
#include "lang/page/page_sides.h"

#include <stdlib.h>

#include "lang/page/words.h"

#define SKIP(text, words) skip_any(text, words, sizeof words / sizeof *words)

enum parity { PARITY_NONE, PARITY_EVEN, PARITY_ODD };

static const char *skip_blanks(const char *text)
{
    return text + strspn(text, " \t-(");
}

enum { MOST = 4 };      /* words of a kind that follow each other */

/* Behind those of some words that come next. */
static const char *skip_any(const char *text, const char *const *word, int n)
{
    for (int i = 0; i < MOST && words_find(text, word, n) >= 0; i++)
        text = skip_blanks(text + words_length(text));
    return text;
}

/* `the right side`, `a WS row`, `RS`: which, and what stands behind it; open: none. */
static enum side side_at(const char **text)
{
    static const char *const article[] = {"the", "a", "an", "on", "from", "worked", "always", "first"}, *const sides[] = {"rs", "right", "ws", "wrong"}, *const row[] = {"row", "rows"};
    const char *at = SKIP(*text, article), *word;
    int side;

    at += strncasecmp(at, "1st ", 4) == 0 ? 4 : 0;
    word = skip_blanks(at + words_length(at));
    side = words_find(at, sides, 4);

    if (side < 0 || (side % 2 && !words_is(word, "side")))
        return SIDE_OPEN;
    if (side % 2)
        word = skip_blanks(word + words_length(word));
    *text = SKIP(word, row);
    return side < 2 ? SIDE_RS : SIDE_WS;
}

/* `row 2`, `1st row`, `the even-numbered rows`, `first row`; behind `RS rows are` `even` is enough. */
static enum parity rows_at(const char **text, bool short_form)
{
    static const char *const article[] = {"the", "all", "on"}, *const which[] = {"even", "odd", "second", "first"}, *const numbered[] = {"numbered"}, *const row[] = {"row", "rows"};
    const char *at = SKIP(*text, article), *behind = at;
    size_t ordinal = words_ordinal_length(at);
    int word = words_find(at, which, 4), number = 0;

    if (word >= 0) {
        behind = skip_blanks(at + words_length(at));
        behind = SKIP(behind, numbered);
        at = behind;
    }
    if (ordinal) {
        number = words_number(at);
        at = skip_blanks(at + ordinal);
    }
    if (words_find(at, row, 2) >= 0)
        behind = skip_blanks(at + words_length(at));
    else if (word < 0 || !short_form)
        return PARITY_NONE;
    if (word < 0 && !ordinal) {
        number = words_number(behind);
        behind = skip_blanks(behind + (isdigit((unsigned char)*behind) ? strspn(behind, "0123456789") : number ? words_length(behind) : 0));
    }
    *text = behind;
    return word >= 0 ? (word % 2 ? PARITY_ODD : PARITY_EVEN) : number > 0 ? (number % 2 ? PARITY_ODD : PARITY_EVEN) : PARITY_NONE;
}

/* Behind `is`, `are`, `=`, `form`, `facing for`; NULL: none. */
static const char *behind_verb(const char *text)
{
    static const char *const verb[] = {"is", "are", "being", "be", "form", "forms", "make", "will", "facing", "for"};

    if (*text == '=')
        return skip_blanks(text + 1);
    return words_find(text, verb, sizeof verb / sizeof *verb) >= 0 ? SKIP(text, verb) : NULL;
}

/* `Start on the wrong side.`, `Work the 1st row from WS`: no more of a sentence stands behind it. */
static enum side start_at(const char *text)
{
    static const char *const begin[] = {"start", "starts", "starting", "begin", "begins", "beginning", "beg"}, *const with[] = {"on", "with"};
    const char *at = SKIP(text, begin), *behind = SKIP(at, with), *row = words_one_of("work|knit", text) ? words_skip_any(words_next(text), "the|first|1st|row") : NULL;
    enum side side;

    if (row && words_one_of("from|on", row)) {
        at = words_next(text);
        behind = row;
    }
    side = at > text && behind > at ? side_at(&behind) : SIDE_OPEN;

    return side && (!*behind || strchr(".!);\r\n", *behind)) ? side : SIDE_OPEN;
}

/* The side that a sentence beginning here gives to row 1. */
static enum side sentence_at(const char *text)
{
    const char *at = text;
    enum side side = side_at(&at);
    enum parity rows = side ? PARITY_NONE : rows_at(&at, false);

    if (!side && !rows)
        return start_at(text);
    at = side || rows ? behind_verb(at) : NULL;
    if (!at)
        return SIDE_OPEN;
    if (side)
        rows = rows_at(&at, true);
    else
        side = side_at(&at);
    if (!side || !rows)
        return SIDE_OPEN;
    return (side == SIDE_RS) == (rows == PARITY_ODD) ? SIDE_RS : SIDE_WS;
}

bool page_sides_line(const char *text)
{
    text = words_skip_any(text + (*text == '('), "note|nb|n.b.|important|please note|:|that|remember|the|this|your|you|pattern|chart|piece|work");
    return sentence_at(text) && !words_line_has_sign(text, ":*,;{");
}

enum side page_sides(const char *text, bool *begins)
{
    static const char first[] = "rRwWeEoOfFsSbBkK12";
    enum side found = SIDE_OPEN;

    *begins = false;

    for (size_t at = 0, n; text[at]; at += n) {
        enum side side = strchr(first, text[at]) ? sentence_at(text + at) : SIDE_OPEN;

        if (side && found && side != found)
            return SIDE_OPEN;
        if (side)
            *begins = start_at(text + at) != SIDE_OPEN;
        found = side ? side : found;
        n = text[at] == '#' ? words_line_length(text + at) : words_length(text + at);
        n += n == 0;
    }
    return found;
}
