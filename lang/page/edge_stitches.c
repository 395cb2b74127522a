/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sentences on edge stitches in, how these are worked out. */
#include "lang/page/edge_stitches.h"

#include <ctype.h>

#include "lang/page/words.h"

enum act { NOTHING, KNIT, PURL, SLIP };

/* What a sentence said so far: what is done on RS rows and on WS rows. */
struct said {
    enum act act, rs, ws;
    bool waits_rs, waits_ws;    /* a side was named before what is done on it; */
    bool placed;                /* what is done has its side */
    bool every, first, last;    /* of every row; of a row's first and last stitch */
    const char *fabric;
};

/* `edge`, `selvedge` before `st`: bytes of both; 0: another word. */
static size_t name_length(const char *text)
{
    const char *next = words_next(text);

    return words_one_of("edge|selvedge|selvage|selv", text) && words_are_stitches(next) ? (size_t)(next - text) + words_length(next) : 0;
}

/* Behind `1 edge st (selvedge st) at each side`; NULL: the text names none. */
static const char *behind_name(const char *text)
{
    const char *at = text + strspn(text, "12 \t");
    const char *name = words_skip_any(at, "the|all|both|these|your|work|knit|purl|slip|k|p|keep|always|note|and|of");

    name = name_length(name) ? name : at;
    if (!name_length(name))
        return NULL;
    at = words_skip_blanks(name + name_length(name));
    if (*at == '(' && name_length(at + 1))
        at = words_skip_blanks(at + strcspn(at, ")\r\n") + 1);
    return words_skip_any(at, "at|on|each|both|either|side|sides|end|ends");
}

static enum act act_of(const char *text)
{
    bool figures = words_length(text) == 1 && isdigit((unsigned char)text[1]);

    if (words_one_of("knit|k|knitted|knitting|knits", text) || (figures && words_is(text, "k")))
        return KNIT;
    if (words_one_of("purl|p|purled|purling|purls", text) || (figures && words_is(text, "p")))
        return PURL;
    return words_one_of("slip|sl|slipped|slipping", text) ? SLIP : NOTHING;
}

/* What is done: on a side named before it, or on one that follows. */
static void take_act(struct said *said, enum act act)
{
    said->act = act;
    said->placed = said->waits_rs || said->waits_ws;
    said->rs = said->waits_rs ? act : said->rs;
    said->ws = said->waits_ws ? act : said->ws;
    said->waits_rs = said->waits_ws = false;
}

static void take_side(struct said *said, enum act *side, bool *waits)
{
    if (said->act && !said->placed)
        *side = said->act;
    else
        *waits = true;
    said->placed = true;
}

static void take_word(struct said *said, const char *text)
{
    enum act act = act_of(text);
    bool side = words_is(words_next(text), "side");

    if (act)
        take_act(said, act);
    else if (words_is(text, "rs") || (words_is(text, "right") && side))
        take_side(said, &said->rs, &said->waits_rs);
    else if (words_is(text, "ws") || (words_is(text, "wrong") && side))
        take_side(said, &said->ws, &said->waits_ws);
    said->every |= words_one_of("every|each|all|always|both|throughout", text) > 0;
    said->first |= words_is(text, "first");
    said->last |= words_is(text, "last");
    if (words_one_of("garter|reverse|rev", text) || (!said->fabric && (words_one_of("stockinette|stocking", text) || (words_is(text, "st") && words_is(words_next(text), "st")))))
        said->fabric = text;
}

/* What follows from what is done on RS and on WS rows. */
static enum edge_stitch kind_of(enum act rs, enum act ws)
{
    if (!rs || !ws)
        return EDGE_UNCLEAR;
    return rs == SLIP || ws == SLIP ? EDGE_SLIPPED : rs == KNIT ? (ws == KNIT ? EDGE_GARTER : EDGE_STOCKINETTE) : ws == KNIT ? EDGE_REVERSE : EDGE_PURLED;
}

/* Whether something is said at all, and what.  A lone `purled` may be of one side. */
static bool says(const struct said *said, enum edge_stitch *kind)
{
    enum act rs = said->waits_rs ? said->act : said->rs, ws = said->waits_ws ? said->act : said->ws;

    if (!rs && !ws && (said->every || said->act != PURL))
        rs = ws = said->act;
    if (said->act)
        *kind = kind_of(rs, ws);
    else if (said->fabric)
        *kind = words_is(said->fabric, "garter") ? EDGE_GARTER : words_one_of("reverse|rev", said->fabric) ? EDGE_REVERSE : EDGE_STOCKINETTE;
    return said->act || said->fabric;
}

/* `Purl the first and last st of every row`, its verb an act. */
static bool is_of_both_ends(const struct said *said)
{
    return said->first && said->last && said->act && said->every;
}

/* Whether a row's head stands before a place on its line: `WS rows: `. */
static bool is_behind_head(const char *text, size_t at)
{
    for (size_t i = words_line_start(text, at), n; i < at; i += n ? n : 1) {
        n = words_length(text + i);
        if (words_are_rows(text + i))
            return true;
    }
    return false;
}

/* Whether a sentence goes on at a place: `st.` does not end it, nor what it has in brackets. */
static bool goes_on(const char *text, size_t at, bool inside)
{
    return text[at] && !strchr(inside ? "\r\n" : ")\r\n", text[at]) && (text[at] != '.' || words_are_stitches(text + words_before(text, at)));
}

size_t edge_stitches_length(const char *text, size_t at, enum edge_stitch *kind)
{
    const char *from = text + at, *name = behind_name(from);
    struct said said = {0};
    bool named = name && (*name != ',' || words_is(words_skip_blanks(name + 1), "worked")), slips = false, inside = false;
    size_t n = 0;

    if (!strchr("\n.:(", words_sign_before(text, at, " \t*-1")) || words_row(from) || (words_sign_before(text, at, " \t") == ':' && is_behind_head(text, at)))
        return 0;
    for (size_t word; n < WORDS_MARGIN && goes_on(text, at + n, inside); n += word ? word : 1) {
        inside = from[n] == '(' || (inside && from[n] != ')');
        word = words_length(from + n);
        named |= word && name_length(from + n) && said.act && said.first && said.every;
        slips |= word && act_of(from + n) == SLIP;
        if (word)
            take_word(&said, from + n);
    }
    if (!(named || is_of_both_ends(&said)) || !(slips || says(&said, kind)))
        return 0;
    *kind = slips ? EDGE_SLIPPED : *kind;
    return n + (from[n] == '.');
}

/* `, edge st`, `edge st, `: among the stitches of a row. */
static bool is_of_row(const char *text, size_t at, size_t length)
{
    return words_sign_before(text, at, " \t1") == ',' || text[at + length + strspn(text + at + length, " \t")] == ',';
}

enum edge_stitch edge_stitches_read(const char *text, bool *used)
{
    enum edge_stitch kind = EDGE_GARTER, said;

    *used = false;
    for (size_t at = 0, n, length; text[at]; at += n ? n : 1) {
        n = text[at] == '#' ? words_line_length(text + at) : words_length(text + at);
        if (text[at] == '#' || !n || (at > 0 && isalnum((unsigned char)text[at - 1])))
            continue;
        *used |= name_length(text + at) && is_of_row(text, at, name_length(text + at));
        length = edge_stitches_length(text, at, &said);
        kind = length ? said : kind;
        n = length ? length : n;
    }
    return kind;
}
