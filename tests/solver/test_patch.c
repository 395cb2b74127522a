/* SPDX-License-Identifier: GPL-3.0-or-later
 * The patch's derivatives against differences, its invariances, and energies
 * known in closed form. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>

#include "solver/memory.h"
#include "solver/patch.h"
#include "solver/two_level.h"
#include "solver/vector.h"
#include "tests/solver/near.h"
#include "tests/solver/scenes.h"

static const struct basis *const bases[] = {&basis_hermite, &basis_spline};

/* A sheet with every term in it: twist, springs, an uneven pattern. */
static struct sheet *full_sheet(void)
{
    struct sheet *s = scene_sheet(5, 4, checker);
    for (int i = 0; i < 20; i++)
        s->twist[i] = 0.3 * scene_random();
    s->spring = 0.02;
    s->spring_edges = EDGE_LEFT | EDGE_TOP;
    return s;
}

/* y = A v for the lower triangle of a symmetric matrix. */
static void multiply(const struct pattern *p, const double *value, const double *v, double *y)
{
    for (int i = 0; i < p->n; i++)
        y[i] = 0;
    for (int j = 0; j < p->n; j++)
        for (int k = p->start[j]; k < p->start[j + 1]; k++) {
            int i = p->row[k];
            y[i] += value[k] * v[j];
            if (i != j)
                y[j] += value[k] * v[i];
        }
}

/* The error of central differences falls with the step squared and rises
 * again by rounding; its least over the steps is what counts. */
static double least_error(const struct discretisation *d, double (*error)(const struct discretisation *, const double *,
                                                                         const double *, double), const double *x, const double *v)
{
    double least = 1;
    for (double step = 1e-3; step > 1e-8; step /= 4)
        least = fmin(least, error(d, x, v, step));
    return least;
}

static double gradient_error(const struct discretisation *d, const double *x, const double *v, double step)
{
    double *g = MEMORY_ARRAY(double, d->n), *y = MEMORY_ARRAY(double, d->n), e[2];
    d->op->energy(d, x, 0.7, g);
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < d->n; i++)
            y[i] = x[i] + (side ? step : -step) * v[i];
        e[side] = d->op->energy(d, y, 0.7, NULL).total;
    }
    double exact = vector_dot(d->n, g, v), error = fabs((e[1] - e[0]) / (2 * step) - exact) / fabs(exact);
    free(g), free(y);
    return error;
}

static double hessian_error(const struct discretisation *d, const double *x, const double *v, double step)
{
    int n = d->n;
    double *H = MEMORY_ARRAY(double, d->pattern.start[n]), *Hv = MEMORY_ARRAY(double, n);
    double *y = MEMORY_ARRAY(double, n), *diff = MEMORY_ARRAY(double, n);
    d->op->hessian(d, x, 0.7, HESSIAN_EXACT, H);
    multiply(&d->pattern, H, v, Hv);
    for (int side = -1; side <= 1; side += 2) {
        double *g = MEMORY_ARRAY(double, n);
        for (int i = 0; i < n; i++)
            y[i] = x[i] + side * step * v[i];
        d->op->energy(d, y, 0.7, g);
        for (int i = 0; i < n; i++)
            diff[i] += side * g[i] / (2 * step);
        free(g);
    }
    for (int i = 0; i < n; i++)
        diff[i] -= Hv[i];
    double error = sqrt(vector_dot(n, diff, diff) / vector_dot(n, Hv, Hv));
    free(H), free(Hv), free(y), free(diff);
    return error;
}

static void gradient_is_the_derivative(void **state)
{
    (void)state;
    struct sheet *s = full_sheet();
    for (int b = 0; b < 2; b++) {
        struct discretisation *d = patch_make(s, bases[b], 1, 3, 1);
        double *x = scene_state(d, 0.4), *v = scene_vector(d->n, 1);
        assert_true(least_error(d, gradient_error, x, v) < 1e-8);
        free(x), free(v);
        d->op->free(d);
    }
    sheet_free(s);
}

static void hessian_is_the_derivative(void **state)
{
    (void)state;
    struct sheet *s = full_sheet();
    for (int b = 0; b < 2; b++)
        for (int per_stitch = 1; per_stitch <= 2; per_stitch++) {
            struct discretisation *d = patch_make(s, bases[b], per_stitch, 4, 1);
            double *x = scene_state(d, 0.2), *v = scene_vector(d->n, 1);
            assert_true(least_error(d, hessian_error, x, v) < 1e-8);
            free(x), free(v);
            d->op->free(d);
        }
    sheet_free(s);
}

static void semidefinite_hessian_has_no_negative_direction(void **state)
{
    (void)state;
    struct sheet *s = full_sheet();
    struct discretisation *d = patch_make(s, &basis_hermite, 1, 3, 1);
    double *H = MEMORY_ARRAY(double, d->pattern.start[d->n]), *Hv = MEMORY_ARRAY(double, d->n);
    for (int trial = 0; trial < 5; trial++) {
        double *x = scene_state(d, 0.5);
        d->op->hessian(d, x, 1, HESSIAN_SEMIDEFINITE, H);
        /* Power iteration on c I - H finds the lowest eigenvalue. */
        double c = 0, lowest = 0, *v = scene_vector(d->n, 1);
        for (int i = 0; i < d->n; i++)
            for (int k = d->pattern.start[i]; k < d->pattern.start[i + 1]; k++)
                c += fabs(H[k]) / 20;
        for (int round = 0; round < 3000; round++) {
            multiply(&d->pattern, H, v, Hv);
            lowest = vector_dot(d->n, v, Hv) / vector_dot(d->n, v, v);
            for (int i = 0; i < d->n; i++)
                v[i] -= Hv[i] / c;
            double length = sqrt(vector_dot(d->n, v, v));
            for (int i = 0; i < d->n; i++)
                v[i] /= length;
        }
        assert_true(lowest > -1e-12 * c);
        free(x), free(v);
    }
    free(H), free(Hv);
    d->op->free(d);
    sheet_free(s);
}

/* A1: U/A = D/2 (kx^2 + ky^2 + 2 nu kx ky), D = h^3 / (12 (1 - nu^2)). */
static void flat_energy_in_closed_form(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(6, 5, NULL);
    for (int i = 0; i < 30; i++)
        s->kx[i] = -0.7, s->ky[i] = 1.3;
    double D = 0.125 / (12 * (1 - 0.16)), area = 6 * 1.4 * 5 * 1.2;
    double expected = area * D / 2 * (0.49 + 1.69 - 2 * 0.4 * 0.91);
    for (int b = 0; b < 2; b++) {
        struct discretisation *d = patch_make(s, bases[b], 2, 3, 1);
        double *x = MEMORY_ARRAY(double, d->n);
        d->op->flat(d, x);
        struct fold_energy e = d->op->energy(d, x, 1, NULL);
        assert_near(e.total, expected, 1e-13 * expected);
        assert_near(e.stretching, 0, 1e-15);
        assert_near(d->op->energy(d, x, 0, NULL).total, 0, 1e-15);
        free(x);
        d->op->free(d);
    }
    sheet_free(s);
}

/* Turned and moved far away, a state keeps its energy. */
static void rigid_motion_costs_nothing(void **state)
{
    (void)state;
    struct sheet *s = full_sheet();
    s->spring = 0;
    struct discretisation *d = patch_make(s, &basis_hermite, 1, 3, 1);
    double *x = scene_state(d, 0.3), before = d->op->energy(d, x, 1, NULL).total;
    const double R[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
    for (int i = 0; i < d->n; i += 3) {
        double r[3] = {x[i], x[i + 1], x[i + 2]};
        for (int c = 0; c < 3; c++)
            x[i + c] = R[c][0] * r[0] + R[c][1] * r[1] + R[c][2] * r[2] + (i % 12 == 0 ? 1000 : 0);
    }
    assert_near(d->op->energy(d, x, 1, NULL).total, before, 1e-10 * before);
    free(x);
    d->op->free(d);
    sheet_free(s);
}

/* Springs: every point moved by u costs 1/2 k |u|^2 times the length of the sprung edges. */
static void springs_in_closed_form(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(5, 4, NULL);
    s->spring = 0.3;
    s->spring_edges = EDGE_LEFT | EDGE_BOTTOM;
    for (int b = 0; b < 2; b++) {
        struct discretisation *d = patch_make(s, bases[b], 1, 3, 1);
        double *x = MEMORY_ARRAY(double, d->n);
        d->op->flat(d, x);
        for (int i = 0; i < d->nnodes; i++)
            x[d->node[i]] += 0.5, x[d->node[i] + 2] -= 2;
        double expected = 0.5 * 0.3 * (0.25 + 4) * (4 * 1.2 + 5 * 1.4);
        assert_near(d->op->energy(d, x, 0, NULL).springs, expected, 1e-12);
        free(x);
        d->op->free(d);
    }
    sheet_free(s);
}

/* Levels are nested: the finer state is the same surface, so the same energy
 * where the quadrature sees it equally (a sheet at small strain). */
static void prolongation_keeps_the_surface(void **state)
{
    (void)state;
    struct sheet *s = full_sheet();
    struct discretisation *level[3] = {patch_make(s, &basis_spline, 1, 4, 1), patch_make(s, &basis_hermite, 1, 4, 1),
                                       patch_make(s, &basis_hermite, 2, 4, 1)};
    double *x = scene_state(level[0], 0.1);
    struct surface coarse = surface_make(5, 4, 3), fine = surface_make(5, 4, 3);
    level[0]->op->sample(level[0], x, 1, &coarse);
    for (int l = 1; l < 3; l++) {
        double *y = MEMORY_ARRAY(double, level[l]->n);
        level[l]->op->prolong(level[l - 1], x, level[l], y);
        level[l]->op->sample(level[l], y, 1, &fine);
        for (int i = 0; i < 3 * 16 * 13; i++) {
            assert_near(fine.position[i], coarse.position[i], 1e-12);
            assert_near(fine.normal[i], coarse.normal[i], 1e-12);
        }
        for (int i = 0; i < 15 * 12; i++)
            assert_near(fine.mean[i], coarse.mean[i], 1e-11);
        free(x);
        x = y;
    }
    free(x);
    surface_free(&coarse), surface_free(&fine);
    for (int l = 0; l < 3; l++)
        level[l]->op->free(level[l]);
    sheet_free(s);
}

/* One thread or two: the same bits. */
/* P^T g and P^T H P against P itself, H v in two halves and blended against H v, on a mesh with several bands. */
static void restrictions_are_those_of_the_prolongation(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(9, 37, miura);
    struct discretisation *level[] = {patch_make(s, &basis_spline, 1, 3, 2), patch_make(s, &basis_hermite, 1, 4, 2),
                                      patch_make(s, &basis_hermite, 2, 4, 2)};
    for (int l = 1; l < 3; l++) {
        const struct discretisation *coarse = level[l - 1], *fine = level[l];
        double *x = scene_state(fine, 0.1), *g = scene_vector(fine->n, 1), *v = scene_vector(coarse->n, 1);
        double *Pv = MEMORY_ARRAY(double, fine->n), *HPv = MEMORY_ARRAY(double, fine->n);
        double *Pg = MEMORY_ARRAY(double, coarse->n), *Hv = MEMORY_ARRAY(double, coarse->n), *y = MEMORY_ARRAY(double, fine->n);
        double *H = MEMORY_ARRAY(double, fine->pattern.start[fine->n]);
        double *Hc = MEMORY_ARRAY(double, coarse->pattern.start[coarse->n]);
        coarse->op->prolong(coarse, v, fine, Pv);
        coarse->op->restrict_gradient(coarse, Pg, fine, g);
        assert_near(vector_dot(coarse->n, Pg, v), vector_dot(fine->n, g, Pv), 1e-10);

        fine->op->hessian(fine, x, 1, HESSIAN_EXACT, H);
        coarse->op->restrict_hessian(coarse, Hc, fine, H);
        multiply(&fine->pattern, H, Pv, HPv);
        multiply(&coarse->pattern, Hc, v, Hv);
        coarse->op->restrict_gradient(coarse, Pg, fine, HPv);
        double size = sqrt(vector_dot(coarse->n, Hv, Hv));
        for (int i = 0; i < coarse->n; i++)
            assert_near(Hv[i], Pg[i], 1e-12 * size);

        struct two_level *t = two_level_make(coarse, NULL, NULL, fine);
        two_level_update(t, x, 1, 0);
        two_level_multiply(t, Pv, y);
        size = sqrt(vector_dot(fine->n, HPv, HPv));
        for (int i = 0; i < fine->n; i++)
            assert_near(y[i], HPv[i], 1e-12 * size);

        fine->op->hessian(fine, x, 1, HESSIAN_SEMIDEFINITE, H);
        multiply(&fine->pattern, H, Pv, g);
        size = fmax(size, sqrt(vector_dot(fine->n, g, g)));
        for (int quarter = 1; quarter <= 4; quarter++) {
            two_level_update(t, x, 1, quarter / 4.0);
            two_level_multiply(t, Pv, y);
            for (int i = 0; i < fine->n; i++)
                assert_near(y[i], HPv[i] + quarter / 4.0 * (g[i] - HPv[i]), 1e-12 * size);
        }
        two_level_free(t);
        free(x), free(g), free(v), free(Pv), free(HPv), free(Pg), free(Hv), free(y), free(H), free(Hc);
    }
    for (int l = 0; l < 3; l++)
        level[l]->op->free(level[l]);
    sheet_free(s);
}

static void threads_change_nothing(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(24, 23, miura);
    struct discretisation *one = patch_make(s, &basis_hermite, 1, 3, 1), *two = patch_make(s, &basis_hermite, 1, 3, 2);
    double *x = scene_state(one, 0.2), *g = MEMORY_ARRAY(double, one->n), *f = MEMORY_ARRAY(double, one->n);
    int nonzeros = one->pattern.start[one->n];
    double *H = MEMORY_ARRAY(double, nonzeros), *I = MEMORY_ARRAY(double, nonzeros);
    assert_true(one->op->energy(one, x, 1, g).total == two->op->energy(two, x, 1, f).total);
    one->op->hessian(one, x, 1, HESSIAN_EXACT, H);
    two->op->hessian(two, x, 1, HESSIAN_EXACT, I);
    assert_memory_equal(g, f, sizeof *g * (size_t)one->n);
    assert_memory_equal(H, I, sizeof *H * (size_t)nonzeros);
    free(x), free(g), free(f), free(H), free(I);
    one->op->free(one), two->op->free(two);
    sheet_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gradient_is_the_derivative),
        cmocka_unit_test(hessian_is_the_derivative),
        cmocka_unit_test(semidefinite_hessian_has_no_negative_direction),
        cmocka_unit_test(flat_energy_in_closed_form),
        cmocka_unit_test(rigid_motion_costs_nothing),
        cmocka_unit_test(springs_in_closed_form),
        cmocka_unit_test(prolongation_keeps_the_surface),
        cmocka_unit_test(restrictions_are_those_of_the_prolongation),
        cmocka_unit_test(threads_change_nothing),
    };
    return cmocka_run_group_tests_name("patch", tests, NULL, NULL);
}
