/* SPDX-License-Identifier: GPL-3.0-or-later
 * Which folds the points of a sweep take: the folds that came to an end in; those
 * to run next, and the one each point keeps, out.
 *
 * Plainly, each point folds from the flat sheet.  With --warm the points along the
 * last param are a chain, and from its point a to its point b:
 *   a and b fold from flat;
 *   a + 1, ... b each fold from the state of the one before, the first from a's;
 *   where each of these leads back to the one before, and b so comes to the energy
 *   it has from flat, a + 1, ... b - 1 keep them;
 *   where not, the same from a to the middle and from the middle to b;
 *   with few points between, all fold from flat. */
#ifndef WEFT_SWEEP_PLAN_H
#define WEFT_SWEEP_PLAN_H

#include "cli/sweep_point.h"

/* A fold of a point. */
struct sweep_fold {
    int                number, from;    /* as sweep_point takes them */
    bool               wanted, done;
    bool               good;            /* converged, and leads back to where it began */
    double             energy;
    struct sweep_fold *other;           /* of the same point */
    struct sweep_fold *next;            /* to be run */
};

struct sweep_plan {
    const struct sweep *sweep;
    bool                looking;        /* nothing will be run: an error in the script at a point stands */
    struct sweep_fold **fold;           /* (npoints) those looked at */
    int                *from;           /* (npoints) the fold that is kept, -1: not known yet */
    int                 nwanted;
    struct sweep_fold  *next, **last;   /* to be run */
    struct arena        arena;          /* owns it all */
};

/* Looks at all points.  Free with sweep_plan_free. */
void sweep_plan_begin(struct sweep_plan *plan, const struct sweep *sweep, bool looking);
void sweep_plan_free(struct sweep_plan *plan);

/* Looks again at the chain of a point of which a fold has ended. */
void sweep_plan_look(struct sweep_plan *plan, int number);

/* The next fold to run, or NULL; it is off the list then. */
struct sweep_fold *sweep_plan_next(struct sweep_plan *plan);

/* How many points have the fold they keep. */
int sweep_plan_done(const struct sweep_plan *plan);

#endif
