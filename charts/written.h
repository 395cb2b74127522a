/* SPDX-License-Identifier: GPL-3.0-or-later
 * Written instructions of a grid: equal rows named together, repeats of rows found. */
#ifndef WEFT_WRITTEN_H
#define WEFT_WRITTEN_H

#include <stdbool.h>

#include "charts/dictionary.h"
#include "charts/text.h"
#include "lang/grid.h"

struct written_style {
    const struct dictionary *words;
    bool        round;      /* worked in the round: every row from the right side */
    bool        ws_first;   /* the first row from the wrong side */
    bool        open;       /* rows for any multiple of the width, without their count */
    bool        uncounted;  /* rows without `(22 sts)` */
    const char *indent;     /* of every line */
};

/* A whole pattern, from `Multiple of` (where the words fit other widths, too) to `Bind off`, `uncounted` or not.
 * Without the definitions of stitches. */
void written_pattern(struct text *, const struct grid *, const struct written_style *);

/* Its rows. */
void written_rows(struct text *, const struct grid *, const struct written_style *);

#endif
