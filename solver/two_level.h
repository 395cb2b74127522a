/* SPDX-License-Identifier: GPL-3.0-or-later
 * Conjugate gradients on a level's Hessian without a factor of it: the
 * preconditioner goes half a step by the nodes' own blocks D, corrects what is
 * left by the factor of a coarser level's Hessian, and goes another half step,
 * I - M^-1 H = (I - D^-1 H / 2) (I - P H_coarse^-1 P^T H) (I - D^-1 H / 2).
 * H_coarse is P^T H P once two_level_renew was called (soft modes are told apart
 * by little: with the coarse level's own Hessian at its own minimum the steps
 * were up to five times as many). */
#ifndef WEFT_TWO_LEVEL_H
#define WEFT_TWO_LEVEL_H

#include "solver/discretisation.h"
#include "solver/factor.h"

struct two_level;

/* Levels nested and in blocks (restrict_gradient, block > 0).  The coarse state
 * (coarse n; only tells how to pin a free sheet) and factor stay the caller's. */
struct two_level *two_level_make(const struct discretisation *coarse, const double *x_coarse, struct factor *factor,
                                 const struct discretisation *fine);
void two_level_free(struct two_level *t);

/* Takes the fine H = E + blend (S - E) at x (fine n), E the exact Hessian and S the semidefinite one; blend 0 to 1.
 * false: a node's own block is not positive definite. */
bool two_level_update(struct two_level *t, const double *x, double growth, double blend);

/* Factors P^T H P of the fine Hessian taken last; where that is not positive definite it is shifted, if it may be.
 * false: it cannot be factored. */
bool two_level_renew(struct two_level *t, bool shifted);

enum two_level_end { TWO_LEVEL_DONE, TWO_LEVEL_NEGATIVE, TWO_LEVEL_CAP };

struct two_level_result {
    enum two_level_end end;
    int                iterations;
    double             decrease;    /* of 1/2 e.He + g.e; grows towards 1/2 g.H^-1 g */
};

/* H e = -g from e = 0, until a step adds less than `enough` of the decrease.
 * A direction of negative curvature ends it: that is left in negative (fine n)
 * where this is not NULL, and e holds what came before. */
struct two_level_result two_level_solve(struct two_level *t, const double *g, double enough, int most, double *e,
                                        double *negative);

/* y = H v (fine n). */
void two_level_multiply(const struct two_level *t, const double *v, double *y);

#endif
