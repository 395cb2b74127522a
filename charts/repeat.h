/* SPDX-License-Identifier: GPL-3.0-or-later
 * The smallest piece of a grid that gives the whole of it when it is repeated. */
#ifndef WEFT_REPEAT_H
#define WEFT_REPEAT_H

#include "lang/grid.h"

struct repeat { int columns, rows; };

/* Each side on its own: the smallest p for which every line equals the p-th from
 * it, where two of them find room; else the grid's own side.  What is left over
 * beside whole repeats is the beginning of one more. */
struct repeat repeat_of(const struct grid *);

#endif
