/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a triangle costs: nanoseconds for energy, energy + gradient, both
 * Hessians and the change of increments, one line each per number of threads.
 *   triangle_kernel [columns rows per_stitch [threads]] */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "solver/triangle.h"

struct work {
    const struct discretisation *d;
    double *x, *g, *value;
};

static void energy(const struct work *w)
{
    w->d->op->energy(w->d, w->x, 1, NULL);
}

static void gradient(const struct work *w)
{
    w->d->op->energy(w->d, w->x, 1, w->g);
}

static void exact(const struct work *w)
{
    w->d->op->hessian(w->d, w->x, 1, HESSIAN_EXACT, w->value);
}

static void semidefinite(const struct work *w)
{
    w->d->op->hessian(w->d, w->x, 1, HESSIAN_SEMIDEFINITE, w->value);
}

static void tangent(const struct work *w)
{
    w->d->op->tangent(w->d, w->x, w->x, w->g);
}

static void cotangent(const struct work *w)
{
    w->d->op->cotangent(w->d, w->x, w->x, w->g);
}

static const struct {
    const char *name;
    void (*run)(const struct work *w);
} items[] = {
    {"energy", energy},           {"energy and gradient", gradient}, {"Hessian, exact", exact},
    {"Hessian, semidefinite", semidefinite}, {"tangent", tangent},   {"cotangent", cotangent},
};

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The least of five rounds of a tenth of a second each. */
static double measure(void (*run)(const struct work *), const struct work *w)
{
    double least = INFINITY;
    run(w);
    for (int round = 0; round < 5; round++) {
        double start = seconds(), now;
        int calls = 0;
        do
            run(w), calls++;
        while ((now = seconds()) - start < 0.1);
        least = fmin(least, (now - start) / calls);
    }
    return least;
}

int main(int argc, char **argv)
{
    bool sized = argc > 3;
    int columns = sized ? atoi(argv[1]) : 48, rows = sized ? atoi(argv[2]) : 92, per = sized ? atoi(argv[3]) : 2;
    int threads = argc > 4 ? atoi(argv[4]) : 1;
    size_t stitches = (size_t)columns * (size_t)rows;
    double *natural = calloc(stitches, sizeof *natural);
    struct sheet sheet = {.columns = columns, .rows = rows, .dx = 1.4, .dy = 1.2, .thickness = 0.5, .young = 1,
                          .poisson = 0.4, .kx = natural, .ky = natural, .twist = natural};
    for (size_t k = 0; k < stitches; k++)
        natural[k] = k / 3 % 2 ? 1 : -1;
    printf("threads,triangles,unknowns,what,ns_per_triangle\n");
    for (int n = 1; n <= threads; n *= 2) {
        struct discretisation *d = triangle_make(&sheet, per, n);
        struct work w = {d, calloc((size_t)d->n, 8), calloc((size_t)d->n, 8),
                         calloc((size_t)d->pattern.start[d->n], 8)};
        d->op->flat(d, w.x);
        for (int i = 0; i < d->n; i++)
            w.x[i] += 0.1 * sin(i);
        for (size_t k = 0; k < sizeof items / sizeof *items; k++)
            printf("%d,%ld,%d,%s,%.1f\n", n, d->elements, d->n, items[k].name,
                   1e9 * measure(items[k].run, &w) / (double)d->elements);
        free(w.x);
        free(w.g);
        free(w.value);
        d->op->free(d);
    }
    free(natural);
    return 0;
}
