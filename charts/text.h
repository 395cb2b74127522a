/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text that grows at its end, in an arena. */
#ifndef WEFT_TEXT_H
#define WEFT_TEXT_H

#include <stddef.h>

#include "lang/arena.h"

struct text {
    struct arena *arena;
    char         *bytes;        /* (length), no NUL behind them */
    size_t        length, room;
};

void text_bytes(struct text *, const char *bytes, size_t n);
void text_print(struct text *, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
