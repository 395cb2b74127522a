/* SPDX-License-Identifier: GPL-3.0-or-later
 * A table of phrases, and which of them stands at a place of a text.  A large
 * file is looked through word by word: each is looked up once. */
#ifndef WEFT_PHRASES_H
#define WEFT_PHRASES_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/arena.h"

/* Words are separated by one blank, for any blanks or a line end of the text. `a|b`: one of
 * them; `?` behind: or nothing; `#`: a number, `~` the sign #, `$` a stitch with its figures, `k2`; `=` before: stays as it is, the others make
 * room for the plain wording. `@` begins a phrase that stands behind a stitch: knit, p; `<` one
 * that stands on one line; `^` one that begins a line, `!` a sentence, `>` a sentence before a row's stitches. Each `#` of
 * the plain wording is the number of the phrase; it may be a line end. */
struct phrase {
    const char *words, *plain;
};

enum { PHRASE_WORDS = 16 };

/* Where the words of a phrase stand in the text. */
struct found {
    int n;
    size_t start[PHRASE_WORDS], end[PHRASE_WORDS];
    bool stays[PHRASE_WORDS];
};

struct phrases *phrases_read(struct arena *, const struct phrase *, int n);

/* The first phrase, from a number on, whose words stand at a place where a word begins; -1: none. */
int phrases_find(struct phrases *, const char *text, size_t at, int from, struct found *);

/* Whether a line ends within a phrase; whether a word of it goes, or such an end. */
bool phrases_break(const char *text, const struct found *);
bool phrases_change(const char *text, const struct found *);

/* Puts the plain wording where the first word is that goes; false: there is no room. */
bool phrases_put(char *text, const struct found *, const char *plain);

/* Behind blanks and at most one line end. */
size_t phrases_skip(const char *text, size_t at);

#endif
