/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows in sentences with a verb: `The first row is knitted`, `Rows 2 and 4 are purl`. */
#ifndef WEFT_ROWS_TOLD_H
#define WEFT_ROWS_TOLD_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of such a sentence that begins at a place, up to its stitches; in plain words the rows' head, and the stitch
 * where the verb is one: `row 1:k`, `Rows 2 and 4:`. 0: there is none. */
size_t rows_told_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
