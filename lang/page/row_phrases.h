/* SPDX-License-Identifier: GPL-3.0-or-later
 * Phrases of a row's text that are put plainly (signs.c): how many bytes go, with `plain` in their place; 0: none of these. */
#ifndef WEFT_ROW_PHRASES_H
#define WEFT_ROW_PHRASES_H

#include <stddef.h>

#include "lang/page/signs.h"

/* `(5 times)` of `k1, *p1, k1 (5 times)`, where the row's star has no other end: its second star. */
size_t row_phrases_star(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `alternate k1 and p1`: a repeat, or a group that something behind it ends. */
size_t row_phrases_alternate(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `purl on RS, knit on WS`: a fabric. */
size_t row_phrases_sided(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `Work until 3 full repeats of rows 1-4 have been completed`: those rows, so often in all. */
size_t row_phrases_repeats(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `to form the broken rib pattern`, behind rows: `for patt`. */
size_t row_phrases_form(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `until it is square (I did 44 rows)`, `till long enough (about 14 times)` of what is repeated: as often as the brackets say. */
size_t row_phrases_told(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `the last 2 rows` of `Rows 3-8: repeat the last 2 rows`: `rows 1-2`. */
size_t row_phrases_last(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `Same.`, `as above`, `repeat previous row` behind `Row 6:`: `as 5`. */
size_t row_phrases_previous(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `Rows 1 and 2 are repeated` so often: `rep Rows 1-2`. */
size_t row_phrases_passive(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `Repeat Rib Round` behind the line `Rib Round: ..`: `rep last Round`. */
size_t row_phrases_named(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `in Box St Pat`, where rows above `form Box St Pattern`: `in patt`. */
size_t row_phrases_formed(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `work in k1, p1 rib` before `to last 2 sts` or a marker: `(k1, p1)`. */
size_t row_phrases_rib(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* `work the last 3 sts in seed st`, `3 sts moss st`: `seed 3`. */
size_t row_phrases_fabric(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
