/* SPDX-License-Identifier: GPL-3.0-or-later
 * The files of a run: a scene's list of outputs, growth steps and the final
 * state in; files out, each at its time. */
#include <config.h>

#include "cli/outputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "charts/csv.h"
#include "charts/drawn.h"
#include "charts/knitout.h"
#include "charts/picture.h"
#include "cli/progress.h"
#include "cli/script.h"
#include "cli/state.h"
#include "output/chart.h"
#include "output/growth.h"
#include "output/obj.h"
#include "output/page.h"
#include "output/portrait.h"
#include "output/ply.h"
#include "output/stl.h"
#include "output/vtp.h"

/* Samples along a stitch's side where an output does not say. */
enum { SAMPLES_DEFAULT = 2, SAMPLES_PICTURE = 4 };

/* ---- what can be written ---- */

/* When: of a writer, all its times; of an occasion, one.  Final: a fold that did
 * not fail; record: any fold, once it has ended. */
enum due { DUE_CHART = 1, DUE_STEP = 2, DUE_FINAL = 4, DUE_RECORD = 8, DUE_REPORT = 16, DUE_STOPPED = 32 };

/* What is known when outputs are due: the members that make sense then. */
struct occasion {
    enum due                 due;
    const struct fold_step  *step;
    const struct fold_state *state;
    const struct fold_record *record;
    const struct report     *report;
};

typedef bool write_output(struct outputs *outputs, int index, const struct occasion *now);
static write_output write_report, write_chart, write_step, write_mesh, write_glb, write_page, write_growth, write_state;

static const struct writer {
    enum output_kind kind;
    const char      *extension;     /* the only one of the kind, NULL: any */
    unsigned         due;
    write_output    *write;
} writers[] = {
    {OUTPUT_REPORT, NULL,   DUE_REPORT, write_report},
    {OUTPUT_CHART,  ".txt", DUE_CHART,  write_chart},
    {OUTPUT_CHART,  ".csv", DUE_CHART,  write_chart},
    {OUTPUT_CHART,  ".k",   DUE_CHART,  write_chart},
    {OUTPUT_CHART,  ".svg", DUE_CHART,  write_chart},
    {OUTPUT_CHART,  ".pdf", DUE_CHART,  write_chart},
    {OUTPUT_CHART,  ".png", DUE_CHART,  write_chart},
    {OUTPUT_PIXELS, NULL,   DUE_CHART,  write_chart},
    {OUTPUT_PVD,    NULL,   DUE_STEP,   write_step},
    {OUTPUT_VTP,    NULL,   DUE_FINAL,  write_mesh},
    {OUTPUT_OBJ,    NULL,   DUE_FINAL,  write_mesh},
    {OUTPUT_PLY,    NULL,   DUE_FINAL,  write_mesh},
    {OUTPUT_STL,    NULL,   DUE_FINAL,  write_mesh},
    {OUTPUT_PICTURE, NULL,  DUE_FINAL,  write_mesh},
    {OUTPUT_STATE,  NULL,   DUE_FINAL,  write_state},
    {OUTPUT_PLOT,   NULL,   DUE_RECORD, write_growth},
    {OUTPUT_TABLE,  NULL,   DUE_RECORD, write_growth},
    {OUTPUT_GLB,    NULL,   DUE_STEP | DUE_FINAL | DUE_STOPPED, write_glb},
    {OUTPUT_HTML,   NULL,   DUE_STEP | DUE_FINAL | DUE_STOPPED, write_page},
};
enum { NWRITERS = sizeof writers / sizeof writers[0] };

static bool has_extension(const char *path, const char *extension)
{
    size_t n = strlen(path), m = strlen(extension);
    return n >= m && strcasecmp(path + n - m, extension) == 0;
}

static const struct writer *find_writer(enum output_kind kind, const char *path)
{
    for (const struct writer *w = writers; w < writers + NWRITERS; w++)
        if (w->kind == kind && (!w->extension || has_extension(path, w->extension)))
            return w;
    return NULL;
}

bool outputs_of_sweep(const struct scene *scene, int index)
{
    const struct output *output = &scene->output[index];
    return scene->naxes > 0 && output->line > 0 && (output->kind == OUTPUT_TABLE || output->kind == OUTPUT_PLOT);
}

bool outputs_has_chart(struct chart_file chart)
{
    return find_writer(chart.kind, chart.path);
}

/* A chart as a drawing, not as text. */
static bool is_drawn(struct chart_file chart, enum canvas_format *format)
{
    return chart.kind == OUTPUT_CHART && canvas_format_of(chart.path, format);
}

enum status outputs_check_chart(struct chart_file chart, const struct scene *scene)
{
    enum canvas_format format;
    const char *refusal = is_drawn(chart, &format) ? drawn_refusal(scene, &chart.look, format) : NULL;
    if (refusal) {
        fprintf(stderr, "%s: the chart cannot be written as '%s': %s\n", source_called(scene->file), chart.path, refusal);
        return STATUS_SCRIPT;
    }
    bool plain = chart.kind == OUTPUT_PIXELS || (chart.kind == OUTPUT_CHART && has_extension(chart.path, ".k"));
    return plain ? script_knit_and_purl(scene) : STATUS_DONE;
}

/* ---- before any work ---- */

static void print_place(const struct scene *scene, const struct output *output, const char *severity)
{
    if (output->line > 0)
        fprintf(stderr, "%s:%d: %s: ", source_called(scene->file), output->line, severity);
    else
        fprintf(stderr, "weft: -o %s: ", output->path);
}

/* The error belongs to the script, or to the command line. */
static enum status status_of(const struct output *output)
{
    return output->line > 0 ? STATUS_SCRIPT : STATUS_USAGE;
}

static enum status check_kind(const struct scene *scene, const struct output *output)
{
    if (find_writer(output->kind, output->path))
        return STATUS_DONE;
    print_place(scene, output, "error");
    fprintf(stderr, "this weft cannot write the %s '%s'; it can write:", output_kind_name(output->kind), output->path);
    for (const struct writer *w = writers; w < writers + NWRITERS; w++)
        fprintf(stderr, "%s %s%s%s%s", w == writers ? "" : ",", output_kind_name(w->kind), w->extension ? " (" : "",
                w->extension ? w->extension : "", w->extension ? ")" : "");
    fprintf(stderr, "\n");
    return status_of(output);
}

/* A kind that this binary could write had it been built with all.  A script that
 * asks for it among others is still good, and goes without. */
static enum status check_built(const struct outputs *outputs, const struct output *output)
{
    bool bad = output->line == 0 || outputs->strict;
    if (output->kind != OUTPUT_HTML || page_is_there())
        return STATUS_DONE;
    print_place(outputs->scene, output, bad ? "error" : "warning");
    fprintf(stderr, "this weft cannot write the page '%s': npm or its registry was missing when it was built "
                    "(docs/formats.md, 'The page')\n", output->path);
    return bad ? status_of(output) : STATUS_DONE;
}

static enum status check_path(struct outputs *outputs, const struct output *output)
{
    if (file_check(&outputs->log, output->path))
        return STATUS_DONE;
    print_place(outputs->scene, output, "error");
    fprintf(stderr, "%s\n", outputs->log.error ? outputs->log.error : "out of memory");
    return STATUS_FILES;
}

enum status outputs_begin(struct outputs *outputs, const struct scene *scene)
{
    *outputs = (struct outputs){.scene = scene, .strict = outputs->strict, .log.into = outputs->log.into};
    outputs->pvd = calloc((size_t)scene->noutputs + 1, sizeof *outputs->pvd);
    outputs->glb = calloc((size_t)scene->noutputs + 1, sizeof *outputs->glb);
    outputs->page = calloc((size_t)scene->noutputs + 1, sizeof *outputs->page);
    if (!outputs->pvd || !outputs->glb || !outputs->page)
        return STATUS_FAILED;
    for (int i = 0; i < scene->noutputs; i++) {
        const struct output *output = &scene->output[i];
        enum status status = check_kind(scene, output);
        if (status == STATUS_DONE)
            status = outputs_check_chart((struct chart_file){output->kind, output->path, output->chart}, scene);
        if (status == STATUS_DONE)
            status = check_built(outputs, output);
        if (status == STATUS_DONE && !outputs_of_sweep(scene, i))
            status = check_path(outputs, output);
        if (status != STATUS_DONE)
            return status;
        if (find_writer(output->kind, output->path)->due == DUE_STEP)
            outputs->pvd[i] = pvd_begin(&outputs->log, output->path, scene, output->format);
        if (output->kind == OUTPUT_GLB)
            outputs->glb[i] = glb_begin(scene);
        if (output->kind == OUTPUT_HTML && page_is_there())
            outputs->page[i] = page_begin(scene);
    }
    return STATUS_DONE;
}

void outputs_end(struct outputs *outputs)
{
    for (int i = 0; outputs->pvd && i < outputs->scene->noutputs; i++)
        pvd_end(&outputs->pvd[i]);
    for (int i = 0; outputs->glb && i < outputs->scene->noutputs; i++)
        glb_end(&outputs->glb[i]);
    for (int i = 0; outputs->page && i < outputs->scene->noutputs; i++)
        page_end(outputs->page[i]);
    free(outputs->pvd);
    free(outputs->glb);
    free(outputs->page);
    file_log_free(&outputs->log);
}

/* ---- writing ---- */

static void write_knitout(struct text *text, const struct scene *scene)
{
    knitout_write(text, scene->grid);
}

static void write_pixels(struct text *text, const struct scene *scene)
{
    picture_write(text, scene->grid);
}

typedef void write_text(struct text *text, const struct scene *scene);

static void send(void *file, const void *bytes, size_t n)
{
    file_write(file, bytes, n);
}

static bool write_drawn(struct file_log *log, struct chart_file chart, enum canvas_format format,
                        const struct scene *scene)
{
    struct file *file = file_create(log, chart.path);
    const char *why = file ? drawn_chart(scene, &chart.look, format, send, file) : NULL;
    if (why) {
        file_fail(log, "%s: %s", chart.path, why);
        file_abandon(file);
    }
    return file && !why && file_commit(file);
}

bool outputs_write_chart(struct file_log *log, struct chart_file chart, const struct scene *scene)
{
    enum canvas_format format;
    if (is_drawn(chart, &format))
        return write_drawn(log, chart, format, scene);
    write_text *write = chart.kind == OUTPUT_PIXELS            ? write_pixels
                        : has_extension(chart.path, ".csv") ? csv_write
                        : has_extension(chart.path, ".k")   ? write_knitout
                                                            : NULL;
    struct arena arena = {0};
    struct text text = {.arena = &arena};
    struct file *file = file_create(log, chart.path);
    if (file && write) {
        write(&text, scene);
        file_write(file, text.bytes, text.length);
    } else if (file) {
        chart_grid(file, scene);
    }
    arena_free(&arena);
    return file && file_commit(file);
}

/* The state at the points an output asks for. */
static struct surface sample(const struct scene *scene, int index, const struct fold_state *state)
{
    const struct output *output = &scene->output[index];
    int usual = output->kind == OUTPUT_PICTURE ? SAMPLES_PICTURE
              : output->kind == OUTPUT_HTML    ? page_per_stitch(scene) : SAMPLES_DEFAULT;
    struct surface surface = surface_make(scene->grid->columns, scene->grid->rows,
                                          output->per_stitch > 0 ? output->per_stitch : usual);
    fold_sample(state, &surface);
    return surface;
}

static bool write_report(struct outputs *outputs, int index, const struct occasion *now)
{
    return report_write(&outputs->log, outputs->scene->output[index].path, now->report);
}

static bool write_chart(struct outputs *outputs, int index, const struct occasion *now)
{
    (void)now;
    const struct output *output = &outputs->scene->output[index];
    return outputs_write_chart(&outputs->log, (struct chart_file){output->kind, output->path, output->chart}, outputs->scene);
}

static bool write_step(struct outputs *outputs, int index, const struct occasion *now)
{
    struct surface surface = sample(outputs->scene, index, now->state);
    bool done = pvd_step(&outputs->pvd[index], now->step->growth, &surface);
    surface_free(&surface);
    return done;
}

static bool write_mesh(struct outputs *outputs, int index, const struct occasion *now)
{
    const struct scene *scene = outputs->scene;
    const struct output *output = &scene->output[index];
    struct file_log *log = &outputs->log;
    struct surface surface = sample(scene, index, now->state);
    bool done = false;
    switch (output->kind) {
    case OUTPUT_VTP: done = vtp_write(log, output->path, scene, &surface, output->format); break;
    case OUTPUT_OBJ: done = obj_write(log, output->path, scene, &surface); break;
    case OUTPUT_PLY: done = ply_write(log, output->path, scene, &surface); break;
    case OUTPUT_STL: done = stl_write(log, output->path, &surface); break;
    case OUTPUT_PICTURE: done = portrait_write(log, output, scene, &surface); break;
    default: break;
    }
    surface_free(&surface);
    return done;
}

static bool write_growth(struct outputs *outputs, int index, const struct occasion *now)
{
    const struct output *output = &outputs->scene->output[index];
    return output->kind == OUTPUT_PLOT ? growth_plot(&outputs->log, output, now->record)
                                       : growth_table(&outputs->log, output->path, now->record);
}

static bool write_state(struct outputs *outputs, int index, const struct occasion *now)
{
    const struct fold_start start = fold_start(now->state);
    return state_write(&outputs->log, outputs->scene->output[index].path, &start);
}

static bool keep_step(struct outputs *outputs, int index, const struct occasion *now)
{
    struct glb *glb = &outputs->glb[index];
    if (!glb_wants(glb, now->step->growth))
        return glb_step(glb, now->step->growth, NULL);
    struct surface surface = sample(outputs->scene, index, now->state);
    bool done = glb_step(glb, now->step->growth, &surface);
    surface_free(&surface);
    if (!done)
        file_fail(&outputs->log, "out of memory");
    return done;
}

/* The next two gather the steps, and are written in the end. */
static bool write_glb(struct outputs *outputs, int index, const struct occasion *now)
{
    const struct glb *glb = &outputs->glb[index];
    const char *path = outputs->scene->output[index].path;
    if (now->due == DUE_STEP)
        return keep_step(outputs, index, now);
    if (now->due == DUE_STOPPED)
        return glb->nsteps == 0 || glb_write(glb, &outputs->log, path, NULL);
    struct surface surface = sample(outputs->scene, index, now->state);
    bool done = glb_write(glb, &outputs->log, path, &surface);
    surface_free(&surface);
    return done;
}

static bool write_page(struct outputs *outputs, int index, const struct occasion *now)
{
    struct page *page = outputs->page[index];
    if (!page)
        return true;
    if (now->due != DUE_STEP)
        return page_nsteps(page) == 0 || page_write(page, &outputs->log, outputs->scene->output[index].path, now->record);
    if (page_wants(page, now->step)) {
        struct surface surface = sample(outputs->scene, index, now->state);
        page_add(page, now->step, &surface);
        surface_free(&surface);
    }
    return true;
}

/* All outputs that are due. */
static bool write_due(struct outputs *outputs, const struct occasion *now)
{
    double begun = progress_clock();
    bool done = true;
    for (int i = 0; i < outputs->scene->noutputs && done; i++) {
        const struct output *output = &outputs->scene->output[i];
        const struct writer *writer = find_writer(output->kind, output->path);
        if (writer->due & now->due && !outputs_of_sweep(outputs->scene, i))
            done = writer->write(outputs, i, now);
    }
    outputs->write_s += progress_clock() - begun;
    return done;
}

bool outputs_chart(struct outputs *outputs)
{
    return write_due(outputs, &(struct occasion){.due = DUE_CHART});
}

bool outputs_step(struct outputs *outputs, const struct fold_step *step, const struct fold_state *state)
{
    return write_due(outputs, &(struct occasion){.due = DUE_STEP, .step = step, .state = state});
}

bool outputs_final(struct outputs *outputs, const struct fold_state *state, const struct fold_record *record)
{
    return write_due(outputs, &(struct occasion){.due = DUE_FINAL, .state = state, .record = record});
}

bool outputs_stopped(struct outputs *outputs)
{
    return write_due(outputs, &(struct occasion){.due = DUE_STOPPED});
}

bool outputs_kept(const struct outputs *outputs, int index)
{
    const struct output *output = &outputs->scene->output[index];
    return (find_writer(output->kind, output->path)->due & DUE_STEP) && file_log_find(&outputs->log, output->path);
}

bool outputs_report(struct outputs *outputs, struct report *report)
{
    if (!write_due(outputs, &(struct occasion){.due = DUE_RECORD, .record = report->record}))
        return false;
    report->write_s = outputs->write_s;
    return write_due(outputs, &(struct occasion){.due = DUE_REPORT, .report = report});
}

int outputs_steps(const struct outputs *outputs, int index)
{
    const struct output *output = &outputs->scene->output[index];
    return find_writer(output->kind, output->path)->due == DUE_STEP ? outputs->pvd[index].nsteps : -1;
}
