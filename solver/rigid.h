/* SPDX-License-Identifier: GPL-3.0-or-later
 * The six motions of a sheet as a whole. */
#ifndef WEFT_RIGID_H
#define WEFT_RIGID_H

/* The velocities of coordinate c of a point at r under the six rigid motions: three
 * translations, then omega x r about each axis. */
static inline void rigid_velocity(const double *r, int c, double z[6])
{
    const double turn[3][3] = {{0, -r[2], r[1]}, {r[2], 0, -r[0]}, {-r[1], r[0], 0}};
    for (int m = 0; m < 3; m++) {
        z[m] = m == c;
        z[3 + m] = turn[m][c];
    }
}

#endif
