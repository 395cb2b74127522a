/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a run would lose if it were killed: growth steps in, a file to go on
 * from out.  The file is a line, the key, and for each step a record (all but
 * x), x, and the SHA-256 of both, in the machine's own form: the key holds the
 * program's build id. */
#include <config.h>

#include "cli/checkpoint.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/build.h"
#include "cli/manifest.h"

static const char title[] = "weft checkpoint 1\n";

/* ---- the key ---- */

static void make_key(struct checkpoint *c, const struct report *report, const struct options *options)
{
    struct file_log log = {0};
    char program[FILE_HASH], line[200];
    cJSON *root = cJSON_CreateObject();
    build_id(program);
    report_describe(root, &log, report);
    cJSON_DeleteItemFromObject(cJSON_GetObjectItem(root, "scene"), "file");
    long threads = options->threads ? options->threads : sysconf(_SC_NPROCESSORS_ONLN);
    snprintf(line, sizeof line, "%s seed %" PRIu64 " threads %ld", program, report->kept_seed, threads);
    json_text(root, "run", line);
    char *text = cJSON_PrintUnformatted(root);
    if (text)
        file_hash_text(&log, text, strlen(text), c->key);
    cJSON_free(text);
    cJSON_Delete(root);
    file_log_free(&log);
}

/* ---- records ---- */

/* head: the record's bytes as they stand in the file. */
static void hash_mark(const struct fold_mark *head, const double *x, char sha256[FILE_HASH])
{
    struct file_log log = {0};
    struct file *hasher = file_hasher(&log);
    sha256[0] = '\0';
    if (hasher) {
        file_write(hasher, head, sizeof *head);
        file_write(hasher, x, (size_t)head->n * sizeof *x);
        file_hash(hasher, sha256);
    }
    file_log_free(&log);
}

/* The record without the address of x. */
static struct fold_mark plain(const struct fold_mark *mark)
{
    struct fold_mark m;
    memset(&m, 0, sizeof m);
    m.step = mark->step;
    m.iterations = mark->iterations;
    m.evaluations = mark->evaluations;
    m.factorisations = mark->factorisations;
    m.n = mark->n;
    return m;
}

static bool write_mark(FILE *stream, const struct fold_mark *mark)
{
    struct fold_mark m = plain(mark);
    char sha256[FILE_HASH];
    size_t n = (size_t)mark->n;
    bool written = fwrite(&m, sizeof m, 1, stream) == 1 && fwrite(mark->x, sizeof *mark->x, n, stream) == n;
    hash_mark(&m, mark->x, sha256);
    return written && fwrite(sha256, sizeof sha256, 1, stream) == 1 && fflush(stream) == 0;
}

/* The next whole record; false at the end, or where it is cut off. */
static bool read_mark(FILE *stream, struct fold_mark *mark)
{
    char sha256[FILE_HASH], wanted[FILE_HASH];
    double *x = NULL;
    if (fread(mark, sizeof *mark, 1, stream) != 1 || mark->n <= 0 || !(x = malloc((size_t)mark->n * sizeof *x)))
        return false;
    size_t n = (size_t)mark->n;
    if (fread(x, sizeof *x, n, stream) == n && fread(sha256, sizeof sha256, 1, stream) == 1) {
        hash_mark(mark, x, wanted);
        if (memcmp(sha256, wanted, sizeof sha256) == 0) {
            mark->x = x;
            return true;
        }
    }
    free(x);
    return false;
}

/* ---- going on ---- */

/* Reads all whole records; what is after them is cut off. */
static void read_marks(struct checkpoint *c)
{
    struct fold_mark mark;
    long end = ftell(c->stream);
    while (read_mark(c->stream, &mark)) {
        struct fold_mark *more = realloc(c->mark, (size_t)(c->nread + 1) * sizeof *more);
        if (!more)
            break;
        c->mark = more;
        c->mark[c->nread++] = mark;
        end = ftell(c->stream);
    }
    c->nmarks = c->nread;
    fseek(c->stream, end, SEEK_SET);
    if (ftruncate(fileno(c->stream), end) != 0) {
        fclose(c->stream);
        c->stream = NULL;
    }
}

/* A file without a whole beginning is nobody's: it is written anew. */
static bool is_ours(struct checkpoint *c)
{
    char head[sizeof title - 1 + FILE_HASH];
    if (fread(head, sizeof head, 1, c->stream) != 1) {
        fclose(c->stream);
        c->stream = NULL;
        return true;
    }
    return memcmp(head, title, sizeof title - 1) == 0 &&
           memcmp(head + sizeof title - 1, c->key, FILE_HASH) == 0;
}

/* Says why there is nothing to go on from. */
static enum status refuse(const struct checkpoint *c, int number)
{
    if (number == ENOENT) {
        fprintf(stderr, "weft: there is no %s to go on from: the run begins anew\n", c->path);
        return STATUS_DONE;
    }
    fprintf(stderr, "weft: cannot go on from '%s': %s\n", c->path,
            number ? strerror(number) : "it is of another script, other parameters or threads, or another build of weft; "
                                        "without --resume the run begins anew");
    return STATUS_FILES;
}

/* One that does not fit is of no use to anybody where it need not. */
static void drop(struct checkpoint *c)
{
    if (c->stream)
        fclose(c->stream);
    c->stream = NULL;
    unlink(c->path);
}

static enum status resume(struct checkpoint *c, enum checkpoint_wish wish, bool quiet)
{
    c->stream = fopen(c->path, "r+b");
    int number = c->stream ? 0 : errno;
    bool fits = c->stream && is_ours(c);
    if (!fits && wish == CHECKPOINT_MUST_FIT)
        return refuse(c, number);
    if (!fits)
        drop(c);
    if (c->stream)
        read_marks(c);
    if (!quiet && c->nread > 0)
        fprintf(stderr, "weft: going on after growth %.6g, from %s\n", c->mark[c->nread - 1].step.growth, c->path);
    return STATUS_DONE;
}

/* As manifest_path, below a folder. */
static char *path_below(const char *into, const struct scene *scene)
{
    char *path = manifest_path(scene, ".checkpoint"), *below = NULL;
    if (!path || !into)
        return path;
    if (asprintf(&below, "%s/%s", into, path) < 0)
        below = NULL;
    free(path);
    return below;
}

enum status checkpoint_open(struct checkpoint *c, const struct report *report, const struct options *options,
                            enum checkpoint_wish wish, const char *into)
{
    *c = (struct checkpoint){.path = path_below(into, report->scene)};
    if (!c->path)
        return STATUS_DONE;
    make_key(c, report, options);
    enum status status = wish == CHECKPOINT_ANEW ? STATUS_DONE : resume(c, wish, options->quiet);
    if (status != STATUS_DONE) {
        c->nmarks = 1;      /* not ours to remove */
        checkpoint_close(c, false);
    }
    return status;
}

/* ---- keeping ---- */

static bool begin(struct checkpoint *c)
{
    c->stream = fopen(c->path, "wb");
    return c->stream && fputs(title, c->stream) >= 0 && fwrite(c->key, FILE_HASH, 1, c->stream) == 1;
}

void checkpoint_step(struct checkpoint *c, const struct fold_step *step, const struct fold_state *state)
{
    if (!c->path || step->growth >= 1 || c->nshown++ < c->nread)
        return;
    struct fold_mark mark = fold_mark(step, state);
    if ((c->stream || begin(c)) && write_mark(c->stream, &mark)) {
        c->nmarks++;
        return;
    }
    fprintf(stderr, "weft: cannot write '%s': %s; the run goes on, but could not be resumed\n", c->path, strerror(errno));
    c->nmarks = 0;
    checkpoint_close(c, true);
}

void checkpoint_close(struct checkpoint *c, bool complete)
{
    if (c->stream)
        fclose(c->stream);
    if (c->stream && (complete || c->nmarks == 0))
        unlink(c->path);
    for (int i = 0; i < c->nread; i++)
        free((double *)c->mark[i].x);
    free(c->mark);
    free(c->path);
    c->stream = NULL;
    c->path = NULL;
    c->mark = NULL;
    c->nread = 0;
}
