/* SPDX-License-Identifier: GPL-3.0-or-later
 * The way down to a minimum, on a landscape of two valleys that is known. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#include "solver/descent.h"
#include "tests/solver/near.h"
#include "tests/solver/scenes.h"

/* One node; E = (u^2 - 1)^2 + 0.3 u + (v^2 + w^2)/2 has minima near u = -1 (lower) and u = 1. */
enum { UNKNOWNS = 3 };

static struct fold_energy valleys_energy(const struct discretisation *d, const double *restrict x, double growth,
                                         double *restrict gradient)
{
    (void)d, (void)growth;
    double u = x[0], v = x[1], w = x[2];
    if (gradient) {
        gradient[0] += 4 * u * (u * u - 1) + 0.3;
        gradient[1] += v;
        gradient[2] += w;
    }
    return (struct fold_energy){.total = (u * u - 1) * (u * u - 1) + 0.3 * u + (v * v + w * w) / 2};
}

/* The semidefinite one is so soft that its step from u = 1.5 ends beyond the ridge. */
static void valleys_hessian(const struct discretisation *d, const double *restrict x, double growth,
                            enum hessian_kind kind, double *restrict value)
{
    (void)d, (void)growth;
    value[0] = kind == HESSIAN_EXACT ? 12 * x[0] * x[0] - 4 : 3;
    value[1] = value[2] = 1;
}

static void valleys_mass(const struct discretisation *d, double *mass)
{
    for (int i = 0; i < d->n; i++)
        mass[i] = 1;
}

static const char *beyond_the_ridge(const struct discretisation *d, const double *x)
{
    (void)d;
    return x[0] < 0 ? "beyond the ridge" : NULL;
}

static const char *any_valley(const struct discretisation *d, const double *x)
{
    (void)d;
    return x[0] < 1.2 ? "in a valley" : NULL;
}

/* Where the descent from u = 1.5 ends, for a doubt or none. */
static double end_of(const char *(*doubt)(const struct discretisation *d, const double *x))
{
    const struct discretisation_ops op = {.kind = "valleys", .energy = valleys_energy, .hessian = valleys_hessian,
                                          .mass = valleys_mass, .doubt = doubt};
    int start[UNKNOWNS + 1] = {0, 1, 2, 3}, row[UNKNOWNS] = {0, 1, 2}, node = 0;
    struct sheet *sheet = scene_sheet(1, 1, NULL);
    sheet->spring = 1;      /* nothing is free to move rigidly */
    struct discretisation d = {.op = &op, .sheet = sheet, .n = UNKNOWNS, .elements = 1, .ordered = true, .nnodes = 1,
                               .node = &node, .threads = 1, .pattern = {.n = UNKNOWNS, .start = start, .row = row}};
    struct effort effort = {0};
    struct problem p;
    problem_open(&p, &d, &effort);
    p.limit = 1000;
    p.tolerance = 1e-10;
    double x[UNKNOWNS] = {1.5, 0.1, 0.1};
    struct descent end = descent_to_minimum(&p, METHOD_AUTO, x);
    assert_true(end.outcome == OUTCOME_CONVERGED && end.minimum);
    assert_true(p.gradient_max <= p.tolerance);
    assert_near(p.energy.total, valleys_energy(&d, x, 1, NULL).total, 1e-15);
    problem_close(&p);
    sheet_free(sheet);
    return x[0];
}

static void a_state_of_no_sense_is_gone_around(void **state)
{
    (void)state;
    assert_near(end_of(NULL), -1.0355, 1e-4);                /* the fast way overshoots */
    assert_near(end_of(beyond_the_ridge), 0.9602, 1e-4);     /* Newton's does not */
    assert_near(end_of(any_valley), -1.0355, 1e-4);          /* nor does it help here: the first end stays */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_state_of_no_sense_is_gone_around),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
