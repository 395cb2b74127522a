/* SPDX-License-Identifier: GPL-3.0-or-later
 * A minimum and the next level in; the energy decrease and the step that
 * Newton's method would make there out, by a few conjugate gradients. */
#include "solver/estimate.h"

#include <math.h>
#include <stdlib.h>

#include "solver/memory.h"
#include "solver/two_level.h"

static const double ENOUGH = 0.02;      /* of the decrease so far: a step that adds less is the last */
enum { MOST_STEPS = 40 };

/* By the exact Hessian, or the semidefinite one where that has a negative direction. */
static double predicted_decrease(struct two_level *t, const double *x_fine, double growth, const double *gradient,
                                 double *e)
{
    double decrease = 0;
    for (int blend = 0; blend <= 1; blend++) {
        if (!two_level_update(t, x_fine, growth, blend))
            continue;
        struct two_level_result result = two_level_solve(t, gradient, ENOUGH, MOST_STEPS, e, NULL);
        decrease = result.decrease;
        if (result.end != TWO_LEVEL_NEGATIVE)
            break;
    }
    return decrease;
}

struct estimate estimate_error(const struct problem *p, const struct discretisation *coarse, struct factor *factor,
                               const double *x, const struct discretisation *fine, double *x_fine)
{
    struct two_level *t = two_level_make(coarse, NULL, factor, fine);
    double *gradient = MEMORY_ARRAY(double, fine->n), *e = MEMORY_ARRAY(double, fine->n);
    p->d->op->prolong(p->d, x, fine, x_fine);
    double prolonged = fine->op->energy(fine, x_fine, p->growth, gradient).total, furthest = 0;
    double decrease = predicted_decrease(t, x_fine, p->growth, gradient, e);
    for (int i = 0; i < fine->n; i++)
        x_fine[i] += e[i];
    for (int i = 0; i < fine->nnodes; i++) {
        const double *move = e + fine->node[i];
        furthest = fmax(furthest, sqrt(move[0] * move[0] + move[1] * move[1] + move[2] * move[2]));
    }
    two_level_free(t);
    free(gradient), free(e);
    return (struct estimate){ESTIMATE_BEYOND * fabs(p->energy.total - prolonged + decrease), ESTIMATE_BEYOND * furthest};
}
