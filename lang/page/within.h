/* SPDX-License-Identifier: GPL-3.0-or-later
 * A pattern that is worked within a row: `K4, work row 1 of Box Stitch to last 4 sts, k4`, its name being plain. */
#ifndef WEFT_WITHIN_H
#define WEFT_WITHIN_H

#include <stddef.h>

#include "lang/ast.h"

/* The bytes of `work row 1 of pattern to last 4 sts`, `patt over next 20 sts`; 0: a text begins otherwise. */
size_t within_length(const char *text, struct within *);

#endif
