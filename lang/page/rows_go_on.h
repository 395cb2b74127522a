/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows that are begun only: `k1, p1, k1, p1, and so on to the end`. */
#ifndef WEFT_ROWS_GO_ON_H
#define WEFT_ROWS_GO_ON_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of such a row's stitches behind the sign at a place, and of what says that they go on; in plain words those that are
 * repeated: `k1, p1 to end`. 0: the row is told otherwise. */
size_t rows_go_on_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
