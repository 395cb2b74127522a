/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft run --from`: a manifest in; the run repeated, and whether every output
 * came out the same. */
#include <config.h>

#include "cli/repeat.h"

#include <errno.h>
#include <ftw.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/build.h"
#include "cli/recorded.h"
#include "cli/run.h"
#include "lang/names.h"

/* A manifest and what follows from it. */
struct repeat {
    const struct options *options;      /* those of --from */
    struct recorded       recorded;     /* the first run */
    char                  folder[PATH_MAX];     /* the manifest's */
    char                  into[PATH_MAX];
    bool                  temporary;    /* into is ours to remove */
};

__attribute__((format(printf, 2, 3)))
static enum status refuse(const struct repeat *r, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "weft: %s: ", r->options->from);
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\n");
    va_end(arguments);
    return STATUS_FILES;
}

/* ---- the manifest ---- */

static enum status read_manifest(struct repeat *r)
{
    return recorded_read(&r->recorded, r->options->from) ? STATUS_DONE : refuse(r, "%s", r->recorded.why);
}

/* Says of each text of an object where this program's is another. */
static void compare_texts(const struct repeat *r, const cJSON *now, const char *name)
{
    const cJSON *before = cJSON_GetObjectItemCaseSensitive(r->recorded.root, name), *item;
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(now, name))
        if (strcmp(recorded_text(before, item->string), item->valuestring) != 0)
            fprintf(stderr, "weft: note: made with %s '%s', this is '%s'; bytes may differ\n", item->string,
                    recorded_text(before, item->string), item->valuestring);
}

/* Another program, library or machine need not give the same bytes: said, not refused. */
static void compare_program(const struct repeat *r)
{
    char id[FILE_HASH];
    cJSON *now = cJSON_CreateObject();
    build_id(id);
    build_describe(now);
    if (strcmp(recorded_text(r->recorded.root, "build_id"), id) != 0)
        fprintf(stderr, "weft: note: made by another build (weft %s, compiler %s) than this one; bytes may differ\n",
                recorded_text(r->recorded.root, "weft"), recorded_text(r->recorded.root, "compiler"));
    compare_texts(r, now, "libraries");
    compare_texts(r, now, "machine");
    cJSON_Delete(now);
}

/* The first run's command line. */
static enum status read_command(struct repeat *r)
{
    if (!recorded_parse(&r->recorded, r->options->argv[0]))
        return refuse(r, "%s", r->recorded.why);
    struct options *first = &r->recorded.options;
    first->threads = r->options->threads ? r->options->threads : first->threads;
    first->quiet = true;
    first->no_manifest = true;
    first->resume = first->cached = false;
    return STATUS_DONE;
}

/* ---- folders ---- */

/* The folder to write into, made now, while relative paths are still the user's. */
static enum status make_into(struct repeat *r)
{
    const char *parent = getenv("TMPDIR");
    if (r->options->into) {
        if (!file_make_folder(r->options->into) || !realpath(r->options->into, r->into))
            return refuse(r, "cannot write into '%s': %s", r->options->into, strerror(errno));
        return STATUS_DONE;
    }
    snprintf(r->into, sizeof r->into, "%s/weft-XXXXXX", parent && *parent == '/' ? parent : P_tmpdir);
    r->temporary = mkdtemp(r->into);
    return r->temporary ? STATUS_DONE : refuse(r, "cannot write into '%s': %s", r->into, strerror(errno));
}

static int remove_one(const char *path, const struct stat *status, int kind, struct FTW *place)
{
    (void)status, (void)kind, (void)place;
    return remove(path);
}

/* Goes to where the script is: --from FILE's own word, the first run's folder, the manifest's. */
static enum status find_script(struct repeat *r, const char **script)
{
    const char *path = r->recorded.options.operand[0], *slash = strrchr(path, '/');
    const char *folder = recorded_text(recorded_command(&r->recorded), "folder");
    char manifest[PATH_MAX], *end;
    if (r->options->noperands > 0) {
        *script = r->options->operand[0];
        return STATUS_DONE;
    }
    if (!realpath(r->options->from, manifest))
        return refuse(r, "cannot be found again");
    end = strrchr(manifest, '/');
    end[end == manifest] = '\0';
    *script = path;
    if (chdir(manifest) == 0 && chdir(folder) == 0 && access(path, R_OK) == 0)
        return STATUS_DONE;
    *script = slash ? slash + 1 : path;
    if (chdir(manifest) == 0 && access(*script, R_OK) == 0)
        return STATUS_DONE;
    return refuse(r, "its script '%s' is neither where it was nor beside the manifest; name it: weft run --from %s FILE",
                  path, r->options->from);
}

/* Has number i of the first run's files this hash? */
static enum status compare_hash(const struct repeat *r, int i, const char *path, const char *sha256)
{
    const cJSON *sources = cJSON_GetObjectItemCaseSensitive(r->recorded.root, "sources");
    if (strcmp(sha256, recorded_text(cJSON_GetArrayItem(sources, i), "sha256")) == 0)
        return STATUS_DONE;
    return refuse(r, "'%s' is not the file the run was made with: its SHA-256 differs", path);
}

/* Is a file number i of the first run's? */
static enum status compare_source(const struct repeat *r, int i, const char *path, const char *text, size_t size)
{
    struct file_log log = {0};
    char sha256[FILE_HASH];
    file_hash_text(&log, text, size, sha256);
    file_log_free(&log);
    return compare_hash(r, i, path, sha256);
}

/* The script itself, before anything is made of it: another one's errors would say nothing. */
static enum status compare_script(const struct repeat *r, const char *path)
{
    struct arena arena = {0};
    const char *why = "";
    if (strcmp(path, "-") == 0)     /* can be read once */
        return STATUS_DONE;
    const struct source *source = source_read(&arena, path, &why);
    enum status status = source ? compare_source(r, 0, path, source->text, source->size)
                                : refuse(r, "'%s' cannot be read: %s", path, why);
    arena_free(&arena);
    return status;
}

/* Is every file the scene is made of the one of the first run? */
static enum status compare_sources(const struct repeat *r, const char *script)
{
    struct script now = {0};
    enum status status = compare_script(r, script);
    if (status == STATUS_DONE)
        status = script_load(&now, script, &r->recorded.options);
    const cJSON *sources = cJSON_GetObjectItemCaseSensitive(r->recorded.root, "sources");
    int nstates = r->recorded.options.start != NULL;
    if (status == STATUS_DONE && now.scene->nsources + nstates != cJSON_GetArraySize(sources))
        status = refuse(r, "its script uses other files now");
    for (int i = 0; status == STATUS_DONE && i < now.scene->nsources; i++) {
        const struct scene_source *s = &now.scene->source[i];
        status = compare_source(r, i, s->path, s->text, s->size);
    }
    script_free(&now);
    return status;
}

/* Is the state the first run began from, the last of its sources, what it was? */
static enum status compare_start(const struct repeat *r)
{
    const cJSON *sources = cJSON_GetObjectItemCaseSensitive(r->recorded.root, "sources");
    const char *path = r->recorded.options.start;
    char sha256[FILE_HASH];
    if (!path)
        return STATUS_DONE;
    if (!file_hash_path(path, sha256))
        return refuse(r, "the state '%s' that the run began from cannot be read: %s", path, strerror(errno));
    return compare_hash(r, cJSON_GetArraySize(sources) - 1, path, sha256);
}

/* ---- the comparison ---- */

/* Says of every output whether it is the same. */
static enum status compare_outputs(const struct repeat *r, const struct file_log *log)
{
    const cJSON *outputs = cJSON_GetObjectItemCaseSensitive(r->recorded.root, "outputs"), *output;
    int n = cJSON_GetArraySize(outputs), same = 0;
    cJSON_ArrayForEach(output, outputs) {
        const char *path = recorded_text(output, "path");
        const struct file_entry *entry = file_log_find(log, path);
        bool equal = entry && recorded_same(output, entry);
        same += equal;
        if (!equal)
            printf("%s: %s\n", path, entry ? "differs" : "was not written");
        else if (!r->options->quiet)
            printf("%s: the same%s\n", path, entry->lasting[0] ? ", but for time, memory, path and threads" : "");
    }
    if (same == n)
        printf(n == 1 ? "its output is identical\n" : "all %d outputs are identical\n", n);
    else
        printf("%d of %d %s identical\n", same, n, names_count(n, "output is", "outputs are"));
    return same == n ? STATUS_DONE : STATUS_FAILED;
}

static enum status run_again(const struct repeat *r, const char *script)
{
    struct run run = {.options = &r->recorded.options, .into = r->into};
    enum status status = run_script(&run, script);
    if (status == STATUS_DONE || status == STATUS_FAILED)
        status = compare_outputs(r, &run.outputs.log);
    run_free(&run);
    return status;
}

/* ---- the whole ---- */

enum status repeat_run(const struct options *options)
{
    struct repeat r = {.options = options};
    const char *script = NULL;
    enum status status = read_manifest(&r);
    if (status == STATUS_DONE)
        status = read_command(&r);
    if (status == STATUS_DONE)
        status = make_into(&r);
    if (status == STATUS_DONE)
        status = find_script(&r, &script);
    if (status == STATUS_DONE && *recorded_text(recorded_command(&r.recorded), "weft_path"))
        setenv("WEFT_PATH", recorded_text(recorded_command(&r.recorded), "weft_path"), 1);
    if (status == STATUS_DONE)
        status = compare_sources(&r, script);
    if (status == STATUS_DONE)
        status = compare_start(&r);
    if (status == STATUS_DONE) {
        compare_program(&r);
        status = run_again(&r, script);
    }
    if (r.temporary)
        nftw(r.into, remove_one, 16, FTW_DEPTH | FTW_PHYS);
    recorded_free(&r.recorded);
    return status;
}
