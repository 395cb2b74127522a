/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the facts that its sentences state of all its rows out. */
#include "lang/page/page_facts.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/page/heads.h"
#include "lang/page/lengths.h"
#include "lang/page/page_sides.h"
#include "lang/page/prose.h"
#include "lang/page/prose_line.h"
#include "lang/page/words.h"

/* ---- whose words they are ---- */

/* `motif flag {`, `for i in 1..4 {`: a block of the language's own. */
static bool begins_block(const char *text)
{
    size_t n = words_line_length(text);

    return words_sign_before(text, n, " \t") == '{' || (memchr(text, '{', n) && !prose_reads(text, true) && words_is(text, "chart"));
}

/* Rows in a knitter's words, and no statement of the language's own. */
static bool is_knitters(const char *text, size_t size)
{
    bool rows = false;

    for (size_t at = 0, line; at < size; at += line + 1) {
        const char *first = text + at + strspn(text + at, " \t*-");

        line = words_line_length(text + at);
        if ((prose_line_is_keyword(first) && !prose_line_ends(first + words_length(first))) || begins_block(first))
            return false;
        rows |= words_row(first) || prose_begins_cast_on(first);
    }
    return rows;
}

/* ---- rows that are rounds ---- */

static bool is_called_row(const char *text)
{
    return strncasecmp(text, "row", 3) == 0;
}

/* `Rnd 1`; not `R1`, which may be either. */
static bool heads_round(const char *text)
{
    return words_length(text) > 1 && words_row(text) && !is_called_row(text);
}

/* `This is knit in the round`, `is worked in rounds`; not `may be knit in the round`, `knit in the round or flat`. */
static bool says_round(const char *text, size_t at)
{
    static const char *const work[] = {"knit", "knitted", "worked", "made", "working", "knitting", "work"}, *const maybe[] = {"can", "could", "may", "might", "if", "to", "either", "not", "when"},
                             *const round[] = {"round", "rounds", "rnd", "rnds"}, *const either[] = {"or", "and"};
    const char *next = words_next(text + at);

    if (words_find(text + at, work, sizeof work / sizeof *work) < 0)
        return false;
    for (int i = 0; i < 6 && !words_is(next, "in"); i++)
        next = words_next(next);
    next = words_is(next, "in") ? words_next(next) : "";
    next = words_is(next, "the") ? words_next(next) : next;
    if (words_find(next, round, 4) < 0 || words_find(words_next(next), either, 2) >= 0)
        return false;
    for (size_t back = 0; back < at && back < WORDS_MARGIN && !strchr(".\r\n", text[at - back - 1]); back++)
        if (words_find(text + at - back, maybe, sizeof maybe / sizeof *maybe) >= 0 &&
            !(words_is(text + at - back, "to") && words_is(words_next(text + at - back), "be")))
            return false;
    return true;
}

/* `Cast on 52 sts, join.`, `.. and join, being careful not to twist`; not `join new yarn`. */
static bool joins_cast_on(const char *text, size_t cast, size_t behind)
{
    static const char *const next[] = {"and", "being", "taking", "making", "pm", "place", "without", "carefully"};
    const char *word = words_skip_blanks(text + behind);

    return cast && !memchr(text + cast, '\n', behind - cast) && (prose_line_ends(word) || strchr(".,;", *word) || words_find(word, next, sizeof next / sizeof *next) >= 0);
}

/* Whether one of the words right before a place says no: `Do not join`, `without joining`. */
static bool is_denied(const char *text, size_t at)
{
    enum { WORDS_BEFORE = 3 };

    for (int i = 0; i < WORDS_BEFORE && at > 0; i++) {
        while (at > 0 && strchr(" \t\r\n", text[at - 1]))
            at--;
        while (at > 0 && !strchr(" \t\r\n.;:,", text[at - 1]))
            at--;
        if (words_one_of("not|don't|don\xE2\x80\x99t|dont|without|never|no", text + at))
            return true;
    }
    return false;
}

/* Whether `join .. in the round` stands before the rows, no row has a wrong side, and rows are not called both. */
static bool is_joined(const char *text)
{
    static const char *const join[] = {"join", "joined", "joining"}, *const round[] = {"round", "rnd", "rounds", "circle", "twist", "twisted", "twisting"},
                             *const flat[] = {"ws", "wrong", "turn"};
    size_t said = 0, cast = 0;
    bool joined = false, rows = false, rounds = false;

    for (size_t at = 0, n; text[at]; at += n ? n : 1) {
        n = words_length(text + at);
        if (!n || (at > 0 && isalnum((unsigned char)text[at - 1])))
            continue;
        if (words_find(text + at, flat, 3) >= 0)
            return false;
        rows |= words_row(text + at) && is_called_row(text + at);
        rounds |= heads_round(text + at);
        if (rows && !joined)
            return false;
        if (words_find(text + at, join, 3) >= 0 && is_denied(text, at))
            return false;
        joined |= says_round(text, at);
        cast = words_is(text + at, "co") || (words_are(text + at, WORDS_CAST) && words_is(words_next(text + at), "on")) ? at + 1 : words_are(text + at, WORDS_PLAIN) ? 0 : cast;
        joined |= words_is(text + at, "join") && joins_cast_on(text, cast, at + n);
        if (words_find(text + at, join, 3) >= 0)
            said = at + 1;
        else if (said && at < said + 100 && words_find(text + at, round, 7) >= 0)
            joined = true;
    }
    return joined && !(rows && rounds);
}

/* `Place marker`, `pm`, `place a marker` */
static bool places_marker(const char *text)
{
    return words_is(text, "pm") || (words_is(text, "place") && (words_is(words_next(text), "marker") || words_is(words_next(words_next(text)), "marker")));
}

/* Behind `circular`, where a marker at the cast-on may begin rounds, and no word says rounds or rows; 0: it is not so. */
static size_t find_circle(const char *text)
{
    size_t behind = 0;
    bool cast = false, worked = false, marked = false;

    for (size_t at = 0, n; text[at]; at += n ? n : 1) {
        n = text[at] == '#' ? words_line_length(text + at) : words_length(text + at);
        if (text[at] == '#' || !n || (at > 0 && isalnum((unsigned char)text[at - 1])))
            continue;
        if (words_one_of("join|joined|joining|turn|turning|rs|ws|wrong|flat|back|rounds|rnds", text + at) || heads_round(text + at) || (words_one_of("round|rnd", text + at) && text[at + n] == ':'))
            return 0;
        behind = words_one_of("circular|circulars", text + at) ? at + n : behind;
        cast |= prose_begins_cast_on(text + at) > 0;
        worked |= cast && (words_are(text + at, WORDS_PLAIN) || words_row(text + at));
        marked |= cast && !worked && places_marker(text + at);
    }
    return marked ? behind : 0;
}

/* ---- looms ---- */

/* Behind the last `loom` of a text with rows; 0: there is none. */
static size_t find_loom(const char *text, bool *pegs)
{
    static const char *const loom[] = {"loom", "looms"}, *const peg[] = {"peg", "pegs"};
    size_t behind = 0;
    bool rows = false, rounds = false;

    for (size_t at = 0, n; text[at]; at += n ? n : 1) {
        n = text[at] == '#' ? words_line_length(text + at) : words_length(text + at);
        if (text[at] == '#' || !n || (at > 0 && isalnum((unsigned char)text[at - 1])))
            continue;
        rows |= words_are_rows(text + at) && is_called_row(text + at);
        rounds |= heads_round(text + at);
        *pegs |= words_find(text + at, peg, 2) >= 0;
        behind = words_find(text + at, loom, 2) >= 0 ? at + n : behind;
    }
    *pegs &= rows && !rounds && behind;
    return rows && !rounds ? behind : 0;
}

/* Behind the `knitting machine`, the `gauge machine` of a text; 0: there is none. */
static size_t find_machine(const char *text)
{
    for (size_t at = strcspn(text, "mM"); text[at]; at += 1 + strcspn(text + at + 1, "mM")) {
        size_t before = at, word;

        while (before > 0 && strchr(" -", text[before - 1]))
            before--;
        for (word = before; word > 0 && isalpha((unsigned char)text[word - 1]);)
            word--;
        if (before < at && words_is(text + at, "machine") && words_one_of("knitting|gauge|bulky|chunky", text + word))
            return at + strlen("machine");
    }
    return 0;
}

/* ---- sizes ---- */

/* Where `(26, 30)` of a cast-on stands, and how many further sizes that are; or 0. */
static size_t find_sizes(const char *text, int *n)
{
    size_t bracket = 0;

    for (size_t at = strcspn(text, "cC"); text[at] && !bracket; at += 1 + strcspn(text + at + 1, "cC")) {
        bool begins = at == 0 || !isalnum((unsigned char)text[at - 1]);
        size_t cast = begins ? prose_begins_cast_on(text + at) : 0, digits;

        if (!cast)
            continue;
        cast = at + cast + strspn(text + at + cast, " ");
        digits = strspn(text + cast, "0123456789");
        cast += digits + strspn(text + cast + digits, " ");
        if (digits && strchr("([", text[cast]) && text[cast] && prose_sizes_length(text + cast, n))
            bracket = cast;
    }
    return bracket;
}

/* ---- the end ---- */

/* The number of the last `Row 58: bind off`; 0: there is none. */
static int find_bound_off(const char *text)
{
    int number = 0, found;

    for (size_t at = 0; text[at]; at += text[at] ? 1 : 0) {
        found = heads_bound_off(text + at + strspn(text + at, " \t*-"));
        number = found ? found : number;
        at += words_line_length(text + at);
    }
    return number;
}

struct page_facts page_facts_read(const char *text, size_t size)
{
    struct page_facts facts = {.rounds = is_joined(text)};

    if (!words_are_page(text, size))
        return facts;
    facts.page = true;
    facts.knitters = is_knitters(text, size);
    facts.first = page_sides(text, &facts.begins);
    facts.gauge = lengths_gauge(text, &facts.gauge_from, &facts.gauge_to);
    facts.loom = facts.rounds ? 0 : find_loom(text, &facts.pegs);
    facts.circle = facts.rounds || facts.loom ? 0 : find_circle(text);
    facts.machine = facts.rounds ? 0 : find_machine(text);
    facts.sizes = find_sizes(text, &facts.nsizes);
    facts.bound_off = find_bound_off(text);
    facts.edge = edge_stitches_read(text, &facts.edges);
    return facts;
}
