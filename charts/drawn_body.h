/* SPDX-License-Identifier: GPL-3.0-or-later
 * The stitches of a chart, drawn into a rectangle: the right side, row 1 at the
 * bottom. */
#ifndef WEFT_DRAWN_BODY_H
#define WEFT_DRAWN_BODY_H

#include "drawing/canvas.h"
#include "drawing/colours.h"
#include "lang/scene.h"

/* x, y is its upper left corner. */
struct drawn_box { double x, y, width, height; };

struct drawn_style {
    const struct palette *palette;  /* cells in its colours; NULL: black on white */
    bool                  symbols;  /* draw them; knit has none */
    enum purls            purls;
};

const struct palette *drawn_palette(enum dyes);

/* The whole grid, edge to edge in the box, without lines between cells.  Up to
 * some tens of thousands of marks are lines and areas; beyond that all is one
 * image of a few pixels a stitch. */
void drawn_body(cairo_t *, const struct scene *, struct drawn_box, const struct drawn_style *);

/* One stitch alone, as drawn_body draws it where there is room. */
void drawn_cell(cairo_t *, const struct scene *, stitch_id, struct drawn_box, const struct drawn_style *);

/* Pixels of a stitch's side in the image; 0: lines and areas. */
int drawn_pixels(const struct scene *, const struct drawn_style *);

#endif
