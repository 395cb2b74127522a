/* SPDX-License-Identifier: GPL-3.0-or-later
 * Wall time in seconds from some fixed moment. */
#ifndef WEFT_STOPWATCH_H
#define WEFT_STOPWATCH_H

#include <time.h>

static inline double stopwatch(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
