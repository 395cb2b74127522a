/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with the number of stitches for a marker out: the row itself works all that is behind it. */
#include "lang/page/markers.h"

#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { PLAIN = 40, MOST = 10000 };  /* bytes; stitches */

/* Where a row placed markers: stitches before its first, and behind its last; 0: not told by figures alone. */
struct places {
    int first, last;
};

static const char *skip_words(const char *text, const char *const *word, int n)
{
    while (words_find(text, word, n) >= 0)
        text = words_next(text);
    return text;
}

static const char *behind_marker(const char *text)
{
    static const char *const words[] = {"the", "a", "next", "first", "second", "last", "st", "stitch"}, *const marker[] = {"marker", "m"};

    text = skip_words(text, words, 8);
    return words_find(text, marker, 2) >= 0 ? text + words_length(text) : NULL;
}

/* Behind `PM`, `place marker for side border`; NULL: none is placed. */
static const char *behind_placed(const char *text)
{
    static const char *const why[] = {"for", "at", "on"};
    const char *behind = words_is(text, "pm") ? text + 2 : words_is(text, "place") ? behind_marker(words_next(text)) : NULL;

    if (behind && words_find(words_skip_blanks(behind), why, 3) >= 0)
        behind += strcspn(behind, ",;.\r\n");
    return behind;
}

/* Behind `sm`, `slip marker`; NULL: none is slipped. */
static const char *behind_slipped(const char *text)
{
    static const char *const sign[] = {"sm", "slm", "rm"}, *const verb[] = {"slip", "sl", "move", "remove"};

    if (words_find(text, sign, 3) >= 0)
        return text + words_length(text);
    return words_find(text, verb, 4) >= 0 ? behind_marker(words_next(text)) : NULL;
}

/* Behind `to marker`, `until next m`; NULL: another text. */
static const char *behind_to(const char *text)
{
    static const char *const to[] = {"to", "until", "till"};

    return words_find(text, to, 3) >= 0 ? behind_marker(words_next(text)) : NULL;
}

/* The stitches of so much of a row, where all have their figures, `K3; P 1, k3`; 0: they have not. */
static int count_fixed(const char *text, const char *end)
{
    int sum = 0;

    for (text += strspn(text, " \t,;."); text < end; text += strspn(text, " \t,;.")) {
        const char *marker = behind_slipped(text) ? behind_slipped(text) : behind_placed(text), *number = words_next(text);

        if (!marker && (!words_are(text, WORDS_PLAIN) || !words_behind_number(number) || words_number(number) > MOST - sum))
            return 0;
        text = marker ? marker : words_skip_blanks(words_behind_number(number));
        sum += marker ? 0 : words_number(number);
        text += marker || !words_are_stitches(text) ? 0 : words_length(text);
    }
    return sum;
}

/* Behind the head of a row, `Row 1:`, `1st row - `. */
static const char *behind_head(const char *line, const char *end)
{
    for (const char *at = line; at < end; at++)
        if (*at == ':' || (*at == '-' && at[1] == ' '))
            return at + 1;
    return line;
}

static struct places places_on(const char *line, const char *end)
{
    struct places places = {0};
    bool found = false;

    for (const char *at = line; at < end; at += words_length(at) + (words_length(at) == 0)) {
        const char *behind = behind_placed(at);

        if (!behind)
            continue;
        if (!found)
            places.first = count_fixed(behind_head(line, at), at);
        places.last = count_fixed(behind, end);
        found = true;
    }
    return places;
}

/* The line's one `to marker`; NULL: there are none or more. */
static const char *only_to(const char *line, const char *end)
{
    const char *only = NULL;

    for (const char *at = line; at < end; at += words_length(at) + (words_length(at) == 0))
        if (behind_to(at)) {
            if (only)
                return NULL;
            only = at;
        }
    return only;
}

/* What stands plainly for a text of so many bytes, with or without `sts`; false: there are too few. */
static bool to_last(char plain[static PLAIN], size_t room, int stitches)
{
    if (room >= PLAIN)
        return false;
    if ((size_t)snprintf(plain, PLAIN, "to last %d sts", stitches) > room && (size_t)snprintf(plain, PLAIN, "to last %d", stitches) > room)
        return false;
    memset(plain + strlen(plain), ' ', room - strlen(plain));
    return true;
}

/* How many bytes of a line, from its `to marker` at `*to` up to the stitches behind it, `plain` stands for; 0: it has none. */
static size_t line_plain(const char *line, const char *end, struct places places, const char **to, char plain[static PLAIN])
{
    const char *behind, *slipped;
    int stitches;

    *to = places.first || places.last ? only_to(line, end) : NULL;
    if (!*to)
        return 0;
    behind = behind_to(*to);
    stitches = count_fixed(behind, end);
    slipped = behind_slipped(behind + strspn(behind, " \t,;."));
    behind = slipped ? slipped : behind;
    if (!stitches || (stitches != places.first && stitches != places.last))
        return 0;
    return to_last(plain, (size_t)(behind - *to), stitches) ? (size_t)(behind - *to) : 0;
}

const char *markers_plain(struct arena *arena, const char *text, size_t size)
{
    char *own = NULL, plain[PLAIN];
    struct places places = {0};

    for (size_t at = 0, length; at < size; at += length + 1) {
        const char *line = text + at, *to;
        size_t room;
        struct places here;

        length = words_line_within(line, size - at);
        if (length > WORDS_LINE)
            continue;
        if (prose_begins_cast_on(line))
            places = (struct places){0};
        room = line_plain(line, line + length, places, &to, plain);
        if (room) {
            own = own ? own : arena_copy(arena, text, size);
            memcpy(own + (to - text), plain, room);
        }
        here = places_on(line, line + length);
        places = here.first || here.last ? here : places;
    }
    return own ? own : text;
}
