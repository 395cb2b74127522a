/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the next finer level would change at a minimum of this one, without
 * solving there: the discretisation error's estimate. */
#ifndef WEFT_ESTIMATE_H
#define WEFT_ESTIMATE_H

#include "solver/problem.h"

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
