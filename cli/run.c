/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft run`: a script in; its swatch folded, its outputs written and a summary
 * on standard output out. */
#include <config.h>

#include "cli/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "cli/cached.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/manifest.h"
#include "cli/repeat.h"
#include "lang/names.h"
#include "solver/forecast.h"
#include "solver/sheet.h"

/* ---- while it folds ---- */

static bool on_step(void *self, const struct fold_step *step, const struct fold_state *state)
{
    struct run *run = self;
    progress_step(&run->progress, step);
    if (!outputs_step(&run->outputs, step, state))
        return false;
    checkpoint_step(&run->checkpoint, step, state);
    return !interrupt_asked();
}

static bool on_progress(void *self, double growth, int iterations, double energy)
{
    struct run *run = self;
    progress_iteration(&run->progress, growth, iterations, energy);
    return !interrupt_asked();
}

/* While several seeds are tried nothing is written; each begins its own progress. */
static bool on_trial_step(void *self, const struct fold_step *step, const struct fold_state *state)
{
    struct run *run = self;
    (void)state;
    if (step->growth == 0) {
        progress_end(&run->progress);
        run->progress = progress_begin(run->script.scene->solve.steps, run->options->quiet);
    }
    progress_step(&run->progress, step);
    return !interrupt_asked();
}

/* ---- afterwards ---- */

static const struct {
    const char *sentence;
    bool        good;       /* a minimum: exit status 0 */
} ending[] = {
    [FOLD_CONVERGED]       = {"converged", true},
    [FOLD_PRECISION]       = {"converged to the precision of the arithmetic", true},
    [FOLD_SADDLE]          = {"not converged: this is a saddle, not a minimum", false},
    [FOLD_ITERATION_LIMIT] = {"not converged: the limit of iterations was reached", false},
    [FOLD_FAILED]          = {"failed", false},
};

static void print_files(const struct run *run)
{
    const struct outputs *outputs = &run->outputs;
    const struct scene *scene = outputs->scene;
    const char *before = "wrote";
    char *manifest = run->options->no_manifest ? NULL : manifest_path(scene, ".manifest.json");
    for (int i = 0; i < scene->noutputs; i++) {
        int steps = outputs_steps(outputs, i);
        if (!file_log_find(&outputs->log, scene->output[i].path))
            continue;
        printf("%s %s", before, scene->output[i].path);
        if (steps >= 0)
            printf(" and its %d %s", steps, names_count(steps, "step", "steps"));
        before = ",";
    }
    for (int i = 0; i < scene->noutputs; i++)
        if (outputs_of_sweep(scene, i)) {
            printf("%s%s is of `weft sweep`", *before == ',' ? "; " : "", scene->output[i].path);
            before = ",";
        }
    if (manifest)
        printf("; manifest %s", manifest);
    free(manifest);
    printf("%s\n", scene->noutputs == 0 ? "nothing written: no output in the script, no -o" : "");
}

static void print_summary(const struct run *run)
{
    const struct fold_record *r = &run->record;
    printf("%s: %s%s%s\n", source_called(run->script.scene->file), ending[r->status].sentence, r->remark ? "; " : "",
           r->remark ? r->remark : "");
    if (r->status != FOLD_FAILED) {
        printf("energy %.6g: stretching %.6g, bending %.6g, springs %.6g", r->energy.total, r->energy.stretching,
               r->energy.bending, r->energy.springs);
        if (r->energy_error >= 0)
            printf("; error about %.2g %%", 100 * r->energy_error);
        printf("\nfolded to %.3g of its width and %.3g of its height, %.3g deep\n", r->extent_x, r->extent_y, r->extent_z);
    }
    if (run->options->verbose)
        printf("%s, %d per stitch: %ld unknowns; %s: %d iterations, %d evaluations, %d factorisations; "
               "largest gradient %.2g; %d threads\n",
               r->kind, r->per_stitch, r->unknowns, r->method, r->iterations, r->evaluations, r->factorisations,
               r->gradient_max, r->threads);
    print_files(run);
    printf("%.2f s\n", progress_clock() - run->begun);
}

struct report run_report(const struct run *run)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (struct report){
        .scene = run->script.scene,
        .record = &run->record,
        .source = run->script.source->text,
        .source_size = run->script.source->size,
        .total_s = progress_clock() - run->begun,
        .compile_s = run->script.compile_s,
        .nseeds = run->seeds.nresults,
        .seed = run->seeds.result,
        .kept_seed = run->seed,
        .peak_bytes = usage.ru_maxrss * 1024,
    };
}

static bool write_records(struct run *run)
{
    struct report report = run_report(run);
    return outputs_report(&run->outputs, &report) && (run->options->no_manifest || manifest_write(run));
}

/* A run that came to its end: good or bad is the solver's word. */
static enum status finished(const struct run *run)
{
    bool good = ending[run->record.status].good;
    if (!run->options->quiet)
        print_summary(run);
    else if (!good)
        fprintf(stderr, "weft: %s: %s\n", source_called(run->script.scene->file), ending[run->record.status].sentence);
    return good ? STATUS_DONE : STATUS_FAILED;
}

/* Says what stopped a run that could not end. */
static enum status stopped(const struct run *run)
{
    if (run->outputs.log.error) {
        fprintf(stderr, "weft: %s\n", run->outputs.log.error);
        return STATUS_FILES;
    }
    fprintf(stderr, "weft: stopped after %d of %d growth steps", run->progress.done, run->progress.nsteps);
    for (int i = 0; i < run->script.scene->noutputs; i++)
        if (outputs_kept(&run->outputs, i))
            fprintf(stderr, "; %s holds what is complete", run->script.scene->output[i].path);
    fprintf(stderr, "%s\n", run->checkpoint.nmarks == 0 ? ""
                            : run->of_sweep             ? "; the sweep goes on from there"
                                                        : "; --resume goes on from there");
    return STATUS_FAILED;
}

/* ---- the run ---- */

/* What a run would do. */
static void print_plan(const struct scene *scene, int seeds)
{
    struct sheet *sheet = sheet_build(scene);
    struct forecast forecast = forecast_fold(sheet);
    sheet_free(sheet);
    bool plain = scene->solve.method == METHOD_LBFGS;
    printf("%s: %d %s x %d %s, %d growth %s\n", source_called(scene->file), scene->grid->columns,
           names_count(scene->grid->columns, "stitch", "stitches"), scene->grid->rows, names_count(scene->grid->rows, "row", "rows"),
           scene->solve.steps, names_count(scene->solve.steps, "step", "steps"));
    printf("%d per stitch%s: %ld unknowns, %ld elements\n", forecast.per_stitch,
           scene->mesh.per_stitch || plain ? "" : " (as a sample of the swatch takes)", forecast.unknowns, forecast.elements);
    if (seeds > 1) {    /* the one that is kept is folded once more */
        printf("%d seeds\n", seeds);
        forecast.seconds *= seeds + 1;
    }
    printf(forecast.seconds < 10 ? "about %.2g s, %.2g GB%s\n" : "about %.0f s, %.2g GB%s\n", forecast.seconds,
           forecast.bytes / 1e9,
           plain ? " and many times that: lbfgs takes thousands of iterations" : "");
    int n = 0;
    for (int i = 0; i < scene->noutputs; i++)
        if (!outputs_of_sweep(scene, i))
            printf("%s %s", n++ == 0 ? "would write" : ",", scene->output[i].path);
    printf("%s", n > 0 ? "\n" : "");
}

/* Where several seeds are asked for, leaves the sheet with the one to keep; false: interrupted. */
static bool choose_seed(struct run *run, const struct fold_options *options, struct sheet *sheet)
{
    const struct fold_observer observer = {run, on_trial_step, on_progress};
    if (run->options->seeds > 1 && !seeds_try(&run->seeds, run->options->seeds, sheet, options, &observer))
        return false;
    progress_end(&run->progress);
    run->seed = sheet->solve.seed;
    if (run->seeds.nresults > 0 && !run->options->quiet)
        seeds_print(&run->seeds);
    return true;
}

/* The steps to begin with, where there is a run to go on with; STATUS_FILES: its checkpoint does not fit. */
static enum status open_checkpoint(struct run *run, struct fold_options *options)
{
    const struct report report = run_report(run);
    if (run->options->start || (run->into && !run->of_sweep))
        return STATUS_DONE;
    enum checkpoint_wish wish = run->of_sweep           ? CHECKPOINT_IF_IT_FITS
                                : run->options->resume ? CHECKPOINT_MUST_FIT
                                                       : CHECKPOINT_ANEW;
    enum status status = checkpoint_open(&run->checkpoint, &report, run->options, wish, run->into);
    options->nmarks = run->checkpoint.nmarks;
    options->mark = run->checkpoint.mark;
    return status;
}

/* Folds the scene's swatch and writes all its outputs. */
static enum status fold_and_write(struct run *run)
{
    const struct options *asked = run->options;
    struct fold_options options = {.threads = asked->threads, .start = asked->start ? &run->state.start : NULL};
    const struct fold_observer observer = {run, on_step, on_progress};
    struct sheet *sheet = sheet_build(run->script.scene);
    bool written = outputs_chart(&run->outputs);

    interrupt_ask_first();
    written = written && choose_seed(run, &options, sheet);
    if (written && open_checkpoint(run, &options) != STATUS_DONE) {
        sheet_free(sheet);
        return STATUS_FILES;
    }
    run->progress = progress_begin(asked->start ? 1 : run->script.scene->solve.steps, asked->quiet);
    struct fold_state *state = written ? fold_run(sheet, &options, &observer, &run->record) : NULL;
    progress_end(&run->progress);

    written = written && !run->outputs.log.error && !interrupt_asked();
    bool folded = written && state && run->record.status != FOLD_FAILED;
    written = written && (!folded || outputs_final(&run->outputs, state, &run->record)) && write_records(run);
    if (!written && interrupt_asked() && !run->outputs.log.error)
        outputs_stopped(&run->outputs);
    checkpoint_close(&run->checkpoint, written);
    fold_free(state);
    sheet_free(sheet);
    return written ? finished(run) : stopped(run);
}

/* Of a script with a sweep this is one point, and not one of its table. */
static void note_sweep(const struct run *run)
{
    const struct scene *scene = run->script.scene;
    int npoints = 1;
    for (int i = 0; i < scene->naxes; i++)
        npoints *= scene->axis[i].npoints;
    if (scene->naxes > 0 && !run->of_sweep && !run->options->quiet)
        fprintf(stderr, "note: %s has a sweep of %d %s; this run takes each param as it stands, `weft sweep %s` runs all points\n",
                source_called(scene->file), npoints, names_count(npoints, "point", "points"), scene->file);
}

enum status run_script(struct run *run, const char *path)
{
    run->begun = progress_clock();
    enum status status = script_load(&run->script, path, run->options);
    run->outputs.log.into = run->into;
    run->outputs.strict = run->options->warnings;
    if (status == STATUS_DONE)
        note_sweep(run);
    if (status == STATUS_DONE)
        status = outputs_begin(&run->outputs, run->script.scene);
    if (status == STATUS_DONE && run->options->start && !state_read(&run->state, run->options->start))
        status = STATUS_FILES;
    if (status == STATUS_DONE && run->options->cached && cached_holds(run))
        return STATUS_DONE;
    if (status == STATUS_DONE && run->options->dry_run)
        print_plan(run->script.scene, run->options->seeds);
    else if (status == STATUS_DONE)
        status = fold_and_write(run);
    return status;
}

void run_free(struct run *run)
{
    fold_record_free(&run->record);
    seeds_free(&run->seeds);
    if (run->script.scene)
        outputs_end(&run->outputs);
    state_free(&run->state);
    script_free(&run->script);
}

enum status command_run(const struct options *options)
{
    if (options->from)
        return repeat_run(options);
    struct run run = {.options = options};
    enum status status = run_script(&run, options->operand[0]);
    run_free(&run);
    return status;
}
