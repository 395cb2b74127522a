/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with the numbers of its rows for the star that stands before them out:
 * `*Row 1: .. Row 2: .. Rep from * twice` repeats rows 1 and 2. */
#include "lang/page/starred.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { LABEL = 16, MOST_STARS = 3 };

/* Rows behind so many stars that begin a line. */
struct starred {
    size_t star;        /* where they stand, */
    int    first, last; /* rows; first 0: there is none open, -1: several begin so */
    size_t close;       /* as many stars at the end of the last row's line, which close it; 0: none */
    bool   repeated;    /* some were repeated behind the last of them */
};

static size_t count_stars(const char *text)
{
    return strspn(text, "*");
}

/* The last number of `Row 1`, `Rows 2-4`, `2nd row`. */
static int last_number(const char *head)
{
    int last = words_ordinal_length(head) ? words_row(head) : 0;

    for (const char *at = words_next(head); isdigit((unsigned char)*at); at += strspn(at, " -")) {
        last = words_number(at);
        at += strspn(at, "0123456789");
    }
    return last;
}

/* The bytes of `Repeat from *`, `Rep from ** to **` at a line's beginning, and the stars; 0: it is none, or a part of a
 * row, `rep from * to end`. */
static size_t repeat_length(const char *line, size_t *stars)
{
    static const char *const of_a_row[] = {"to", "across", "around", "all"};
    const char *from = words_next(line + (strncasecmp(line, "rep.", 4) == 0)), *at;

    if (!words_are(line, WORDS_AGAIN) || !words_is(from, "from"))
        return 0;
    at = words_next(from);
    *stars = count_stars(at);
    if (!*stars || *stars > MOST_STARS)
        return 0;
    at += *stars;
    from = words_skip_blanks(at);
    if ((words_is(from, "to") || words_is(from, "through")) && count_stars(words_next(from)) == *stars)
        at = words_next(from) + *stars;
    return words_find(words_skip_blanks(at), of_a_row, 4) < 0 && !words_are(words_skip_blanks(at), WORDS_END) ? (size_t)(at - line) : 0;
}

/* Where as many stars end a line; a single one where no other is on it. 0: nowhere. */
static size_t closing_stars(const char *text, size_t line, size_t stars)
{
    size_t n = words_line_length(text + line);

    while (n > 0 && strchr(" \t.;", text[line + n - 1]))
        n--;
    if (n <= stars || count_stars(text + line + n - stars) != stars || text[line + n - stars - 1] == '*')
        return 0;
    return stars > 1 || !memchr(text + line, '*', n - 1) ? line + n - stars : 0;
}

/* `Rep from *` is `Rep r1-4`, `Rep from ** to **` is `Rep r001 to 4`: the words that stay keep their places. */
static void put_repeat(char *text, const struct starred *rows, size_t line, size_t length, size_t stars)
{
    size_t from = line + words_length(text + line), end = line + length, mark;
    char label[LABEL];
    bool closed;
    int n;

    from += strspn(text + from, " .");
    mark = from + strcspn(text + from, "*");
    closed = mark + stars < end;
    if (rows->repeated || (closed && !rows->close))
        return;
    n = snprintf(label, sizeof label, closed ? "r%03d" : "r%d-%d", rows->first, rows->last);
    if (n >= LABEL || from + (size_t)n >= end || (closed && (rows->last > 9 * (stars > 1 ? 11 : 1) || (size_t)n > strlen("from"))))
        return;
    memset(text + from, ' ', mark + stars - from);
    memcpy(text + from, label, (size_t)n);
    if (closed) {
        memset(text + end - stars, ' ', stars);
        n = snprintf(label, sizeof label, "%d", rows->last);
        memcpy(text + end - n, label, (size_t)n);
    }
    memset(text + rows->star, ' ', stars);
    if (rows->close)
        memset(text + rows->close, ' ', stars);
}

/* Counts a row on; none that begins again, or that leaves out of account what was repeated before it. */
static void count_on(struct starred *rows, const char *text, size_t head, size_t line, size_t stars)
{
    int number = words_row(text + head);

    if (number <= rows->last || (rows->repeated && number == rows->last + 1)) {
        *rows = (struct starred){.first = -1};
        return;
    }
    rows->last = last_number(text + head);
    rows->repeated = false;
    rows->close = closing_stars(text, line, stars);
}

/* What a line says of the rows behind so many stars; where other work is among them, their numbers are not all of it. */
static void read_line(struct starred *rows, const char *text, size_t line, size_t stars)
{
    size_t head = line + count_stars(text + line);

    head += strspn(text + head, " ");
    if (count_stars(text + line) == stars && words_row(text + head) && (stars > 1 || head == line + 1))
        *rows = rows->first ? (struct starred){.first = -1} : (struct starred){.star = line, .first = words_row(text + head)};
    if (rows->first <= 0 || rows->close)
        return;
    if (words_row(text + head))
        count_on(rows, text, head, line, stars);
    else if (words_are(text + line, WORDS_AGAIN))
        rows->repeated = true;
    else if (prose_statement_follows(text + line))
        *rows = (struct starred){.first = -1};
}

const char *starred_plain(struct arena *arena, const char *text, size_t size)
{
    struct starred rows[MOST_STARS + 1] = {0};
    char *own = NULL;

    for (size_t at = 0, line, stars; at < size; at += words_line_length(text + at) + 1) {
        size_t length;

        line = at + strspn(text + at, " \t");
        length = repeat_length(text + line, &stars);
        if (!length || rows[stars].first <= 0 || !rows[stars].last) {
            for (stars = 1; stars <= MOST_STARS; stars++)
                read_line(&rows[stars], text, line, stars);
            continue;
        }
        own = own ? own : arena_copy(arena, text, size);
        put_repeat(own, &rows[stars], line, length, stars);
        rows[stars] = (struct starred){0};
    }
    return own ? own : text;
}
