/* SPDX-License-Identifier: GPL-3.0-or-later
 * From the syntax of a row's text to its work: names of stitches and numbers are looked up. */
#ifndef WEFT_LOWER_H
#define WEFT_LOWER_H

#include "lang/eval.h"
#include "lang/rows/rows.h"

/* Sets *first to the list of work, NULL for nothing at all: `k0`. False after an error. */
bool lower_items(struct eval *, struct where, const struct item *, struct work **first);

#endif
