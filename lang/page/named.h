/* SPDX-License-Identifier: GPL-3.0-or-later
 * Patterns that a page calls by a name: "Box Stitch" above its rows, "work in Box Stitch" later on. */
#ifndef WEFT_NAMED_H
#define WEFT_NAMED_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/arena.h"

/* Where a name is mentioned, and where the first of its rows stands. */
struct named_mention {
    unsigned at, rows;
    bool works;         /* `in Box Stitch`, `work Box Stitch` */
};

/* The names of a page that are mentioned behind their rows. */
struct named {
    struct named_mention *mention;  /* in the order of the text */
    int nmentions, room;
    const unsigned *heading;        /* where each name stands above its rows */
    int nheadings;
};

/* The text, in as many bytes, with "in pattern" for the names of its rows behind them; where none is mentioned,
 * the text itself. */
const char *named_plain(struct arena *, const char *text, size_t size, struct named *);

/* Whether a name stands there above its rows. */
bool named_is_heading(const struct named *, size_t at);

/* Where the rows begin that are worked by their name between two places; 0: none are. `several`: names of others are, too. */
unsigned named_rows(const struct named *, unsigned start, unsigned end, bool *several);

#endif
