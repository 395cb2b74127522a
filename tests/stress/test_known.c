/* SPDX-License-Identifier: GPL-3.0-or-later
 * Closed forms beyond those of the solver's own tests: oblique rolls, narrow
 * twisted strips, a prescribed bump, cantilevers bent by their own curvature. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "solver/memory.h"
#include "solver/patch.h"
#include "tests/solver/scenes.h"
#include "tests/stress/trial.h"

static void set_curvature(struct sheet *s, double kx, double ky, double twist)
{
    for (int i = 0; i < s->columns * s->rows; i++)
        s->kx[i] = kx, s->ky[i] = ky, s->twist[i] = twist;
}

/* The folded sheet, sampled at the corners of its stitches; it must be a minimum. */
static struct surface folded(const struct sheet *s)
{
    struct fold_options options = {.threads = 1};
    struct fold_record r;
    struct fold_state *state = fold_run(s, &options, NULL, &r);
    if (r.status != FOLD_CONVERGED && r.status != FOLD_PRECISION)
        print_message("%s, gradient %g\n", fold_status_name(r.status), r.gradient_max);
    assert_true(r.positive_definite && (r.status == FOLD_CONVERGED || r.status == FOLD_PRECISION));
    struct surface at = surface_make(s->columns, s->rows, 1);
    fold_sample(state, &at);
    fold_free(state);
    fold_record_free(&r);
    return at;
}

/* A3: a roll at 30 degrees to the mesh, b0 = k n n^T: no energy in the limit;
 * what is left falls with the fourth power of the cells, U being of order
 * (error of the second derivatives, h^2) squared. */
static void oblique_roll(void **state)
{
    (void)state;
    double share[3], c = cos(0.5235987755982988), d = sin(0.5235987755982988);
    for (int level = 0; level < 3; level++) {
        struct sheet *s = scene_sheet(8, 5, NULL);
        set_curvature(s, 0.3 * c * c, 0.3 * d * d, 0.3 * c * d);
        s->mesh.per_stitch = 1 << level;
        struct fold_options options = {.threads = 1};
        struct fold_record r;
        fold_free(fold_run(s, &options, NULL, &r));
        assert_true(r.positive_definite && r.status == FOLD_CONVERGED);
        share[level] = r.energy.total / r.energy_flat;
        fold_record_free(&r);
        sheet_free(s);
    }
    print_message("U/U_flat %.3g %.3g %.3g: orders %.2f %.2f\n", share[0], share[1], share[2],
                  log2(share[0] / share[1]), log2(share[1] / share[2]));
    assert_true(share[2] < 1e-6);
    assert_true(log2(share[0] / share[1]) > 3.5 && log2(share[1] / share[2]) > 3.5);
}

/* How fast a strip's cross line turns about its axis, over its middle third. */
static double twist_of(const struct sheet *s, const struct surface *at)
{
    int x[2] = {s->columns / 3, s->columns - s->columns / 3};
    double across[2][3], dot = 0, length[2] = {0};
    for (int e = 0; e < 2; e++)
        for (int c = 0; c < 3; c++) {
            across[e][c] = at->position[3 * (s->rows * (at->nx + 1) + x[e]) + c] - at->position[3 * x[e] + c];
            length[e] += across[e][c] * across[e][c];
        }
    for (int c = 0; c < 3; c++)
        dot += across[0][c] * across[1][c];
    return acos(dot / sqrt(length[0] * length[1])) / ((x[1] - x[0]) * s->dx);
}

/* A8: a narrow strip with b0 = [[0, K], [K, 0]] twists by m = x K, where
 * x^3 (1 + nu) c/60 = 1 - x, c = (K W^2/h)^2. */
static void narrow_strip_twists(void **state)
{
    (void)state;
    for (double c = 1; c < 200; c *= 10) {
        double K = 0.02, W = 1, h = K * W * W / sqrt(c), x = 1;
        struct sheet *s = scene_sheet(24, 4, NULL);
        s->thickness = h;
        s->dx = 0.75, s->dy = W / 4;
        s->solve.tolerance = 1e-10;
        set_curvature(s, 0, 0, K);
        for (int i = 0; i < 50; i++)
            x -= (x * x * x * 1.4 * c / 60 + x - 1) / (3 * x * x * 1.4 * c / 60 + 1);
        struct surface at = folded(s);
        double m = twist_of(s, &at) / K;
        print_message("c = %g: m/K = %.5f, in theory %.5f\n", c, m, x);
        assert_true(fabs(m - x) < 0.01);
        surface_free(&at);
        sheet_free(s);
    }
}

/* A9: bending energy of w = w0 (1 - r^2/a^2)^2 inside r < a, 0 outside, is
 * 32 pi/3 D w0^2/a^2; nodes take the function's values, slopes and twists.
 * The second derivatives jump at r = a: first order in the cells. */
static double bump_error(int columns)
{
    const double a = 1, w0 = 1e-5;
    struct sheet *s = scene_sheet(columns, columns, NULL);
    s->dx = s->dy = 2.2 * a / columns;
    s->thickness = 0.1;
    set_curvature(s, 0, 0, 0);
    struct discretisation *d = patch_make(s, &basis_hermite, 1, 4, 1);
    double *r = MEMORY_ARRAY(double, d->n), D = 1e-3 / (12 * (1 - 0.16));
    d->op->flat(d, r);
    for (int i = 0; i < d->nnodes; i++) {
        double *at = r + d->node[i], x = at[0] - 1.1 * a, y = at[1] - 1.1 * a, q = 1 - (x * x + y * y) / (a * a);
        if (q <= 0)
            continue;
        at[2] = w0 * q * q;
        at[5] = -4 * w0 * q * x / (a * a) * s->dx;
        at[8] = -4 * w0 * q * y / (a * a) * s->dy;
        at[11] = 8 * w0 * x * y / (a * a * a * a) * s->dx * s->dy;
    }
    double exact = 32 * 3.141592653589793 / 3 * D * w0 * w0 / (a * a);
    double error = d->op->energy(d, r, 1, NULL).bending / exact - 1;
    free(r);
    d->op->free(d);
    sheet_free(s);
    return error;
}

static void prescribed_bump(void **state)
{
    (void)state;
    double coarse = bump_error(16), fine = bump_error(64);
    print_message("errors %.3g, %.3g: order %.2f\n", coarse, fine, log2(fabs(coarse / fine)) / 2);
    assert_true(fabs(fine) < 0.02);
    assert_true(fabs(fine) < fabs(coarse) / 3);
}

/* A10: a strip with b0 = diag(p/L, 0) is an arc of angle p: its chord is
 * sin(p/2)/(p/2) L; seen from one end, held flat, the tip is at
 * x/L = sin p/p and z/L = (1 - cos p)/p. */
static void cantilever_with_end_moment(void **state)
{
    (void)state;
    for (double p = 0.5; p < 6.3; p *= 2) {
        struct sheet *s = scene_sheet(40, 1, NULL);
        double L = 40 * s->dx, tip[2] = {0};
        s->mesh.per_stitch = 2;
        set_curvature(s, p / L, 0, 0);
        struct surface at = folded(s);
        const double *n = at.normal, *first = at.position, *last = at.position + 3 * 40, *side = first + 3 * 41;
        double y[3], x[3], norm = 0;
        for (int c = 0; c < 3; c++)
            y[c] = side[c] - first[c], norm += y[c] * y[c];
        for (int c = 0; c < 3; c++)     /* along the strip where it begins: y x n */
            x[c] = (y[(c + 1) % 3] * n[(c + 2) % 3] - y[(c + 2) % 3] * n[(c + 1) % 3]) / sqrt(norm);
        for (int c = 0; c < 3; c++)
            tip[0] += (last[c] - first[c]) * x[c] / L, tip[1] += (last[c] - first[c]) * n[c] / L;
        print_message("p = %g: U/L %.6f (%.6f), W/L %.6f (%.6f)\n", p, 1 - tip[0], 1 - sin(p) / p, fabs(tip[1]), (1 - cos(p)) / p);
        assert_true(fabs(tip[0] - sin(p) / p) < 1e-4);
        assert_true(fabs(fabs(tip[1]) - (1 - cos(p)) / p) < 1e-4);
        surface_free(&at);
        sheet_free(s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oblique_roll),
        cmocka_unit_test(narrow_strip_twists),
        cmocka_unit_test(prescribed_bump),
        cmocka_unit_test(cantilever_with_end_moment),
    };
    return cmocka_run_group_tests_name("closed forms", tests, NULL, NULL);
}
