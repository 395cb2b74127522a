/* SPDX-License-Identifier: GPL-3.0-or-later
 * One run, whoever asks for it: a script and options in; its swatch folded,
 * its outputs written, the record of both out. */
#ifndef WEFT_RUN_H
#define WEFT_RUN_H

#include "cli/checkpoint.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/script.h"
#include "cli/seeds.h"
#include "cli/state.h"

/* Begin with options and, where outputs go into a folder of their own rather
 * than where their paths say, into; a point of a
 * sweep says so; all else zero. */
struct run {
    const struct options *options;
    const char           *into;         /* NULL: outputs go where their paths say */
    bool                  of_sweep;     /* a point: goes on of its own accord where it was killed */

    double                begun;        /* on progress_clock */
    struct script         script;
    struct state          state;        /* that of options->start */
    struct outputs        outputs;      /* its log says what was written */
    struct progress       progress;
    struct seeds          seeds;        /* tried before the fold that is kept, if several were asked for */
    uint64_t              seed;         /* of that fold */
    struct checkpoint     checkpoint;   /* of that fold */
    struct fold_record    record;
};

/* Compiles the script at path, folds it and writes all outputs and the
 * manifest.  What goes wrong is said on standard error.  run_free in any case. */
enum status run_script(struct run *run, const char *path);
void        run_free(struct run *run);

/* All that the report and the manifest say of a run. */
struct report run_report(const struct run *run);

#endif
