/* SPDX-License-Identifier: GPL-3.0-or-later
 * Grids of the letters K and P as text. */
#ifndef WEFT_KP_H
#define WEFT_KP_H

#include "charts/pattern.h"
#include "lang/diag.h"

/* Reads an optional header `# UP ACROSS` and a line of K and P for each row,
 * with or without blanks between them, the bottom row first. Errors are in diag;
 * after one the result has no grid. */
struct pattern kp_read(struct arena *, struct diag *, const struct source *);

#endif
