/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sentence in, the side of the last of its rows out, where it says that. */
#include "lang/page/endings.h"

#include <string.h>

#include "lang/page/words.h"

/* The side that `ending with a WS row`, `end with RS facing` give to the last row, and behind them. */
static enum side side_at(const char *text, const char **behind)
{
    size_t n = words_one_of("end|ending|ends|finish|finishing", text);
    const char *side = words_skip_any(text + n, "with|on|after|by|having|worked|working|completed|completing|just|a|an|the"), *next;
    enum side said;

    if (!n || !(n = words_one_of("rs|ws|right side|right-side|wrong side|wrong-side", side)))
        return SIDE_OPEN;
    said = (*side | 0x20) == 'r' ? SIDE_RS : SIDE_WS;
    next = words_skip_blanks(side + n);
    *behind = next + words_one_of("row|facing", next);
    if (words_is(next, "facing"))       /* for the next row */
        return said == SIDE_RS ? SIDE_WS : SIDE_RS;
    return words_is(next, "row") || !*next || strchr(".,;\r\n", *next) ? said : SIDE_OPEN;
}

enum side endings_side(const char *text, unsigned from, unsigned behind, unsigned *start, unsigned *end)
{
    while (text[behind] && !strchr(".;\r\n", text[behind]))
        behind++;
    for (; from < behind; from += words_length(text + from) ? (unsigned)words_length(text + from) : 1) {
        const char *last;
        enum side side = side_at(text + from, &last);

        *start = from;
        *end = side ? (unsigned)(last - text) : from;
        if (side)
            return side;
    }
    return SIDE_OPEN;
}
