/* SPDX-License-Identifier: GPL-3.0-or-later
 * Row numbers of a statement: `rows 1-4 and 6` are 1, 2, 3, 4, 6. */
#ifndef WEFT_ROW_LABELS_H
#define WEFT_ROW_LABELS_H

#include "lang/eval.h"

struct row_labels {
    int *label;     /* (n) */
    int n, room;
};

/* Adds those of a list of parts; false, with a message, for none or one that is no row's number. */
bool row_labels_evaluate(struct eval *, struct where, const struct row_numbers *, struct row_labels *);

/* `from row 3`: adds those behind its first number, up to the last row. */
bool row_labels_go_on(struct eval *, struct row_labels *, int last, struct span);

#endif
