/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with numbers for its rows' letters out: `Row A:` is row 1, and rows 1b, 2b, 3b that
 * follow each other are rows 1 to 3 of a part of their own. */
#include "lang/page/lettered.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/words.h"

enum { MOST_HEADS = 200, LETTERS = 9 };

/* `3b`; without a figure: number 0. */
struct label {
    size_t at, end;     /* in the text; end 0: none stands there */
    int    number;
    char   letter;
};

/* The labels of rows' heads, in the order of the text. */
struct heads {
    struct label head[MOST_HEADS];
    int          n;
    bool         alone;     /* `Row A`, no figures */
};

static struct label label_at(const char *text, size_t at)
{
    size_t digits = strspn(text + at, "0123456789"), letter = at + digits;
    bool alone = isalpha((unsigned char)text[letter]) && !isalnum((unsigned char)text[letter + 1]);

    if (!alone || digits > 4 || (!digits && !isupper((unsigned char)text[letter])))
        return (struct label){0};
    return (struct label){at, letter + 1, digits ? words_number(text + at) : 0, (char)tolower((unsigned char)text[letter])};
}

/* The label of the row whose head a line begins with. */
static struct label head_of(const char *text, size_t line)
{
    size_t at = line + strspn(text + line, " \t*-");
    struct label label = words_are_rows(text + at) ? label_at(text, (size_t)(words_next(text + at) - text)) : (struct label){0};

    return label.end && strchr(":.(-", *words_skip_blanks(text + label.end)) && *words_skip_blanks(text + label.end) ? label : (struct label){0};
}

/* Whether the labels count on: A, B, C; or 1b, 2b, 3b and then another letter from a number of its own on. */
static bool count_on(const struct heads *heads)
{
    bool row_2 = heads->alone && heads->n > 1;

    for (int i = 0; i < heads->n; i++) {
        const struct label *head = &heads->head[i], *before = i ? head - 1 : NULL;

        if ((head->number == 0) != heads->alone || (heads->alone && head->letter != 'a' + i))
            return false;
        for (int j = 0; j + 1 < i && !heads->alone; j++)
            if (heads->head[j].letter == head->letter && before->letter != head->letter)
                return false;
        if (before && before->letter == head->letter && head->number != before->number + 1)
            return false;
        row_2 |= head->number == 2;
        if (!heads->alone && (!before || before->letter != head->letter) && head->number != 1)
            return false;
    }
    return row_2 && (!heads->alone || heads->n <= LETTERS);
}

static struct heads find_heads(const char *text, size_t size)
{
    struct heads heads = {0};

    for (size_t line = 0; line < size && heads.n < MOST_HEADS; line += words_line_length(text + line) + 1) {
        struct label label = head_of(text, line);

        if (label.end)
            heads.head[heads.n++] = label;
    }
    heads.alone = heads.n > 0 && heads.head[0].number == 0;
    return heads;
}

/* The labels that begin at a place, `1b and 2b`, `A-C`, plainly where they are of the part worked there. */
static size_t put_labels(char *text, size_t at, const struct heads *heads, char letter)
{
    for (struct label label; label = label_at(text, at), label.end; at = (size_t)(words_skip_blanks(text + at) - text)) {
        if (heads->alone && label.number == 0 && label.letter - 'a' < heads->n)
            text[label.at] = (char)('1' + label.letter - 'a');
        else if (!heads->alone && label.number && label.letter == letter)
            text[label.end - 1] = ' ';
        at = (size_t)(words_skip_blanks(text + label.end) - text);
        at += words_is(text + at, "and") || words_is(text + at, "to") ? words_length(text + at) : strspn(text + at, ",-&");
    }
    return at;
}

const char *lettered_plain(struct arena *arena, const char *text, size_t size)
{
    struct heads heads = find_heads(text, size);
    int part = 0;
    char *own;

    if (!count_on(&heads))
        return text;
    own = arena_copy(arena, text, size);
    for (size_t at = words_line_start(text, heads.head[0].at); at < size;) {
        size_t n = words_length(own + at), next = at + (n ? n : 1);

        while (part + 1 < heads.n && heads.head[part + 1].at <= at + n + 1)
            part++;
        if (words_are_rows(own + at))
            next = put_labels(own, (size_t)(words_next(own + at) - own), &heads, heads.head[part].letter);
        at = next > at ? next : at + 1;
    }
    return own;
}
