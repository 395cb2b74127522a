/* SPDX-License-Identifier: GPL-3.0-or-later
 * The arithmetic of one row: which widths its text fits, and its stitches in
 * working order at a width. */
#ifndef WEFT_ROW_FIT_H
#define WEFT_ROW_FIT_H

#include "lang/rows/rows.h"

/* Sets the length of a list of work; groups must be of one definite length.
 * False after an error. */
bool work_measure(struct diag *, struct work *, long long *length);

/* The stitches of a list of work; -1: they are open. */
long long work_length(const struct work *);

/* Whether two lists say the same. */
bool work_is_same(const struct work *, const struct work *);

/* False after an error: the text contradicts itself. Any width fits what is worked to a marker. */
bool row_fit(struct diag *, const struct row_text *, struct fit *);

/* `rep from * 3 times`, `k1, p1 3 times`: in how many ways a part of a row's work can be read, and how many
 * stitches the row has in each, from the least on. */
int row_readings(const struct row_text *, const struct work *);
long long row_reading(const struct row_text *, const struct work *, int reading);

/* Where what follows a repeat is how it goes on from one of its runs: the repeat is then worked so many
 * stitches and stops. Looks from the run *from on, and moves it behind; -1: nowhere. */
long long work_stop(const struct work *repeat, int *from);

/* Widths that fit both; false where there are none. */
bool fit_join(const struct fit *, const struct fit *, struct fit *both);
bool fit_has(const struct fit *, long long width);

/* Writes `width` stitches in working order; the row's work then has a number of times in each part. False after an error. */
bool row_work(struct diag *, struct row_text *, int width, enum width_from, const struct row_text *before, stitch_id *worked);

#endif
