/* SPDX-License-Identifier: GPL-3.0-or-later
 * One minimisation: a discretised sheet at one growth, its work arrays and
 * counts, and the minimisers that run on it. */
#ifndef WEFT_PROBLEM_H
#define WEFT_PROBLEM_H

#include <stdbool.h>

#include "solver/discretisation.h"
#include "solver/factor.h"
#include "solver/two_level.h"

/* Summed over all levels and growth steps of a fold. */
struct effort {
    int    iterations, evaluations, factorisations;
    double evaluate_s, assemble_s, factor_s, solve_s;   /* wall seconds */
};

enum outcome {
    OUTCOME_CONVERGED,      /* largest gradient component within the tolerance */
    OUTCOME_PRECISION,      /* rounding stops further progress */
    OUTCOME_LIMIT,          /* iterations used up */
    OUTCOME_STALLED,        /* no descent found */
    OUTCOME_STOPPED,        /* the observer asked to stop */
    OUTCOME_FAILED          /* not finite, or out of memory in the factor */
};

struct problem {
    const struct discretisation *d;
    double         growth;
    double         tolerance;       /* of the largest gradient component, young * length^2 */
    int            limit;           /* on effort->iterations */
    struct effort *effort;
    bool         (*progress)(void *self, double growth, int iterations, double energy);
    void          *progress_self;

    struct two_level *two_level;    /* instead of a factor, where that does not fit; the caller's, or NULL */
    struct factor *factor;          /* symbolic for the level; NULL until problem_factor needs it */
    double        *hessian;         /* (pattern.start[n]) NULL until problem_assemble needs it */
    double        *diagonal;        /* (n) of the Hessian as assembled */
    double        *mass;            /* (n) */
    double        *gradient;        /* (n) at the state last evaluated */
    double        *trial;           /* (n) */
    double        *step;            /* (n) */
    struct fold_energy energy;      /* at the state last evaluated */
    double         gradient_max;    /* likewise */
    int            looked, doubts;  /* problem_lost: the iteration of its last look, doubts in a row */
};

void problem_open(struct problem *p, const struct discretisation *d, struct effort *effort);
void problem_close(struct problem *p);

/* Energy, gradient and their largest component at x; returns the total energy, not finite where x makes no sense. */
double problem_evaluate(struct problem *p, const double *x);

/* y (n): where length * step leads from x; y is neither of them. */
void problem_move(const struct problem *p, const double *x, double length, const double *step, double *y);

/* Adds shift * mass, and stiffness at the pins of a free sheet, to a Hessian, whose own diagonal (n) is given apart so
 * that this can be done again: at any state x the step that solves with it is the free sheet's own, as the
 * gradient does no work along rigid motions. */
void problem_regularise(const struct discretisation *d, const double *x, const double *diagonal, const double *mass,
                        double shift, double *hessian);

/* H(x), then as often as wanted H(x) + shift * mass factored, rigid modes of a free sheet pinned. */
void               problem_assemble(struct problem *p, const double *x, enum hessian_kind kind);
enum factor_result problem_factor(struct problem *p, const double *x, double shift);

/* Has the state made no sense (op->doubt) for some hundred iterations?  It will not again: to be asked between them. */
bool problem_lost(struct problem *p, const double *x);

/* false once the observer asks to stop. */
bool problem_report(struct problem *p);

/* x (n) is moved downhill; the problem's energy and gradient are those of x after. */
enum outcome lbfgs_minimise(struct problem *p, double *x);          /* plain libLBFGS */
enum outcome plbfgs_minimise(struct problem *p, double *x);         /* in the semidefinite factor's coordinates */
enum outcome newton_minimise(struct problem *p, double *x);

/* The inertia test at a state: is the exact Hessian positive definite, rigid
 * modes aside?  If not, direction (n) is one of negative curvature. */
bool newton_is_minimum(struct problem *p, const double *x, double *direction);

#endif
