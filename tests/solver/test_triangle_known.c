/* SPDX-License-Identifier: GPL-3.0-or-later
 * Triangles against closed forms: flat sheets, rolls along the mesh and across
 * it, which way a knit sheet curls, springs; and energies of minimised sheets. */
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
#include "solver/vector.h"
#include "tests/solver/differences.h"
#include "tests/solver/scenes.h"

static const char *const diagonals[] = {"uniform", "alternating", "criss-cross"};

/* A sheet with one natural curvature everywhere. */
static struct sheet *even_sheet(int columns, int rows, double kx, double ky, double twist, int kind)
{
    struct sheet *s = scene_sheet(columns, rows, NULL);
    for (int i = 0; i < columns * rows; i++) {
        s->kx[i] = kx;
        s->ky[i] = ky;
        s->twist[i] = twist;
    }
    s->mesh.diagonals = (enum diagonals)kind;
    return s;
}

static void release(struct discretisation *d, struct sheet *sheet, double *x)
{
    free(x);
    d->op->free(d);
    sheet_free(sheet);
}

/* U/A = D/2 (kx^2 + ky^2 + 2 nu kx ky + 2 (1 - nu) twist^2), D = h^3/12(1 - nu^2). */
static void flat_sheet(void **unused)
{
    (void)unused;
    double kx = -0.7, ky = 0.4, twist = 0.2, nu = 0.4, D = 0.125 / (12 * (1 - nu * nu));
    double expected = D / 2 * (kx * kx + ky * ky + 2 * nu * kx * ky + 2 * (1 - nu) * twist * twist) * 3 * 1.4 * 2 * 1.2;
    for (int kind = 0; kind < 3; kind++)
        for (int per = 1; per < 4; per++) {
            struct sheet *sheet = even_sheet(3, 2, kx, ky, twist, kind);
            struct discretisation *d = triangle_make(sheet, per, 1);
            double *x = scene_state(d, 0);
            struct fold_energy e = d->op->energy(d, x, 1, NULL);
            assert_true(fabs(e.bending / expected - 1) < 1e-14);
            assert_true(e.stretching < 1e-28);
            assert_true(fabs(d->op->energy(d, x, 0.5, NULL).bending / expected - 0.25) < 1e-14);
            release(d, sheet, x);
        }
}

/* b0 = diag(k, 0) or diag(0, k): facets of side d that turn by 2 asin(k d/2), and no energy at all.  Angles are
 * zero, but on the two edges where the roll ends: half a turn there. */
static void aligned_roll_is_exact(void **unused)
{
    (void)unused;
    for (int test = 0; test < 8; test++) {
        bool across = test & 1, alternating = test & 2;
        double k = test & 4 ? 0.9 : -0.6;
        struct sheet *sheet = even_sheet(4, 3, across ? 0 : k, across ? k : 0, 0, alternating);
        struct discretisation *d = triangle_make(sheet, 2, 1);
        const struct triangle *t = (const struct triangle *)d;
        const struct triangle_mesh *m = t->mesh;
        int n = across ? m->ny : m->nx, other = across ? m->nx : m->ny;
        double side = across ? m->dy : m->dx, half = asin(k * side / 2), u = 0, z = 0;
        double *x = scene_state(d, 0), *g = MEMORY_ARRAY(double, d->n);
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= other; j++) {
                double *r = x + t->vertex_at[across ? triangle_mesh_corner(m, j, i) : triangle_mesh_corner(m, i, j)];
                r[across] = u;
                r[2] = z;
            }
            u += side * cos(2 * i * half);
            z += side * sin(2 * i * half);
        }
        for (int j = 0; j < other; j++)
            for (int end = 0; end < 2; end++)
                x[t->edge_at[across ? triangle_mesh_edge_x(m, j, end * n) : triangle_mesh_edge_y(m, end * n, j)]] =
                    -half;
        struct fold_energy e = d->op->energy(d, x, 1, g);
        assert_true(e.total < 1e-28);
        assert_true(sqrt(vector_dot(d->n, g, g)) < 1e-13);
        free(g);
        release(d, sheet, x);
    }
}

/* Minimises from x; returns the energy. */
static double minimise(const struct discretisation *d, double *x)
{
    struct effort effort = {0};
    struct problem problem;
    problem_open(&problem, d, &effort);
    problem.growth = 1;
    problem.limit = 2000;
    problem.tolerance = 1e-10;
    enum outcome outcome = newton_minimise(&problem, x);
    double energy = problem.energy.total;
    problem_close(&problem);
    assert_true(outcome == OUTCOME_CONVERGED || outcome == OUTCOME_PRECISION);
    assert_true(triangle_max_angle(d, x) < M_PI / 2);
    return energy;
}

/* The sheet rolled about an axis at right angles to (1, 1), with curvature k. */
static void roll_obliquely(const struct discretisation *d, double k, double *x)
{
    for (int i = 0; i < d->nnodes; i++) {
        double *r = x + d->node[i], s = (r[0] + r[1]) / sqrt(2), t = (r[1] - r[0]) / sqrt(2);
        r[2] = (1 - cos(k * s)) / k;
        s = sin(k * s) / k;
        r[0] = (s - t) / sqrt(2);
        r[1] = (s + t) / sqrt(2);
    }
}

/* The same roll at 45 degrees to the mesh: what energy is left falls with at least the third power of the cells. */
static void oblique_roll_converges(void **unused)
{
    (void)unused;
    const double k = 0.5, most[] = {1e-5, 1e-3, 1e-5};
    for (int kind = 0; kind < 3; kind++) {
        double before = 0;
        for (int per = 1; per <= 4; per *= 2) {
            struct sheet *sheet = even_sheet(4, 4, k / 2, k / 2, k / 2, kind);
            struct discretisation *d = triangle_make(sheet, per, 1);
            double *x = scene_state(d, 0), flat = d->op->energy(d, x, 1, NULL).total;
            roll_obliquely(d, k, x);
            double left = minimise(d, x) / flat;
            print_message("# oblique roll, %s, %d cells a stitch: %.1e of the flat sheet's energy\n", diagonals[kind],
                          per, left);
            if (per > 1 && !(left < before / 8))
                fail_msg("%s: %.1e after %.1e", diagonals[kind], left, before);
            before = left;
            release(d, sheet, x);
        }
        assert_true(before < most[kind]);
    }
}

/* A knit sheet from the right side: kx < 0 takes the left and right edges back, ky > 0 the top and bottom forward. */
static void knit_sheet_curls_as_knitters_know(void **unused)
{
    (void)unused;
    for (int across = 0; across < 2; across++) {
        struct sheet *sheet = even_sheet(4, 3, across ? 0 : -0.3, across ? 0.3 : 0, 0, 0);
        struct discretisation *d = triangle_make(sheet, 2, 1);
        const struct triangle *t = (const struct triangle *)d;
        double *x = scene_state(d, 1e-3);
        minimise(d, x);
        int nx = t->mesh->nx, ny = t->mesh->ny;
        const double *a = x + t->vertex_at[triangle_mesh_corner(t->mesh, 0, 0)];
        const double *b = x + t->vertex_at[triangle_mesh_corner(t->mesh, across ? nx : 0, across ? 0 : ny)];
        const double *c = x + t->vertex_at[triangle_mesh_corner(t->mesh, across ? 0 : nx, across ? ny : 0)];
        const double *middle = x + t->vertex_at[triangle_mesh_corner(t->mesh, nx / 2, ny / 2)];
        /* Height of the middle over the plane of an edge's ends and the opposite corner, along the normal to the RS. */
        double u[3], v[3], w[3], height = 0;
        for (int i = 0; i < 3; i++) {
            u[i] = b[i] - a[i];
            v[i] = c[i] - a[i];
            w[i] = middle[i] - a[i];
        }
        for (int i = 0; i < 3; i++)
            height += (u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]) * w[i];
        height *= across ? 1 : -1;
        assert_true(across ? height < -1e-2 : height > 1e-2);
        release(d, sheet, x);
    }
}

/* 1/2 k Int |r - r_flat|^2 ds on the edges chosen: for a shift the length counts, for a stretch its third moment. */
static void springs_are_the_integral(void **unused)
{
    (void)unused;
    const double k = 0.3, length[] = {3 * 1.2, 3 * 1.2, 4 * 1.4, 4 * 1.4}, shift[3] = {0.3, -0.2, 0.5}, stretch = 0.1;
    for (int edge = 0; edge < 4; edge++) {
        struct sheet *sheet = even_sheet(4, 3, 0, 0, 0, DIAGONALS_CRISSCROSS);
        sheet->spring = k;
        sheet->spring_edges = 1u << edge;       /* left, right, top, bottom */
        struct discretisation *d = triangle_make(sheet, 2, 1);
        double *x = scene_state(d, 0), *g = MEMORY_ARRAY(double, d->n), force[3] = {0};
        for (int i = 0; i < d->nnodes; i++)
            for (int c = 0; c < 3; c++)
                x[d->node[i] + c] += shift[c];
        struct fold_energy e = d->op->energy(d, x, 1, g);
        double squared = shift[0] * shift[0] + shift[1] * shift[1] + shift[2] * shift[2];
        assert_true(fabs(e.springs - k * length[edge] * squared / 2) < 1e-14);
        assert_true(fabs(e.total - e.springs) < 1e-25);
        for (int i = 0; i < d->nnodes; i++)
            for (int c = 0; c < 3; c++)
                force[c] += g[d->node[i] + c];
        for (int c = 0; c < 3; c++)
            assert_true(fabs(force[c] - k * length[edge] * shift[c]) < 1e-13);

        d->op->flat(d, x);
        for (int i = 0; i < d->nnodes; i++)
            x[d->node[i] + (edge < 2)] *= 1 + stretch;
        e = d->op->energy(d, x, 1, NULL);
        assert_true(fabs(e.springs - k * stretch * stretch * pow(length[edge], 3) / 6) < 1e-13);
        free(g);
        release(d, sheet, x);
    }
}

/* The 2x2 rib of 8 x 8 stitches with uniform diagonals: energies of an independent program on the same mesh. */
static void rib_has_the_known_energies(void **unused)
{
    (void)unused;
    const double known[] = {0.48633, 0.49062};
    for (int level = 0; level < 2; level++) {
        struct sheet *sheet = scene_sheet(8, 8, rib);
        struct discretisation *d = triangle_make(sheet, 2 << level, 1);
        double *x = scene_state(d, 0.005), energy = minimise(d, x);
        if (!(fabs(energy - known[level]) < 1e-5))
            fail_msg("%.7f is not %.5f", energy, known[level]);
        release(d, sheet, x);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_sheet),
        cmocka_unit_test(aligned_roll_is_exact),
        cmocka_unit_test(oblique_roll_converges),
        cmocka_unit_test(knit_sheet_curls_as_knitters_know),
        cmocka_unit_test(springs_are_the_integral),
        cmocka_unit_test(rib_has_the_known_energies),
    };
    return cmocka_run_group_tests_name("triangle: closed forms", tests, NULL, NULL);
}
