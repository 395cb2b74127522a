/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; how much of it names the yarn of whole rows out. */
#include "lang/page/yarns.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { LONGEST = 60 };      /* bytes that say which yarn it is */

/* ---- names ---- */

/* `A`, `MC`, `CC2`: its bytes, or 0. */
static size_t letters_length(const char *text)
{
    size_t n = words_length(text), digits = strspn(text + n, "0123456789");
    bool two = n == 2 && (strncmp(text, "MC", 2) == 0 || strncmp(text, "CC", 2) == 0);

    if (isalnum((unsigned char)text[n + digits]))
        return 0;
    return two || (n == 1 && *text == 'C' && digits) ? n + digits : n == 1 && !digits && strchr("ABCDEF", *text) ? n : 0;
}

/* `the main colour`, `Col B`, `red`: its bytes, or 0; whether it is more than a letter, which may also name a part. */
static size_t colour_length(const char *text, bool *plain)
{
    static const char *const colour[] = {"red", "blue", "green", "white", "black", "yellow", "pink", "grey", "gray", "brown", "orange", "purple",
                                         "cream", "navy", "main", "contrast", "contrasting"},
                             *const yarn[] = {"colour", "color", "col", "yarn", "shade"}, *const which[] = {"the", "your", "dark", "light"};
    size_t at = 0, end = 0, n;
    bool named = false;

    for (*plain = false; ; at = end + strspn(text + end, " .")) {
        bool letters = (n = letters_length(text + at)) > 0, word = !letters && (n = words_length(text + at)) > 0;

        if (!letters && !(word && (words_find(text + at, colour, 17) >= 0 || words_find(text + at, yarn, 5) >= 0 || words_find(text + at, which, 4) >= 0)))
            return named ? end : 0;
        *plain |= n > 1 && words_find(text + at, which, 4) < 0;
        named |= letters || words_find(text + at, colour, 17) >= 0;
        end = at + n;
    }
}

/* Any name up to a comma, a colon or a word of work: its bytes, or 0. */
static size_t name_length(const char *text)
{
    const unsigned work = WORDS_ROW | WORDS_STITCH | WORDS_PLAIN | WORDS_WORK | WORDS_AGAIN | WORDS_SIDE | WORDS_EVERY | WORDS_TIMES | WORDS_CAST |
                          WORDS_BIND | WORDS_GO_ON | WORDS_FABRIC;
    static const char *const other[] = {"pattern", "patt", "pat", "chart", "side", "facing", "right", "wrong", "stocking"};
    size_t at = 0;

    for (size_t n; at < LONGEST && text[at] && !strchr(",:", text[at]); at += n ? n : 1) {
        n = words_length(text + at);
        if (n && words_are(text + at, work))
            return at;
        if (n ? words_find(text + at, other, 9) >= 0 : !strchr(" -'/#&.0123456789", text[at]))
            return 0;
    }
    return at < LONGEST && text[at] ? at : 0;
}

/* ---- what is worked with it ---- */

/* `knit 4 rows`, `work 8 rows st st`, `repeat rows 1-4`, `work in garter st`, `beg with a k row`, `Row 1: ..`. */
static bool rows_follow(const char *text)
{
    const char *next = words_next(text), *fabric = words_is(next, "in") ? words_next(next) : next;

    if (prose_pattern_follows(text) || (words_are(text, WORDS_AGAIN) && prose_repeats_rows(next)))
        return true;
    if (words_are(text, WORDS_WORK | WORDS_GO_ON) && prose_fabric_follows(fabric))
        return true;
    if (words_are(text, WORDS_WORK) && words_row(next))
        return true;
    return words_are(text, WORDS_PLAIN | WORDS_WORK) && (prose_rows_follow(next) || (words_are(next, WORDS_EVERY) && words_are_rows(words_next(next))));
}

/* `knit`, `purl across`, and no more of the sentence. */
static bool row_follows(const char *text)
{
    static const char *const all[] = {"all", "across", "row", "sts", "stitches", "to", "end"};
    const char *at = words_next(text);

    while (words_find(at, all, 7) >= 0)
        at = words_next(at);
    return words_are(text, WORDS_PLAIN) && !isdigit((unsigned char)text[words_length(text)]) && (prose_line_ends(at) || strchr(".;", *at));
}

/* ---- places ---- */

/* Behind `with`, `change to`, `join`; or NULL. `any`: any name may follow. */
static const char *behind_lead(const char *text, bool *any)
{
    static const char *const use[] = {"with", "using"}, *const change[] = {"change", "switch", "join", "attach", "in"}, *const to[] = {"back", "to", "in"};
    const char *at = words_next(text);

    *any = words_find(text, use, 2) >= 0;
    if (!*any && words_find(text, change, 5) < 0)
        return NULL;
    while (!*any && words_find(at, to, 3) >= 0)
        at = words_next(at);
    return at;
}

/* `Using Red, ` before rows, or before a row behind its head. */
static size_t before_rows(const char *text, bool row)
{
    static const char *const then[] = {"and", "then"};
    bool any, plain;
    const char *name = behind_lead(text, &any), *end;
    size_t n = name ? colour_length(name, &plain) : 0;

    if (name && !n && any)
        n = name_length(name);
    if (!n)
        return 0;
    end = words_skip_blanks(name + n);
    end = words_skip_blanks(end + (*end == ',' || *end == ':'));
    while (words_find(end, then, 2) >= 0)
        end = words_next(end);
    return rows_follow(end) || (row && row_follows(end)) ? (size_t)(end - text) : 0;
}

/* Whether so many rows, or a whole row behind its head, are worked before a place. */
static bool behind_work(const char *text, size_t at)
{
    size_t word = words_before(text, at), number = words_before(text, word);

    if (words_are_rows(text + word))
        return words_are(text + number, WORDS_NUMBER) || (number > 0 && isdigit((unsigned char)text[number - 1]));
    return words_are(text + word, WORDS_PLAIN) && words_sign_before(text, word, " ") == ':';
}

/* `with B`, `in red` behind `knit 2 rows` or behind `Row 1: knit`, at a sentence's end. */
static size_t behind_rows(const char *text, size_t at)
{
    static const char *const lead[] = {"with", "using", "in"};
    const char *name = words_next(text + at);
    bool plain, in = words_is(text + at, "in");
    size_t n = words_find(text + at, lead, 3) >= 0 ? colour_length(name, &plain) : 0;

    if (!n || (in && !plain) || !behind_work(text, at))
        return 0;
    return prose_line_ends(name + n) || strchr(".;", name[n]) ? (size_t)(name + n - (text + at)) : 0;
}

/* `(MC)` between a row's number and its colon; the comma and the name of `(RS, MC)`. */
static size_t in_head(const char *text, size_t at)
{
    bool plain, side = text[at] == ',';
    size_t blanks = strspn(text + at + 1, " "), n = colour_length(text + at + 1 + blanks, &plain), end = at + 1 + blanks + n;

    if (!n || text[end] != ')' || *words_skip_blanks(text + end + 1) != ':')
        return 0;
    if (side)
        return at > 2 && text[at - 3] == '(' && words_are(text + at - 2, WORDS_SIDE) ? end - at : 0;
    return isdigit((unsigned char)words_sign_before(text, at, " ")) ? end + 1 - at : 0;
}

/* The `B:` of `Row 4: B: purl`, the `color A:` of `Row 1 - color A: knit`. */
static size_t before_colon(const char *text)
{
    bool plain;
    size_t n = colour_length(text, &plain), end = n + strspn(text + n, " ");

    return n && text[end] == ':' && prose_stitches_follow(words_skip_blanks(text + end + 1)) ? end + 1 : 0;
}

size_t yarns_length(const char *text, size_t at, bool begins)
{
    bool row = words_sign_before(text, at, " ") == ':';

    if (text[at] == '(' || text[at] == ',')
        return in_head(text, at);
    if ((row || words_sign_before(text, at, " ") == '-') && before_colon(text + at))
        return before_colon(text + at);
    return begins || row ? before_rows(text + at, row && !begins) : behind_rows(text, at);
}
