/* SPDX-License-Identifier: GPL-3.0-or-later
 * A pattern that a page calls by a name: "Box Stitch" above its rows, "work in Box Stitch" later on. */
#ifndef WEFT_NAMED_H
#define WEFT_NAMED_H

#include <stddef.h>

#include "lang/arena.h"

/* The text, in as many bytes, with "in pattern" for the name of its rows behind them; where it has rows 1 more than once, or
 * none with a name, the text itself. */
const char *named_plain(struct arena *, const char *text, size_t size);

#endif
