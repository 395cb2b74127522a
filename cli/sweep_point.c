/* SPDX-License-Identifier: GPL-3.0-or-later
 * One point of a sweep: a script and a number in; the run's outputs, its report
 * and a record in a folder of the point's own out. */
#include <config.h>

#include "cli/sweep_point.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/run.h"
#include "output/json.h"

/* ---- what a point is ---- */

static const char *number_text(struct arena *arena, double value)
{
    for (int digits = 6; digits < 17; digits++) {
        const char *text = arena_printf(arena, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return text;
    }
    return arena_printf(arena, "%.17g", value);
}

struct sweep_point sweep_point(const struct sweep *sweep, int number, struct arena *arena)
{
    struct sweep_point point = {.number = number, .value = arena_array(arena, const char *, (size_t)sweep->naxes)};
    int width = snprintf(NULL, 0, "%d", sweep->npoints), rest = number - 1;
    for (int i = sweep->naxes - 1; i >= 0; i--) {
        point.value[i] = number_text(arena, sweep->axis[i].point[rest % sweep->axis[i].npoints]);
        rest /= sweep->axis[i].npoints;
    }
    point.name = arena_printf(arena, "%0*d", width, number);
    for (int i = 0; i < sweep->naxes; i++)
        point.name = arena_printf(arena, "%s-%s=%s", point.name, sweep->axis[i].param, point.value[i]);
    point.folder = arena_printf(arena, "%s/%s", sweep->folder, point.name);
    return point;
}

/* The name of the option that sets a block's key. */
static const char *option_of_key(const char *key)
{
    const struct option *o = option_table;
    while (!o->key || strcmp(o->key, key) != 0)
        o++;
    return o->name;
}

static void add_words(const char **word, int *n, const char *option, const char *value)
{
    word[(*n)++] = option;
    word[(*n)++] = value;
}

/* The words of a plain run with those of the options that its outputs follow from: what the point's manifest says. */
static char **run_words(const struct options *o, const char *script, struct arena *arena, int *n)
{
    int room = 5 + 2 * (o->ndefines + o->nsets + o->nincludes + o->noutputs);
    const char **word = arena_array(arena, const char *, (size_t)room);
    *n = 0;
    word[(*n)++] = o->argv[0];
    add_words(word, n, "run", script);
    for (int i = 0; i < o->ndefines; i++)
        add_words(word, n, "-D", arena_printf(arena, "%s=%s", o->define[i].name, o->define[i].value));
    for (int i = 0; i < o->nsets; i++)
        add_words(word, n, option_of_key(o->set[i].name), o->set[i].value);
    for (int i = 0; i < o->nincludes; i++)
        add_words(word, n, "-I", o->include[i]);
    for (int i = 0; i < o->noutputs; i++)
        add_words(word, n, "-o", o->output[i]);
    if (o->seeds > 0)
        add_words(word, n, "--seeds", arena_printf(arena, "%d", o->seeds));
    return (char **)word;
}

/* The options of a plain run at the point: its params set, a report asked for. */
static struct options point_options(const struct sweep *sweep, const struct sweep_point *point, struct arena *arena)
{
    struct options o = *sweep->options;
    o.define = arena_array(arena, struct compile_override, (size_t)(o.ndefines + sweep->naxes));
    if (o.ndefines > 0)
        memcpy(o.define, sweep->options->define, sizeof *o.define * (size_t)o.ndefines);
    for (int i = 0; i < sweep->naxes; i++)
        o.define[o.ndefines++] = (struct compile_override){sweep->axis[i].param, point->value[i]};
    o.output = arena_array(arena, const char *, (size_t)o.noutputs + 1);
    if (o.noutputs > 0)
        memcpy(o.output, sweep->options->output, sizeof *o.output * (size_t)o.noutputs);
    o.output[o.noutputs++] = "report:" SWEEP_REPORT;
    o.argv = run_words(&o, sweep->script, arena, &o.argc);
    return o;
}

/* ---- is it done? ---- */

/* SHA-256 of all that the point's results follow from. */
static void point_key(const struct scene *scene, char key[FILE_HASH])
{
    struct file_log log = {0};
    struct file *hasher = file_hasher(&log);
    file_print(hasher, "%s\n", VERSION);
    for (int i = 0; i < scene->nsources; i++)
        file_write(hasher, scene->source[i].text, scene->source[i].size + 1);
    for (int i = 0; i < scene->nsettings; i++) {
        const struct setting *s = &scene->setting[i];
        file_write(hasher, s->name, strlen(s->name) + 1);
        if (s->text)
            file_write(hasher, s->text, strlen(s->text) + 1);
        file_print(hasher, "%a\n", s->number);
    }
    for (int i = 0; i < scene->noutputs; i++) {
        file_print(hasher, "%s\n", output_kind_name(scene->output[i].kind));
        file_write(hasher, scene->output[i].path, strlen(scene->output[i].path) + 1);
    }
    file_hash(hasher, key);
    file_log_free(&log);
}

/* The record in a point's folder, or NULL. */
static cJSON *read_record(const struct sweep_point *point, struct arena *arena)
{
    const char *why;
    const struct source *source = source_read(arena, arena_printf(arena, "%s/" SWEEP_RECORD, point->folder), &why);
    return source ? cJSON_ParseWithLength(source->text, source->size) : NULL;
}

static bool record_has_key(const cJSON *record, const char *key)
{
    const cJSON *own = cJSON_GetObjectItemCaseSensitive(record, "key");
    return cJSON_IsString(own) && strcmp(own->valuestring, key) == 0;
}

bool sweep_point_is_done(const struct sweep *sweep, int number)
{
    struct arena arena = {0};
    struct script script;
    struct sweep_point point = sweep_point(sweep, number, &arena);
    struct options options = point_options(sweep, &point, &arena);
    options.quiet = true;
    cJSON *record = read_record(&point, &arena);
    bool done = false;
    if (record && script_load(&script, sweep->script, &options) == STATUS_DONE) {
        char key[FILE_HASH];
        point_key(script.scene, key);
        done = record_has_key(record, key);
    }
    if (record)
        script_free(&script);
    cJSON_Delete(record);
    arena_free(&arena);
    return done;
}

/* ---- the run ---- */

/* Says that the point is finished, and how; false: see log->error. */
static bool write_record(const struct sweep *sweep, const struct sweep_point *point, const struct run *run)
{
    struct file_log log = {.into = point->folder};
    char key[FILE_HASH];
    cJSON *root = cJSON_CreateObject(), *params = NULL;
    point_key(run->script.scene, key);
    json_integer(root, "point", point->number);
    params = cJSON_AddObjectToObject(root, "params");
    for (int i = 0; i < sweep->naxes; i++)
        json_number(params, sweep->axis[i].param, strtod(point->value[i], NULL));
    json_text(root, "status", fold_status_name(run->record.status));
    json_text(root, "key", key);
    char *text = cJSON_Print(root);
    struct file *file = file_create(&log, SWEEP_RECORD);
    if (file)
        file_print(file, "%s\n", text);
    bool done = file && file_commit(file);
    if (!done)
        fprintf(stderr, "weft: %s\n", log.error);
    cJSON_free(text);
    cJSON_Delete(root);
    file_log_free(&log);
    return done;
}

enum status sweep_point_run(const struct sweep *sweep, int number)
{
    struct arena arena = {0};
    struct sweep_point point = sweep_point(sweep, number, &arena);
    struct options options = point_options(sweep, &point, &arena);
    struct run run = {.options = &options, .into = point.folder};
    enum status status = STATUS_DONE;
    if (!sweep_point_is_done(sweep, number)) {
        status = run_script(&run, sweep->script);
        if (file_log_find(&run.outputs.log, SWEEP_REPORT) && !write_record(sweep, &point, &run))
            status = STATUS_FILES;
        run_free(&run);
    } else if (!options.quiet) {
        printf("%s: done before\n", point.name);
    }
    arena_free(&arena);
    return status;
}
