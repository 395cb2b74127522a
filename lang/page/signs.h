/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in, what stands for it plainly out, where it is a sign or a remark. */
#ifndef WEFT_SIGNS_H
#define WEFT_SIGNS_H

#include <stddef.h>

enum { SIGNS_PLAIN = 96 };       /* bytes of the longest plain text, with its end */

/* How many bytes from `at` on go for `plain` and blanks: `~` for a dash, an ellipsis, a remark in
 * brackets within a row, a number in letters above twelve, the bars of a table, `[18]` behind a
 * row, a row behind another, a caption behind `(24 sts)`. 0: none of these. */
size_t signs_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
