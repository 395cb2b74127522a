/* SPDX-License-Identifier: GPL-3.0-or-later
 * A row in working order into the grid: sides turned, stitches of a fabric by what is below. */
#ifndef WEFT_ROW_DRAW_H
#define WEFT_ROW_DRAW_H

#include "lang/rows/rows.h"

/* Where a row is drawn. */
struct row_place {
    int              width;
    enum side        side;
    bool             round, first;      /* first: nothing is below */
    bool             front;             /* of a loom: from the right side, though it runs the other way */
    const stitch_id *ws;                /* of each stitch its other face */
};

/* Whether there must be a row below: `knit the knits`. */
bool row_draw_asks_below(const stitch_id *worked, int width);

/* Draws (width) stitches as the right side shows them; the row below lies before `cell`. True where they are
 * the same wherever they stand on this side. */
bool row_draw(stitch_id *cell, const stitch_id *worked, struct row_place);

#endif
