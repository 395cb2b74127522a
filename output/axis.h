/* SPDX-License-Identifier: GPL-3.0-or-later
 * An axis: the range of some numbers in; round ends, ticks with their texts, and
 * the place of each number along it out. */
#ifndef WEFT_AXIS_H
#define WEFT_AXIS_H

#include <stdbool.h>

enum { AXIS_TICKS = 96, AXIS_TEXT = 40 };

enum axis_scale {
    AXIS_LINEAR,
    AXIS_LOG,
    AXIS_AUTO       /* log where all numbers are positive and the greatest is a thousand times the least */
};

/* What an axis has to show.  Begin with AXIS_NOTHING. */
struct axis_range { double low, high, positive; };      /* positive: the least above zero */
#define AXIS_NOTHING ((struct axis_range){HUGE_VAL, -HUGE_VAL, HUGE_VAL})

/* Widens a range by n numbers.  What is not finite, or greater than 1e290, does not count. */
void axis_see(struct axis_range *range, const double *value, int n);

struct axis_tick {
    double value;
    char   text[AXIS_TEXT];     /* UTF-8; empty: a small tick */
};

struct axis {
    bool             log;
    double           low, high; /* low < high */
    int              nticks;
    struct axis_tick tick[AXIS_TICKS];      /* from low to high */
};

struct axis_wish {
    enum axis_scale scale;
    bool            zero;       /* linear: zero is on it */
    bool            whole;      /* linear: no tick between whole numbers */
    int             texts;      /* about so many ticks with texts, at least 2 */
};

/* Its ends are ticks, or whole decades.  With nothing to show: 0 to 1, or 1 to 10. */
struct axis axis_make(const struct axis_range *range, const struct axis_wish *wish);

/* 0 at low, 1 at high; NAN for what the axis cannot show. */
double axis_place(const struct axis *axis, double value);

/* A number as the ticks have it, with so many significant digits at most: "0.25", "2×10⁻⁵". */
void axis_print(char text[AXIS_TEXT], double value, int digits);

#endif
