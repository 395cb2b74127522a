/* SPDX-License-Identifier: GPL-3.0-or-later
 * Casting on a number that is a multiple, in many words. */
#ifndef WEFT_CASTS_H
#define WEFT_CASTS_H

#include <stddef.h>

/* Of `as many sts as you like, in a multiple of 4`, behind `cast on`: the bytes before `multiple of`, `divisible by` or
 * `even number`; 0: they say something else, or nothing. *close: the bracket behind it that closes one among them, or 0. */
size_t casts_many(const char *text, size_t *close);

#endif
