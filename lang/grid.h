/* SPDX-License-Identifier: GPL-3.0-or-later
 * The stitch grid: what the right side of the fabric shows, and its algebra. */
#ifndef WEFT_GRID_H
#define WEFT_GRID_H

#include <stdbool.h>
#include <stddef.h>

struct arena;

/* Index into the scene's table of stitches. K and P exist from the start. */
typedef unsigned char stitch_id;
enum { STITCH_K = 0, STITCH_P = 1, STITCH_MAX = 250 };

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

/* The algebra: new grids from old ones.  Sizes are the caller's to check: every
 * result has at least one stitch and at most INT_MAX of them.  `ws` names, for
 * each stitch, what it shows from the other side (K <-> P). */
struct grid *grid_new(struct arena *, int columns, int rows, stitch_id **cell);
struct grid *grid_constant(struct arena *, int columns, int rows, stitch_id);

/* columns x rows copies. */
struct grid *grid_tile(struct arena *, const struct grid *, int columns, int rows);

/* A window of the grid repeated without end; (x, y) may lie anywhere. */
struct grid *grid_window(struct arena *, const struct grid *, long long x, long long y, int columns, int rows);

/* Columns at .. at+period-1 taken n times, all others once. */
struct grid *grid_stretch(struct arena *, const struct grid *, int at, int period, int n);

/* Left to right, of one height; bottom to top, of one width. */
struct grid *grid_beside(struct arena *, const struct grid *const *part, int nparts);
struct grid *grid_above(struct arena *, const struct grid *const *part, int nparts);

struct grid *grid_mirror(struct arena *, const struct grid *);                      /* left <-> right */
struct grid *grid_flip(struct arena *, const struct grid *);                        /* top <-> bottom */
struct grid *grid_invert(struct arena *, const struct grid *, const stitch_id *ws); /* knit <-> purl */
struct grid *grid_turn(struct arena *, const struct grid *, const stitch_id *ws);   /* the wrong side's view */
struct grid *grid_rotate(struct arena *, const struct grid *);                      /* by half a turn */

/* Rows and columns pushed out on one side come back on the other. */
struct grid *grid_shift(struct arena *, const struct grid *, long long dx, long long dy);

/* `part` laid over `ground`, its lower left stitch at (x, y); it fits inside. */
struct grid *grid_inset(struct arena *, const struct grid *part, const struct grid *ground, int x, int y);

long long grid_count(const struct grid *, stitch_id);
bool grid_equal(const struct grid *, const struct grid *);

#endif
