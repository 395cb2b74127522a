/* SPDX-License-Identifier: GPL-3.0-or-later
 * The triangles' derivatives against differences on every kind of mesh, their
 * invariances, and the same bits from any number of threads. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "solver/memory.h"
#include "solver/triangle.h"
#include "solver/triangle_model.h"
#include "solver/vector.h"
#include "tests/solver/differences.h"
#include "tests/solver/scenes.h"

/* A sheet with every term in it: twist, springs, an uneven pattern. */
static struct sheet *full_sheet(int columns, int rows, enum diagonals diagonals)
{
    struct sheet *s = scene_sheet(columns, rows, checker);
    for (int i = 0; i < columns * rows; i++)
        s->twist[i] = 0.3 * scene_random();
    s->spring = 0.02;
    s->spring_edges = EDGE_LEFT | EDGE_TOP;
    s->mesh.diagonals = diagonals;
    return s;
}

/* A mesh of a caller's: that of a sheet with its vertices moved about. */
static struct triangle_mesh *uneven_mesh(const struct sheet *sheet)
{
    struct triangle_mesh *even = triangle_mesh_make(sheet, 1);
    for (int v = 0; v < even->nvertices; v++)
        for (int c = 0; c < 2; c++)
            even->rest[v][c] += 0.2 * scene_random();
    struct triangle_mesh *mesh = triangle_mesh_of_faces(even->nvertices, (const double(*)[2])even->rest, even->nfaces,
                                                        (const int(*)[3])even->face);
    memcpy(mesh->natural, even->natural, (size_t)mesh->nfaces * sizeof *mesh->natural);
    triangle_mesh_free(even);
    return mesh;
}

enum { KINDS = 4 };     /* the three diagonals, an uneven mesh */

static struct discretisation *make(int kind, int columns, int rows, int per_stitch, struct sheet **sheet)
{
    *sheet = full_sheet(columns, rows, kind < 3 ? (enum diagonals)kind : DIAGONALS_ALTERNATING);
    return kind < 3 ? triangle_make(*sheet, per_stitch, 1) : triangle_make_of_mesh(*sheet, uneven_mesh(*sheet), 1);
}

static void release(struct discretisation *d, struct sheet *sheet)
{
    d->op->free(d);
    sheet_free(sheet);
}

static void gradient_is_the_differences(void **unused)
{
    (void)unused;
    for (int k = 0; k < 5 * KINDS; k++) {
        struct sheet *sheet;
        struct discretisation *d = make(k % KINDS, 5, 3, 1 + k % 2, &sheet);
        double *x = scene_state(d, 0.25), error = difference_gradient_error(d, x);
        if (!(error < 1e-8))
            fail_msg("kind %d: relative error %.1e", k % KINDS, error);
        free(x);
        release(d, sheet);
    }
}

/* One stitch, one course, one wale: a grid may be a single cell wide. */
static void narrow_sheets_are_sheets(void **unused)
{
    (void)unused;
    const int size[][2] = {{1, 1}, {1, 7}, {40, 1}, {3, 100}};
    for (int k = 0; k < 3 * 4 * 2; k++) {
        struct sheet *sheet = full_sheet(size[k % 4][0], size[k % 4][1], (enum diagonals)(k / 8));
        struct discretisation *d = triangle_make(sheet, 1 + k / 4 % 2, 2), *fine = triangle_make(sheet, 3, 1);
        double *x = scene_state(d, 0.2), *y = MEMORY_ARRAY(double, fine->n);
        assert_true(difference_gradient_error(d, x) < 1e-8);
        assert_true(difference_hessian_error(d, x) < 1e-7);
        d->op->prolong(d, x, fine, y);
        assert_true(isfinite(fine->op->energy(fine, y, 1, NULL).total));
        free(x);
        free(y);
        fine->op->free(fine);
        release(d, sheet);
    }
}

static void hessian_is_the_differences(void **unused)
{
    (void)unused;
    for (int k = 0; k < 5 * KINDS; k++) {
        struct sheet *sheet;
        struct discretisation *d = make(k % KINDS, 5, 3, 1 + k % 2, &sheet);
        double *x = scene_state(d, 0.25), error = difference_hessian_error(d, x);
        if (!(error < 1e-7))
            fail_msg("kind %d: relative error %.1e", k % KINDS, error);
        free(x);
        release(d, sheet);
    }
}

/* T^T is the transpose of T, and T turns an increment into what keeps the frames along. */
static void cotangent_is_the_transpose(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < KINDS; kind++) {
        struct sheet *sheet;
        struct discretisation *d = make(kind, 5, 3, 2, &sheet);
        double *x = scene_state(d, 0.25), *z = scene_vector(d->n, 1), *g = scene_vector(d->n, 1);
        double *tz = MEMORY_ARRAY(double, d->n), *tg = MEMORY_ARRAY(double, d->n);
        d->op->tangent(d, x, z, tz);
        d->op->cotangent(d, x, g, tg);
        assert_true(fabs(vector_dot(d->n, g, tz) - vector_dot(d->n, tg, z)) < 1e-11);
        free(x);
        free(z);
        free(g);
        free(tz);
        free(tg);
        release(d, sheet);
    }
}

/* No negative eigenvalue, also far from a minimum, where the exact Hessian has many. */
static void semidefinite_is_semidefinite(void **unused)
{
    (void)unused;
    for (int k = 0; k < 3 * KINDS; k++) {
        struct sheet *sheet;
        struct discretisation *d = make(k % KINDS, 3, 2, 1 + k % 2, &sheet);
        double *x = scene_state(d, 0.25), *value = MEMORY_ARRAY(double, d->pattern.start[d->n]), largest = 0;
        d->op->hessian(d, x, 1, HESSIAN_SEMIDEFINITE, value);
        for (int i = 0; i < d->n; i++)
            largest = fmax(largest, value[d->pattern.start[i]]);
        assert_true(difference_cholesky(&d->pattern, value, 1e-11 * largest) > 0);
        d->op->hessian(d, x, 1, HESSIAN_EXACT, value);
        assert_true(difference_cholesky(&d->pattern, value, 1e-11 * largest) < 0);
        free(x);
        free(value);
        release(d, sheet);
    }
}

/* Near a state without stress the two Hessians are one. */
static void hessians_meet_at_rest(void **unused)
{
    (void)unused;
    struct sheet *sheet = scene_sheet(3, 2, NULL);
    struct discretisation *d = triangle_make(sheet, 2, 1);
    int entries = d->pattern.start[d->n];
    double *x = scene_state(d, 0), *a = MEMORY_ARRAY(double, entries), *b = MEMORY_ARRAY(double, entries);
    d->op->hessian(d, x, 0, HESSIAN_EXACT, a);
    d->op->hessian(d, x, 0, HESSIAN_SEMIDEFINITE, b);
    for (int k = 0; k < entries; k++)
        assert_true(fabs(a[k] - b[k]) < 1e-12);
    free(x);
    free(a);
    free(b);
    release(d, sheet);
}

static void nothing_at_rest(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < KINDS; kind++) {
        struct sheet *sheet;
        struct discretisation *d = make(kind, 5, 3, 2, &sheet);
        double *x = scene_state(d, 0), *g = MEMORY_ARRAY(double, d->n);
        struct fold_energy e = d->op->energy(d, x, 0, g);
        assert_true(e.total < 1e-28);
        assert_true(sqrt(vector_dot(d->n, g, g)) < 1e-13);
        free(x);
        free(g);
        release(d, sheet);
    }
}

/* Turns (by a unit quaternion) and moves positions; angles stay. */
static double *rigid(const struct discretisation *d, const double *x, double far)
{
    double a = 0.5, b = 0.1, c = -0.7, w = sqrt(1 - a * a - b * b - c * c);
    double R[3][3] = {{1 - 2 * (b * b + c * c), 2 * (a * b - c * w), 2 * (a * c + b * w)},
                      {2 * (a * b + c * w), 1 - 2 * (a * a + c * c), 2 * (b * c - a * w)},
                      {2 * (a * c - b * w), 2 * (b * c + a * w), 1 - 2 * (a * a + b * b)}};
    double *y = MEMORY_ARRAY(double, d->n);
    memcpy(y, x, (size_t)d->n * sizeof *y);
    for (int k = 0; k < d->nnodes; k++)
        for (int i = 0; i < 3; i++) {
            const double *r = x + d->node[k];
            y[d->node[k] + i] = R[i][0] * r[0] + R[i][1] * r[1] + R[i][2] * r[2] + far * (i - 1);
        }
    return y;
}

static void rigid_motions_change_nothing(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < KINDS; kind++) {
        struct sheet *sheet;
        struct discretisation *d = make(kind, 5, 3, 2, &sheet);
        double *x = scene_state(d, 0.25), *near = rigid(d, x, 7), *far = rigid(d, x, 1e6);
        struct fold_energy e = d->op->energy(d, x, 1, NULL), n = d->op->energy(d, near, 1, NULL);
        struct fold_energy f = d->op->energy(d, far, 1, NULL);
        assert_true(fabs(n.stretching / e.stretching - 1) < 1e-12);
        assert_true(fabs(n.bending / e.bending - 1) < 1e-12);
        assert_true(fabs(f.bending / e.bending - 1) < 1e-8);   /* the positions themselves lose ten digits */
        free(x);
        free(near);
        free(far);
        release(d, sheet);
    }
}

/* The state turned over left to right on the mesh turned over: criss-cross is its own mirror image. */
static void mirror_image_has_the_same_energy(void **unused)
{
    (void)unused;
    struct sheet *sheet = scene_sheet(4, 3, seed), *mirrored = scene_sheet(4, 3, seed);
    for (int k = 0; k < 12; k++) {
        sheet->twist[k] = 0.3 * scene_random();
        mirrored->kx[k / 4 * 4 + 3 - k % 4] = sheet->kx[k];
        mirrored->ky[k / 4 * 4 + 3 - k % 4] = sheet->ky[k];
        mirrored->twist[k / 4 * 4 + 3 - k % 4] = -sheet->twist[k];
    }
    sheet->mesh.diagonals = mirrored->mesh.diagonals = DIAGONALS_CRISSCROSS;
    struct discretisation *d = triangle_make(sheet, 2, 1), *m = triangle_make(mirrored, 2, 1);
    const struct triangle *t = (const struct triangle *)d, *u = (const struct triangle *)m;
    double *x = scene_state(d, 0.25), *y = MEMORY_ARRAY(double, d->n);
    int nx = t->mesh->nx, ny = t->mesh->ny;

    /* Vertices go over by their place; edge angles by their ends, as the mirror turns the order of faces about. */
    int *image = MEMORY_ARRAY(int, t->mesh->nvertices);
    for (int j = 0; j <= ny; j++)
        for (int i = 0; i <= nx; i++) {
            image[triangle_mesh_corner(t->mesh, i, j)] = triangle_mesh_corner(t->mesh, nx - i, j);
            if (i < nx && j < ny)
                image[triangle_mesh_centre(t->mesh, i, j)] = triangle_mesh_centre(t->mesh, nx - 1 - i, j);
        }
    for (int v = 0; v < t->mesh->nvertices; v++)
        for (int c = 0; c < 3; c++)
            y[u->vertex_at[image[v]] + c] = c ? x[t->vertex_at[v] + c] : -x[t->vertex_at[v]];
    for (int e = 0; e < t->mesh->nedges; e++) {
        int a = image[t->mesh->edge[e][0]], b = image[t->mesh->edge[e][1]], f = 0;
        while (!(u->mesh->edge[f][0] == a && u->mesh->edge[f][1] == b) &&
               !(u->mesh->edge[f][0] == b && u->mesh->edge[f][1] == a))
            f++;
        /* The image of the first face runs along the image edge backwards. */
        y[u->edge_at[f]] = (u->mesh->edge[f][0] == b ? 1 : -1) * x[t->edge_at[e]];
    }
    struct fold_energy one = d->op->energy(d, x, 1, NULL), other = m->op->energy(m, y, 1, NULL);
    assert_true(fabs(one.stretching / other.stretching - 1) < 1e-13);
    assert_true(fabs(one.bending / other.bending - 1) < 1e-13);
    free(image);
    free(x);
    free(y);
    release(d, sheet);
    release(m, mirrored);
}

static void any_number_of_threads_gives_the_same_bits(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < 3; kind++) {
        struct sheet *sheet = full_sheet(30, 26, (enum diagonals)kind);
        struct discretisation *d = triangle_make(sheet, 2, 1);
        assert_int_equal(((const struct triangle *)d)->ncolours, 2);
        size_t n = (size_t)d->n, entries = (size_t)d->pattern.start[d->n];
        double *x = scene_state(d, 0.1), *g[2], *z[2], *value[2];
        struct fold_energy e[2];
        for (int k = 0; k < 2; k++) {
            d->threads = k ? 3 : 1;
            g[k] = MEMORY_ARRAY(double, n);
            z[k] = MEMORY_ARRAY(double, n);
            value[k] = MEMORY_ARRAY(double, entries);
            e[k] = d->op->energy(d, x, 1, g[k]);
            d->op->cotangent(d, x, g[k], z[k]);
            d->op->hessian(d, x, 1, HESSIAN_EXACT, value[k]);
        }
        assert_memory_equal(&e[0], &e[1], sizeof e[0]);
        assert_memory_equal(g[0], g[1], n * sizeof *g[0]);
        assert_memory_equal(z[0], z[1], n * sizeof *z[0]);
        assert_memory_equal(value[0], value[1], entries * sizeof *value[0]);
        for (int k = 0; k < 2; k++) {
            free(g[k]);
            free(z[k]);
            free(value[k]);
        }
        free(x);
        release(d, sheet);
    }
}

/* Two triangles, the second corner swung about their diagonal by theta. */
static void swing(const struct discretisation *d, double *x, double theta)
{
    const struct triangle *t = (const struct triangle *)d;
    d->op->flat(d, x);
    double *a = x + t->vertex_at[triangle_mesh_corner(t->mesh, 1, 0)], diagonal[2] = {1.4, 1.2};
    double along = a[0] * diagonal[0] / (1.4 * 1.4 + 1.2 * 1.2), foot[2] = {along * 1.4, along * 1.2};
    double u[2] = {a[0] - foot[0], a[1] - foot[1]};
    a[0] = foot[0] + cos(theta) * u[0];
    a[1] = foot[1] + cos(theta) * u[1];
    a[2] = sin(theta) * hypot(u[0], u[1]);
}

static void largest_angle_is_found(void **unused)
{
    (void)unused;
    struct sheet *sheet = scene_sheet(1, 1, NULL);
    struct discretisation *d = triangle_make(sheet, 1, 1);
    const struct triangle *t = (const struct triangle *)d;
    double *x = MEMORY_ARRAY(double, d->n), degree = M_PI / 180;
    swing(d, x, 170 * degree);
    assert_true(fabs(triangle_max_angle(d, x) - 85 * degree) < 1e-12);
    x[t->edge_at[triangle_mesh_inner(t->mesh, 0, 0)]] = 7 * degree;
    assert_true(fabs(triangle_max_angle(d, x) - 92 * degree) < 1e-12);
    x[t->edge_at[triangle_mesh_edge_x(t->mesh, 0, 0)]] = -100 * degree;
    assert_true(fabs(triangle_max_angle(d, x) - 100 * degree) < 1e-12);
    free(x);
    release(d, sheet);
}

/* A triangle folded onto its neighbour, one without area, numbers that are none: an answer or nan, never a trap. */
static void degenerate_states_return(void **unused)
{
    (void)unused;
    struct sheet *sheet = scene_sheet(1, 1, NULL);
    struct discretisation *d = triangle_make(sheet, 1, 1);
    double *x = MEMORY_ARRAY(double, d->n), *g = MEMORY_ARRAY(double, d->n);
    swing(d, x, M_PI);
    assert_true(isfinite(d->op->energy(d, x, 1, g).total));
    assert_true(isfinite(vector_dot(d->n, g, g)));
    for (int k = 0; k < d->nnodes; k++)
        x[d->node[k]] = x[d->node[k] + 1] = 0;
    d->op->energy(d, x, 1, g);
    for (int i = 0; i < d->n; i++)
        x[i] = NAN;
    assert_true(isnan(d->op->energy(d, x, 1, g).total));
    assert_true(isnan(triangle_max_angle(d, x)));
    free(x);
    free(g);
    release(d, sheet);
}

static void meshes_that_are_none_are_refused(void **unused)
{
    (void)unused;
    const double rest[5][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {-1, 0}};
    const int good[2][3] = {{0, 1, 2}, {2, 1, 3}}, turned[2][3] = {{0, 1, 2}, {1, 2, 3}};
    const int three[3][3] = {{0, 1, 2}, {2, 1, 3}, {1, 2, 4}};
    struct triangle_mesh *mesh = triangle_mesh_of_faces(4, rest, 2, good);
    assert_non_null(mesh);
    assert_int_equal(mesh->nedges, 5);
    triangle_mesh_free(mesh);
    assert_null(triangle_mesh_of_faces(4, rest, 2, turned));
    assert_null(triangle_mesh_of_faces(5, rest, 3, three));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gradient_is_the_differences),
        cmocka_unit_test(hessian_is_the_differences),
        cmocka_unit_test(narrow_sheets_are_sheets),
        cmocka_unit_test(cotangent_is_the_transpose),
        cmocka_unit_test(semidefinite_is_semidefinite),
        cmocka_unit_test(hessians_meet_at_rest),
        cmocka_unit_test(nothing_at_rest),
        cmocka_unit_test(rigid_motions_change_nothing),
        cmocka_unit_test(mirror_image_has_the_same_energy),
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(largest_angle_is_found),
        cmocka_unit_test(degenerate_states_return),
        cmocka_unit_test(meshes_that_are_none_are_refused),
    };
    return cmocka_run_group_tests_name("triangle: derivatives and invariances", tests, NULL, NULL);
}
