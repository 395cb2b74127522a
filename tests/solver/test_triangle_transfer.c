/* SPDX-License-Identifier: GPL-3.0-or-later
 * From one triangle mesh to a finer one, and to sampled surfaces. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>

#include "solver/memory.h"
#include "solver/problem.h"
#include "solver/triangle.h"
#include "solver/triangle_model.h"
#include "tests/solver/differences.h"
#include "tests/solver/scenes.h"

/* A sheet that wants to be the roll of curvature k along x, and that roll (angles of its boundary still missing). */
static const double k = -0.5;

static struct sheet *roll_sheet(int kind)
{
    struct sheet *s = scene_sheet(5, 3, NULL);
    for (int i = 0; i < 15; i++) {
        s->kx[i] = k;
        s->ky[i] = 0;
    }
    s->mesh.diagonals = (enum diagonals)kind;
    return s;
}

static double *rolled(const struct discretisation *d)
{
    double *x = scene_state(d, 0);
    for (int i = 0; i < d->nnodes; i++) {
        double *r = x + d->node[i];
        r[2] = (1 - cos(k * r[0])) / k;
        r[0] = sin(k * r[0]) / k;
    }
    return x;
}

/* The mesh's own minimum nearby. */
static void settle(const struct discretisation *d, double *x)
{
    struct effort effort = {0};
    struct problem problem;
    problem_open(&problem, d, &effort);
    problem.growth = 1;
    problem.limit = 1000;
    problem.tolerance = 1e-9;
    enum outcome outcome = newton_minimise(&problem, x);
    problem_close(&problem);
    assert_true(outcome == OUTCOME_CONVERGED || outcome == OUTCOME_PRECISION);
}

static void flat_stays_flat(void **unused)
{
    (void)unused;
    const int level[][2] = {{1, 2}, {2, 4}, {3, 4}, {4, 6}};
    for (int test = 0; test < 12; test++) {
        struct sheet *sheet = roll_sheet(test / 4);
        struct discretisation *a = triangle_make(sheet, level[test % 4][0], 1);
        struct discretisation *b = triangle_make(sheet, level[test % 4][1], 1);
        double *x = scene_state(a, 0), *y = MEMORY_ARRAY(double, b->n), *flat = scene_state(b, 0);
        a->op->prolong(a, x, b, y);
        for (int i = 0; i < b->n; i++)
            assert_true(fabs(y[i] - flat[i]) < 1e-13);
        free(x);
        free(y);
        free(flat);
        a->op->free(a);
        b->op->free(b);
        sheet_free(sheet);
    }
}

/* A state at rest of one mesh is nearly so on the next, the nearer the finer both are. */
static void little_energy_comes_in(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < 3; kind++) {
        struct sheet *sheet = roll_sheet(kind);
        double before = 1;
        for (int per = 2; per <= 8; per *= 2) {
            struct discretisation *a = triangle_make(sheet, per, 1), *b = triangle_make(sheet, 2 * per, 1);
            double *x = rolled(a), *y = MEMORY_ARRAY(double, b->n);
            settle(a, x);
            double *flat = scene_state(b, 0), scale = b->op->energy(b, flat, 1, NULL).total;
            a->op->prolong(a, x, b, y);
            double share = b->op->energy(b, y, 1, NULL).total / scale;
            print_message("# %d to %d cells a stitch: %.1e of the flat sheet's energy comes in\n", per, 2 * per, share);
            assert_true(share < before / 3);
            assert_true(triangle_max_angle(b, y) < M_PI / 4);
            before = share;
            free(x);
            free(y);
            free(flat);
            a->op->free(a);
            b->op->free(b);
        }
        assert_true(before < 1e-3);
        sheet_free(sheet);
    }
}

/* The roll's curvature, normals and positions; energies add up whatever the sample. */
static void sample_is_the_surface(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < 3; kind++)
        for (int per = 1; per <= 8; per = per < 4 ? per + 1 : per + 4) {
            struct sheet *sheet = roll_sheet(kind);
            struct discretisation *d = triangle_make(sheet, 4, 1);
            const struct triangle *t = (const struct triangle *)d;
            double *x = rolled(d), stretching = 0, bending = 0, area = 1.4 * 1.2 / (per * per);
            struct surface s = surface_make(5, 3, per);
            d->op->sample(d, x, 0.5, &s);
            for (int j = 0; j <= s.ny; j++)
                for (int i = 0; i <= s.nx; i++) {
                    const double *r = s.position + 3 * (j * (s.nx + 1) + i), *n = s.normal + 3 * (j * (s.nx + 1) + i);
                    const double *u = s.displacement + 3 * (j * (s.nx + 1) + i);
                    double angle = k * i * 1.4 / per;
                    assert_true(fabs(r[0] - sin(angle) / k) < 1e-4 && fabs(r[2] - (1 - cos(angle)) / k) < 1e-4);
                    assert_true(fabs(r[1] - j * 1.2 / per) < 1e-12);
                    assert_true(fabs(n[0] + sin(angle)) < 3e-3 && fabs(n[1]) < 1e-12 && fabs(n[2] - cos(angle)) < 3e-3);
                    assert_true(fabs(u[0] - (r[0] - i * 1.4 / per)) < 1e-12 && u[2] == r[2]);
                    int corner = triangle_mesh_corner(t->mesh, i * 4 / per, j * 4 / per);
                    if (4 % per == 0)
                        assert_true(fabs(r[0] - x[t->vertex_at[corner]]) < 1e-14);
                }
            for (int c = 0; c < s.nx * s.ny; c++) {
                stretching += s.stretching[c] * area;
                bending += s.bending[c] * area;
            }
            struct fold_energy e = d->op->energy(d, x, 0.5, NULL);
            assert_true(fabs(stretching / e.stretching - 1) < 1e-12 && fabs(bending / e.bending - 1) < 1e-12);

            settle(d, x);
            d->op->sample(d, x, 1, &s);
            for (int c = 0; c < s.nx * s.ny; c++) {
                assert_true(fabs(s.mean[c] - k / 2) < 3e-3 * fabs(k));
                assert_true(fabs(s.gauss[c]) < 1e-3 * k * k);
            }
            surface_free(&s);
            free(x);
            d->op->free(d);
            sheet_free(sheet);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_stays_flat),
        cmocka_unit_test(little_energy_comes_in),
        cmocka_unit_test(sample_is_the_surface),
    };
    return cmocka_run_group_tests_name("triangle: levels and samples", tests, NULL, NULL);
}
