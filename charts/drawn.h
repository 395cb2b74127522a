/* SPDX-License-Identifier: GPL-3.0-or-later
 * A chart as knitting books print it: a scene in, a drawing out. */
#ifndef WEFT_DRAWN_H
#define WEFT_DRAWN_H

#include "drawing/canvas.h"
#include "lang/scene.h"

/* NULL, or why the chart cannot be drawn in that format: too many pixels. */
const char *drawn_refusal(const struct scene *, const struct chart_look *, enum canvas_format);

/* The right side of the fabric, row 1 at the bottom: title, cells with their
 * symbols, numbers of rows on the side where they begin (odd ones right, even
 * ones left; all right in the round), of stitches from the right, a box around
 * the repeat in the lower right corner, a key.  NULL, or what went wrong; then
 * the bytes are not a complete file. */
const char *drawn_chart(const struct scene *, const struct chart_look *, enum canvas_format, canvas_sink *, void *self);

#endif
