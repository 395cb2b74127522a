/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the next finer level would change at a minimum of this one, without
 * solving there: the discretisation error's estimate. */
#ifndef WEFT_ESTIMATE_H
#define WEFT_ESTIMATE_H

#include "solver/problem.h"

/* What lies beyond the next level: the energy's order in the element size is at
 * least 2 where curvature jumps at patch lines, so 1/(1 - 2^-2) = 4/3; and what
 * the conjugate gradients leave out. */
static const double ESTIMATE_BEYOND = 1.5;

struct estimate {
    double energy;      /* bound meant for the energy above that without discretisation error; young * length^3 */
    double shape;       /* bound meant for the largest distance to that surface; length */
};

/* x (n): a minimum of p.  fine: the next level; coarse, factor: p's own level or
 * a coarser one, and the factor of its Hessian near x, that precondition it; x_fine (fine n) becomes the prolonged state, moved by the
 * predicted step: a start for a minimisation there. */
struct estimate estimate_error(const struct problem *p, const struct discretisation *coarse, struct factor *factor,
                               const double *x, const struct discretisation *fine, double *x_fine);

#endif
