/* SPDX-License-Identifier: GPL-3.0-or-later
 * Whole rows of a page that are repeated from a star. */
#ifndef WEFT_STARRED_H
#define WEFT_STARRED_H

#include <stddef.h>

#include "lang/arena.h"

/* The text with `Rep r1-4` for the `Repeat from *` below `*Row 1: ..`, in as many bytes. */
const char *starred_plain(struct arena *, const char *text, size_t size);

#endif
