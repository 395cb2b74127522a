/* SPDX-License-Identifier: GPL-3.0-or-later
 * One point of a sweep: a script and a number in; the run's outputs, its report
 * and a record in a folder of the point's own out. */
#include <config.h>

#include "cli/sweep_point.h"

#include <ftw.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/outputs.h"
#include "cli/run.h"
#include "output/chart.h"
#include "output/json.h"
#include "solver/sheet.h"

/* ---- what a point is ---- */

int sweep_chain(const struct sweep *sweep)
{
    return sweep->options->warm ? sweep->axis[sweep->naxes - 1].npoints : 1;
}

/* The point, whichever fold of it. */
static struct sweep_point any_fold(const struct sweep *sweep, int number, struct arena *arena)
{
    struct sweep_point point = {.number = number, .value = arena_array(arena, const char *, (size_t)sweep->naxes)};
    int width = snprintf(NULL, 0, "%d", sweep->npoints), rest = number - 1;
    for (int i = sweep->naxes - 1; i >= 0; i--) {
        point.value[i] = arena_number(arena, sweep->axis[i].point[rest % sweep->axis[i].npoints]);
        rest /= sweep->axis[i].npoints;
    }
    point.name = arena_printf(arena, "%0*d", width, number);
    for (int i = 0; i < sweep->naxes; i++)
        point.name = arena_printf(arena, "%s-%s=%s", point.name, sweep->axis[i].param, point.value[i]);
    return point;
}

struct sweep_point sweep_point(const struct sweep *sweep, int number, int from, struct arena *arena)
{
    struct sweep_point point = any_fold(sweep, number, arena);
    point.from = from;
    if (from > 0) {
        point.name = arena_printf(arena, "%s-from-%d", point.name, from);
        point.start = any_fold(sweep, number - 1, arena).name;
    }
    if (from > 0 && from < number - 1)
        point.start = arena_printf(arena, "%s-from-%d", point.start, from);
    point.folder = arena_printf(arena, "%s/%s", sweep->folder, point.name);
    return point;
}

struct sweep_point sweep_point_kept(const struct sweep *sweep, int number, struct arena *arena)
{
    return sweep_point(sweep, number, sweep->from ? sweep->from[number - 1] : 0, arena);
}

/* The state a fold begins from, or NULL. */
static const char *start_of(const struct sweep *sweep, const struct sweep_point *point, struct arena *arena)
{
    return point->start ? arena_printf(arena, "%s/%s/" SWEEP_STATE, sweep->folder, point->start) : NULL;
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
    int room = 7 + 2 * (o->ndefines + o->nsets + o->nincludes + o->noutputs);
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
    if (o->start)
        add_words(word, n, "--start", o->start);
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
    o.output = arena_array(arena, const char *, (size_t)o.noutputs + 2);
    if (o.noutputs > 0)
        memcpy(o.output, sweep->options->output, sizeof *o.output * (size_t)o.noutputs);
    o.output[o.noutputs++] = "report:" SWEEP_REPORT;
    if (o.warm)
        o.output[o.noutputs++] = "state:" SWEEP_STATE;
    o.start = start_of(sweep, point, arena);
    o.argv = run_words(&o, sweep->script, arena, &o.argc);
    return o;
}

/* ---- is it done? ---- */

static void hash_text(struct file *hasher, const char *text)
{
    file_write(hasher, text, strlen(text) + 1);
}

static void hash_value(void *hasher, const void *value, size_t size)
{
    file_write(hasher, value, size);
}

static void hash_settings(struct file *hasher, const struct scene *scene)
{
    for (const struct setting *s = scene->setting; s < scene->setting + scene->nsettings; s++) {
        hash_text(hasher, s->name);
        hash_text(hasher, s->text ? s->text : "");
        file_print(hasher, "%a\n", s->number);
    }
}

/* Version and seeds; with --warm, too, the state that is begun from as it stands there now. */
static struct file *hash_begin(struct file_log *log, const struct sweep *sweep, const struct sweep_point *point)
{
    struct arena arena = {0};
    struct file *hasher = file_hasher(log);
    const char *start = start_of(sweep, point, &arena);
    char sha256[FILE_HASH] = "flat";
    file_print(hasher, "%s %d\n", VERSION, sweep->options->seeds);
    if (start && !file_hash_path(start, sha256))
        sha256[0] = '\0';
    if (sweep->options->warm)
        hash_text(hasher, sha256);
    arena_free(&arena);
    return hasher;
}

/* SHA-256 of the words the point is made of: the files, the settings, -o, the
 * point's values.  The same words give the same results, and nothing need be compiled. */
static void words_key(const struct sweep *sweep, const struct sweep_point *point, char key[FILE_HASH])
{
    struct file_log log = {0};
    struct file *hasher = hash_begin(&log, sweep, point);
    const struct scene *scene = sweep->scene;
    for (int i = 0; i < scene->nsources; i++)
        file_write(hasher, scene->source[i].text, scene->source[i].size + 1);
    hash_settings(hasher, scene);
    for (int i = 0; i < sweep->options->noutputs; i++)
        hash_text(hasher, sweep->options->output[i]);
    for (int i = 0; i < sweep->naxes; i++)
        hash_text(hasher, point->value[i]);
    file_hash(hasher, key);
    file_log_free(&log);
}

/* SHA-256 of what the words mean at the point, but for what is made of all
 * points: a comment or another plot of the sweep changes nothing. */
static void scene_key(const struct sweep *sweep, const struct sweep_point *point, const struct scene *scene, char key[FILE_HASH])
{
    struct file_log log = {0};
    struct file *hasher = hash_begin(&log, sweep, point);
    chart_grid(hasher, scene);
    hash_settings(hasher, scene);
    for (const struct stitch *s = scene->stitch; s < scene->stitch + scene->nstitches; s++) {
        hash_text(hasher, s->symbol);
        file_print(hasher, "%a %a %a %d\n", s->kx, s->ky, s->twist, (int)s->ws);
    }
    for (int i = 0; i < scene->noutputs; i++) {
        const struct output *o = &scene->output[i];
        if (!outputs_of_sweep(scene, i)) {
            hash_text(hasher, output_kind_name(o->kind));
            hash_text(hasher, o->path);
            output_values(o, hash_value, hasher);
        }
    }
    file_hash(hasher, key);
    file_log_free(&log);
}

cJSON *sweep_point_json(const struct sweep_point *point, const char *name, struct arena *arena)
{
    const char *why;
    const struct source *source = source_read(arena, arena_printf(arena, "%s/%s", point->folder, name), &why);
    return source ? cJSON_ParseWithLength(source->text, source->size) : NULL;
}

static bool has_text(const cJSON *record, const char *name, const char *wanted)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(record, name);
    return cJSON_IsString(item) && strcmp(item->valuestring, wanted) == 0;
}

/* Other words, but is it the same scene? */
static bool means_the_same(const struct sweep *sweep, const struct sweep_point *point, const cJSON *record)
{
    struct arena arena = {0};
    struct script script;
    struct options options = point_options(sweep, point, &arena);
    char key[FILE_HASH] = "";
    options.quiet = true;
    if (script_load(&script, sweep->script, &options) == STATUS_DONE)
        scene_key(sweep, point, script.scene, key);
    script_free(&script);
    arena_free(&arena);
    return *key && has_text(record, "scene", key);
}

/* Is the state it left, if it left one, still what it was? */
static bool state_stands(const struct sweep_point *point, const cJSON *record)
{
    struct arena arena = {0};
    char sha256[FILE_HASH] = "";
    bool left = cJSON_HasObjectItem(record, "state");
    if (left)
        file_hash_path(arena_printf(&arena, "%s/" SWEEP_STATE, point->folder), sha256);
    arena_free(&arena);
    return !left || has_text(record, "state", sha256);
}

enum sweep_state sweep_point_state(const struct sweep *sweep, const struct sweep_point *point)
{
    struct arena arena = {0};
    char key[FILE_HASH];
    cJSON *record = sweep_point_json(point, SWEEP_RECORD, &arena);
    bool report = access(arena_printf(&arena, "%s/" SWEEP_REPORT, point->folder), R_OK) == 0;
    words_key(sweep, point, key);
    enum sweep_state state = !record || point->from < 0                                                   ? SWEEP_MISSING
                             : has_text(record, "words", key)                           ? SWEEP_DONE
                             : report && cJSON_HasObjectItem(record, "scene") &&
                                       means_the_same(sweep, point, record)             ? SWEEP_DONE
                                                                                        : SWEEP_STALE;
    if (state == SWEEP_DONE && has_text(record, "status", SWEEP_ERROR_STATUS))
        state = SWEEP_ERROR;
    else if (state == SWEEP_DONE && !(report && state_stands(point, record)))
        state = SWEEP_MISSING;
    cJSON_Delete(record);
    arena_free(&arena);
    return state;
}

/* ---- there and back ---- */

static const double RETURNED = 1e-6;    /* of the energy: a level that is refined further is not minimised to the end */

/* The energy of the scene's sheet from a state, on the level it grows on; NAN where there is no minimum. */
static double coarse_energy(const struct scene *scene, const struct fold_start *start, int threads)
{
    struct fold_options options = {.threads = threads, .start = start, .coarse = true};
    struct fold_record record;
    struct sheet *sheet = sheet_build(scene);
    fold_free(fold_run(sheet, &options, NULL, &record));
    bool minimum = record.status == FOLD_CONVERGED || record.status == FOLD_PRECISION;
    double energy = minimum ? record.energy.total : NAN;
    fold_record_free(&record);
    sheet_free(sheet);
    return energy;
}

/* Does the state that a fold came to lead its neighbour back to the one it began from?  If not, that shape came to
 * its end on the way, and the fabric snapped into another. */
static bool leads_back(const struct sweep *sweep, const struct sweep_point *point, const struct fold_start *from)
{
    struct arena arena = {0};
    struct sweep_point before = any_fold(sweep, point->number - 1, &arena);
    struct options options = point_options(sweep, &before, &arena);
    struct state here = {0};
    struct script script = {0};
    double energy = NAN;
    options.quiet = true;
    if (state_read(&here, arena_printf(&arena, "%s/" SWEEP_STATE, point->folder)) &&
        script_load(&script, sweep->script, &options) == STATUS_DONE)
        energy = coarse_energy(script.scene, &here.start, options.threads);
    script_free(&script);
    state_free(&here);
    arena_free(&arena);
    return fabs(energy - from->energy) <= RETURNED * fabs(from->energy);
}

/* ---- the run ---- */

static cJSON *describe(const struct sweep *sweep, const struct sweep_point *point, const struct run *run)
{
    bool folded = file_log_find(&run->outputs.log, SWEEP_REPORT);
    char key[FILE_HASH];
    cJSON *root = cJSON_CreateObject();
    json_integer(root, "point", point->number);
    cJSON *params = cJSON_AddObjectToObject(root, "params");
    for (int i = 0; i < sweep->naxes; i++)
        json_number(params, sweep->axis[i].param, strtod(point->value[i], NULL));
    json_text(root, "status", folded ? fold_status_name(run->record.status) : SWEEP_ERROR_STATUS);
    words_key(sweep, point, key);
    json_text(root, "words", key);
    const struct file_entry *state = file_log_find(&run->outputs.log, SWEEP_STATE);
    if (state)
        json_text(root, "state", state->sha256);
    if (state && point->start)
        cJSON_AddBoolToObject(root, SWEEP_BACK, leads_back(sweep, point, &run->state.start));
    if (folded) {
        scene_key(sweep, point, run->script.scene, key);
        json_text(root, "scene", key);
    }
    return root;
}

/* Says that the point is finished, and how. */
static bool write_record(const struct sweep *sweep, const struct sweep_point *point, const struct run *run)
{
    struct file_log log = {.into = point->folder};
    cJSON *root = describe(sweep, point, run);
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

/* For nftw: what a killed run left unfinished goes. */
static int tidy(const char *path, const struct stat *status, int type, struct FTW *where)
{
    (void)status;
    if (type == FTW_F && file_is_unfinished(path + where->base))
        unlink(path);
    return 0;
}

enum status sweep_point_run(const struct sweep *sweep, int number, int from)
{
    enum { FOLDERS_OPEN = 8 };
    struct arena arena = {0};
    struct sweep_point point = sweep_point(sweep, number, from, &arena);
    struct options options = point_options(sweep, &point, &arena);
    struct run run = {.options = &options, .into = point.folder, .of_sweep = true};
    enum status status = STATUS_DONE;
    if (sweep_point_state(sweep, &point) != SWEEP_DONE) {
        nftw(point.folder, tidy, FOLDERS_OPEN, FTW_PHYS);
        status = run_script(&run, sweep->script);
        bool ended = status == STATUS_SCRIPT || status == STATUS_USAGE || file_log_find(&run.outputs.log, SWEEP_REPORT);
        if (ended && !write_record(sweep, &point, &run))
            status = STATUS_FILES;
        run_free(&run);
    } else if (!options.quiet) {
        printf("%s: done before\n", point.name);
    }
    arena_free(&arena);
    return status;
}
