/* SPDX-License-Identifier: GPL-3.0-or-later
 * Newton's method with the exact Hessian, shifted by a multiple of the mass
 * where it is not positive definite; and the inertia test at its end. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/noise.h"
#include "solver/problem.h"
#include "solver/stopwatch.h"
#include "solver/vector.h"

static const double ARMIJO = 1e-4;          /* share of the predicted decrease a step must reach */
static const double KEPT = 0.1;             /* of the gradient must be all that a step leaves for its factor to serve again */
static const double ROUNDING = 1e-13;       /* of the energy: smaller decreases are not seen */
static const double FIRST_SHIFT = 1e-5, LAST_SHIFT = 1e6;
static const double FAR = 0.1, FAR_SHIFT = 1e-3;    /* the shift to begin with: of the gradient, but no more than that */
static const double FIRST_BLEND = 1.0 / 64, LEAST_BLEND = 1e-3; /* of the semidefinite Hessian, in a conjugate step's */
static const double GAIN = 1e-4;            /* of the decrease: a conjugate step that adds less is the last */
static const double GAIN_OF_TEST = 1e-10;   /* the same in the inertia test */
enum { MOST_CONJUGATE = 300 };

/* Factors H + shift M, raising the shift until that is positive definite. */
static bool factor_shifted(struct problem *p, const double *x, double *shift)
{
    enum factor_result result;
    problem_assemble(p, x, HESSIAN_EXACT);
    while ((result = problem_factor(p, x, *shift)) != FACTOR_DONE) {
        if (result == FACTOR_NO_MEMORY || *shift > LAST_SHIFT)
            return false;
        *shift = fmax(8 * *shift, FIRST_SHIFT);
    }
    return true;
}

/* No node moves further than `most`. */
static void cap_step(const struct discretisation *d, double most, double *step)
{
    double furthest = 0;
    for (int i = 0; i < d->nnodes; i++)
        for (int c = 0; c < 3; c++)
            furthest = fmax(furthest, fabs(step[d->node[i] + c]));
    if (furthest > most)
        for (int i = 0; i < d->n; i++)
            step[i] *= most / furthest;
}

/* step = -T (H + shift M)^-1 T^T g, with the Hessian at x or, where keep is set, the one factored before */
static bool factored_step(struct problem *p, const double *x, double *shift, bool keep)
{
    const struct discretisation *d = p->d;
    if (!keep && !factor_shifted(p, x, shift))
        return false;
    double start = stopwatch();
    const double *g = p->gradient;
    if (d->op->cotangent) {
        d->op->cotangent(d, x, g, p->trial);
        g = p->trial;
    }
    factor_solve(p->factor, g, p->step);
    if (d->op->tangent) {
        memcpy(p->trial, p->step, sizeof *p->trial * (size_t)d->n);
        d->op->tangent(d, x, p->trial, p->step);
    }
    for (int i = 0; i < d->n; i++)
        p->step[i] = -p->step[i];
    p->effort->solve_s += stopwatch() - start;
    return true;
}

/* The Hessian at x and the coarse factor that goes with it; false: not to be had. */
static bool update_levels(struct problem *p, const double *x, double blend, bool shifted)
{
    double start = stopwatch();
    bool done = two_level_update(p->two_level, x, p->growth, blend);
    double assembled = stopwatch();
    done = done && two_level_renew(p->two_level, shifted);
    p->effort->assemble_s += assembled - start;
    p->effort->factor_s += stopwatch() - assembled;
    p->effort->factorisations++;
    return done;
}

static struct two_level_result solve_levels(struct problem *p)
{
    double start = stopwatch();
    struct two_level_result result = two_level_solve(p->two_level, p->gradient, GAIN, MOST_CONJUGATE, p->step, NULL);
    p->effort->solve_s += stopwatch() - start;
    return result;
}

/* Conjugate gradients on H step = -g, with as much of the semidefinite Hessian in H as leaves no negative direction: what
 * leads up to one is a short step (Steihaug 1983 takes it: three times as many on the Miura), a shift by the mass stops
 * the soft bends of a large sheet that the semidefinite Hessian lets go on. */
static bool conjugate_step(struct problem *p, const double *x, double *blend)
{
    for (;;) {
        struct two_level_result result = {.end = TWO_LEVEL_NEGATIVE};
        if (update_levels(p, x, *blend, *blend == 1))
            result = solve_levels(p);
        if (result.end != TWO_LEVEL_NEGATIVE || *blend == 1)
            return result.end != TWO_LEVEL_NEGATIVE || result.decrease > 0;
        *blend = fmin(1, fmax(8 * *blend, FIRST_BLEND));
    }
}

/* Moves x along the step by Armijo's rule with quadratic backtracking; returns
 * the length taken, 0 where none descends. */
static double line_search(struct problem *p, double *x, double energy, double slope)
{
    double length = 1;
    for (int tries = 0; tries < 30; tries++) {
        problem_move(p, x, length, p->step, p->trial);
        double there = problem_evaluate(p, p->trial);
        if (isfinite(there) && there <= energy + ARMIJO * length * slope) {
            memcpy(x, p->trial, sizeof *x * (size_t)p->d->n);
            return length;
        }
        double best = isfinite(there) ? -slope * length * length / (2 * (there - energy - slope * length)) : 0;
        length = fmin(fmax(best, 0.1 * length), 0.5 * length);
    }
    return 0;
}

/* Where decreases drown in rounding the gradient decides: the full step is
 * taken as long as it lowers that. */
static bool step_by_gradient(struct problem *p, double *x)
{
    double before = p->gradient_max;
    problem_move(p, x, 1, p->step, p->trial);
    problem_evaluate(p, p->trial);
    if (!(p->gradient_max < 0.9 * before)) {
        problem_evaluate(p, x);
        return false;
    }
    memcpy(x, p->trial, sizeof *x * (size_t)p->d->n);
    return true;
}

/* What Newton's method carries from step to step. */
struct march {
    double energy;
    double shift;           /* of the Hessian, in masses */
    double blend;           /* of the semidefinite Hessian in that of a conjugate step */
    double before;          /* the gradient one step ago */
    double most;            /* way of a node in one step */
    bool   keep;            /* near the end one factor serves several steps */
};

/* Below rounding: by the gradient; where even that ends and the factor is fresh, this is all there is. */
static enum outcome last_steps(struct problem *p, double *x, struct march *m)
{
    p->effort->iterations++;
    if (!step_by_gradient(p, x) && !m->keep)
        return OUTCOME_PRECISION;
    m->keep = false;
    m->energy = p->energy.total;
    return OUTCOME_CONVERGED;
}

/* The shift or blend of the next step by how far this one went: an eighth after a whole one, none below the least. */
static double next_remedy(double now, double length, double first, double least)
{
    if (length == 1)
        return now / 8 < least ? 0 : now / 8;
    return length < 0.25 ? fmax(4 * now, first) : now;
}

/* Along the step as far as it descends. */
static enum outcome descend(struct problem *p, double *x, double slope, struct march *m)
{
    double length = line_search(p, x, m->energy, slope);
    if (length == 0) {
        problem_evaluate(p, x);
        bool again = m->keep;
        m->keep = false;
        return again ? OUTCOME_CONVERGED : OUTCOME_STALLED;
    }
    p->effort->iterations++;
    m->energy = p->energy.total;
    m->keep = length == 1 && m->shift == 0 && !p->two_level;
    m->shift = next_remedy(m->shift, length, FIRST_SHIFT, FIRST_SHIFT * 1e-3);
    m->blend = fmin(1, next_remedy(m->blend, length, FIRST_BLEND, LEAST_BLEND));
    return problem_report(p) ? OUTCOME_CONVERGED : OUTCOME_STOPPED;
}

/* One step; OUTCOME_CONVERGED: so far all is well. */
static enum outcome newton_step(struct problem *p, double *x, struct march *m)
{
    m->keep = m->keep && p->gradient_max < KEPT * m->before;
    m->before = p->gradient_max;
    if (p->effort->iterations >= p->limit)
        return OUTCOME_LIMIT;
    if (problem_lost(p, x))
        return OUTCOME_STALLED;
    if (!(p->two_level ? conjugate_step(p, x, &m->blend) : factored_step(p, x, &m->shift, m->keep)))
        return OUTCOME_FAILED;
    cap_step(p->d, m->most, p->step);
    double slope = vector_dot(p->d->n, p->gradient, p->step);
    return -slope < ROUNDING * fabs(m->energy) ? last_steps(p, x, m) : descend(p, x, slope, m);
}

enum outcome newton_minimise(struct problem *p, double *x)
{
    const struct sheet *sheet = p->d->sheet;
    struct march m = {.energy = problem_evaluate(p, x), .before = INFINITY, .blend = 1,
                      .most = 0.25 * fmax(sheet->columns * sheet->dx, sheet->rows * sheet->dy)};
    m.shift = fmin(FAR * p->gradient_max, FAR_SHIFT);
    if (!(m.shift > FIRST_SHIFT))
        m.shift = 0;
    enum outcome outcome = isfinite(m.energy) ? OUTCOME_CONVERGED : OUTCOME_FAILED;
    while (outcome == OUTCOME_CONVERGED && p->gradient_max > p->tolerance)
        outcome = newton_step(p, x, &m);
    return outcome;
}

/* Inverse iteration with the shifted factor ends in the softest direction; v.Hv tells its curvature. */
static double softest_direction(struct problem *p, double shift, double *v)
{
    int n = p->d->n;
    double curvature = 0;
    for (int i = 0; i < n; i++)
        v[i] = sin(1.0 + 12.9898 * i) * p->mass[i];
    for (int round = 0; round < 12; round++) {
        factor_solve(p->factor, v, p->trial);
        double top = vector_dot(n, p->trial, v), norm = 0;
        for (int i = 0; i < n; i++)
            norm += p->mass[i] * p->trial[i] * p->trial[i];
        curvature = top / norm - shift;
        for (int i = 0; i < n; i++)
            v[i] = p->mass[i] * p->trial[i] / sqrt(norm);
    }
    for (int i = 0; i < n; i++)
        v[i] /= p->mass[i];
    return curvature;
}

/* Without a factor: conjugate gradients for a right side H w, w arbitrary, meet
 * any direction of negative curvature before they converge (but for one that w
 * happens to be orthogonal to). */
static bool is_minimum_by_conjugates(struct problem *p, const double *x, double *direction)
{
    uint64_t seed = 1;
    if (!update_levels(p, x, 0, true))
        return false;
    for (int i = 0; i < p->d->n; i++)
        p->step[i] = noise_next(&seed);
    two_level_multiply(p->two_level, p->step, p->trial);
    return two_level_solve(p->two_level, p->trial, GAIN_OF_TEST, MOST_CONJUGATE, p->step, direction).end ==
           TWO_LEVEL_DONE;
}

bool newton_is_minimum(struct problem *p, const double *x, double *direction)
{
    double shift = 0;
    if (p->two_level)
        return is_minimum_by_conjugates(p, x, direction);
    if (!factor_shifted(p, x, &shift))
        return false;
    if (shift == 0)
        return true;
    softest_direction(p, shift, direction);
    return false;
}
