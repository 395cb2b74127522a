/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a run would lose if it were killed: growth steps in, a file to go on
 * from out, which is gone once the run is complete. */
#ifndef WEFT_CHECKPOINT_H
#define WEFT_CHECKPOINT_H

#include <stdio.h>

#include "cli/options.h"
#include "output/file.h"
#include "output/report.h"
#include "solver/fold.h"

/* All zero: nothing is kept. */
struct checkpoint {
    char             *path;             /* beside the manifest: NAME.checkpoint */
    FILE             *stream;           /* NULL: not begun, or it could not be written */
    char              key[FILE_HASH];   /* of program, scene, seed, threads: what the steps depend on */
    int               nmarks, nshown;   /* steps in the file; of those read, how many the fold has gone through */
    struct fold_mark *mark;             /* (those read) owned, with their x */
    int               nread;
};

/* Of the steps that are there: none is wanted; those that fit; or those, and
 * it is an error if they are of another run. */
enum checkpoint_wish { CHECKPOINT_ANEW, CHECKPOINT_IF_IT_FITS, CHECKPOINT_MUST_FIT };

/* Says where the steps of a run go, which report describes: beside its manifest,
 * below into if that is no NULL.  Reads those that are wanted, and says so.
 * STATUS_FILES, with the reason on standard error, where they had to fit. */
enum status checkpoint_open(struct checkpoint *c, const struct report *report, const struct options *options,
                            enum checkpoint_wish wish, const char *into);

/* Appends a step, each with its hash, so that one cut off half-way is seen.
 * Where that fails, it is said once, and the run goes on without. */
void checkpoint_step(struct checkpoint *c, const struct fold_step *step, const struct fold_state *state);

/* Ends it; complete: the file is removed. */
void checkpoint_close(struct checkpoint *c, bool complete);

#endif
