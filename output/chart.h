/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts as text: a stitch grid in, lines of letters out. */
#ifndef WEFT_CHART_H
#define WEFT_CHART_H

#include "lang/scene.h"
#include "output/file.h"

/* The K/P grid, for programs: a header "# 1 1", then for each row, the bottom
 * one first, a line of stitch names with blanks between them. */
void chart_grid(struct file *file, const struct scene *scene);

/* The chart as printed for knitters: the right side, top row first, each
 * stitch by its symbol, row numbers at the right of right-side (odd) rows and
 * of rounds, at the left of wrong-side rows. */
void chart_text(struct file *file, const struct scene *scene);

#endif
