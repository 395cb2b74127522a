/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's list whose numbers are those of steps, not of rows. */
#ifndef WEFT_LISTED_H
#define WEFT_LISTED_H

#include <stddef.h>

#include "lang/arena.h"

/* The text with the numbers of rows for those of the steps that are rows, in as many bytes, where the first step is
 * the cast-on; a list that also names rows by their numbers, and one that names steps that are no rows, is as it is. */
const char *listed_plain(struct arena *, const char *text, size_t size);

#endif
