/* SPDX-License-Identifier: GPL-3.0-or-later
 * libLBFGS on the unknowns themselves, or on y where x = R(x0, s P^T L^-T y), R the
 * way of an increment (op->retract) and L L^T = P H P^T the factor of the semidefinite
 * Hessian (Liu, Bouaziz and Kavan 2017): H looks like the identity to it.  The only user of lbfgs.h. */
#include "solver/problem.h"

#include <lbfgs.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/stopwatch.h"

enum { REFRESH = 20, HISTORY = 8, LANES_OF_LBFGS = 8 };

enum { STOP_CONVERGED = 1, STOP_REFRESH, STOP_LIMIT, STOP_OBSERVER, STOP_FINITE };

struct run {
    struct problem *p;
    bool            preconditioned;
    double         *x0;                 /* (n) where the factor was taken */
    double         *dx;                 /* (n) the increment of the state last evaluated, over s */
    double          scale;              /* s */
};

/* dx = T P^T L^-T y and its transpose. */
static void to_step(struct run *run, const double *y, double *dx)
{
    struct problem *p = run->p;
    double start = stopwatch();
    factor_upper(p->factor, y, dx);
    if (p->d->op->tangent) {
        memcpy(p->step, dx, sizeof *dx * (size_t)p->d->n);
        p->d->op->tangent(p->d, run->x0, p->step, dx);
    }
    p->effort->solve_s += stopwatch() - start;
}

static void to_gradient(struct run *run, const double *gx, double *gy)
{
    struct problem *p = run->p;
    double start = stopwatch();
    if (p->d->op->retract_adjoint) {
        p->d->op->retract_adjoint(p->d, run->x0, run->scale, run->dx, gx, p->step);
        gx = p->step;
    }
    if (p->d->op->cotangent) {
        p->d->op->cotangent(p->d, run->x0, gx, p->step);
        gx = p->step;
    }
    factor_lower(p->factor, gx, gy);
    p->effort->solve_s += stopwatch() - start;
}

static void state_of(struct run *run, const double *y, double *x)
{
    int n = run->p->d->n;
    if (!run->preconditioned) {
        memcpy(x, y, sizeof *x * (size_t)n);
        return;
    }
    to_step(run, y, run->dx);
    double start = stopwatch();
    problem_move(run->p, run->x0, run->scale, run->dx, x);
    run->p->effort->solve_s += stopwatch() - start;
}

static lbfgsfloatval_t evaluate(void *instance, const lbfgsfloatval_t *y, lbfgsfloatval_t *gy, int padded,
                                lbfgsfloatval_t step)
{
    struct run *run = instance;
    struct problem *p = run->p;
    (void)step;
    state_of(run, y, p->trial);
    double energy = problem_evaluate(p, p->trial);
    memset(gy + p->d->n, 0, sizeof *gy * (size_t)(padded - p->d->n));
    if (!run->preconditioned) {
        memcpy(gy, p->gradient, sizeof *gy * (size_t)p->d->n);
        return energy;
    }
    to_gradient(run, p->gradient, gy);
    for (int i = 0; i < p->d->n; i++)
        gy[i] *= run->scale;
    return energy;
}

static int watch(void *instance, const lbfgsfloatval_t *y, const lbfgsfloatval_t *gy, lbfgsfloatval_t energy,
                 lbfgsfloatval_t ynorm, lbfgsfloatval_t gnorm, lbfgsfloatval_t step, int n, int k, int ls)
{
    struct run *run = instance;
    struct problem *p = run->p;
    (void)y, (void)gy, (void)ynorm, (void)gnorm, (void)step, (void)n, (void)ls;
    p->effort->iterations++;
    if (!isfinite(energy))
        return STOP_FINITE;
    if (p->gradient_max <= p->tolerance)
        return STOP_CONVERGED;
    if (p->effort->iterations >= p->limit)
        return STOP_LIMIT;
    if (!problem_report(p))
        return STOP_OBSERVER;
    return run->preconditioned && k >= REFRESH ? STOP_REFRESH : 0;
}

static lbfgs_parameter_t parameters(void)
{
    lbfgs_parameter_t with;
    lbfgs_parameter_init(&with);
    with.m = HISTORY;
    with.epsilon = 0;
    with.max_iterations = 0;
    with.max_linesearch = 30;
    return with;
}

/* One call of libLBFGS from y = 0 (preconditioned) or y = x; x is moved to where it ended. */
static int descend(struct run *run, double *x)
{
    struct problem *p = run->p;
    int n = p->d->n, padded = (n + LANES_OF_LBFGS - 1) / LANES_OF_LBFGS * LANES_OF_LBFGS;
    lbfgsfloatval_t *y = lbfgs_malloc(padded);
    memset(y, 0, sizeof *y * (size_t)padded);
    if (!run->preconditioned)
        memcpy(y, x, sizeof *y * (size_t)n);
    lbfgs_parameter_t with = parameters();
    int why = lbfgs(padded, y, NULL, evaluate, watch, run, &with);
    state_of(run, y, x);
    lbfgs_free(y);
    return why;
}

static enum outcome outcome_of(int why, bool moved)
{
    switch (why) {
    case STOP_CONVERGED: return OUTCOME_CONVERGED;
    case STOP_LIMIT: return OUTCOME_LIMIT;
    case STOP_OBSERVER: return OUTCOME_STOPPED;
    case STOP_FINITE: return OUTCOME_FAILED;
    default: return moved ? OUTCOME_STALLED : OUTCOME_PRECISION;
    }
}

enum outcome lbfgs_minimise(struct problem *p, double *x)
{
    struct run run = {.p = p};
    if (!isfinite(problem_evaluate(p, x)))
        return OUTCOME_FAILED;
    if (p->gradient_max <= p->tolerance)
        return OUTCOME_CONVERGED;
    int before, why;
    do {    /* a line search that gives up loses the history; the gradient's own direction may still descend */
        before = p->effort->iterations;
        why = descend(&run, x);
    } while (why < 0 && p->effort->iterations > before + 1);
    problem_evaluate(p, x);
    return outcome_of(why, p->effort->iterations > before);
}

/* A unit step of libLBFGS' first direction becomes one full Newton step. */
static void scale_first_step(struct run *run)
{
    struct problem *p = run->p;
    memset(run->dx, 0, sizeof *run->dx * (size_t)p->d->n);
    to_gradient(run, p->gradient, p->trial);
    double square = 0;
    for (int i = 0; i < p->d->n; i++)
        square += p->trial[i] * p->trial[i];
    run->scale = sqrt(square);
}

enum outcome plbfgs_minimise(struct problem *p, double *x)
{
    struct run run = {.p = p, .preconditioned = true, .x0 = MEMORY_ARRAY(double, p->d->n),
                      .dx = MEMORY_ARRAY(double, p->d->n)};
    enum outcome outcome = OUTCOME_FAILED;
    int why = STOP_REFRESH, before = -1;
    if (isfinite(problem_evaluate(p, x)))
        for (;;) {
            if (p->gradient_max <= p->tolerance) {
                outcome = OUTCOME_CONVERGED;
                break;
            }
            if (why != STOP_REFRESH && (why >= 0 || p->effort->iterations <= before + 1)) {
                outcome = outcome_of(why, p->effort->iterations > before);
                break;
            }
            if (problem_lost(p, x)) {
                outcome = OUTCOME_STALLED;
                break;
            }
            problem_assemble(p, x, HESSIAN_SEMIDEFINITE);
            if (problem_factor(p, x, 1e-8) != FACTOR_DONE)
                break;
            memcpy(run.x0, x, sizeof *x * (size_t)p->d->n);
            scale_first_step(&run);
            before = p->effort->iterations;
            why = descend(&run, x);
            problem_evaluate(p, x);
        }
    free(run.x0);
    free(run.dx);
    return outcome;
}
