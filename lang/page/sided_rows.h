/* SPDX-License-Identifier: GPL-3.0-or-later
 * One row in a sentence that says its side: `Work 1 WS row in knit`, `With RS facing, purl one row`. */
#ifndef WEFT_SIDED_ROWS_H
#define WEFT_SIDED_ROWS_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of such a sentence, or part of one, that begins at a place; in plain words `k 1 row ws`. 0: there is none. */
size_t sided_rows_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
