/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows of a page that have letters for numbers, or beside them. */
#ifndef WEFT_LETTERED_H
#define WEFT_LETTERED_H

#include <stddef.h>

#include "lang/arena.h"

/* The text with numbers for `Row A`, `Rows 1b and 2b`, in as many bytes; where its letters do not count on, as it is. */
const char *lettered_plain(struct arena *, const char *text, size_t size);

#endif
