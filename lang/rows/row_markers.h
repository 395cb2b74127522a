/* SPDX-License-Identifier: GPL-3.0-or-later
 * Markers that hang between stitches: `k3, pm, k6, pm, k3`, and rows worked `to marker`. */
#ifndef WEFT_ROW_MARKERS_H
#define WEFT_ROW_MARKERS_H

#include "lang/limits.h"
#include "lang/rows/rows.h"

/* Where they hang: stitches from the right edge, ascending, each place once. */
struct markers {
    int at[LIMIT_MARKERS];      /* (n) */
    int n;
};

/* A row in work: so many stitches, from this side. `round`: behind the last stitch hangs one, too. */
struct marked_row { const struct row_text *text; int width; enum side side; bool round; };

/* Whether a list of work has to do with markers. */
bool work_has_marker(const struct work *);

/* The row's work with the stitches left for each `to marker`; NULL, with a message, where none hangs ahead, or not there. */
struct work *markers_reached(struct diag *, const struct markers *, struct marked_row);

/* Hangs and takes away what the row does; its work has its times. False, with a message, past the limit. */
bool markers_worked(struct diag *, struct markers *, struct marked_row);

#endif
