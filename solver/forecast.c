/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a fold will need, without folding: a sheet in; its last mesh, a guess of
 * time and memory out. */
#include "solver/forecast.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/factor.h"
#include "solver/fold.h"
#include "solver/levels.h"
#include "solver/memory.h"
#include "solver/sheet.h"

/* Costs, measured on two cores of 2020s make; and how often each is paid. */
static const double FLOP = 1 / 1.5e10;          /* s, of a factorisation */
static const double NONZERO = 1.5e-9;           /* s, of a factor, per iteration */
static const double ENTRY = 1e-9;               /* s, of a Hessian, per conjugate step */
static const double LARGE_NONZERO = 2.5e-9, LARGE_ENTRY = 3e-9;    /* the same two beyond any cache */
static const double ELEMENT = 2.5e-6;           /* s, per iteration */
static const double ASSEMBLE = 1.2e-5;          /* s, an element, per factorisation */
static const double FACE = 0.25;                /* of an element's costs, for a triangle */
static const double KEPT = 2.6;                 /* times a factor and its pattern */
static const double PROGRAM = 15e6, BEGIN = 0.02;   /* bytes and seconds, whatever the fold */
enum { FIRST_ITERATIONS = 90, FIRST_FACTORS = 5, GROWTH_ITERATIONS = 20, GROWTH_FACTORS = 2 };
enum { LEVEL_ITERATIONS = 60, LEVEL_FACTORS = 5 };
enum { NEWTON_STEPS = 18, CONJUGATE_STEPS = 24 };   /* of a level too large to factor, the inertia test too; of each step */
static const double RENEWED = 1.3;                  /* times in such a step that the Hessian and the factor are made */
static const double TURN_ITERATIONS = 10, TURN_FACTORS = 0.4;  /* more on each level, for each turn that the sheet rolls */
enum { CHECK_ITERATIONS = 40, CHECK_FACTORS = 6 };  /* on patches, for the error of triangles */
enum { ESTIMATE_STEPS = 20 };                       /* conjugate ones, for the error */
enum { SAMPLE = 12 };                               /* stitches a side */
enum { NEXT_LEVEL = 4 };                            /* times as many unknowns */

/* The last level that was factored. */
struct factored {
    double nonzeros, flops, bytes;
};

static double hessian_entries(const struct discretisation *d)
{
    return d->pattern.start[d->n];
}

/* A level that is factored, on which so many iterations and factorisations are made. */
static struct factored add_level(struct forecast *f, const struct discretisation *d, double iterations, double factors)
{
    struct factored own = {0};
    struct factor *factor = factor_make(&d->pattern, d->ordered, d->parts, d->threads);
    if (factor) {
        own.nonzeros = factor_nonzeros(factor);
        own.flops = factor_flops(factor);
        factor_free(factor);
    }
    double elements = (double)d->elements * (d->op->restrict_hessian ? 1 : FACE);
    own.bytes = KEPT * (own.nonzeros * sizeof(double) + hessian_entries(d) * (sizeof(double) + sizeof(int)));
    f->seconds += iterations * (own.nonzeros * NONZERO + elements * ELEMENT);
    f->seconds += factors * (own.flops * FLOP + elements * ASSEMBLE);
    f->bytes = PROGRAM + own.bytes;
    return own;
}

/* A level too large for that: conjugate gradients with the last factor; the most
 * memory goes into the Hessian of the next level, for the error estimate. */
static void add_conjugate_level(struct forecast *f, const struct discretisation *d, const struct factored *coarse)
{
    double step = hessian_entries(d) * LARGE_ENTRY + coarse->nonzeros * LARGE_NONZERO;
    double unknown = (double)d->block * sizeof(double);
    f->seconds += NEWTON_STEPS * (RENEWED * (coarse->flops * FLOP + (double)d->elements * ASSEMBLE) + CONJUGATE_STEPS * step);
    f->bytes = PROGRAM + coarse->bytes +
               (1 + NEXT_LEVEL) * (hessian_entries(d) * (sizeof(double) + sizeof(int)) + d->n * unknown);
}

/* The error estimate of the last level assembles the next one's Hessian and takes conjugate steps there. */
static void add_estimate(struct forecast *f, const struct discretisation *d, const struct factored *last)
{
    double finer = NEXT_LEVEL * (double)d->elements, entries = NEXT_LEVEL * hessian_entries(d);
    f->seconds += finer * ASSEMBLE + ESTIMATE_STEPS * (entries * ENTRY + last->nonzeros * NONZERO);
    double bytes = PROGRAM + last->bytes + entries * (sizeof(double) + sizeof(int));
    f->bytes = bytes > f->bytes ? bytes : f->bytes;
}

/* The turns that the mean curvature makes along a side, the more of the two. */
static double turns_of(const struct sheet *s)
{
    double x = 0, y = 0, stitches = (double)s->columns * s->rows;
    for (size_t i = 0; i < (size_t)stitches; i++)
        x += s->kx[i] / stitches, y += s->ky[i] / stitches;
    return fmax(fabs(x) * s->columns * s->dx, fabs(y) * s->rows * s->dy) / (2 * M_PI);
}

/* ---- auto: how fine? ---- */

/* The middle of the sheet, SAMPLE stitches a side at most. */
static struct sheet sample_of(const struct sheet *sheet)
{
    struct sheet s = *sheet;
    s.columns = s.columns < SAMPLE ? s.columns : SAMPLE;
    s.rows = s.rows < SAMPLE ? s.rows : SAMPLE;
    s.solve.steps = 1;
    const double *from[] = {sheet->kx, sheet->ky, sheet->twist};
    double **to[] = {&s.kx, &s.ky, &s.twist};
    int x = (sheet->columns - s.columns) / 2, y = (sheet->rows - s.rows) / 2;
    for (int k = 0; k < 3; k++) {
        *to[k] = MEMORY_ARRAY(double, (size_t)s.columns * (size_t)s.rows);
        for (int j = 0; j < s.rows; j++)
            memcpy(*to[k] + (size_t)j * (size_t)s.columns,
                   from[k] + (size_t)(y + j) * (size_t)sheet->columns + x, sizeof(double) * (size_t)s.columns);
    }
    return s;
}

/* The cells a stitch's side: as asked for, or those that the accuracy takes on a sample, as errors are made at the
 * stitches' lines, alike all over the sheet.  Plain libLBFGS stays on its first level. */
static int cells_of(const struct sheet *sheet)
{
    if (sheet->mesh.per_stitch || sheet->solve.method == METHOD_LBFGS)
        return sheet->mesh.per_stitch;
    struct sheet sample = sample_of(sheet);
    struct fold_record record;
    fold_free(fold_run(&sample, &(struct fold_options){.threads = 1}, NULL, &record));
    int cells = record.per_stitch;
    fold_record_free(&record);
    free(sample.kx), free(sample.ky), free(sample.twist);
    return cells;
}

/* Triangles find their error on patches, with their own level kept. */
static void add_check(struct forecast *f, const struct sheet *sheet)
{
    struct discretisation *patches = levels_patches(sheet, 1, 1);
    double kept = f->bytes;
    add_level(f, patches, CHECK_ITERATIONS, CHECK_FACTORS);
    f->bytes += kept - PROGRAM;
    patches->op->free(patches);
}

struct forecast forecast_fold(const struct sheet *sheet)
{
    struct forecast forecast = {.seconds = BEGIN};
    int cells = cells_of(sheet);
    struct discretisation *d = levels_first(sheet, 1);
    double more = sheet->solve.steps - 1, turns = turns_of(sheet);
    struct factored last = add_level(&forecast, d, FIRST_ITERATIONS + turns * TURN_ITERATIONS + more * GROWTH_ITERATIONS,
                                     FIRST_FACTORS + turns * TURN_FACTORS + more * GROWTH_FACTORS);
    while (levels_passing(d) || d->per_stitch < cells) {
        if (!levels_passing(d) && d->op->restrict_hessian)
            add_estimate(&forecast, d, &last);
        struct discretisation *finer = levels_next(d, 1);
        d->op->free(d);
        d = finer;
        if (d->n > FOLD_MOST_FACTORED && d->op->restrict_hessian)
            add_conjugate_level(&forecast, d, &last);
        else
            last = add_level(&forecast, d, LEVEL_ITERATIONS + turns * TURN_ITERATIONS, LEVEL_FACTORS + turns * TURN_FACTORS);
    }
    if (!d->op->restrict_hessian)
        add_check(&forecast, sheet);
    else
        add_estimate(&forecast, d, &last);
    forecast.per_stitch = d->per_stitch;
    forecast.unknowns = d->n;
    forecast.elements = d->elements;
    d->op->free(d);
    return forecast;
}
