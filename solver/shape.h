/* SPDX-License-Identifier: GPL-3.0-or-later
 * Measures of a folded surface that do not depend on how it is turned. */
#ifndef WEFT_SHAPE_H
#define WEFT_SHAPE_H

#include "solver/surface.h"

/* Turns and moves the surface onto its flat state, best in least squares. */
void shape_align(struct surface *surface);

/* Fills extents, height and curvature of the record from an aligned surface of a sheet width x height. */
void shape_measure(const struct surface *surface, double width, double height, struct fold_record *record);

#endif
