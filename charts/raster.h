/* SPDX-License-Identifier: GPL-3.0-or-later
 * A grid in the making: stitches row by row, checked for one width and the limits. */
#ifndef WEFT_RASTER_H
#define WEFT_RASTER_H

#include <stdbool.h>

#include "charts/pattern.h"
#include "lang/diag.h"

struct raster {
    struct arena *arena;
    struct diag  *diag;
    stitch_id    *cell;         /* (ncells), in reading order */
    size_t        ncells;
    int           room;
    int           width;        /* of the first row; 0 before it */
    int           rows;         /* complete */
    int           here;         /* stitches of the row being read */
    struct span   first;        /* the first row */
    struct span   blank;        /* an empty line behind the rows so far; no source: none */
    struct span   excess;       /* the first stitch past the width in this row */
};

/* One more stitch of the row, from left to right; false past the limit. */
bool raster_stitch(struct raster *, stitch_id, struct span);

/* The row is complete, or given up after an error in it. */
void raster_row(struct raster *, struct span line);
void raster_give_up(struct raster *);

/* An empty line: an error only if a row follows. */
void raster_blank(struct raster *, struct span line);
void raster_row_follows(struct raster *);

/* The grid; NULL if there were errors or no row. */
enum raster_order { RASTER_BOTTOM_FIRST, RASTER_TOP_FIRST };
const struct grid *raster_grid(struct raster *, const struct source *, enum raster_order);

/* "the character 'x'", "the byte 0x00": what stands at a span, for a message. */
const char *raster_mark(struct arena *, struct span);

/* The character at a byte, to the end of its UTF-8 sequence. */
struct span raster_character(const struct source *, size_t at, size_t end);

#endif
