/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts drawn with signs of a text, and the key that says what they mean. */
#ifndef WEFT_LEGEND_H
#define WEFT_LEGEND_H

#include <stdbool.h>

#include "charts/pattern.h"
#include "lang/diag.h"

/* Whether the text has a key, `. = purl`, and no braces, which scripts have. */
bool legend_is(const struct source *);

/* Reads lines of the key's signs, with row numbers at either end, as seen from the right side. Row 1 is the
 * bottom line, unless the numbers say that it is the top one. Other lines are text. Errors are in diag. */
struct pattern legend_read(struct arena *, struct diag *, const struct source *);

#endif
