/* SPDX-License-Identifier: GPL-3.0-or-later
 * The files of a run: a scene's list of outputs, growth steps and the final
 * state in; files out, each at its time. */
#ifndef WEFT_OUTPUTS_H
#define WEFT_OUTPUTS_H

#include "cli/options.h"
#include "output/file.h"
#include "output/glb.h"
#include "output/pvd.h"
#include "output/report.h"
#include "solver/fold.h"

struct outputs {
    const struct scene *scene;
    struct file_log     log;
    struct pvd         *pvd;        /* (scene->noutputs), begun where the output is a collection */
    struct glb         *glb;        /* (scene->noutputs), begun where the output is one */
    struct page       **page;       /* (scene->noutputs), begun where the output is a page and this weft has it */
    bool                strict;     /* warnings are errors */
    double              write_s;    /* wall seconds so far */
};

/* Sees to it, before any work is done, that every output can be written: its
 * kind is there, its folder takes files.  log.into and strict may be set before.  Says on
 * standard error what does not fit.  Free with outputs_end in any case. */
enum status outputs_begin(struct outputs *outputs, const struct scene *scene);
void        outputs_end(struct outputs *outputs);

/* Each writes the outputs that are due then; false: see outputs->log.error. */
bool outputs_chart(struct outputs *outputs);
bool outputs_step(struct outputs *outputs, const struct fold_step *step, const struct fold_state *state);
bool outputs_final(struct outputs *outputs, const struct fold_state *state, const struct fold_record *record);
bool outputs_stopped(struct outputs *outputs);
bool outputs_report(struct outputs *outputs, struct report *report);

/* Plots and tables in a script with a sweep are of the sweep, not of its runs. */
bool outputs_of_sweep(const struct scene *scene, int index);

/* Was something written of an output that the growth steps go into? */
bool outputs_kept(const struct outputs *outputs, int index);

/* Growth steps a collection has so far; -1: the output is not a collection. */
int outputs_steps(const struct outputs *outputs, int index);

/* A chart to write: as a chart in the format of its extension, or as pixels. */
struct chart_file {
    enum output_kind  kind;
    const char       *path;
    struct chart_look look;     /* where it is drawn */
};

/* Can it be written; can it of this fabric (STATUS_SCRIPT: why not is said on
 * standard error); writes it, NULL error: done. */
bool        outputs_has_chart(struct chart_file chart);
enum status outputs_check_chart(struct chart_file chart, const struct scene *scene);
bool        outputs_write_chart(struct file_log *log, struct chart_file chart, const struct scene *scene);

#endif
