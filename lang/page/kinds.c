/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sentence about rows of a kind in, their head and stitch as the language has them out. */
#include "lang/page/kinds.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* Behind `wrong side (even) rows`; NULL: another text. *head: what these rows are called. */
static const char *behind_kind(const char *text, const char **head)
{
    static const struct { const char *words, *row, *round; } kinds[] = {
        {"even-numbered|even numbered|even", "even rows", "even rnds"}, {"odd-numbered|odd numbered|odd|uneven", "odd rows", "odd rnds"},
        {"ws|wrong-side|wrong side", "WS rows", NULL}, {"rs|right-side|right side", "RS rows", NULL},
        {"every other|all other|other|every alternate|alternate|alternating|every second", "every other row", "every other rnd"}};
    bool round;

    text = words_skip_any(text, "all|each|the|of|remaining");
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const char *rows = words_skip_any(text, i < 4 ? "every|all|the|remaining" : "the");
        size_t n = words_one_of(kinds[i].words, rows);

        if (!n)
            continue;
        rows = words_skip_blanks(rows + n);
        if (*rows == '(' && words_one_of("odd|even|rs|ws|right side|wrong side", rows + 1))
            rows = words_skip_blanks(rows + strcspn(rows, ")\r\n") + 1);
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

/* `Purl back on all WS rows` */
static size_t says_stitch_first(const char *text, const char **head, char *stitch)
{
    size_t n;
    const char *behind;

    *stitch = stitch_of(text, &n);
    if (!*stitch || text[n] != ' ')
        return 0;
    behind = behind_kind(words_skip_any(text + n, "back|on|in|across|for"), head);
    return behind && ends(behind) ? (size_t)(behind - text) : 0;
}

/* `The even rows are purled`, `Even rows - purl`; up to a list of stitches, where one stands: `WS rows - k2, p2`. */
static size_t says_rows_first(const char *text, bool bracket, const char **head, char *stitch)
{
    const char *rows = behind_kind(text, head), *behind = rows ? words_skip_blanks(rows) : NULL, *dash;
    size_t n;

    if (!behind || (*behind == ':' && !bracket))
        return 0;
    dash = behind + strspn(behind, "-,=:\xE2\x80\x93\x94");
    behind = words_skip_any(dash, "are|is|should|must|will|to|be|get|all|always|just");
    *stitch = stitch_of(behind, &n);
    if (*stitch && (ends(behind + n) || words_one_of("across|all|every|to|plain", words_skip_blanks(behind + n))))
        return (size_t)(behind + n - text);
    *stitch = 0;
    return dash > words_skip_blanks(rows) && behind == words_skip_blanks(dash) && (prose_stitches_follow(behind) || words_one_of("knit the|purl the", behind)) ? (size_t)(behind - text) : 0;
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
