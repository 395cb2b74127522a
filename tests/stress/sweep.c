/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sweeps over materials, gauges, starts and patterns: each fold in a process of
 * its own with a time limit, its result judged by other means; a table out.
 * `sweep full [NAME]` prints it for the manual; without words a part of it, as TAP. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "solver/noise.h"
#include "tests/solver/scenes.h"
#include "tests/stress/trial.h"

enum { LIMIT = 120, MOST = 300, NRANDOM = 200, NRANDOM_SHORT = 24, CELLS = 4 };

/* ---- one sweep ---- */

struct sweep {
    const char *name, *range;
    void      (*set)(struct sheet *sheet, double value);
    double      value[12];      /* 0 ends the list unless it is the first */
    int         nvalues;
};

/* What came out of all folds of a sweep. */
struct tally {
    int    folds, status[FOLD_FAILED + 1], crushed, lost, wrong;
    int    iterations[MOST];
    double slowest;
    long   largest;
    char   note[8000];          /* a line for each fold that is not a minimum */
};

static void note(struct tally *tally, const char *scene, const char *text)
{
    size_t used = strlen(tally->note);
    snprintf(tally->note + used, sizeof tally->note - used, "%s: %s\n", scene, text);
}

static void count(struct tally *tally, const struct sheet *sheet, const char *scene)
{
    struct trial t;
    char text[320];
    tally->folds++;
    if (!trial_apart(sheet, LIMIT, &t, text)) {
        tally->lost++;
        note(tally, scene, text);
        return;
    }
    tally->status[t.status]++;
    tally->crushed += trial_crushed(&t);
    tally->iterations[tally->folds - tally->lost - 1] = t.iterations;
    tally->slowest = fmax(tally->slowest, t.seconds);
    tally->largest = t.unknowns > tally->largest ? t.unknowns : tally->largest;
    tally->wrong += t.wrong != 0;
    if (trial_good(&t))
        return;
    snprintf(text, sizeof text, "%s, gradient %.2g, %d iterations%s%s%s%s%s%s", fold_status_name(t.status), t.gradient,
             t.iterations, t.remark[0] ? "; " : "", t.remark, t.wrong & WRONG_NUMBER ? "; NOT FINITE" : "",
             t.wrong & WRONG_GRADIENT ? "; WRONG GRADIENT" : "", t.wrong & WRONG_INERTIA ? "; WRONG INERTIA" : "",
             t.wrong & WRONG_CLAIM ? "; WRONG CLAIM" : "");
    note(tally, scene, text);
}

static int by_size(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Every fold is a minimum, or there is none and it says so. */
static bool as_expected(const struct tally *t)
{
    return t->status[FOLD_CONVERGED] + t->status[FOLD_PRECISION] + t->crushed == t->folds && t->wrong == 0;
}

static void print_row(struct tally *t, const char *name, const char *range, bool full)
{
    static int number;
    int done = t->folds - t->lost;
    qsort(t->iterations, (size_t)done, sizeof *t->iterations, by_size);
    if (!full)
        printf("%s %d - ", as_expected(t) ? "ok" : "not ok", ++number);
    printf("| %s | %s | %d | %d | %d | %d | %d | %d | %d | %d | %d | %d / %d | %.1f |\n", name, range, t->folds,
           t->status[FOLD_CONVERGED], t->status[FOLD_PRECISION], t->status[FOLD_SADDLE], t->status[FOLD_ITERATION_LIMIT],
           t->status[FOLD_FAILED] - t->crushed, t->crushed, t->lost, t->wrong, done ? t->iterations[done / 2] : 0,
           done ? t->iterations[done - 1] : 0, t->slowest);
    for (char *line = strtok(t->note, "\n"); line; line = strtok(NULL, "\n"))
        full ? fprintf(stderr, "%s: %s\n", name, line) : printf("# %s\n", line);
    fflush(stdout);
}

/* ---- what is varied ---- */

static void thickness(struct sheet *s, double v)
{
    s->thickness = v;
}

static void curvature(struct sheet *s, double v)
{
    for (int i = 0; i < s->columns * s->rows; i++)
        s->kx[i] *= v, s->ky[i] *= v;
}

static void poisson(struct sheet *s, double v)
{
    s->poisson = v;
}

static void aspect(struct sheet *s, double v)
{
    s->dx = 1.3 * sqrt(v), s->dy = 1.3 / sqrt(v);
}

static void springs(struct sheet *s, double v)
{
    s->spring = v;
}

static void noise(struct sheet *s, double v)
{
    s->solve.noise = v;
}

#define LIST(...) {__VA_ARGS__}, (int)(sizeof(double[])LIST_(__VA_ARGS__) / sizeof(double))
#define LIST_(...) {__VA_ARGS__}

static const struct sweep sweeps[] = {
    {"thickness", "0.001 to 10", thickness, LIST(1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1, 3, 10)},
    {"curvature", "0.01 to 3", curvature, LIST(0.01, 0.03, 0.1, 0.3, 1, 2, 3)},
    {"poisson", "-0.9 to 0.499", poisson, LIST(-0.9, -0.5, 0, 0.3, 0.45, 0.49, 0.499)},
    {"stitch width : height", "1:50 to 50:1", aspect, LIST(0.02, 0.1, 0.3, 1, 3, 10, 50)},
    {"springs", "0 to 10", springs, LIST(0, 1e-6, 1e-3, 0.1, 1, 10)},
    {"noise", "0 to 1", noise, LIST(0, 1e-6, 0.01, 0.1, 1)},
};

static const struct {
    const char *name;
    int       (*purl)(int x, int y);
    int         columns, rows;
} patterns[] = {{"plain", NULL, 6, 6}, {"rib", rib, 8, 6}, {"checker", checker, 6, 6}, {"seed", seed, 6, 6}};
enum { NPATTERNS = sizeof patterns / sizeof *patterns };

static const char *name_of(char name[80], const char *swept, enum discretisation_kind kind)
{
    snprintf(name, 80, "%s%s", swept, kind == DISCRETISATION_TRIANGLE ? ", triangles" : "");
    return name;
}

/* Every value with every pattern; in short, and on triangles, the first, middle and last with one pattern each. */
static bool run_sweep(const struct sweep *sweep, bool full, enum discretisation_kind kind)
{
    bool triangle = kind == DISCRETISATION_TRIANGLE;
    struct tally *tally = calloc(1, sizeof *tally);
    char name[80];
    for (int i = 0; i < sweep->nvalues; i++)
        for (int p = 0; p < NPATTERNS; p++) {
            if ((!full || triangle) && !(i % ((sweep->nvalues - 1) / 2) == 0 && p == i % NPATTERNS))
                continue;
            char scene[80];
            struct sheet *s = scene_sheet(patterns[p].columns, patterns[p].rows, patterns[p].purl);
            s->mesh.discretisation = kind;
            s->mesh.per_stitch = triangle ? CELLS : 1;
            sweep->set(s, sweep->value[i]);
            snprintf(scene, sizeof scene, "%s, %s %g", patterns[p].name, sweep->name, sweep->value[i]);
            count(tally, s, scene);
            sheet_free(s);
        }
    print_row(tally, name_of(name, sweep->name, kind), sweep->range, full);
    bool good = as_expected(tally);
    free(tally);
    return good;
}

/* Patterns without rule: any size to 12 x 12, one in ten long and narrow. */
static bool run_random(bool full, enum discretisation_kind kind)
{
    bool triangle = kind == DISCRETISATION_TRIANGLE;
    struct tally *tally = calloc(1, sizeof *tally);
    char name[80];
    for (int i = 1; i <= (full ? NRANDOM : NRANDOM_SHORT) / (triangle ? 5 : 1); i++) {
        uint64_t random = (uint64_t)i;
        int most = full ? 12 : 6, columns = 1 + (int)((noise_next(&random) + 1) / 2 * most);
        int rows = 1 + (int)((noise_next(&random) + 1) / 2 * most);
        if (i % 10 == 0)
            columns = i % 20 ? 1 : 5 * columns, rows = i % 20 ? 5 * rows : 1;
        struct sheet *s = scene_sheet(columns, rows, NULL);
        for (int k = 0; k < columns * rows; k++)
            if (noise_next(&random) < 0)
                s->kx[k] *= -1, s->ky[k] *= -1;
        s->mesh.discretisation = kind;
        s->mesh.per_stitch = triangle ? CELLS : 0;
        s->solve.steps = i % 2 ? 10 : 1;
        char scene[80];
        snprintf(scene, sizeof scene, "pattern %d, %d x %d", i, columns, rows);
        count(tally, s, scene);
        sheet_free(s);
    }
    print_row(tally, name_of(name, "random patterns", kind), full ? "1x1 to 12x12, 1x60, 60x1" : "1x1 to 6x6", full);
    bool good = as_expected(tally);
    free(tally);
    return good;
}

int main(int argc, char **argv)
{
    bool full = argc > 1, good = true;
    const char *only = argc > 2 ? argv[2] : NULL;
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    setenv("OMP_WAIT_POLICY", "passive", 1);
    if (full)
        printf("| swept | range | folds | converged | precision | saddle | limit | failed | crushed | lost | wrong | "
               "iterations median / max | longest s |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    else
        printf("1..%d\n", (int)(sizeof sweeps / sizeof *sweeps) + 2);
    for (size_t i = 0; i < sizeof sweeps / sizeof *sweeps; i++)
        if (!only || strcmp(only, sweeps[i].name) == 0)
            good &= run_sweep(&sweeps[i], full, DISCRETISATION_PATCH);
    if (!only || strcmp(only, "random") == 0)
        good &= run_random(full, DISCRETISATION_PATCH);
    if (!only || strcmp(only, "triangle") == 0)
        good &= run_random(full, DISCRETISATION_TRIANGLE);
    for (size_t i = 0; full && i < sizeof sweeps / sizeof *sweeps; i++)
        if (!only || strcmp(only, "triangle") == 0)
            good &= run_sweep(&sweeps[i], full, DISCRETISATION_TRIANGLE);
    return good ? 0 : 1;
}
