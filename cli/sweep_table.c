/* SPDX-License-Identifier: GPL-3.0-or-later
 * The table of a sweep: the records and reports in its points' folders in; a
 * row for each point, as CSV and as JSON lines, out. */
#include <config.h>

#include "cli/sweep_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/json.h"
#include "output/report.h"

/* Columns after the params, by their place in the report: nothing that a clock or the machine decides. */
static const char *const fields[] = {
    "solve.status", "energy.total", "energy.stretching", "energy.bending", "energy.springs", "energy.flat",
    "energy.error_estimate", "shape.extent_x", "shape.extent_y", "shape.extent_z", "shape.rms_height",
    "shape.max_normal_curvature", "shape.error_estimate", "scene.rows", "scene.columns", "scene.knit", "scene.purl",
    "discretisation.per_stitch", "discretisation.unknowns", "solve.iterations", "solve.evaluations",
    "solve.factorisations", "solve.gradient_max", "solve.positive_definite", "solve.seed",
};
enum { NFIELDS = sizeof fields / sizeof *fields };

const char *sweep_table_field(int index)
{
    return index + 1 < NFIELDS ? fields[index + 1] : NULL;      /* but for the status */
}

/* The report's value at "energy.total", or NULL. */
static const cJSON *value_at(const cJSON *report, const char *path)
{
    char name[64];
    for (size_t n; report && *path; path += n + (path[n] == '.')) {
        n = strcspn(path, ".");
        snprintf(name, sizeof name, "%.*s", (int)n, path);
        report = cJSON_GetObjectItemCaseSensitive(report, name);
    }
    return report;
}

double sweep_table_number(const cJSON *report, const char *field)
{
    const cJSON *value = value_at(report, field);
    return cJSON_IsNumber(value) ? value->valuedouble : NAN;
}

static const char *status_of(const cJSON *report)
{
    const char *word = cJSON_GetStringValue(value_at(report, "solve.status"));
    return word ? word : "";
}

/* The status of a point that has no report. */
static const char *state_word(enum sweep_state state)
{
    return state == SWEEP_ERROR ? SWEEP_ERROR_STATUS : "missing";
}

/* Where the fold of a sweep with --warm began. */
static const char *start_word(const struct sweep_point *point)
{
    return point->from < 0 ? "" : point->start ? point->start : "flat";
}

/* Is it the fold from the flat sheet? */
static bool is_checked(const struct sweep_point *point)
{
    return point->from == 0;
}

static void print_header(const struct sweep *sweep, struct file *csv)
{
    file_print(csv, "point");
    for (int i = 0; i < sweep->naxes; i++)
        file_print(csv, ",%s", sweep->axis[i].param);
    if (sweep->options->warm)
        file_print(csv, ",start,checked");
    for (int i = 0; i < NFIELDS; i++)
        file_print(csv, ",%s", fields[i]);
    file_print(csv, "\n");
}

static void print_value(struct file *csv, const cJSON *value)
{
    char *text = value && !cJSON_IsNull(value) ? cJSON_PrintUnformatted(value) : NULL;
    if (cJSON_IsString(value))
        file_print(csv, ",%s", value->valuestring);
    else
        file_print(csv, ",%s", text ? text : "");
    cJSON_free(text);
}

static void print_row(const struct sweep *sweep, const struct sweep_point *point, enum sweep_state state,
                      const cJSON *report, struct file *csv)
{
    file_print(csv, "%d", point->number);
    for (int i = 0; i < sweep->naxes; i++)
        file_print(csv, ",%s", point->value[i]);
    if (sweep->options->warm)
        file_print(csv, ",%s,%s", start_word(point), is_checked(point) ? "true" : "false");
    if (!report)
        file_print(csv, ",%s", state_word(state));
    for (int i = report ? 0 : 1; i < NFIELDS; i++)
        print_value(csv, report ? value_at(report, fields[i]) : NULL);
    file_print(csv, "\n");
}

static void print_line(const struct sweep *sweep, const struct sweep_point *point, enum sweep_state state, cJSON *report,
                       struct file *jsonl)
{
    cJSON *line = cJSON_CreateObject(), *params;
    json_integer(line, "point", point->number);
    json_text(line, "folder", point->name);
    params = cJSON_AddObjectToObject(line, "params");
    for (int i = 0; i < sweep->naxes; i++)
        json_number(params, sweep->axis[i].param, strtod(point->value[i], NULL));
    if (sweep->options->warm) {
        json_text(line, "start", start_word(point));
        cJSON_AddBoolToObject(line, "checked", is_checked(point));
    }
    json_text(line, "status", report ? status_of(report) : state_word(state));
    report_keep_lasting(report);
    if (report)
        cJSON_AddItemReferenceToObject(line, "report", report);
    else
        cJSON_AddNullToObject(line, "report");
    char *text = cJSON_PrintUnformatted(line);
    file_write(jsonl, text, strlen(text));
    file_write(jsonl, "\n", 1);
    cJSON_free(text);
    cJSON_Delete(line);
}

bool sweep_table_converged(const cJSON *report)
{
    const char *word = report ? status_of(report) : "";
    return strcmp(word, "converged") == 0 || strcmp(word, "precision") == 0;
}

cJSON *sweep_table_report(const struct sweep *sweep, const struct sweep_point *point, struct arena *arena)
{
    return sweep_point_state(sweep, point) == SWEEP_DONE ? sweep_point_json(point, SWEEP_REPORT, arena) : NULL;
}

static void count_point(enum sweep_state state, const cJSON *report, struct sweep_count *count)
{
    if (sweep_table_converged(report))
        count->good++;
    else if (report || state == SWEEP_ERROR)
        count->other++;
    else
        count->missing++;
    count->stale += state == SWEEP_STALE;
}

static void print_points(const struct sweep *sweep, struct file *const *csv, int ncsv, struct file *jsonl,
                         struct sweep_count *count)
{
    for (int number = 1; number <= sweep->npoints; number++) {
        struct arena arena = {0};
        struct sweep_point point = sweep_point_kept(sweep, number, &arena);
        enum sweep_state state = sweep_point_state(sweep, &point);
        cJSON *report = state == SWEEP_DONE ? sweep_point_json(&point, SWEEP_REPORT, &arena) : NULL;
        for (int i = 0; i < ncsv; i++)
            print_row(sweep, &point, state, report, csv[i]);
        count_point(state, report, count);
        print_line(sweep, &point, state, report, jsonl);
        cJSON_Delete(report);
        arena_free(&arena);
    }
}

bool sweep_table_write(const struct sweep *sweep, const char *const *also, int nalso, struct file_log *log,
                       struct sweep_count *count)
{
    struct arena arena = {0};
    struct file **csv = arena_array(&arena, struct file *, (size_t)nalso + 1);
    struct file *jsonl = file_create(log, arena_printf(&arena, "%s/table.jsonl", sweep->folder));
    int ncsv = 0;
    bool done = jsonl != NULL;
    *count = (struct sweep_count){0};
    for (int i = 0; done && i <= nalso; i++) {
        const char *path = i < nalso ? also[i] : arena_printf(&arena, "%s/table.csv", sweep->folder);
        if ((csv[ncsv] = file_create(log, path)))
            print_header(sweep, csv[ncsv++]);
        else
            done = false;
    }
    if (done)
        print_points(sweep, csv, ncsv, jsonl, count);
    for (int i = ncsv - 1; i >= 0; i--)
        done = file_commit(csv[i]) && done;
    if (jsonl)
        done = file_commit(jsonl) && done;
    arena_free(&arena);
    return done;
}
