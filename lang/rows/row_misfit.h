/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows that do not come out on the width there is: sentences with their arithmetic. */
#ifndef WEFT_ROW_MISFIT_H
#define WEFT_ROW_MISFIT_H

#include "lang/rows/rows.h"

/* "row 3"; rows before row 1 have no number. */
const char *misfit_name(struct arena *, const struct row_text *, const char *unnumbered);

/* "22 are cast on", "row 1 left 22". */
const char *misfit_left(struct arena *, enum width_from, const struct row_text *before, long long width);

/* A row's own widths, none of which is this one. */
void misfit_width(struct diag *, const struct row_text *, const struct fit *, long long width, const char *left);

/* Behind that, of a row with a repeat: the stitches left over may be its edges. */
void misfit_hint_edges(struct diag *, const struct fit *, long long width);

/* A row's widths, which have nothing in common with those of the rows before. */
void misfit_rows(struct diag *, const struct row_text *, const struct row_text *before, const struct fit *row, const struct fit *others);

/* `rep from * 3 times`: in all, or more?  `k1, p1 4 times`: p1, or both?  `left`: what neither fits, or NULL. */
void misfit_readings(struct diag *, const struct row_text *, const struct work *, const char *left);

#endif
