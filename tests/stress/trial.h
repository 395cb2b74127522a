/* SPDX-License-Identifier: GPL-3.0-or-later
 * A fold judged by other means than its own: gradient computed again, inertia
 * by a dense factor, every number looked at. */
#ifndef WEFT_STRESS_TRIAL_H
#define WEFT_STRESS_TRIAL_H

#include "solver/fold.h"
#include "solver/sheet.h"

/* What is wrong with a result; a set. */
enum {
    WRONG_NUMBER   = 1,     /* not finite, in the record or in the surface */
    WRONG_GRADIENT = 2,     /* not what the record says, or too large for "converged" */
    WRONG_INERTIA  = 4,     /* called a minimum, but the Hessian has a negative direction */
    WRONG_CLAIM    = 8      /* a good status without a minimum, or a bad one without a remark */
};

struct trial {
    enum fold_status status;
    unsigned         wrong;
    bool             dense;             /* the inertia was found by a dense factor */
    bool             minimum, pushed;   /* as the record says */
    int              iterations;
    long             unknowns;
    double           energy, gradient, seconds;
    double           extent_x, extent_y, extent_z;
    char             remark[160];
};

/* Folds with one thread and judges the result. */
struct trial trial_fold(const struct sheet *sheet);

/* The same in a child process: false when it crashed or took longer than limit seconds;
 * how says which ("signal 11", "time"). */
bool trial_apart(const struct sheet *sheet, int limit, struct trial *trial, char how[24]);

/* Did the fold end because the sheet is crushed at a point (patch_doubt) or its triangles are too coarse
 * (triangle_doubt), and say so? */
bool trial_crushed(const struct trial *trial);

/* Is the outcome a minimum, and nothing wrong with it? */
static inline bool trial_good(const struct trial *trial)
{
    return (trial->status == FOLD_CONVERGED || trial->status == FOLD_PRECISION) && !trial->wrong;
}

#endif
