/* SPDX-License-Identifier: GPL-3.0-or-later
 * An orthographic view: angles in, the picture's axes out. */
#ifndef WEFT_VIEW_H
#define WEFT_VIEW_H

/* Unit vectors in the fabric's coordinates: x right, y up along the wales, z to
 * the viewer of the right side. */
struct view {
    double right[3], up[3], eye[3];     /* eye: from the fabric to the eye */
};

/* Degrees: azimuth about z, 0 from the first row, 90 from the right edge;
 * elevation above the fabric's plane, 90: the right side as its chart shows it. */
struct view view_make(const double angles[2]);

/* A point's place in the picture: to the right, upward, towards the eye. */
void view_project(const struct view *view, const double point[3], double seen[3]);

/* A direction that stands still before the eye, as a unit vector of the fabric:
 * degrees to the right and upward of the eye's own. */
void view_direction(const struct view *view, const double angles[2], double direction[3]);

#endif
