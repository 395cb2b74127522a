/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with "pattern" for the name it gave to its rows out. */
#include "lang/named.h"

#include "lang/headings.h"
#include "lang/prose.h"
#include "lang/words.h"

enum { LONGEST_NAME = 40, LINES_BETWEEN = 3 };

/* A name's words but the last ones that say it is a pattern's: `Box` of `Box Stitch`. */
struct name {
    const char *text;
    size_t      length;
};

static const char *const of_patterns[] = {"st", "sts", "stitch", "pattern", "patt", "pat"};

static bool is_of_patterns(const char *text)
{
    return words_find(text, of_patterns, sizeof of_patterns / sizeof *of_patterns) >= 0;
}

static const char *next_line(const char *text)
{
    text += words_line_length(text);
    return text + strspn(text, " \t\r\n");
}

/* "Row 1", "Rnd 1:", "Rows 1 and 3", "1st row", "R1". */
static bool is_row_1(const char *text)
{
    const char *number = text + words_length(text);

    if (!strchr("rR1", *text))
        return false;
    if (strncasecmp(text, "1st ", 4) == 0)
        return words_are_rows(text + 4);
    number += words_are_rows(text) ? strspn(number, " \t") : 0;
    return (words_are_rows(text) || words_is(text, "r")) && *number == '1' && !isdigit((unsigned char)number[1]);
}

/* What may stand between a name and its rows. */
static bool is_about_rows(const char *text)
{
    static const char *const word[] = {"multiple", "mult", "worked", "work", "any", "note"};

    return *text == '(' || (strchr("mMwWaAnN", *text) && words_find(text, word, sizeof word / sizeof *word) >= 0);
}

static bool rows_follow(const char *line)
{
    const char *next = next_line(line);

    for (int i = 0; i < LINES_BETWEEN && is_about_rows(next); i++)
        next = next_line(next);
    return is_row_1(next);
}

/* The name that a line is, up to a bracket, a colon or a dash. */
static struct name name_of(const char *line)
{
    size_t length = strcspn(line, "(:\r\n"), end = 0, heading;

    if (length > LONGEST_NAME || prose_row_word(line) || headings_find(line, &heading) || !isalpha((unsigned char)*line))
        return (struct name){NULL, 0};
    for (size_t at = 0; at < length && isalpha((unsigned char)line[at]); at += strspn(line + at, " '-")) {
        size_t word = words_length(line + at);

        end = is_of_patterns(line + at) ? end : at + word;
        at += word;
    }
    return (struct name){line, end};
}

/* The name of the text's rows; no text: it has none, or rows 1 twice. */
static struct name find_name(const char *text)
{
    struct name name = {NULL, 0};
    int rows = 0;

    for (const char *line = text + strspn(text, " \t\r\n"); *line; line = next_line(line)) {
        rows += is_row_1(line);
        if (rows == 0 && !is_about_rows(line) && rows_follow(line))
            name = name_of(line);
    }
    return rows == 1 && name.length ? name : (struct name){NULL, 0};
}

/* How long the name, and what says that it is a pattern's, is at a place; or 0. */
static size_t named_length(struct name name, const char *text)
{
    size_t n = name.length;

    if (strncasecmp(text, name.text, n) != 0 || isalnum((unsigned char)text[n]))
        return 0;
    for (const char *next; next = words_skip_blanks(text + n), is_of_patterns(next);)
        n = (size_t)(next - text) + words_length(next);
    return n;
}

/* What the name is to be at a place of the text from `first` on: behind `in` or `of` the pattern, behind `work`
 * nothing before its rows, and else `in patt`. NULL: the word is no mention. */
static const char *plain_at(const char *first, const char *at, size_t length)
{
    size_t before = (size_t)(at - first);

    while (before > 0 && first[before - 1] == ' ')
        before--;
    if (before > 4 && strncasecmp(first + before - 4, " the", 4) == 0)
        before -= 4;
    if (before < 3 || before == (size_t)(at - first))
        return NULL;
    if (strncasecmp(first + before - 3, " in", 3) == 0 || strncasecmp(first + before - 3, " of", 3) == 0)
        return length >= strlen("pattern") ? "pattern" : length >= strlen("pat") ? "pat" : NULL;
    if (before < 4 || strncasecmp(first + before - 4, "work", 4) != 0)
        return NULL;
    return words_are_rows(words_skip_blanks(at + length)) ? "" : length >= strlen("in patt") ? "in patt" : NULL;
}

const char *named_plain(struct arena *arena, const char *text, size_t size)
{
    struct name name = find_name(text);
    char *plain = NULL;

    if (!name.length)
        return text;
    for (const char *at = name.text + name.length; *at; at += words_length(at) ? words_length(at) : 1) {
        size_t length = named_length(name, at);
        const char *wording = length ? plain_at(name.text, at, length) : NULL;

        if (!wording)
            continue;
        plain = plain ? plain : arena_copy(arena, text, size);
        memset(plain + (at - text), ' ', length);
        memcpy(plain + (at - text), wording, strlen(wording));
    }
    return plain ? plain : text;
}
