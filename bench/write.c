/* SPDX-License-Identifier: GPL-3.0-or-later
 * What each output of a folded swatch costs: a script in; for each of its outputs a CSV line out: kind, path,
 * bytes of that file, CPU seconds of all its growth steps and its end, sampling and hashing with it (the least of three).
 *   write SCRIPT */
#include <config.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <time.h>

#include "cli/outputs.h"
#include "lang/compile.h"
#include "solver/sheet.h"

enum { ROUNDS = 3 };

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static const struct scene *compile(struct arena *arena, const char *path)
{
    struct diag diag;
    const char *why = "errors";
    diag_init(&diag, arena);
    const struct source *source = source_read(arena, path, &why);
    const struct scene *scene = source ? scene_compile(arena, &diag, source, NULL) : NULL;
    diag_print(&diag, stderr, DIAG_HUMAN, false);
    if (!scene)
        fprintf(stderr, "%s: %s\n", path, why);
    return scene;
}

/* One output from start to end; the folded state stands in for all growth steps, which are no smaller. */
static bool write_once(const struct scene *scene, const struct fold_state *state, const struct fold_record *record)
{
    struct outputs outputs = {0};
    bool done = outputs_begin(&outputs, scene) == STATUS_DONE && outputs_chart(&outputs);
    for (int i = 0; i <= scene->solve.steps && done; i++) {
        struct fold_step step = {.growth = (double)i / scene->solve.steps, .energy = record->energy};
        done = outputs_step(&outputs, &step, state);
    }
    done = done && outputs_final(&outputs, state, record);
    if (!done)
        fprintf(stderr, "%s\n", outputs.log.error ? outputs.log.error : "not written");
    outputs_end(&outputs);
    return done;
}

static bool measure(const struct scene *scene, const struct fold_state *state, const struct fold_record *record)
{
    const struct output *output = scene->output;
    double least = INFINITY;
    struct stat status;
    for (int round = 0; round < ROUNDS; round++) {
        double begun = seconds();
        if (!write_once(scene, state, record))
            return false;
        least = fmin(least, seconds() - begun);
    }
    if (stat(output->path, &status) != 0)
        return false;
    printf("%s,%s,%ld,%.3f\n", output_kind_name(output->kind), output->path, (long)status.st_size, least);
    fflush(stdout);
    return true;
}

int main(int argc, char **argv)
{
    struct arena arena = {0};
    struct fold_record record;
    const struct fold_options options = {.threads = 1};
    const struct scene *scene = argc == 2 ? compile(&arena, argv[1]) : NULL;
    if (!scene)
        return EXIT_FAILURE;
    struct sheet *sheet = sheet_build(scene);
    struct fold_state *state = fold_run(sheet, &options, NULL, &record);
    bool done = state;
    printf("kind,path,bytes,cpu_s\n");
    for (int i = 0; i < scene->noutputs && done; i++) {
        struct scene one = *scene;
        one.output = &scene->output[i];
        one.noutputs = 1;
        done = measure(&one, state, &record);
    }
    fold_free(state);
    fold_record_free(&record);
    sheet_free(sheet);
    arena_free(&arena);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
