/* SPDX-License-Identifier: GPL-3.0-or-later
 * What stands at the beginning of a line before a part of a pattern, or fills a line without being one. */
#ifndef WEFT_HEADS_H
#define WEFT_HEADS_H

#include <stdbool.h>
#include <stddef.h>

/* How many bytes at the beginning of a line go: `Scarf #1:`, `Lace panel -`, `Row 1:` before a cast-on,
 * and, where not `inside` braces or an expression, the place `3:10` in a film, a table's cell without a row, a number
 * alone. 0: none of these. `stop`: the last of them is to be a full stop, as a row's number stands before it. */
size_t heads_length(const char *text, bool inside, bool *stop);

/* How long `Rib ` is before `row 1`, `rows 1 and 2`, and the same before a row's head with its colon; or 0. */
size_t heads_rows_named(const char *text);
size_t heads_label(const char *text);

/* How long `Cast on:` alone on its line is, with the line end where `20 sts` follows behind it; 0: another line. */
size_t heads_cast_on(const char *text);

/* The number of the row `Row 58: Bind off`, `Row 8 (WS): purl and bind off`; 0: another line. */
int heads_bound_off(const char *text);

/* How long ` a multiple of 4 (I used 24)` behind `Cast on` is, and where the number stands; or 0. */
size_t heads_example(const char *text, size_t *number);

#endif
