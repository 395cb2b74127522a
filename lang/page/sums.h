/* SPDX-License-Identifier: GPL-3.0-or-later
 * What stands behind `3 times` and says the sum of it: `(6 rows in all)`. */
#ifndef WEFT_SUMS_H
#define WEFT_SUMS_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of `(6 rows in all)`, `, 6 rows in all`, `(4 times in all)`, and ` in 6 rows`, ` in 4 x` for it; ` in 6 rows total`
 * where the rows of the piece are meant, `(6 rows in total, counting the 2 of the border)`. 0: it is none. */
size_t sums_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
