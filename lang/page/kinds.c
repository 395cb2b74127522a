/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sentence about rows of a kind in, their head and stitch as the language has them out. */
#include "lang/page/kinds.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* Behind `(even)`, which names the same rows otherwise. */
static const char *behind_bracket(const char *text)
{
    bool kind = *text == '(' && words_one_of("odd|even|rs|ws|right side|wrong side", text + 1);

    return kind ? words_skip_blanks(text + strcspn(text, ")\r\n") + 1) : text;
}

/* Behind `wrong side (even) rows`; NULL: another text. *head: what these rows are called. */
static const char *behind_kind(const char *text, const char **head)
{
    static const struct { const char *words, *row, *round; } kinds[] = {
        {"even-numbered|even numbered|even", "even rows", "even rnds"}, {"odd-numbered|odd numbered|odd|uneven", "odd rows", "odd rnds"},
        {"ws|wrong-side|wrong side|return", "WS rows", NULL}, {"rs|right-side|right side", "RS rows", NULL},
        {"every other|all other|other|every alternate|alternate|alternating|every second", "every other row", "every other rnd"}};
    bool round;

    text = words_skip_any(text, "all|each|the|of|remaining");
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const char *rows = words_skip_any(text, i < 4 ? "every|all|the|remaining" : "the");
        size_t n = words_one_of(kinds[i].words, rows);

        if (!n)
            continue;
        rows = words_skip_blanks(rows + n);
        rows = behind_bracket(rows);
        round = words_one_of("round|rounds|rnd|rnds", rows) > 0;
        *head = round ? kinds[i].round : kinds[i].row;
        return words_are_rows(rows) && *head ? rows + words_length(rows) : NULL;
    }
    return NULL;
}

/* The stitch of `knit`, `purled`; 0: there is none. */
static char stitch_of(const char *text, size_t *n)
{
    *n = words_one_of("k|knit|knitted|knits|p|purl|purled|purls", text);
    return *n ? (char)tolower((unsigned char)*text) : 0;
}

static bool ends(const char *text)
{
    return prose_line_ends(text) || strchr(".,;)", *words_skip_blanks(text));
}

/* `Purl back on all WS rows`; `Work all WS rows` before `as the sts appear`, which stays. */
static size_t says_stitch_first(const char *text, const char **head, char *stitch)
{
    size_t n;
    const char *behind;

    *stitch = stitch_of(text, &n);
    n = *stitch ? n : words_one_of("work", text);
    if (!n || text[n] != ' ')
        return 0;
    behind = behind_kind(words_skip_any(text + n, "back|on|in|across|for"), head);
    return behind && (*stitch ? ends(behind) : words_one_of("as the|as they|as sts|as stitches", words_skip_blanks(behind)) > 0) ? (size_t)(behind - text) : 0;
}

/* `The even rows are purled`, `Even rows - purl`; up to a list of stitches, where one stands: `WS rows - k2, p2`. */
static size_t says_rows_first(const char *text, bool bracket, const char **head, char *stitch)
{
    static const char written[] = "and|are|is|not|given|shown|written|out|charted|listed|described|printed";
    const char *kind = words_skip_any(text, "on|in|for"), *rows = behind_kind(kind, head), *behind = rows ? words_skip_blanks(rows) : NULL, *dash, *end;
    bool named = kind > text || words_one_of("return", kind);
    size_t n;

    if (!behind)
        return 0;
    if (strchr("RW", **head) && words_one_of("odd|even", behind + (*behind == '('))) {
        named |= *behind == '(';
        behind = behind_bracket(behind);
    }
    if (*behind == ':' && !bracket && !named)
        return 0;
    if (words_one_of("are not|not", behind))
        behind = words_skip_any(behind, written);
    dash = behind + strspn(behind, "-,=:\xE2\x80\x93\x94");
    named |= dash > words_skip_blanks(rows);
    behind = words_skip_any(dash, "are|is|should|must|will|to|be|get|all|always|just");
    *stitch = stitch_of(behind, &n);
    end = behind + n;
    if (*stitch && words_one_of("and not|and are not", words_skip_blanks(end)))
        end = words_skip_any(end, written);
    if (*stitch && (ends(end) || words_one_of("across|all|every|to|plain", words_skip_blanks(end))))
        return (size_t)(end - text);
    *stitch = 0;
    return named && behind == words_skip_blanks(dash) && (prose_stitches_follow(behind) || words_one_of("knit the|purl the|work", behind)) ? (size_t)(behind - text) : 0;
}

/* Whether a colon ends `Note:`. */
static bool is_note(const char *text, size_t colon)
{
    size_t word = colon;

    while (word > 0 && isalpha((unsigned char)text[word - 1]))
        word--;
    return words_one_of("note|notes|nb", text + word) > 0;
}

/* Behind the bracket that closes the sentence; 0: more stands before it. */
static size_t closed(const char *text, size_t n)
{
    const char *end = words_skip_any(text + n, "across|all|sts|stitches|to|end|.");

    return *end == ')' ? (size_t)(end + 1 - text) : 0;
}

/* `Purl rows 2, 3 and 4`: its bytes, and `rows 2, 3 and 4:p`. */
static size_t numbered_length(const char *text, char plain[static SIGNS_PLAIN])
{
    size_t n;
    char stitch = stitch_of(text, &n);
    const char *rows = words_skip_blanks(text + n), *end = words_next(rows);

    if (!stitch || rows == text + n || !words_are_rows(rows) || !isdigit((unsigned char)*end))
        return 0;
    while (isdigit((unsigned char)*end) || (strchr(" ,-&", *end) && *end) || words_one_of("and|to", end))
        end += words_one_of("and|to", end) ? words_length(end) : 1;
    while (strchr(" ,-&", end[-1]))
        end--;
    if (!ends(end) || end - rows > SIGNS_PLAIN - 4)
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%.*s:%c", (int)(end - rows), rows, stitch);
    return (size_t)(end - text);
}

size_t kinds_added(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t close = strcspn(text + at, ")\r\n");
    const char *every = text + at + 1, *rows = words_skip_any(every, "and|every|each|all|following|foll|other|alternate|alt|second|even-numbered|odd-numbered|even|odd|numbered"), *end, *behind, *side;

    if (text[at + close] != ')' || close + 2 > SIGNS_PLAIN || !words_one_of("and every|and each|and all|and following|and foll|and alt|and alternate", every) || !words_are_rows(rows))
        return 0;
    end = rows + words_length(rows);
    behind = words_skip_any(end, ",|rs|ws|right side|wrong side");
    if (behind != text + at + close || (words_skip_blanks(end) == behind && words_skip_any(every, "and|every|each|all|even-numbered|odd-numbered|even|odd|numbered") == rows))
        return 0;       /* such a bracket is the language's own */
    side = words_skip_any(end, ",");
    snprintf(plain, SIGNS_PLAIN, side < behind ? "(%cS) %.*s" : "%c%.*s", side < behind ? toupper((unsigned char)*side) : ' ', (int)(end - every), every);
    return close + 1;
}

size_t kinds_given(const char *text)
{
    const char *head, *rows = behind_kind(words_skip_any(text, "only|just|the"), &head), *verb = rows ? words_skip_any(rows, "are|have been") : NULL;
    const char *given = rows ? words_skip_any(verb, "only|all") : NULL, *end;

    if (!rows || verb == words_skip_blanks(rows) || !words_one_of("given|written|shown|charted|listed|described|printed", given))
        return 0;
    end = words_skip_any(words_next(given), "out|here|below|in|on|this|the|pattern|chart|instructions");
    return prose_line_ends(end) || strchr(".,;", *end) ? (size_t)(end - text) : 0;
}

size_t kinds_given_before(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t n = strchr(".;:(\r\n", words_sign_before(text, at, " \t")) ? kinds_given(text + at) : 0;

    if (!n || n + 2 > SIGNS_PLAIN || prose_line_ends(text + at + n + 1))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%.*s\n", (int)n, text + at);
    return n + 1;
}

size_t kinds_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t sign = at, n, open = text[at] == '(';
    const char *head;
    char before = words_sign_before(text, at, " \t"), stitch;

    while (sign > 0 && strchr(" \t", text[sign - 1]))
        sign--;
    if (!strchr(".;\r\n", before) && !(before == ':' && is_note(text, sign - 1)))
        return 0;
    n = strchr("\r\n.", before) && !open ? numbered_length(text + at, plain) : 0;
    if (n)
        return n;
    n = says_stitch_first(text + at + open, &head, &stitch);
    n = n ? n : says_rows_first(text + at + open, open, &head, &stitch);
    n = n && open ? closed(text + at, n + 1) : n;
    if (n)
        snprintf(plain, SIGNS_PLAIN, stitch ? "%s%s:%c" : "%s%s:", strchr(".;:", before) ? "\n" : "", head, stitch);
    return strlen(plain) <= n ? n : 0;
}
