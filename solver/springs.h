/* SPDX-License-Identifier: GPL-3.0-or-later
 * Springs along the boundary: 1/2 k Int |r - r_flat|^2 ds, as a quadratic form
 * in the unknowns.  The discretisation gives the boundary's mass matrix. */
#ifndef WEFT_SPRINGS_H
#define WEFT_SPRINGS_H

#include "solver/discretisation.h"

/* Entries of the boundary mass matrix between the x-components of two unknown
 * vectors; y and z components stand at +1 and +2. */
struct spring_form {
    int     count, capacity;
    int    *row, *col;      /* (count) unknowns, row >= col */
    double *value;          /* (count) stiffness * Int N_row N_col ds; length^2 */
    int    *position;       /* (count x 3) of (row + c, col + c) in the pattern */
    double *flat;           /* (n) the state the springs pull to */
};

/* Adds to the entry (i, j) of the mass matrix, i, j in any order. */
void springs_add(struct spring_form *s, int i, int j, double value);

/* Looks up positions and takes the flat state.  After the last springs_add. */
void springs_finish(struct spring_form *s, const struct discretisation *d);

/* The energy; its gradient is added to gradient (n) unless that is NULL. */
double springs_energy(const struct spring_form *s, const double *restrict x, double *restrict gradient);

/* Adds the Hessian to value (pattern.start[n]). */
void springs_hessian(const struct spring_form *s, double *restrict value);

void springs_free(struct spring_form *s);

#endif
