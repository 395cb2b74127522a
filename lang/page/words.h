/* SPDX-License-Identifier: GPL-3.0-or-later
 * Words of a text, as a knitter writes them: letters alone, upper or lower case. */
#ifndef WEFT_WORDS_H
#define WEFT_WORDS_H

#include <ctype.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include <strings.h>

/* The letters a text begins with. */
static inline size_t words_length(const char *text)
{
    size_t n = 0;

    while (isalpha((unsigned char)text[n]))
        n++;
    return n;
}

static inline const char *words_skip_blanks(const char *text)
{
    return text + strspn(text, " \t\f\v");
}

/* Behind the first word and its blanks. */
static inline const char *words_next(const char *text)
{
    return words_skip_blanks(text + words_length(text));
}

/* Bytes of a stitch with its figure, `k2`, that a text begins with; 0: it begins otherwise. */
static inline size_t words_stitch_length(const char *text)
{
    size_t n = 1;

    if ((*text | 0x20) != 'k' && (*text | 0x20) != 'p')
        return 0;
    while (text[n] >= '0' && text[n] <= '9')
        n++;
    return n > 1 ? n : 0;
}

/* Commas and blanks between stitches. */
static inline size_t words_gap_length(const char *text)
{
    size_t n = 0;

    while (text[n] == ',' || text[n] == ' ')
        n++;
    return n;
}

/* The number of the word of a list that a text begins with; -1: none. */
static inline int words_find(const char *text, const char *const *word, int n)
{
    size_t length = words_length(text);

    for (int i = 0; i < n; i++)
        if (((*word[i] ^ *text) & 0xDF) == 0 && strlen(word[i]) == length && strncasecmp(text, word[i], length) == 0)
            return i;
    return -1;
}

static inline bool words_is(const char *text, const char *word)
{
    return words_find(text, &word, 1) == 0;
}

/* The name a text begins with: letters and underscores. */
static inline size_t words_name_length(const char *text)
{
    size_t n = 0;

    while (isalpha((unsigned char)text[n]) || text[n] == '_')
        n++;
    return n;
}

static inline bool words_is_name(const char *text, const char *name)
{
    size_t length = words_name_length(text);

    return strlen(name) == length && strncasecmp(text, name, length) == 0;
}

/* Where the word begins that stands before a place, over blanks; where none does, these begin. */
static inline size_t words_before(const char *text, size_t at)
{
    while (at > 0 && text[at - 1] == ' ')
        at--;
    while (at > 0 && isalpha((unsigned char)text[at - 1]))
        at--;
    return at;
}

/* The sign before a place, over others; '\n': a line begins there.  `\n.:` are signs that a sentence begins behind. */
static inline char words_sign_before(const char *text, size_t at, const char *over)
{
    while (at > 0 && strchr(over, text[at - 1]))
        at--;
    return at == 0 || text[at - 1] == '\r' ? '\n' : text[at - 1];
}

/* ---- on a line ---- */

enum {
    WORDS_PAGE = 1000000,   /* bytes of the longest page, */
    WORDS_LOOKS = 500000000,/* looks at them, from each place of a line at the whole line, */
    WORDS_LINE = 4000,      /* and of its longest line; what is beyond them was written by a program */
    WORDS_REACH = 1000,     /* how far it is looked for a word that changes what stands before it, */
    WORDS_MARGIN = 200      /* and through blanks and marks for the line's beginning */
};

static inline bool words_ends_line(char c)
{
    return c == '\n' || c == '\r';
}

static inline size_t words_line_length(const char *text)
{
    return strcspn(text, "\r\n");
}

/* The same, or `most`. */
static inline size_t words_line_within(const char *text, size_t most)
{
    size_t n = 0;

    while (n < most && text[n] && !words_ends_line(text[n]))
        n++;
    return n;
}

/* Whether one of the signs stands on it. */
static inline bool words_line_has_sign(const char *text, const char *signs)
{
    size_t line = words_line_length(text);

    for (; *signs; signs++)
        if (memchr(text, *signs, line))
            return true;
    return false;
}

/* Where the line begins that a place is on. */
static inline size_t words_line_start(const char *text, size_t at)
{
    while (at > 0 && !words_ends_line(text[at - 1]))
        at--;
    return at;
}

static inline bool words_line_has(const char *text, const char *word)
{
    for (size_t i = 0; i < WORDS_REACH && text[i] && !words_ends_line(text[i]); i++)
        if ((text[i] | 0x20) == *word && (i == 0 || !isalpha((unsigned char)text[i - 1])) && words_is(text + i, word))
            return true;
    return false;
}

/* A line that a text is read through by. */
struct words_line {
    size_t start, end;
};

/* Whether a place is on a line longer than those of pages: what these may say is not looked for there. */
bool words_line_is_long(struct words_line *, const char *text, size_t at);

/* Whether a text is as much as a page has: what is more was written by a program, and is read as it is written. */
bool words_are_page(const char *text, size_t size);

/* How many braces are open behind so many bytes, of `depth` before them. */
int words_depth(const char *text, size_t length, int depth);

/* ---- what they mean ---- */

/* Classes of the words of work; a word may be of several. */
enum words_class {
    WORDS_ROW    = 1 << 0,  /* row, rnds */
    WORDS_STITCH = 1 << 1,  /* st, stitches */
    WORDS_PLAIN  = 1 << 2,  /* k, knit, p, purl */
    WORDS_WORK   = 1 << 3,  /* work */
    WORDS_AGAIN  = 1 << 4,  /* rep, repeat */
    WORDS_SIDE   = 1 << 5,  /* rs, ws */
    WORDS_EVERY  = 1 << 6,  /* every, each, all */
    WORDS_TIMES  = 1 << 7,  /* time, times */
    WORDS_OFTEN  = 1 << 8,  /* once, twice, thrice */
    WORDS_END    = 1 << 9,  /* end, ends, ending, finish, finishing */
    WORDS_CAST   = 1 << 10, /* cast, co */
    WORDS_GO_ON  = 1 << 11, /* cont, continue */
    WORDS_FABRIC = 1 << 12, /* garter, seed, rib */
    WORDS_NUMBER = 1 << 13, /* one to twelve */
    WORDS_NTH    = 1 << 14, /* first to twelfth */
    WORDS_THEN   = 1 << 15, /* then, now */
    WORDS_BIND   = 1 << 16, /* bind, bo */
    WORDS_PART   = 1 << 17, /* border, body, hem: a part of a piece */

    /* what a row's text has, and a remark has not */
    WORDS_OF_ROW = WORDS_PLAIN | WORDS_AGAIN | WORDS_ROW | WORDS_SIDE | WORDS_TIMES | WORDS_OFTEN
};

/* Those of the word a text begins with; 0: it is none. */
unsigned words_class(const char *text);

/* The number that `one`, `first`, `once` says; 0: another word. */
int words_value(const char *text);

static inline bool words_are(const char *text, unsigned classes)
{
    return words_class(text) & classes;
}

static inline bool words_are_rows(const char *text)
{
    return (*text | 0x20) == 'r' && words_are(text, WORDS_ROW);
}

static inline bool words_are_stitches(const char *text)
{
    return (*text | 0x20) == 's' && words_are(text, WORDS_STITCH);
}

/* Bytes of `1st`, `3rd`; or 0. */
size_t words_ordinal_length(const char *text);

/* The length of the first of the words a|b|c that stands in the text; 0: none does. */
size_t words_one_of(const char *list, const char *text);

/* Whether one of them stands between two places. */
bool words_any_of(const char *list, const char *text, size_t start, size_t end);

/* Behind blanks and words of a list a|b|c. */
const char *words_skip_any(const char *text, const char *list);

/* Behind a text in quotes that begins at a place; inches are none. */
size_t words_skip_quoted(const char *text, size_t at);

/* A number in figures or, up to twelve, in letters; 0: there is none. */
int words_number(const char *text);

/* The number of the row whose head a text begins with, `Row 1`, `Rnds 1-4`, `Row one`, `1st row`, `R1`; 0: it begins otherwise. */
int words_row(const char *text);

/* Behind a number in figures or in letters; or NULL. */
const char *words_behind_number(const char *text);

#endif
