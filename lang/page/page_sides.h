/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sentences of a page that say which of its rows are worked on which side. */
#ifndef WEFT_PAGE_SIDES_H
#define WEFT_PAGE_SIDES_H

#include "lang/ast.h"

/* The side of row 1 by `Row 2 is the right side`, `The even rows are RS rows`, `RS = row 1`; open where
 * nothing says so, or both are said. Comments say nothing. *begins: of the first row worked, `Start on the wrong side`. */
enum side page_sides(const char *text, bool *begins);

/* Whether a line begins with such a sentence, and asks for no stitches. */
bool page_sides_line(const char *line);

#endif
