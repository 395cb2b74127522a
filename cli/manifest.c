/* SPDX-License-Identifier: GPL-3.0-or-later
 * The manifest: a run in; beside what it wrote, a JSON file with all that is
 * needed to repeat it out. */
#include <config.h>

#include "cli/manifest.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/build.h"

/* ---- where ---- */

/* Length of the folder in a path, with its slash. */
static int folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (int)(slash - path) + 1 : 0;
}

/* Length of a path without its extension. */
static int stem_length(const char *path)
{
    const char *name = path + folder_length(path), *dot = strrchr(name, '.');
    return (int)(dot && dot > name ? dot - path : (ptrdiff_t)strlen(path));
}

char *manifest_path(const struct scene *scene, const char *extension)
{
    const struct output *beside = NULL;
    char *path = NULL;
    for (int i = scene->noutputs - 1; i >= 0; i--) {
        const struct output *o = &scene->output[i];
        bool written = !outputs_of_sweep(scene, i) && file_is_plain(o->path);
        if (written && (o->kind == OUTPUT_REPORT || !beside || beside->kind != OUTPUT_REPORT))
            beside = o;
    }
    if (!beside)
        return NULL;
    const char *script = strcmp(scene->file, "-") == 0 ? "standard-input" : scene->file;
    const char *name = beside->kind == OUTPUT_REPORT ? beside->path : script;
    int folder = folder_length(name), stem = stem_length(name) - folder;
    if (asprintf(&path, "%.*s%.*s%s", folder_length(beside->path), beside->path, stem, name + folder, extension) < 0)
        return NULL;
    return path;
}

/* Adds the working folder as seen from that of path, below into (or NULL): "." or "../..", or its full name where
 * that is no short way. */
static void add_folder(cJSON *command, const char *into, const char *path)
{
    char here[PATH_MAX] = ".", there[PATH_MAX], back[PATH_MAX] = ".", folder[PATH_MAX];
    snprintf(folder, sizeof folder, "%s%s%.*s.", into ? into : "", into ? "/" : "", folder_length(path), path);
    bool known = getcwd(here, sizeof here) && realpath(folder, there);
    size_t n = strlen(here);
    bool below = known && strncmp(here, there, n) == 0 && (there[n] == '/' || !there[n]);
    if (below) {
        int depth = 0;
        for (const char *c = there + n; *c; c++)
            depth += *c == '/' && depth < 1000;
        for (int i = 0; i < depth; i++)
            strcpy(back + (i == 0 ? 0 : 3 * i - 1), i == 0 ? ".." : "/..");
    }
    json_text(command, "folder", below ? back : here);
}

/* ---- what ---- */

static void add_command(cJSON *root, const struct run *run, const char *path)
{
    const struct options *o = run->options;
    const char *weft_path = getenv("WEFT_PATH");
    cJSON *command = cJSON_AddObjectToObject(root, "command");
    cJSON *arguments = cJSON_AddArrayToObject(command, "arguments");
    for (int i = 1; i < o->argc; i++)
        if (strcmp(o->argv[i], "--resume") != 0 && strcmp(o->argv[i], "--cached") != 0)     /* make no difference */
            cJSON_AddItemToArray(arguments, cJSON_CreateString(o->argv[i]));
    add_folder(command, run->into, path);
    if (weft_path)
        json_text(command, "weft_path", weft_path);
    json_integer(command, "threads", fold_threads(o->threads));
}

static void add_source(cJSON *sources, const char *path, const char *sha256)
{
    cJSON *source = cJSON_CreateObject();
    json_text(source, "path", path);
    json_text(source, "sha256", sha256);
    cJSON_AddItemToArray(sources, source);
}

static void add_sources(cJSON *root, const struct run *run)
{
    const struct scene *scene = run->script.scene;
    struct file_log log = {0};
    cJSON *sources = cJSON_AddArrayToObject(root, "sources");
    for (const struct scene_source *s = scene->source; s < scene->source + scene->nsources; s++) {
        char sha256[FILE_HASH];
        file_hash_text(&log, s->text, s->size, sha256);
        add_source(sources, s->path, sha256);
    }
    if (run->options->start)
        add_source(sources, run->state.path, run->state.sha256);
    file_log_free(&log);
}

static void add_outputs(cJSON *root, const struct file_log *log)
{
    cJSON *outputs = cJSON_AddArrayToObject(root, "outputs");
    for (int i = 0; i < log->nentries; i++) {
        const struct file_entry *e = &log->entry[i];
        cJSON *output = cJSON_CreateObject();
        json_text(output, "path", e->path);
        if (e->lasting[0])
            json_text(output, "lasting_sha256", e->lasting);
        else
            json_text(output, "sha256", e->sha256);
        cJSON_AddItemToArray(outputs, output);
    }
}

cJSON *manifest_begin(const struct run *run)
{
    struct file_log log = {0};
    struct report report = run_report(run);
    char id[FILE_HASH], *path = manifest_path(run->script.scene, ".manifest.json");
    cJSON *root = cJSON_CreateObject();
    json_integer(root, "manifest", MANIFEST_SCHEMA);
    build_describe(root);
    build_id(id);
    json_text(root, "build_id", id);
    add_command(root, run, path ? path : "");
    add_sources(root, run);
    report_describe(root, &log, &report);
    file_log_free(&log);
    free(path);
    return root;
}

static char *describe(const struct run *run)
{
    cJSON *root = manifest_begin(run);
    json_unsigned(root, "seed", run->seed);
    json_text(root, "status", fold_status_name(run->record.status));
    add_outputs(root, &run->outputs.log);
    char *text = cJSON_Print(root);
    cJSON_Delete(root);
    return text;
}

bool manifest_write(struct run *run)
{
    struct file_log *log = &run->outputs.log;
    char *path = manifest_path(run->script.scene, ".manifest.json"), *text = path ? describe(run) : NULL;
    struct file *file = text ? file_create(log, path) : NULL;
    bool wanted = path;
    if (file) {
        file_write(file, text, strlen(text));
        file_print(file, "\n");
    }
    cJSON_free(text);
    free(path);
    return !wanted || (file && file_commit(file));
}
