/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a chart file holds: a grid of knit and purl and how often it is repeated. */
#ifndef WEFT_PATTERN_H
#define WEFT_PATTERN_H

#include "lang/grid.h"

struct pattern {
    const struct grid *grid;        /* one repeat; K and P alone */
    int                across, up;  /* repeats, >= 1 each */
    const char        *words;       /* the pattern as a script already; NULL: only the grid */
    const char        *remark;      /* what was taken for what, to be said; NULL: nothing */
};

#endif
