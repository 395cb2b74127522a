/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state in, a minimum (or the honest reason why not) out. */
#include "solver/descent.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"

static const double HANDOVER = 1e-4, CLOSER = 1e-6; /* gradients, young * thickness^2, where Newton takes over */
enum { NEWTON_TRIES = 8, MOST_PUSHES = 12 };
enum { NARROW = 16, LONG = 6, STRIP_LBFGS = 40, STRIP_NEWTON = 600 };   /* stitches; ratio of sides; iterations */

/* The iterations of one minimiser, at most so many more of those allowed. */
static enum outcome limited(struct problem *p, enum outcome minimise(struct problem *, double *), int most, double *x)
{
    int limit = p->limit;
    if (most < limit - p->effort->iterations)
        p->limit = p->effort->iterations + most;
    enum outcome outcome = minimise(p, x);
    p->limit = limit;
    return outcome;
}

/* libLBFGS in the factor's coordinates down to a gradient, then Newton, each for at most so many iterations. */
static enum outcome approach(struct problem *p, double gradient, int lbfgs, int newton, double *x)
{
    double tolerance = p->tolerance, h = p->d->sheet->thickness;
    p->tolerance = fmax(tolerance, gradient * h * h);
    enum outcome outcome = limited(p, plbfgs_minimise, lbfgs, x);
    bool reached = outcome == OUTCOME_CONVERGED && p->gradient_max <= tolerance;
    p->tolerance = tolerance;
    if (reached || outcome == OUTCOME_STOPPED || outcome == OUTCOME_FAILED)
        return outcome;
    return limited(p, newton_minimise, newton, x);
}

static bool is_strip(const struct problem *p)
{
    int across = p->d->sheet->columns, along = p->d->sheet->rows;
    int shorter = across < along ? across : along, longer = across < along ? along : across;
    return p->d->op->retract && shorter <= NARROW && longer >= LONG * shorter;
}

/* Newton's few factors pay where it converges at once; where it does not, libLBFGS goes on first.  The factor of a
 * narrow strip costs so little that Newton's method takes over from a libLBFGS that winds it up turn by turn. */
static enum outcome settle_fast(struct problem *p, double *x)
{
    bool strip = is_strip(p);
    enum outcome outcome = approach(p, HANDOVER, strip ? STRIP_LBFGS : p->limit, strip ? STRIP_NEWTON : NEWTON_TRIES, x);
    if (outcome != OUTCOME_LIMIT || p->effort->iterations >= p->limit)
        return outcome;
    return approach(p, CLOSER, p->limit, p->limit, x);
}

static bool doubted(const struct problem *p, const double *x)
{
    return p->d->op->doubt && p->d->op->doubt(p->d, x);
}

/* Downhill may lead into a state that makes no sense (op->doubt) and is not left again.  Newton's method alone goes
 * another way from the same start; where that ends at no sense or no rest either, the first end stays. */
static enum outcome settle_auto(struct problem *p, double *x)
{
    if (p->two_level)
        return newton_minimise(p, x);
    size_t size = sizeof *x * (size_t)p->d->n;
    double *other = memcpy(MEMORY_ARRAY(double, p->d->n), x, size);
    enum outcome outcome = settle_fast(p, x);
    if (outcome != OUTCOME_STOPPED && outcome != OUTCOME_LIMIT && doubted(p, x) && !doubted(p, other)) {
        p->doubts = 0;
        enum outcome second = newton_minimise(p, other);
        bool better = second != OUTCOME_STALLED && second != OUTCOME_FAILED && !doubted(p, other);
        outcome = better ? second : outcome;
        memcpy(better ? x : other, better ? other : x, size);
        problem_evaluate(p, x);
    }
    free(other);
    return outcome;
}

enum outcome descent_settle(struct problem *p, enum method method, double *x)
{
    switch (method) {
    case METHOD_NEWTON: return newton_minimise(p, x);
    case METHOD_PLBFGS: return plbfgs_minimise(p, x);
    case METHOD_LBFGS: return lbfgs_minimise(p, x);
    default: return settle_auto(p, x);
    }
}

/* Goes from x along a direction as long as the energy falls, doubling from a
 * small part of the thickness; y is where it was lowest. */
static bool slide(struct problem *p, const double *x, const double *direction, double sign, double *y)
{
    const struct discretisation *d = p->d;
    double furthest = 0, best = problem_evaluate(p, x), taken = 0;
    for (int i = 0; i < d->nnodes; i++)
        for (int c = 0; c < 3; c++)
            furthest = fmax(furthest, fabs(direction[d->node[i] + c]));
    for (double length = 0.02 * d->sheet->thickness / furthest; length * furthest < 1e3 * d->sheet->thickness; length *= 2) {
        problem_move(p, x, sign * length, direction, y);
        double there = problem_evaluate(p, y);
        if (!(there < best))
            break;
        best = there, taken = length;
    }
    problem_move(p, x, sign * taken, direction, y);
    return taken > 0;
}

/* Down both sides of a saddle; x becomes the lower of the two ends. */
static enum outcome leave_saddle(struct problem *p, enum method method, double *x, const double *direction)
{
    size_t size = sizeof *x * (size_t)p->d->n;
    double *y = MEMORY_ARRAY(double, p->d->n), *lowest = MEMORY_ARRAY(double, p->d->n);
    double energy = INFINITY;
    enum outcome outcome = OUTCOME_STALLED;
    for (double sign = -1; sign <= 1; sign += 2) {
        if (!slide(p, x, direction, sign, y))
            continue;
        enum outcome end = descent_settle(p, method, y);
        if (p->energy.total < energy || end == OUTCOME_STOPPED) {
            energy = p->energy.total;
            outcome = end;
            memcpy(lowest, y, size);
        }
        if (end == OUTCOME_STOPPED)
            break;
    }
    if (isfinite(energy))
        memcpy(x, lowest, size);
    problem_evaluate(p, x);
    free(y), free(lowest);
    return outcome;
}

struct descent descent_to_minimum(struct problem *p, enum method method, double *x)
{
    struct descent end = {.outcome = descent_settle(p, method, x)};
    double *direction = MEMORY_ARRAY(double, p->d->n);
    while (end.outcome == OUTCOME_CONVERGED || end.outcome == OUTCOME_PRECISION) {
        end.minimum = newton_is_minimum(p, x, direction);
        if (end.minimum || end.pushes == MOST_PUSHES)
            break;
        enum outcome outcome = leave_saddle(p, method, x, direction);
        if (outcome == OUTCOME_STALLED)
            break;
        end.outcome = outcome;
        end.pushes++;
    }
    free(direction);
    return end;
}
