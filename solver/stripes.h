/* SPDX-License-Identifier: GPL-3.0-or-later
 * The one-dimensional answer of a sheet whose stitches do not change along one
 * of its sides (plain, ribs, garter): a start that has the turns already. */
#ifndef WEFT_STRIPES_H
#define WEFT_STRIPES_H

#include "solver/discretisation.h"

/* Bends a flat (or nearly flat) state x (n): rolled across the stripes with each
 * one's curvature at that growth, straight along them.  false, and x untouched:
 * the stitches change along both sides, are twisted, or springs hold the boundary. */
bool stripes_bend(const struct discretisation *d, double growth, double *x);

#endif
