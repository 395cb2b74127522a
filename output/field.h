/* SPDX-License-Identifier: GPL-3.0-or-later
 * A number for each cell of a surface, by name, and the range in which to show it. */
#ifndef WEFT_FIELD_H
#define WEFT_FIELD_H

#include <stdbool.h>

#include "lang/scene.h"
#include "solver/surface.h"

struct field {
    const char *title;          /* "mean curvature (1/length)" */
    const char *ends;           /* what low and high are: "full range", "2 % to 98 %" of the cells */
    bool        diverging;      /* the middle is zero: -low = high */
    double      low, high;      /* low < high */
    double     *value;          /* (ny x nx), free with field_free */
};

/* The field a picture is coloured by, COLOR_HEIGHT and later.  Height is measured
 * from its mean.  A few cells at corners and edges would take the whole scale for
 * themselves: curvatures and energies are shown from the 2nd percentile to the 98th.
 * value is NULL when memory is out. */
struct field field_of(const struct surface *surface, enum coloring color);
void         field_free(struct field *field);

#endif
