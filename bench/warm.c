/* SPDX-License-Identifier: GPL-3.0-or-later
 * Points of a sweep folded from the flat sheet and from their neighbour's shape: a script, a param and
 * its values in; a CSV line for each value out: both energies, both CPU seconds, one thread.
 *   warm SCRIPT PARAM VALUE VALUE... */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "lang/compile.h"
#include "solver/descent.h"
#include "solver/fold.h"
#include "solver/levels.h"
#include "solver/memory.h"
#include "solver/sheet.h"

static const double SETTLED = 1e-5;     /* tolerance of the first level, young * thickness^2, as fold.c has it */
static const double SAME = 1e-8;        /* of the energy: one minimum */

/* What a point leaves to its neighbour: the first level's minimum. */
struct shape {
    int     n;
    double *x;      /* (n), NULL: nothing */
};

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static const struct scene *compile(struct arena *arena, char **argv, const char *value)
{
    struct compile_override define = {argv[2], value};
    struct compile_options options = {.define = &define, .ndefines = 1};
    struct diag diag;
    const char *why = NULL;
    diag_init(&diag, arena);
    const struct source *source = source_read(arena, argv[1], &why);
    const struct scene *scene = source ? scene_compile(arena, &diag, source, &options) : NULL;
    diag_print(&diag, stderr, DIAG_HUMAN, false);
    if (!source)
        fprintf(stderr, "%s: %s\n", argv[1], why);
    return scene;
}

/* Moves the neighbour's shape to this sheet's minimum on the first level. */
static void settle(const struct sheet *sheet, struct shape *shape)
{
    struct discretisation *d = levels_first(sheet, 1);
    struct effort effort = {0};
    struct problem problem = {0};
    problem_open(&problem, d, &effort);
    problem.growth = 1;
    problem.limit = sheet->solve.max_iterations;
    problem.tolerance = SETTLED * sheet->thickness * sheet->thickness;
    descent_to_minimum(&problem, sheet->solve.method, shape->x);
    problem_close(&problem);
    d->op->free(d);
}

/* Keeps the last growth step on the first level: near its minimum, where there is no neighbour yet. */
static bool keep(void *self, const struct fold_step *step, const struct fold_state *state)
{
    struct shape *shape = self;
    struct fold_mark mark = fold_mark(step, state);
    if (shape->n && mark.n != shape->n)
        return true;
    shape->n = mark.n;
    shape->x = memory_grow(shape->x, (size_t)mark.n, sizeof *shape->x);
    for (int i = 0; i < mark.n; i++)
        shape->x[i] = mark.x[i];
    return true;
}

/* From the flat sheet. */
static struct fold_record fold_cold(const struct sheet *sheet, struct shape *shape)
{
    struct fold_record record;
    struct fold_observer observer = {.self = shape, .step = keep};
    struct fold_options options = {.threads = 1};
    fold_free(fold_run(sheet, &options, &observer, &record));
    return record;
}

/* From the neighbour's shape, as if all growth steps but the last had led there. */
static struct fold_record fold_warm(const struct sheet *sheet, struct shape *shape)
{
    int steps = sheet->solve.steps;
    struct fold_mark *mark = MEMORY_ARRAY(struct fold_mark, steps);
    struct fold_options options = {.threads = 1, .nmarks = steps, .mark = mark};
    struct fold_record record;
    settle(sheet, shape);
    for (int i = 0; i < steps; i++)
        mark[i] = (struct fold_mark){.step.growth = (double)i / steps, .n = shape->n, .x = shape->x};
    fold_free(fold_run(sheet, &options, NULL, &record));
    free(mark);
    return record;
}

static void print_row(const char *value, const struct fold_record *cold, const struct fold_record *warm, const double *spent)
{
    double more = warm->energy.total - cold->energy.total;
    const char *verdict = fabs(more) <= SAME * fabs(cold->energy.total) ? "same" : more < 0 ? "lower" : "higher";
    printf("%s,%d,%.12g,%s,%.3f,%.12g,%s,%.3f,%s\n", value, cold->per_stitch, cold->energy.total,
           fold_status_name(cold->status), spent[0], warm->energy.total, fold_status_name(warm->status), spent[1], verdict);
    fflush(stdout);
}

/* One value both ways; the first has no neighbour, and only leaves its shape. */
static void run_point(const struct sheet *sheet, const char *value, struct shape *shape)
{
    struct shape own = {0};
    double begun = seconds();
    struct fold_record cold = fold_cold(sheet, &own), warm;
    double spent[2] = {seconds() - begun, 0};
    if (shape->x) {
        begun = seconds();
        warm = fold_warm(sheet, shape);
        spent[1] = seconds() - begun;
        print_row(value, &cold, &warm, spent);
        fold_record_free(&warm);
        free(own.x);
    } else {
        *shape = own;
        settle(sheet, shape);
    }
    fold_record_free(&cold);
}

int main(int argc, char **argv)
{
    struct shape shape = {0};
    printf("value,per_stitch,cold,cold_status,cold_s,warm,warm_status,warm_s,verdict\n");
    for (int i = 3; i < argc; i++) {
        struct arena arena = {0};
        const struct scene *scene = compile(&arena, argv, argv[i]);
        if (!scene)
            return EXIT_FAILURE;
        struct sheet *sheet = sheet_build(scene);
        run_point(sheet, argv[i], &shape);
        sheet_free(sheet);
        arena_free(&arena);
    }
    free(shape.x);
    return EXIT_SUCCESS;
}
