/* SPDX-License-Identifier: GPL-3.0-or-later
 * Yarns that a page names for whole rows: the fold does not depend on them. */
#ifndef WEFT_YARNS_H
#define WEFT_YARNS_H

#include <stdbool.h>
#include <stddef.h>

/* The bytes of `Using Red, ` before `knit 4 rows` where a sentence begins, or before `knit.` behind a row's head; of `with B`
 * behind them; of `(MC)` in a row's head, of `, MC` of `(RS, MC)`. 0: it is none, or of some stitches of a row alone. */
size_t yarns_length(const char *text, size_t at, bool begins);

#endif
