/* SPDX-License-Identifier: GPL-3.0-or-later
 * Names that a page gives to rows: `Box Stitch` above them, `Rice Stitch: k1, *p1, k1; rep from *`. */
#ifndef WEFT_DEFINITIONS_H
#define WEFT_DEFINITIONS_H

#include <stdbool.h>
#include <stddef.h>

/* A name, and its first row. */
struct definition {
    const char *text;
    size_t      length;     /* without the last words that say it is a pattern's: `Box` of `Box Stitch`; 0: none */
    const char *rows;       /* where that row's head stands, or will be put, */
    const char *stitches;   /* and what is behind this head; NULL: it has its number */
    bool        figures;
    bool        part;       /* `Border`: of the piece, which is repeated and not a pattern to work in */
    bool        beside;     /* the rows are on the line of the name, or have no head: the name gives it room */
};

/* The one that a line begins with. */
struct definition definitions_read(const char *line);

/* Puts what stands plainly for the heads of its rows into a copy of the text, from the name on. */
void definitions_put(const struct definition *, char *copy);

/* `st`, `pattern`: says of a name that it is a pattern's. */
bool definitions_is_of_pattern(const char *text);

/* The next line that is not blank. */
const char *definitions_next_line(const char *text);

#endif
