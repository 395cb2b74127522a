/* SPDX-License-Identifier: GPL-3.0-or-later
 * One row in words: runs folded, repeats found. */
#ifndef WEFT_ROW_H
#define WEFT_ROW_H

#include <stdbool.h>

#include "charts/dictionary.h"
#include "charts/text.h"
#include "lang/grid.h"

/* Where a row's words go and how. */
struct row_writer {
    struct text *text;
    const struct dictionary *words;
    const char  *indent;    /* of lines that go on */
    const char  *end;       /* of the row: `. (24 sts)` */
    int          column;    /* characters on the line so far */
    bool         open;      /* for any multiple of the width: the whole row is a repeat to the end */
    bool         begun;     /* the next item wants a comma before it */
};

/* Writes the row of n stitches in working order: `*k2, p2; rep from *
 * to last 2 sts, k2`. Breaks lines behind commas. */
void row_write(struct row_writer *, const stitch_id *worked, int n);

#endif
