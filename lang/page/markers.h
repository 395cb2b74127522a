/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows worked as far as a marker that an earlier row of the piece placed. */
#ifndef WEFT_MARKERS_H
#define WEFT_MARKERS_H

#include <stddef.h>

#include "lang/arena.h"

/* The text with `to last 7 sts` for `to marker; slip marker` before `K7`, where a row placed a marker 7 stitches from its
 * beginning or end; in as many bytes. Where anything else stands behind the marker, as it is. */
const char *markers_plain(struct arena *, const char *text, size_t size);

#endif
