/* SPDX-License-Identifier: GPL-3.0-or-later
 * The stitch grid: what the right side of the fabric shows, and its algebra. */
#ifndef WEFT_GRID_H
#define WEFT_GRID_H

#include <stddef.h>

struct arena;

/* Index into the scene's table of stitches. K and P exist from the start. */
typedef unsigned char stitch_id;
enum { STITCH_K = 0, STITCH_P = 1, STITCH_MAX = 255 };

/* A fabric as seen from its right side: row 0 is the bottom (the first worked
 * row), column 0 the left edge. Immutable once made; lives in an arena. */
struct grid {
    int              columns;
    int              rows;
    const stitch_id *cell;      /* (rows x columns), row-major, bottom row first */
};

static inline stitch_id grid_at(const struct grid *g, int column, int row)
{
    return g->cell[(size_t)row * (size_t)g->columns + (size_t)column];
}

#endif
