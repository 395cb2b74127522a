/* SPDX-License-Identifier: GPL-3.0-or-later
 * A double in, the shortest text that reads back as the same double out. */
#ifndef WEFT_NUMBER_H
#define WEFT_NUMBER_H

#include <stdio.h>
#include <stdlib.h>

enum { NUMBER_TEXT = 32 };

/* Finite numbers only.  15 digits mostly do, 17 always. */
static inline void number_print(char text[NUMBER_TEXT], double value)
{
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, NUMBER_TEXT, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return;
    }
}

#endif
