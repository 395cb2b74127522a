/* SPDX-License-Identifier: GPL-3.0-or-later
 * How far each stage is from what the machine can do: bandwidth by a triad, arithmetic by dgemm,
 * then the solver's own stages on a sheet of patches, one thread; CSV to standard output.
 *   limits [columns rows [per_stitch]] */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "solver/factor.h"
#include "solver/memory.h"
#include "solver/patch.h"

void dgemm_(const char *ta, const char *tb, const int *m, const int *n, const int *k, const double *alpha,
            const double *a, const int *lda, const double *b, const int *ldb, const double *beta, double *c,
            const int *ldc);
extern void openblas_set_num_threads(int threads) __attribute__((weak));

struct work {
    const struct discretisation *d;
    struct factor *factor;
    double *x, *g, *value;
};

enum { TRIAD = 1 << 23, ORDER = 1024, ROUNDS = 5 };

/* CPU seconds of this process, which runs on one thread. */
static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The least of five rounds. */
static double least_seconds(void (*run)(struct work *w), struct work *w)
{
    double least = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        double start = seconds();
        run(w);
        least = fmin(least, seconds() - start);
    }
    return least;
}

/* a = b + s c, as STREAM does: x, g and value hold TRIAD numbers each. */
static void triad(struct work *w)
{
    for (int i = 0; i < TRIAD; i++)
        w->x[i] = w->g[i] + 3 * w->value[i];
}

static void multiply(struct work *w)
{
    int n = ORDER;
    double one = 1, zero = 0;
    dgemm_("N", "N", &n, &n, &n, &one, w->g, &n, w->value, &n, &zero, w->x, &n);
}

static void gradient(struct work *w)
{
    w->d->op->energy(w->d, w->x, 1, w->g);
}

static void exact(struct work *w)
{
    w->d->op->hessian(w->d, w->x, 1, HESSIAN_EXACT, w->value);
}

static void semidefinite(struct work *w)
{
    w->d->op->hessian(w->d, w->x, 1, HESSIAN_SEMIDEFINITE, w->value);
}

static void factorise(struct work *w)
{
    if (factor_numeric(w->factor, w->value) != FACTOR_DONE)
        fprintf(stderr, "limits: the factor failed\n");
}

static void solve(struct work *w)
{
    factor_solve(w->factor, w->g, w->x);
}

/* flops, bytes: of one call, 0 where not counted. */
static void row(const char *what, double seconds, double flops, double bytes, int unknowns)
{
    printf("%s,%d,%.6f,", what, unknowns, seconds);
    printf(flops > 0 ? "%.2f," : ",", flops / seconds / 1e9);
    printf(bytes > 0 ? "%.2f," : ",", bytes / seconds / 1e9);
    printf(bytes > 0 && unknowns ? "%.0f\n" : "\n", bytes / unknowns);
}

static void probes(void)
{
    struct work w = {.x = MEMORY_ARRAY(double, TRIAD), .g = MEMORY_ARRAY(double, TRIAD),
                     .value = MEMORY_ARRAY(double, TRIAD)};
    for (int i = 0; i < TRIAD; i++)
        w.x[i] = 0, w.g[i] = 1, w.value[i] = 2;
    row("triad", least_seconds(triad, &w), 2.0 * TRIAD, 24.0 * TRIAD, 0);
    row("dgemm", least_seconds(multiply, &w), 2.0 * ORDER * ORDER * ORDER, 0, 0);
    free(w.x);
    free(w.g);
    free(w.value);
}

/* The flat sheet has a factor that is singular but for this much of the mean of its diagonal. */
static void shift_diagonal(const struct discretisation *d, double *value)
{
    double mean = 0;
    for (int j = 0; j < d->n; j++)
        mean += value[d->pattern.start[j]] / d->n;
    for (int j = 0; j < d->n; j++)
        value[d->pattern.start[j]] += 1e-6 * mean;
}

static void stages(const char *level, const struct discretisation *d)
{
    size_t n = (size_t)d->n, entries = (size_t)d->pattern.start[d->n];
    struct work w = {d, NULL, MEMORY_ARRAY(double, n), MEMORY_ARRAY(double, n), MEMORY_ARRAY(double, entries)};
    char name[100];
    d->op->flat(d, w.x);

    /* Evaluation reads x and adds to g; assembly clears and adds to the values. */
    snprintf(name, sizeof name, "%s energy and gradient", level);
    row(name, least_seconds(gradient, &w), 0, 24.0 * (double)n, d->n);
    snprintf(name, sizeof name, "%s Hessian exact", level);
    row(name, least_seconds(exact, &w), 0, 24.0 * (double)entries, d->n);
    snprintf(name, sizeof name, "%s Hessian semidefinite", level);
    row(name, least_seconds(semidefinite, &w), 0, 24.0 * (double)entries, d->n);

    shift_diagonal(d, w.value);
    double start = seconds();
    w.factor = factor_make(&d->pattern, d->ordered, d->parts, 1);
    snprintf(name, sizeof name, "%s analysis", level);
    row(name, seconds() - start, 0, 0, d->n);
    if (w.factor) {
        double nonzeros = factor_nonzeros(w.factor);
        snprintf(name, sizeof name, "%s factor", level);
        row(name, least_seconds(factorise, &w), factor_flops(w.factor), 8 * nonzeros, d->n);
        snprintf(name, sizeof name, "%s solve", level);
        row(name, least_seconds(solve, &w), 4 * nonzeros, 16 * nonzeros, d->n);
    }
    factor_free(w.factor);
    free(w.x);
    free(w.g);
    free(w.value);
}

int main(int argc, char **argv)
{
    int columns = argc > 2 ? atoi(argv[1]) : 48, rows = argc > 2 ? atoi(argv[2]) : 92, per = argc > 3 ? atoi(argv[3]) : 1;
    size_t stitches = (size_t)columns * (size_t)rows;
    double *natural = MEMORY_ARRAY(double, stitches);
    struct sheet sheet = {.columns = columns, .rows = rows, .dx = 1.4, .dy = 1.2, .thickness = 0.5, .young = 1,
                          .poisson = 0.4, .kx = natural, .ky = natural, .twist = natural};
    for (size_t k = 0; k < stitches; k++)
        natural[k] = k / 3 % 2 ? 1 : -1;
    if (openblas_set_num_threads)
        openblas_set_num_threads(1);
    printf("what,unknowns,seconds,gflop_per_s,gbyte_per_s,bytes_per_unknown\n");
    probes();
    struct discretisation *spline = patch_make(&sheet, &basis_spline, per, 3, 1);
    stages("spline", spline);
    spline->op->free(spline);
    struct discretisation *patch = patch_make(&sheet, &basis_hermite, per, 4, 1);
    stages("patch", patch);
    patch->op->free(patch);
    free(natural);
    return 0;
}
