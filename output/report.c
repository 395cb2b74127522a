/* SPDX-License-Identifier: GPL-3.0-or-later
 * The report: a scene, the record of its fold and the files written in; one
 * JSON object out. */
#include <config.h>

#include "output/report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "output/chart.h"
#include "output/json.h"

/* An error estimate; negative means none. */
static double estimate(double error)
{
    return error < 0 ? NAN : error;
}

static void add_hash(cJSON *object, const char *key, struct file *hasher)
{
    char sha256[FILE_HASH] = "";
    if (hasher)
        file_hash(hasher, sha256);
    json_text(object, key, sha256);
}

static void add_scene(cJSON *root, struct file_log *log, const struct report *r)
{
    const struct grid *g = r->scene->grid;
    size_t ncells = (size_t)g->columns * (size_t)g->rows, count[STITCH_MAX + 1] = {0};
    for (size_t i = 0; i < ncells; i++)
        count[g->cell[i]]++;

    cJSON *scene = cJSON_AddObjectToObject(root, "scene");
    json_text(scene, "file", r->scene->file);
    struct file *hasher = file_hasher(log);
    if (hasher)
        file_write(hasher, r->source, r->source_size);
    add_hash(scene, "sha256", hasher);
    json_integer(scene, "rows", g->rows);
    json_integer(scene, "columns", g->columns);
    json_unsigned(scene, "knit", count[STITCH_K]);
    json_unsigned(scene, "purl", count[STITCH_P]);
    json_unsigned(scene, "other", ncells - count[STITCH_K] - count[STITCH_P]);
    hasher = file_hasher(log);
    if (hasher)
        chart_grid(hasher, r->scene);
    add_hash(scene, "grid_sha256", hasher);
}

static void add_parameters(cJSON *root, const struct scene *scene)
{
    static const char *const from[] = {
        [FROM_DEFAULT] = "default", [FROM_FILE] = "file", [FROM_COMMAND_LINE] = "command line",
    };
    cJSON *parameters = cJSON_AddObjectToObject(root, "parameters");
    for (const struct setting *s = scene->setting; s < scene->setting + scene->nsettings; s++) {
        cJSON *entry = cJSON_AddObjectToObject(parameters, s->name);
        if (s->text)
            json_text(entry, "value", s->text);
        else
            json_number(entry, "value", s->number);
        json_text(entry, "unit", s->unit);
        json_text(entry, "from", from[s->from]);
    }
}

static void add_discretisation(cJSON *root, const struct fold_record *r)
{
    cJSON *object = cJSON_AddObjectToObject(root, "discretisation");
    json_text(object, "kind", r->kind);
    json_integer(object, "per_stitch", r->per_stitch);
    json_integer(object, "unknowns", r->unknowns);
    json_integer(object, "elements", r->elements);
}

static void add_energy(cJSON *root, const struct fold_record *r)
{
    cJSON *energy = cJSON_AddObjectToObject(root, "energy");
    json_number(energy, "total", r->energy.total);
    json_number(energy, "stretching", r->energy.stretching);
    json_number(energy, "bending", r->energy.bending);
    json_number(energy, "springs", r->energy.springs);
    json_number(energy, "flat", r->energy_flat);
    json_number(energy, "error_estimate", estimate(r->energy_error));
    json_text(energy, "unit", "force*length");
}

static void add_solve(cJSON *root, const struct report *report)
{
    const struct fold_record *r = report->record;
    cJSON *solve = cJSON_AddObjectToObject(root, "solve");
    json_text(solve, "status", fold_status_name(r->status));
    json_text(solve, "method", r->method ? r->method : "none");
    json_integer(solve, "growth_steps", r->growth_steps);
    json_integer(solve, "iterations", r->iterations);
    json_integer(solve, "evaluations", r->evaluations);
    json_integer(solve, "factorisations", r->factorisations);
    json_number(solve, "gradient_max", r->gradient_max);
    cJSON_AddBoolToObject(solve, "positive_definite", r->positive_definite);
    json_unsigned(solve, "seed", report->kept_seed);
    json_integer(solve, "threads", r->threads);
    if (r->remark)
        json_text(solve, "remark", r->remark);
    else
        cJSON_AddNullToObject(solve, "remark");
}

static void add_shape(cJSON *root, const struct fold_record *r)
{
    cJSON *shape = cJSON_AddObjectToObject(root, "shape");
    json_number(shape, "extent_x", r->extent_x);
    json_number(shape, "extent_y", r->extent_y);
    json_number(shape, "extent_z", r->extent_z);
    json_number(shape, "rms_height", r->rms_height);
    json_number(shape, "max_normal_curvature", r->max_normal_curvature);
    json_number(shape, "error_estimate", estimate(r->shape_error));
}

static void add_steps(cJSON *root, const struct fold_record *r)
{
    cJSON *steps = cJSON_AddArrayToObject(root, "steps");
    for (int i = 0; i < r->nsteps; i++) {
        const struct fold_step *s = &r->step[i];
        cJSON *step = cJSON_CreateObject();
        json_number(step, "growth", s->growth);
        json_number(step, "energy", s->energy.total);
        json_number(step, "stretching", s->energy.stretching);
        json_number(step, "bending", s->energy.bending);
        json_number(step, "springs", s->energy.springs);
        json_integer(step, "iterations", s->iterations);
        json_number(step, "gradient_max", s->gradient_max);
        cJSON_AddItemToArray(steps, step);
    }
}

static void add_cost(cJSON *root, const struct report *r)
{
    cJSON *time = cJSON_AddObjectToObject(root, "time");
    json_number(time, "total_s", r->total_s);
    json_number(time, "compile_s", r->compile_s);
    json_number(time, "solve_s", r->record->solve_s);
    json_number(time, "assemble_s", r->record->assemble_s);
    json_number(time, "factor_s", r->record->factor_s);
    json_number(time, "evaluate_s", r->record->evaluate_s);
    json_number(time, "write_s", r->write_s);
    json_integer(cJSON_AddObjectToObject(root, "memory"), "peak_bytes", r->peak_bytes);
}

static void add_outputs(cJSON *root, const struct file_log *log)
{
    cJSON *outputs = cJSON_AddArrayToObject(root, "outputs");
    for (int i = 0; i < log->nentries; i++) {
        const struct file_entry *e = &log->entry[i];
        cJSON *output = cJSON_CreateObject();
        json_text(output, "path", e->path);
        json_text(output, "sha256", e->sha256);
        cJSON_AddItemToArray(outputs, output);
    }
}

/* Only where several were asked for. */
static void add_seeds(cJSON *root, const struct report *report)
{
    if (report->nseeds == 0)
        return;
    cJSON *seeds = cJSON_AddArrayToObject(root, "seeds");
    for (const struct report_seed *r = report->seed; r < report->seed + report->nseeds; r++) {
        cJSON *seed = cJSON_CreateObject();
        json_unsigned(seed, "seed", r->seed);
        json_number(seed, "energy", r->energy);
        json_text(seed, "status", fold_status_name(r->status));
        cJSON_AddItemToArray(seeds, seed);
    }
}

void report_describe(cJSON *root, struct file_log *log, const struct report *report)
{
    add_scene(root, log, report);
    add_parameters(root, report->scene);
}

void report_keep_lasting(cJSON *root)
{
    static const char *const passing[][2] = {
        {NULL, "time"}, {NULL, "memory"}, {NULL, "outputs"}, {"scene", "file"}, {"solve", "threads"},
    };
    for (size_t i = 0; i < sizeof passing / sizeof passing[0]; i++)
        cJSON_DeleteItemFromObject(passing[i][0] ? cJSON_GetObjectItem(root, passing[i][0]) : root, passing[i][1]);
}

void report_hash_lasting(struct file_log *log, cJSON *root, char sha256[FILE_HASH])
{
    report_keep_lasting(root);
    char *text = cJSON_PrintUnformatted(root);
    struct file *hasher = text ? file_hasher(log) : NULL;
    if (hasher) {
        file_write(hasher, text, strlen(text));
        file_hash(hasher, sha256);
    }
    cJSON_free(text);
}

bool report_write(struct file_log *log, const char *path, const struct report *report)
{
    char lasting[FILE_HASH] = "";
    cJSON *root = cJSON_CreateObject();
    json_text(root, "weft", PACKAGE_VERSION);
    json_integer(root, "schema", REPORT_SCHEMA);
    report_describe(root, log, report);
    add_discretisation(root, report->record);
    add_energy(root, report->record);
    add_solve(root, report);
    add_seeds(root, report);
    add_shape(root, report->record);
    add_steps(root, report->record);
    add_cost(root, report);
    add_outputs(root, log);
    char *text = cJSON_Print(root);
    report_hash_lasting(log, root, lasting);
    cJSON_Delete(root);
    if (!text) {
        file_fail(log, "out of memory");
        return false;
    }
    struct file *file = file_create(log, path);
    if (file) {
        file_write(file, text, strlen(text));
        file_print(file, "\n");
    }
    cJSON_free(text);
    if (!file || !file_commit(file))
        return false;
    memcpy(file_log_find(log, path)->lasting, lasting, sizeof lasting);
    return true;
}
