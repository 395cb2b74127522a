/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with the numbers of its rows for the star that stands before them out:
 * `*Row 1: .. Row 2: .. Rep from * twice` repeats rows 1 and 2. */
#include "lang/starred.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "lang/words.h"

enum { LABEL = 16 };

/* Rows behind a star that begins a line. */
struct starred {
    size_t star;        /* where it stands, */
    int    first, last; /* rows; first 0: there is none open */
    size_t close;       /* a star at the end of the last row's line, that closes it; 0: none */
};

/* The last number of `Row 1`, `Rows 2-4`. */
static int last_number(const char *head)
{
    int last = 0;

    for (const char *at = words_next(head); isdigit((unsigned char)*at); at += strspn(at, " -")) {
        last = words_number(at);
        at += strspn(at, "0123456789");
    }
    return last;
}

/* The bytes of `Repeat from *`, `Rep from * to *` at a line's beginning; or 0. */
static size_t repeat_length(const char *line)
{
    const char *from = words_next(line), *at;

    if (!words_are(line, WORDS_AGAIN) || !words_is(from, "from"))
        return 0;
    at = words_next(from);
    at = words_is(at, "the") || words_is(at, "first") ? words_next(at) : at;
    if (*at != '*')
        return 0;
    at = words_skip_blanks(at + 1);
    if ((words_is(at, "to") || words_is(at, "through")) && *words_next(at) == '*')
        at = words_next(at) + 1;
    return (size_t)(at - line);
}

/* Where the star stands that ends a line without another; or 0. */
static size_t closing_star(const char *text, size_t line)
{
    size_t n = words_line_length(text + line);

    while (n > 0 && strchr(" \t.;", text[line + n - 1]))
        n--;
    return n > 1 && text[line + n - 1] == '*' && !memchr(text + line, '*', n - 1) ? line + n - 1 : 0;
}

/* `Rep from *` is `Rep r1-4`, `Rep from * to *` is `Rep r001 to 4`: the words that stay keep their places. */
static void put_repeat(char *text, const struct starred *rows, size_t line, size_t length)
{
    size_t from = line + words_length(text + line), end = line + length, to = from + strspn(text + from, " ") + strlen("from");
    bool closed = text[end - 1] == '*' && memchr(text + from, '*', length - (from - line) - 1);
    char label[LABEL];
    int n;

    from = to - strlen("from");
    n = closed ? snprintf(label, sizeof label, "r%03d", rows->first) : snprintf(label, sizeof label, "r%d-%d", rows->first, rows->last);
    if (n >= LABEL || from + (size_t)n >= end || (closed && (rows->last > 9 || (size_t)n > strlen("from"))))
        return;
    to = closed ? from + strcspn(text + from, "*") + 1 : end;
    memset(text + from, ' ', to - from);
    memcpy(text + from, label, (size_t)n);
    text[end - 1] = closed ? (char)('0' + rows->last) : text[end - 1];
    text[rows->star] = ' ';
    if (rows->close)
        text[rows->close] = ' ';
}

const char *starred_plain(struct arena *arena, const char *text, size_t size)
{
    struct starred rows = {0};
    char *own = NULL;

    for (size_t at = 0, line; at < size; at += words_line_length(text + at) + 1) {
        line = at + strspn(text + at, " \t");
        if (text[line] == '*' && words_row(text + line + 1)) {
            rows = rows.first ? (struct starred){.first = -1} : (struct starred){.star = line, .first = words_row(text + line + 1)};
            line++;
        }
        if (rows.first > 0 && words_row(text + line)) {
            rows.last = last_number(text + line);
            rows.close = closing_star(text, line);
        } else if (rows.first > 0 && rows.last && repeat_length(text + line)) {
            own = own ? own : arena_copy(arena, text, size);
            put_repeat(own, &rows, line, repeat_length(text + line));
            rows = (struct starred){0};
        }
    }
    return own ? own : text;
}
