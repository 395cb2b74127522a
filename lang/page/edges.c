/* SPDX-License-Identifier: GPL-3.0-or-later
 * Edges that a page asks to be kept in a fabric of their own, in its words. */
#include "lang/page/edges.h"

#include <stdio.h>
#include <string.h>

#include "lang/page/words.h"

enum { MOST = 1000 };       /* stitches of an edge */

/* What was said of the edges so far. */
struct said {
    int n;
    bool stitches, side, first, last;
    const char *fabric;
};

/* A word that says where they are, or nothing. */
static bool is_place(const char *text, struct said *said)
{
    static const char *const side[] = {"side", "sides", "edge", "edges", "end", "ends"}, *const both[] = {"each", "either", "both"},
                             *const other[] = {"at", "on", "of", "in", "the", "and", "as", "outer", "outside", "row", "rows", "every", "work", "piece", "needle",
                                               "st", "stitch", "throughout", "always", "all", "times", "for", "a", "border", "borders"};

    bool sides = words_find(text, side, 6) >= 0, first = words_is(text, "first") || words_is(text, "beginning"), last = words_is(text, "last") || words_is(text, "ending"),
         stitches = words_are_stitches(text);

    said->side |= sides;
    said->first |= first;
    said->last |= last || words_is(text, "end");
    said->stitches |= stitches;
    return sides || first || last || stitches || words_find(text, both, 3) >= 0 || words_find(text, other, sizeof other / sizeof *other) >= 0;
}

/* Takes the word or number at a place; false: the sentence says more than edges.  `Always knit the first and last stitch`: of garter. */
static bool take_word(const char *text, struct said *said)
{
    static const char *const fabric[] = {"garter", "seed", "moss"};

    if (is_place(text, said))
        return true;
    if (words_find(text, fabric, 3) >= 0 && !said->fabric)
        said->fabric = text;
    else if (words_behind_number(text) && words_number(text) && (!said->n || said->n == words_number(text)))     /* not `1st` */
        said->n = words_number(text);
    else
        return false;
    return true;
}

/* Behind `work in pattern as follows:`, which says no more. */
static const char *skip_in_pattern(const char *text)
{
    static const char *const words[] = {"work", "working", "continue", "in", "the", "pattern", "patt", "pat", "as", "follows", "below", "set"};
    const char *at = text;

    while (words_find(at, words, sizeof words / sizeof *words) >= 0)
        at = words_next(at);
    at = words_skip_blanks(at + (*at == ':' || *at == '.'));
    return !*at || words_ends_line(*at) ? at : text;
}

size_t edges_length(const char *text, struct kept_edges *edges, const char **fabric)
{
    const char *at = words_is(text, "always") ? words_next(text) : text;
    bool knitting = words_is(at, "knitting");
    struct said said = {.fabric = knitting ? at : NULL};

    if (!words_one_of("keep|keeping|with|working|maintaining|knitting", at))
        return 0;
    for (at = words_next(at); *at && !words_ends_line(*at) && !strchr(".,:;", *at) && !words_one_of("until|till|for", at); at = words_skip_blanks(at))
        if (take_word(at, &said))
            at = words_length(at) ? words_next(at) : words_behind_number(at);
        else if (*at == '-')    /* `a 2-stitch border` */
            at++;
        else
            return 0;
    if (!said.n || said.n > MOST || !said.stitches || !said.fabric || !(said.side || (said.first && said.last)) || *at == ':')
        return 0;
    *edges = (struct kept_edges){.n = said.n, .fabric = knitting || words_is(said.fabric, "garter") ? FABRIC_GARTER : FABRIC_SEED};
    *fabric = said.fabric;
    return (size_t)(*at == ',' ? skip_in_pattern(words_skip_blanks(at + 1)) - text : at - text);
}

/* ---- sentences without a verb of keeping ---- */

/* `Note: always`, `Remember to`. */
static const char *skip_lead(const char *text)
{
    static const char *const words[] = {"note", "notes", "remember", "always", "to", "be", "sure", "make", "the", "you", "will", "should",
                                        "from", "here", "now", "this", "point", "on"};

    while (words_find(text, words, sizeof words / sizeof *words) >= 0) {
        text = words_next(text);
        text = words_skip_blanks(text + (*text == ':' || *text == ',' || *text == '-'));
    }
    return text;
}

/* Whether it is said of every row. */
static bool says_every(const char *text, const char *end)
{
    static const char *const word[] = {"every", "each", "all", "always", "throughout", "both"};

    for (; text < end; text += words_length(text) ? words_length(text) : 1)
        if (words_find(text, word, sizeof word / sizeof *word) >= 0)
            return true;
    return false;
}

/* `; these are not mentioned below`, `and are not included in the instructions`: its bytes; 0: something else. */
static size_t left_out_length(const char *text)
{
    static const char *const word[] = {"and", "these", "they", "those", "this", "which", "so", "edge", "border", "sts", "stitches", "are", "is", "will", "be", "in", "the",
                                       "instructions", "directions", "pattern", "rows", "row", "below", "out", "again", "further", "part", "of", "included", "mentioned",
                                       "written", "shown", "listed", "counted", "stated", "repeated", "given"};
    size_t at = strspn(text, " ;,"), n;
    bool left = false;

    for (; text[at] && !strchr(".)\r\n", text[at]); at += n, at += strspn(text + at, " ")) {
        left |= words_is(text + at, "not");
        n = words_length(text + at);
        if (!n || (!words_is(text + at, "not") && words_find(text + at, word, sizeof word / sizeof *word) < 0))
            return 0;
    }
    return left ? at : 0;
}

size_t edges_said(const char *text, size_t start, char *plain, size_t room)
{
    static const char *const verb[] = {"are", "is", "be", "worked", "knitted", "kept", "done", "form", "will"};
    struct said said = {0};
    const char *at = skip_lead(text + start);
    bool one = false, knit = words_is(at, "knit") || words_is(at, "k");

    if (!strchr("\n.:", words_sign_before(text, start, " \t*-")))
        return 0;
    if (knit || words_is(at, "work"))
        at = words_is(words_next(at), "the") ? words_next(words_next(at)) : words_next(at);
    if (!words_is(at, "first"))
        return 0;
    for (; *at && !words_ends_line(*at) && !strchr(".,:;(", *at) && !left_out_length(at); at = words_skip_blanks(words_length(at) ? words_next(at) : words_behind_number(at))) {
        one |= words_is(at, "st") || words_is(at, "stitch");
        if (words_is(at, "knit") || words_is(at, "k"))
            knit = true;
        else if (words_find(at, verb, sizeof verb / sizeof *verb) < 0 && !take_word(at, &said))
            return 0;
    }
    said.n = said.n ? said.n : one && !said.fabric;
    if (!said.n || said.n > MOST || !said.last || !said.stitches || (!knit && !said.fabric) || !says_every(text + start, at))
        return 0;
    at += left_out_length(at);
    if ((*at && strchr(",:", *at)))
        return 0;
    snprintf(plain, room, "with %d edge sts %.6s", said.n, said.fabric && !words_is(said.fabric, "garter") ? "seed" : "garter");
    at += *at == '(' ? strcspn(at, ")\r\n") + 1 : 0;
    return (size_t)(at - text) - start;
}
