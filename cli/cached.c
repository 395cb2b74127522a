/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft run --cached`: a run about to begin in; whether all that it would write
 * stands there already out. */
#include <config.h>

#include "cli/cached.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/manifest.h"
#include "cli/recorded.h"
#include "output/page.h"

struct cached {
    const struct run *run;
    char             *path;         /* of the manifest, NULL: nothing is written */
    struct recorded   recorded;     /* what it says */
    cJSON            *now;          /* what this run's would say before it is folded */
    char              why[PATH_MAX + RECORDED_WHY];
};

__attribute__((format(printf, 2, 3)))
static bool differs(struct cached *c, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(c->why, sizeof c->why, format, arguments);
    va_end(arguments);
    return false;
}

/* ---- the run ---- */

/* The same JSON, to the last digit; nothing is not the same as nothing. */
static bool same_json(const cJSON *a, const cJSON *b)
{
    char *first = cJSON_PrintUnformatted(a), *second = cJSON_PrintUnformatted(b);
    bool same = first && second && strcmp(first, second) == 0;
    cJSON_free(first);
    cJSON_free(second);
    return same;
}

static bool same_sources(struct cached *c)
{
    const cJSON *now = cJSON_GetObjectItemCaseSensitive(c->now, "sources");
    const cJSON *then = cJSON_GetObjectItemCaseSensitive(c->recorded.root, "sources");
    if (cJSON_GetArraySize(now) != cJSON_GetArraySize(then))
        return differs(c, "it uses other files");
    for (int i = 0; i < cJSON_GetArraySize(now); i++)
        if (!same_json(cJSON_GetArrayItem(now, i), cJSON_GetArrayItem(then, i)))
            return differs(c, "'%s' changed", recorded_text(cJSON_GetArrayItem(now, i), "path"));
    return true;
}

/* What a manifest says before the fold, and what it means where that is another. */
static bool same_parts(struct cached *c)
{
    static const struct { const char *key, *meaning; } part[] = {
        {"build_id", "it was another build of weft"}, {"libraries", "other libraries"}, {"machine", "another machine"},
        {"parameters", "other parameters"},           {"scene", "another scene"},
    };
    for (size_t i = 0; i < sizeof part / sizeof *part; i++)
        if (!same_json(cJSON_GetObjectItemCaseSensitive(c->now, part[i].key),
                       cJSON_GetObjectItemCaseSensitive(c->recorded.root, part[i].key)))
            return differs(c, "%s", part[i].meaning);
    return *recorded_text(c->now, "build_id") || differs(c, "this build cannot be told from others");
}

/* Words in another order may be the same -o; that is folded again, no harm done. */
static bool same_command(struct cached *c)
{
    const struct options *now = c->run->options, *then = &c->recorded.options;
    if (!recorded_parse(&c->recorded, now->argv[0]))
        return differs(c, "%s: %s", c->path, c->recorded.why);
    bool same = now->noutputs == then->noutputs;
    for (int i = 0; same && i < now->noutputs; i++)
        same = strcmp(now->output[i], then->output[i]) == 0;
    if (!same)
        return differs(c, "other outputs (-o)");
    if ((now->seeds > 1 ? now->seeds : 1) != (then->seeds > 1 ? then->seeds : 1))
        return differs(c, "another number of seeds");
    return then->threads == fold_threads(now->threads) || differs(c, "another number of threads");
}

static bool was_good(struct cached *c)
{
    const char *status = recorded_text(c->recorded.root, "status");
    return strcmp(status, fold_status_name(FOLD_CONVERGED)) == 0 ||
           strcmp(status, fold_status_name(FOLD_PRECISION)) == 0 || differs(c, "it did not converge");
}

/* ---- its outputs ---- */

static const cJSON *outputs_of(const struct cached *c)
{
    return cJSON_GetObjectItemCaseSensitive(c->recorded.root, "outputs");
}

static bool is_listed(const struct cached *c, const char *path)
{
    const cJSON *output;
    cJSON_ArrayForEach(output, outputs_of(c))
        if (strcmp(recorded_text(output, "path"), path) == 0)
            return true;
    return false;
}

/* Is all that the scene asks for something that can be looked at, and in the list? */
static bool lists_all(struct cached *c)
{
    const struct scene *scene = c->run->script.scene;
    for (int i = 0; i < scene->noutputs; i++) {
        const struct output *output = &scene->output[i];
        bool passed_over = outputs_of_sweep(scene, i) || (output->kind == OUTPUT_HTML && !page_is_there());
        if (!file_is_plain(output->path))
            return differs(c, "'%s' is no plain file", output->path);
        if (!passed_over && !is_listed(c, output->path))
            return differs(c, "'%s' is not in %s", output->path, c->path);
    }
    return true;
}

/* The lasting hash of a report. */
static void hash_report(const char *path, char sha256[FILE_HASH])
{
    struct arena arena = {0};
    struct file_log log = {0};
    const char *why;
    const struct source *source = source_read(&arena, path, &why);
    cJSON *report = source ? json_parse(source->text, source->size) : NULL;
    if (report)
        report_hash_lasting(&log, report, sha256);
    cJSON_Delete(report);
    file_log_free(&log);
    arena_free(&arena);
}

static bool outputs_stand(struct cached *c)
{
    const cJSON *output;
    cJSON_ArrayForEach(output, outputs_of(c)) {
        const char *path = recorded_text(output, "path");
        struct file_entry file = {0};
        if (access(path, F_OK) != 0)
            return differs(c, "'%s' is missing", path);
        if (*recorded_text(output, "lasting_sha256"))
            hash_report(path, file.lasting);
        else if (!file_hash_path(path, file.sha256))
            return differs(c, "'%s' cannot be read", path);
        if (!recorded_same(output, &file))
            return differs(c, "'%s' changed", path);
    }
    return true;
}

/* ---- the whole ---- */

static bool manifest_stands(struct cached *c)
{
    if (strcmp(c->run->script.scene->file, "-") == 0)
        return differs(c, "the script is standard input");
    if (!c->path)
        return differs(c, "nothing is written");
    if (access(c->path, F_OK) != 0)
        return differs(c, "there is no %s", c->path);
    return recorded_read(&c->recorded, c->path) || differs(c, "%s: %s", c->path, c->recorded.why);
}

static void print_outcome(const struct cached *c, bool holds)
{
    const struct options *options = c->run->options;
    int n = cJSON_GetArraySize(outputs_of(c));
    if (!holds && options->verbose)
        fprintf(stderr, "weft: note: not cached: %s\n", c->why);
    if (!holds || options->quiet)
        return;
    printf("%s: unchanged, ", c->run->script.scene->file);
    if (n == 1)
        printf("its output is as it was");
    else
        printf("its %d outputs are as they were", n);
    printf(" (%s)\n", c->path);
}

bool cached_holds(const struct run *run)
{
    struct cached c = {.run = run, .path = manifest_path(run->script.scene, ".manifest.json"),
                       .now = manifest_begin(run)};
    bool holds = manifest_stands(&c) && same_sources(&c) && same_parts(&c) && same_command(&c) && was_good(&c) &&
                 lists_all(&c) && outputs_stand(&c);
    print_outcome(&c, holds);
    recorded_free(&c.recorded);
    cJSON_Delete(c.now);
    free(c.path);
    return holds;
}
