/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sentences broken over the lines of a page. */
#ifndef WEFT_JOINED_H
#define WEFT_JOINED_H

#include <stddef.h>

#include "lang/arena.h"

/* The text with blanks for the line ends within sentences, as many bytes. */
const char *joined_plain(struct arena *, const char *text, size_t size);

#endif
