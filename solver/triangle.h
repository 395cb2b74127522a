/* SPDX-License-Identifier: GPL-3.0-or-later
 * The triangle discretisation: a sheet cut into flat triangles that turn
 * against each other, with mid-edge normals and one angle per edge. */
#ifndef WEFT_TRIANGLE_H
#define WEFT_TRIANGLE_H

#include "solver/discretisation.h"

struct triangle_mesh;

/* per_stitch x per_stitch cells a stitch, at least 1, each cut along the sheet's diagonals; threads at least 1.
 * x holds a position per vertex and an angle per edge: of the edge's normal from the mean of its faces' normals,
 * on the boundary from the face's normal.  Free with op->free. */
struct discretisation *triangle_make(const struct sheet *sheet, int per_stitch, int threads);

/* The same on any mesh, which it takes over; of the sheet it reads thickness and poisson only.  Such a
 * discretisation has no prolong and no sample. */
struct discretisation *triangle_make_of_mesh(const struct sheet *sheet, struct triangle_mesh *mesh, int threads);

/* The largest |alpha| over all faces, radians in [0, pi].  The energy sees sin(alpha) only: a state beyond pi/2 is
 * spurious, its mesh too coarse for it. */
double triangle_max_angle(const struct discretisation *d, const double *x);

#endif
