/* SPDX-License-Identifier: GPL-3.0-or-later
 * Where a sentence about how long rows are worked ends and what is worked behind it begins. */
#ifndef WEFT_CLAUSES_H
#define WEFT_CLAUSES_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of a sign that ends such a sentence, `until it is square, knit 2 rows`, or of a clause that only says when,
 * `When it is long enough, knit 2 rows`; a stop for it in plain words. 0: none begins at the place. */
size_t clauses_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
