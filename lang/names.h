/* SPDX-License-Identifier: GPL-3.0-or-later
 * Names: equal texts become one pointer; and the nearest name to a wrong one. */
#ifndef WEFT_NAMES_H
#define WEFT_NAMES_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/arena.h"

struct name_entry;

struct names {
    struct arena       *arena;
    struct name_entry **bucket;         /* (nbuckets), as many as names or more */
    size_t              nbuckets, n;
};

/* The one pointer that stands for this text; compare with ==. */
const char *names_intern(struct names *, const char *text, size_t length);

/* Of a noun the form for so many: one row, 2 rows. */
const char *names_count(long long n, const char *one, const char *many);

/* Widths as patterns have them: "8 + 5", or "4" where nothing is added. */
const char *names_multiple(struct arena *, long long of, long long plus);

/* A search for the candidate nearest to a word, upper and lower case alike:
 * offer each candidate, then read `best`, NULL where none is near. */
struct nearest {
    const char *word;
    const char *best;
    int         distance;       /* of the best; before: one more than is near */
    bool        turned;         /* only the same letters in another order are near */
};
struct nearest nearest_to(const char *word);
void nearest_offer(struct nearest *, const char *candidate);

/* The same over an array. */
const char *nearest_in(const char *word, const char *const *candidate, int n);

#endif
