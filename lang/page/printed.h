/* SPDX-License-Identifier: GPL-3.0-or-later
 * What only printed books have: their marks and stops, ordinals in letters, rows told by others. */
#ifndef WEFT_PRINTED_H
#define WEFT_PRINTED_H

#include <stddef.h>

enum { PRINTED_PLAIN = 32 };     /* bytes of the longest plain text, with its end */

/* How many bytes from `at` on go for blanks: `_1st row._` without its underscores, `=Materials.= Wool` without
 * its signs, `[Illustration: ..]`. 0: none of these. */
size_t printed_mark(const char *text, size_t at);

/* How many bytes go for `plain` and blanks: a sign or a word of a book's own. What stands before `at` is plain already. */
size_t printed_length(const char *text, size_t at, char plain[static PRINTED_PLAIN]);

#endif
