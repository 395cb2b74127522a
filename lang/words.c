/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; what the words there count or say how many, out. */
#include "lang/words.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

bool words_are_rows(const char *text)
{
    static const char *const word[] = {"row", "rows", "round", "rounds", "rnd", "rnds", "rd", "rds"};

    return (*text == 'r' || *text == 'R') && words_find(text, word, sizeof word / sizeof *word) >= 0;
}

bool words_are_stitches(const char *text)
{
    static const char *const word[] = {"st", "sts", "stitch", "stitches"};

    return words_find(text, word, sizeof word / sizeof *word) >= 0;
}

/* A number in letters; 0: none. */
static int number_in_letters(const char *text)
{
    static const char *const word[] = {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};

    return 1 + words_find(text, word, sizeof word / sizeof *word);
}

int words_number(const char *text)
{
    return isdigit((unsigned char)*text) ? (int)fmin(strtod(text, NULL), INT_MAX) : number_in_letters(text);
}

const char *words_behind_number(const char *text)
{
    static const char *const ordinal[] = {"st", "nd", "rd", "th"};
    size_t digits = strspn(text, "0123456789");

    if (digits)
        return words_find(text + digits, ordinal, 4) < 0 ? words_skip_blanks(text + digits) : NULL;
    return number_in_letters(text) ? words_skip_blanks(text + words_length(text)) : NULL;
}

bool words_line_is_long(struct words_line *line, const char *text, size_t at)
{
    if (at < line->start || at >= line->end)
        *line = (struct words_line){words_line_start(text, at), at + words_line_length(text + at)};
    return line->end - line->start > WORDS_LINE && at < line->end;
}

bool words_are_page(const char *text, size_t size)
{
    size_t looks = 0;

    for (size_t at = 0, line; size <= WORDS_PAGE && at < size; at += line + 1) {
        line = words_line_length(text + at);
        looks += line > WORDS_LINE ? 0 : line * line;
    }
    return size <= WORDS_PAGE && looks <= WORDS_LOOKS;
}

int words_depth(const char *text, size_t length, int depth)
{
    if (!memchr(text, '{', length) && !memchr(text, '}', length))
        return depth;
    for (size_t i = 0; i < length; i++)
        depth += text[i] == '{' ? 1 : text[i] == '}' && depth > 0 ? -1 : 0;
    return depth;
}

size_t words_skip_quoted(const char *text, size_t at)
{
    bool inches = at > 0 && isdigit((unsigned char)text[at - 1]);
    size_t length = inches ? 0 : strcspn(text + at + 1, "\"\r\n");

    return inches || text[at + 1 + length] != '"' ? at + 1 : at + length + 2;
}
