/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows that begin or end a piece: `Finish the scarf with two rows of knit stitch`, `.., then end by knitting 1 garter ridge`. */
#ifndef WEFT_FRAMING_H
#define WEFT_FRAMING_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of such a clause that begins at a place, up to its rows and what they are of; in plain words `knit 2 rows`,
 * behind a comma or `then` a stop before them. 0: there is none. */
size_t framing_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
