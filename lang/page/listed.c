/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with numbers of rows for those of its list's steps out: of `1. Cast on 8`, `2. Knit 4 rows`,
 * `3. K2, p2`, `4. Repeat step 3 twice` the third is row 1, and step 3 is row 1. */
#include "lang/page/listed.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { MOST_STEPS = 99, NUMBER = 12 };

struct step {
    size_t at, end, text;   /* its number in the text, and what it says behind that */
    int    row;             /* the row it is; 0: the cast-on, several rows, a repeat */
};

struct list {
    struct step step[MOST_STEPS];
    int         n;
    bool        again;      /* another list follows, or rows with numbers of their own */
};

/* Where the number stands of a step that a line begins with, `2. `, `**2.** `, `Step 2: `. */
static struct step step_at(const char *text, size_t line)
{
    size_t at = line + strspn(text + line, " \t*"), end, behind;

    if (words_is(text + at, "step"))
        at = (size_t)(words_next(text + at) - text);
    end = at + strspn(text + at, "0123456789");
    behind = end + strspn(text + end, ".):");
    if (end == at || end - at > 2 || behind == end)
        return (struct step){0};
    behind += strspn(text + behind, "*") > 1 ? 2 : 0;
    return strchr(" \t", text[behind]) ? (struct step){at, end, behind + strspn(text + behind, " \t"), 0} : (struct step){0};
}

static bool is_cast_on(const char *text)
{
    return words_line_has(text, "cast") || words_line_has(text, "co");
}

/* `K2, p2 to end`, `Knit 1 row`; not `Knit 4 rows`, `k1, p1 for 4 rows`, `Repeat row 1`. */
static bool is_row(const char *text)
{
    const char *behind = words_behind_number(words_next(text));

    if (words_are(text, WORDS_AGAIN) || words_is(text, "as"))
        return false;
    if (words_are(text, WORDS_PLAIN) && behind && words_are_rows(behind))
        return words_number(words_next(text)) == 1 && prose_line_ends(words_next(behind) + strspn(words_next(behind), "."));
    return prose_stitches_follow(text) && !prose_row_count(text);
}

static struct list find_list(const char *text, size_t size)
{
    struct list list = {0};
    int rows = 0;

    for (size_t line = 0; line < size && !list.again; line += words_line_length(text + line) + 1) {
        struct step step = step_at(text, line);
        int number = step.end ? words_number(text + step.at) : 0;

        list.again = list.n && (words_row(words_skip_blanks(text + line)) || (step.end && words_row(text + step.text)));
        if (!number || (!list.n && (number > 1 || !is_cast_on(text + step.text))))
            continue;
        list.again |= number != list.n + 1 || number >= MOST_STEPS;
        step.row = list.n && is_row(text + step.text) ? ++rows : 0;
        list.step[list.n++] = step;
    }
    list.n = rows ? list.n : 0;
    return list;
}

/* Puts a number for another that is no shorter. */
static void put_number(char *text, size_t at, size_t end, int number)
{
    char plain[NUMBER];
    int n = snprintf(plain, sizeof plain, "%*d", (int)(end - at), number);

    memcpy(text + at, plain, (size_t)n);
}

/* The rows of the steps `2-3`, `2 and 3` behind `steps`, `rows`; false: one of them is no row. */
static bool put_named(char *text, size_t word, const struct list *list)
{
    size_t at = (size_t)(words_next(text + word) - text), end;

    for (; isdigit((unsigned char)text[at]); at = (size_t)(words_skip_blanks(text + end) - text)) {
        int number = words_number(text + at);

        end = at + strspn(text + at, "0123456789");
        if (number < 1 || number > list->n || !list->step[number - 1].row || end - at >= NUMBER)
            return false;
        put_number(text, at, end, list->step[number - 1].row);
        at = (size_t)(words_skip_blanks(text + end) - text);
        end = at + (words_is(text + at, "and") || words_is(text + at, "to") ? words_length(text + at) : strspn(text + at, ",-&"));
        if (end == at)
            break;      /* `repeat row 2 3 times` */
    }
    if (words_is(text + word, "steps"))
        memcpy(text + word, " rows", 5);
    else if (words_is(text + word, "step"))
        memcpy(text + word, " row", 4);
    return true;
}

/* The row of a step for its number, and of `Knit 1 row` its first word. */
static void put_row(char *text, const struct step *step)
{
    const char *number = words_next(text + step->text), *behind = words_behind_number(number);
    size_t word = words_line_start(text, step->at) + strspn(text + words_line_start(text, step->at), " \t*");

    if (words_is(text + word, "step"))
        memcpy(text + word, " Row", 4);
    put_number(text, step->at, step->end, step->row);
    if (behind && words_are_rows(behind))
        memset(text + (number - text), ' ', (size_t)(behind + words_length(behind) - number));
}

const char *listed_plain(struct arena *arena, const char *text, size_t size)
{
    struct list list = find_list(text, size);
    char *own;

    if (!list.n || list.again)
        return text;
    own = arena_copy(arena, text, size);
    for (size_t at = list.step[0].text, n; at < size; at += n ? n : 1) {
        bool named;

        n = words_length(own + at);
        named = (words_are_rows(own + at) || words_is(own + at, "step") || words_is(own + at, "steps")) && isdigit((unsigned char)*words_next(own + at));
        if (named && step_at(own, words_line_start(own, at)).text <= at && !put_named(own, at, &list))
            return text;
    }
    for (int i = 0; i < list.n; i++)
        if (list.step[i].row)
            put_row(own, &list.step[i]);
    return own;
}
