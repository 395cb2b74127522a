/* SPDX-License-Identifier: GPL-3.0-or-later
 * The driver: a constant sheet in, the folded sheet and its record out. */
#ifndef WEFT_FOLD_H
#define WEFT_FOLD_H

#include <stdbool.h>

#include "solver/surface.h"

struct sheet;           /* sheet.h: the constant model, made from a scene by sheet_build */
struct fold_state;      /* one state of the sheet, valid during a call of an observer or until fold_free */

/* Who wants to know, and when.  Any member may be NULL. */
struct fold_observer {
    void *self;
    /* Before the first step (growth = 0, the flat sheet) and after each
     * completed one; false stops the fold cleanly.  The final, polished state
     * comes as the last step (growth = 1). */
    bool (*step)(void *self, const struct fold_step *step, const struct fold_state *state);
    /* Now and then while minimising: iterations within the step so far and the
     * current energy.  false stops the fold cleanly. */
    bool (*progress)(void *self, double growth, int iterations, double energy);
};

/* A growth step as it can be kept, and gone on from. */
struct fold_mark {
    struct fold_step step;
    int              iterations, evaluations, factorisations;   /* of the fold so far */
    int              n;
    const double    *x;                 /* (n) unknowns of the level the sheet grows on */
};

/* Where another fold of as many stitches may begin instead of growing. */
struct fold_start {
    int           columns, rows;        /* of stitches */
    double        energy;               /* there, on the level the sheet grows on, at the full curvature */
    int           n;                    /* 0: nowhere, the sheet has no curvature */
    const double *x;                    /* (n) unknowns of that level */
};

struct fold_options {
    int  threads;           /* 0 = all processors */
    int  nmarks;            /* steps that a fold of the same sheet came to; it goes on after the last */
    const struct fold_mark *mark;       /* (nmarks), the first at growth 0; shown to the observer as if new */
    const struct fold_start *start;     /* where to begin, NULL: grow; the fold fails if it is of another mesh */
    bool coarse;            /* end on the level the sheet grows on */
    long most_factored;     /* unknowns beyond which Newton's steps are found by conjugate gradients; 0 = FOLD_MOST_FACTORED */
};

enum { FOLD_MOST_FACTORED = 600000 };

/* The threads a fold takes that is asked for so many, 0 = all processors. */
int fold_threads(int asked);

/* Folds the sheet.  Prints nothing; what went wrong is record->status and
 * record->remark.  The record is always filled; free with fold_record_free.
 * Returns the final state (free with fold_free), NULL when out of range. */
struct fold_state *fold_run(const struct sheet *sheet, const struct fold_options *options,
                            const struct fold_observer *observer, struct fold_record *record);
void fold_free(struct fold_state *state);

/* What to keep of a step, in an observer's call; x is the state's own. */
struct fold_mark fold_mark(const struct fold_step *step, const struct fold_state *state);

/* Where the fold was on the level it grew on; x is the state's own. */
struct fold_start fold_start(const struct fold_state *state);

/* Samples a state into a surface made for the same stitches, at any per_stitch. */
void fold_sample(const struct fold_state *state, struct surface *surface);

#endif
