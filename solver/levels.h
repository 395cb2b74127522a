/* SPDX-License-Identifier: GPL-3.0-or-later
 * Which discretisations a fold passes through, coarse to fine. */
#ifndef WEFT_LEVELS_H
#define WEFT_LEVELS_H

#include "solver/discretisation.h"

/* Unknowns beyond which per_stitch = auto does not refine. */
enum { LEVELS_MOST_UNKNOWNS = 1000000 };

/* The level a fold grows on: for patches the spline on the stitches' lines,
 * for triangles the coarsest mesh the wanted one is a doubling of; for plain libLBFGS, the paper's
 * own way, the one asked for. */
struct discretisation *levels_first(const struct sheet *sheet, int threads);

/* The level that holds a sheet with nothing to fold. */
struct discretisation *levels_flat(const struct sheet *sheet, int threads);

/* The level after this one: twice as fine, or as fine as asked for. */
struct discretisation *levels_next(const struct discretisation *d, int threads);

/* Bicubic patches, so many along a stitch's side, whatever the sheet asks for. */
struct discretisation *levels_patches(const struct sheet *sheet, int per_stitch, int threads);

/* The coarse level of patches, whose nodes are control points? */
bool levels_is_spline(const struct discretisation *d);

/* Is there a finer level before the one asked for? */
bool levels_passing(const struct discretisation *d);

#endif
