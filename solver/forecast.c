/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a fold will need, without folding: a sheet in; its last mesh, a guess of
 * time and memory out. */
#include "solver/forecast.h"

#include "solver/factor.h"
#include "solver/levels.h"
#include "solver/sheet.h"

/* Costs, measured on two cores of 2020s make; and how often each is paid. */
static const double FLOP = 1 / 1.5e10;          /* s, of a factorisation */
static const double NONZERO = 1.5e-9;           /* s, of a factor, per iteration */
static const double ELEMENT = 1e-6;             /* s, per iteration */
static const double ASSEMBLE = 1.2e-5;          /* s, an element, per factorisation */
static const double KEPT = 2.6;                 /* times a factor and its pattern */
static const double PROGRAM = 15e6;             /* bytes */
enum { GROWTH_ITERATIONS = 30, GROWTH_FACTORS = 2, LEVEL_ITERATIONS = 60, LEVEL_FACTORS = 5 };

/* Adds a level on which so many iterations and factorisations are made. */
static void add_level(struct forecast *f, const struct discretisation *d, double iterations, double factors)
{
    struct factor *factor = factor_make(&d->pattern, d->ordered, d->parts, d->threads);
    double nonzeros = factor ? factor_nonzeros(factor) : 0, flops = factor ? factor_flops(factor) : 0;
    if (factor)
        factor_free(factor);
    f->per_stitch = d->per_stitch;
    f->unknowns = d->n;
    f->elements = d->elements;
    f->seconds += iterations * (nonzeros * NONZERO + (double)d->elements * ELEMENT);
    f->seconds += factors * (flops * FLOP + (double)d->elements * ASSEMBLE);
    f->bytes = PROGRAM + KEPT * (nonzeros * sizeof(double) + d->pattern.start[d->n] * (sizeof(double) + sizeof(int)));
}

struct forecast forecast_fold(const struct sheet *sheet)
{
    struct forecast forecast = {0};
    struct discretisation *d = levels_first(sheet, 1);
    double steps = sheet->solve.steps;
    add_level(&forecast, d, steps * GROWTH_ITERATIONS, steps * GROWTH_FACTORS);
    while (levels_passing(d)) {
        struct discretisation *finer = levels_next(d, 1);
        d->op->free(d);
        d = finer;
        add_level(&forecast, d, LEVEL_ITERATIONS, LEVEL_FACTORS);
    }
    d->op->free(d);
    return forecast;
}
