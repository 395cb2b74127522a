/* SPDX-License-Identifier: GPL-3.0-or-later
 * The side on which rows are said to end: `.., ending with a WS row`, `.., ending with RS facing for next row`. */
#ifndef WEFT_ENDINGS_H
#define WEFT_ENDINGS_H

#include "lang/ast.h"

/* The side of the last row by the first such words from a place of a text on, up to the end of the sentence that goes on behind another
 * place, and where they stand; SIDE_OPEN: none is said. */
enum side endings_side(const char *text, unsigned from, unsigned behind, unsigned *start, unsigned *end);

#endif
