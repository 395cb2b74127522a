/* SPDX-License-Identifier: GPL-3.0-or-later
 * The stability scenes, each with its outcome; docs/stability.md has the table
 * of them and of those that are tested elsewhere. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "solver/descent.h"
#include "solver/memory.h"
#include "solver/noise.h"
#include "solver/patch.h"
#include "tests/solver/scenes.h"
#include "tests/stress/trial.h"

/* Folds, judges and frees the sheet; a minimum is wanted. */
static struct trial good(struct sheet *s)
{
    struct trial t = trial_fold(s);
    if (!trial_good(&t))
        print_message("%s, wrong %u, gradient %g, %s\n", fold_status_name(t.status), t.wrong, t.gradient, t.remark);
    assert_true(trial_good(&t));
    sheet_free(s);
    return t;
}

static bool same(double a, double b, double relative)
{
    if (fabs(a - b) <= relative * fabs(b))
        return true;
    print_message("%.15g instead of %.15g\n", a, b);
    return false;
}

/* A square of plain knitting, side 4, curvature +-1. */
static struct sheet *square(double thickness, double noise)
{
    struct sheet *s = scene_sheet(4, 4, NULL);
    s->dx = s->dy = 1;
    s->thickness = thickness;
    s->solve.noise = noise;
    return s;
}

/* ---- levels and states by hand ---- */

struct level {
    struct effort          effort;
    struct discretisation *d;
    struct problem         p;
    double                *x;       /* (n) */
};

static struct level *level_open(const struct sheet *sheet, double growth)
{
    struct level *level = MEMORY_ARRAY(struct level, 1);
    level->d = patch_make(sheet, &basis_hermite, 1, 4, 1);
    level->x = MEMORY_ARRAY(double, level->d->n);
    level->d->op->flat(level->d, level->x);
    problem_open(&level->p, level->d, &level->effort);
    level->p.growth = growth;
    level->p.limit = 10000;
    level->p.tolerance = 1e-8 * sheet->thickness * sheet->thickness;
    return level;
}

static void level_close(struct level *level)
{
    problem_close(&level->p);
    level->d->op->free(level->d);
    free(level->x), free(level);
}

/* ---- S2 to S7 ---- */

/* S2: flat sheets far away and turned have the energy of rest, by rounding of
 * coordinates of that size: strains of 1e-10, energies of their square. */
static void flat_far_away(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(6, 4, checker);
    struct level *level = level_open(s, 0);
    const double R[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
    for (int i = 0; i < level->d->n; i += 3) {
        double r[3] = {level->x[i], level->x[i + 1], level->x[i + 2]};
        for (int c = 0; c < 3; c++)
            level->x[i + c] = R[c][0] * r[0] + R[c][1] * r[1] + R[c][2] * r[2] + (i % 12 == 0 ? 1e6 : 0);
    }
    assert_true(level->d->op->energy(level->d, level->x, 0, NULL).total < 1e-18);
    level_close(level);
    sheet_free(s);
}

/* S3: a crumpled sheet at rest flattens out. */
static void noise_flattens_out(void **state)
{
    (void)state;
    for (double noise = 0.01; noise < 2; noise *= 10) {
        struct sheet *s = scene_sheet(6, 4, checker);
        struct level *level = level_open(s, 0);
        uint64_t seed = 1;
        for (int i = 0; i < level->d->nnodes; i++)
            level->x[level->d->node[i] + 2] += noise * s->thickness * noise_next(&seed);
        struct descent end = descent_to_minimum(&level->p, METHOD_AUTO, level->x);
        assert_true(end.minimum && (end.outcome == OUTCOME_CONVERGED || end.outcome == OUTCOME_PRECISION));
        assert_true(level->p.energy.total < 1e-14);
        level_close(level);
        sheet_free(s);
    }
}

/* S5: a start next to the saddle ends in the minimum beside it. */
static void near_a_saddle(void **state)
{
    (void)state;
    struct trial far = good(square(0.25, 0.01));
    for (double noise = 1e-4; noise > 1e-13; noise /= 1000) {
        struct trial near = good(square(0.25, noise));
        assert_true(near.minimum && same(near.energy, far.energy, 1e-8));
        assert_true(fabs(near.extent_x - near.extent_y) > 0.1);
    }
}

/* How much longer than wide, of the state as it is. */
static double lopsided(const struct level *level, const struct sheet *s)
{
    struct surface at = surface_make(s->columns, s->rows, 1);
    level->d->op->sample(level->d, level->x, 1, &at);
    double *a = at.position, *b = a + 3 * s->columns, *c = a + 3 * (size_t)s->rows * (size_t)(s->columns + 1), *d = c + 3 * s->columns;
    double side[4] = {0}, diagonal[2] = {0};
    for (int i = 0; i < 3; i++) {
        side[0] += (a[i] - b[i]) * (a[i] - b[i]), side[1] += (a[i] - c[i]) * (a[i] - c[i]);
        side[2] += (c[i] - d[i]) * (c[i] - d[i]), side[3] += (b[i] - d[i]) * (b[i] - d[i]);
        diagonal[0] += (a[i] - d[i]) * (a[i] - d[i]), diagonal[1] += (b[i] - c[i]) * (b[i] - c[i]);
    }
    surface_free(&at);
    double sides = fabs(sqrt(side[0]) + sqrt(side[2]) - sqrt(side[1]) - sqrt(side[3])) / (s->columns * s->dx);
    return fmax(sides, fabs(sqrt(diagonal[0]) - sqrt(diagonal[1])) / (s->columns * s->dx));
}

/* Follows the state of a square dome, kx = ky = K, from one thickness to
 * another in equal factors; returns K L^2/h where it is first (thinner) or
 * last (thicker) lopsided. */
static double follow(double from, double to, int steps)
{
    double *x = NULL, critical = 0;
    for (int i = 0; i <= steps; i++) {
        double h = from * pow(to / from, (double)i / steps);
        struct sheet *s = square(h, 0.01);
        for (int k = 0; k < 16; k++)
            s->kx[k] = s->ky[k] = 0.2;
        struct level *level = level_open(s, 1);
        level->p.tolerance = 1e-12 * h * h;
        uint64_t seed = 1;
        for (int k = 0; k < level->d->n; k++)
            level->x[k] = (x ? x[k] : level->x[k]) + 1e-6 * h * noise_next(&seed);
        struct descent end = descent_to_minimum(&level->p, METHOD_AUTO, level->x);
        assert_true(end.minimum && (end.outcome == OUTCOME_CONVERGED || end.outcome == OUTCOME_PRECISION));
        bool bent = lopsided(level, s) > 1e-3;
        if (bent && (critical == 0 || from < to))
            critical = 0.2 * 16 / h;
        x = x ? x : MEMORY_ARRAY(double, level->d->n);
        memcpy(x, level->x, sizeof *x * (size_t)level->d->n);
        level_close(level);
        sheet_free(s);
    }
    free(x);
    return critical;
}

/* S6: a dome becomes a roll at one thickness, whichever side it is met from.
 * (A7 has the value for a disc, and there are no discs: K R^2/h = 5.08 at
 * nu = 0.4; a square's must lie between those of the discs inside and around.) */
static void critical_point_from_both_sides(void **state)
{
    (void)state;
    double thin = follow(0.3, 0.08, 120), thick = follow(0.08, 0.3, 120);
    print_message("critical K L^2/h: %.4f, %.4f\n", thin, thick);
    assert_true(same(thin, thick, 0.012));
    assert_true(thin / 4 < 5.07719 * 1.01 && thin / 2 > 5.07719);
}

/* S7: a state of perfect symmetry is seen to be a saddle, with a direction along which the energy falls. */
static void symmetric_state_is_a_saddle(void **state)
{
    (void)state;
    struct sheet *s = square(0.25, 0);
    struct level *level = level_open(s, 1);
    struct problem *p = &level->p;
    int n = level->d->n;
    double *v = MEMORY_ARRAY(double, n), *y = MEMORY_ARRAY(double, n), furthest = 0;
    p->tolerance = 1e-3 * s->thickness * s->thickness;      /* rounding has not yet broken the symmetry */
    assert_int_equal(newton_minimise(p, level->x), OUTCOME_CONVERGED);
    double energy = p->energy.total;
    assert_false(newton_is_minimum(p, level->x, v));
    for (int i = 0; i < n; i++)
        furthest = fmax(furthest, fabs(v[i]));
    double rise = -2 * energy;      /* the second difference: what is left of the gradient cancels */
    for (double sign = -1; sign <= 1; sign += 2) {
        for (int i = 0; i < n; i++)
            y[i] = level->x[i] + sign * 0.1 * s->thickness / furthest * v[i];
        rise += problem_evaluate(p, y);
    }
    assert_true(rise < 0);
    free(v), free(y);
    level_close(level);
    sheet_free(s);
    struct trial t = good(square(0.25, 0));
    assert_true(same(t.energy, good(square(0.25, 0.01)).energy, 1e-8));
}

/* ---- S8 to S17 ---- */

static int miura_mirrored(int x, int y)
{
    return miura(11 - x, y);
}

static int miura_turned(int x, int y)
{
    return miura(11 - x, 22 - y);
}

/* S8: the mirror image of a pattern, and the pattern turned round, fold with the same energy. */
static void mirror_image(void **state)
{
    (void)state;
    struct sheet *s[3] = {scene_sheet(12, 23, miura), scene_sheet(12, 23, miura_mirrored), scene_sheet(12, 23, miura_turned)};
    double energy[3];
    for (int i = 0; i < 3; i++) {
        s[i]->solve.tolerance = 1e-11;
        energy[i] = good(s[i]).energy;
    }
    assert_true(same(energy[1], energy[0], 1e-12) && same(energy[2], energy[0], 1e-12));
}

/* What is beyond a thin sheet is said to be so. */
static void crushed(struct sheet *s)
{
    struct trial t = trial_fold(s);
    if (!trial_crushed(&t))
        print_message("%s, wrong %u, %s\n", fold_status_name(t.status), t.wrong, t.remark);
    assert_true(trial_crushed(&t));
    sheet_free(s);
}

/* S9: thinner and thinner, the iterations grow slowly; with a thickness of ten
 * radii of curvature there is no minimum. */
static void thin_and_thick(void **state)
{
    (void)state;
    static const struct { double h; int iterations; } bound[] = {{1, 100}, {0.1, 400}, {0.01, 1500}, {0.001, 5000}};
    for (size_t i = 0; i < sizeof bound / sizeof *bound; i++) {
        struct sheet *s = scene_sheet(8, 6, rib);
        s->thickness = bound[i].h;
        assert_true(good(s).iterations <= bound[i].iterations);
    }
    struct sheet *s = scene_sheet(8, 6, rib);
    s->thickness = 10;
    crushed(s);
}

/* S10: stitches 100:1, and Poisson's ratios next to both ends of their range: at
 * -1 area costs nothing beside shape, and a sheet of h = 0.5 is crushed. */
static void ends_of_ranges(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct sheet *s = scene_sheet(5, 4, seed);
        if (i < 2)
            s->dx = i ? 10 : 0.1, s->dy = i ? 0.1 : 10;
        else
            s->poisson = i == 2 ? -0.9999 : 0.5, s->thickness = i == 2 ? 0.01 : 0.5;
        good(s);
    }
    struct sheet *s = scene_sheet(5, 4, seed);
    s->poisson = -0.9999;
    crushed(s);
}

/* S11: curvatures whose stitch turns by 2 and more: coarse, but a minimum. */
static void turns_of_a_stitch(void **state)
{
    (void)state;
    for (double k = 1.4; k < 4; k += 0.7) {
        struct sheet *s = scene_sheet(6, 6, checker);
        for (int i = 0; i < 36; i++)
            s->kx[i] *= k, s->ky[i] *= k;
        good(s);
    }
}

static int stripes_of_4(int x, int y)
{
    (void)y;
    return x / 4 % 2;
}

/* S12: a rib whose arcs turn by half a circle each, l (1 - nu) k = pi: the
 * energy is the accordion's, and it is nearly 2/pi as wide. */
static void folds_of_half_a_circle(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(16, 4, stripes_of_4);
    double k = 3.14159265358979 / (4 * s->dx * 0.6);
    for (int i = 0; i < 64; i++)
        s->kx[i] *= k, s->ky[i] *= k;
    s->mesh.per_stitch = 2;
    struct trial t = good(s);
    print_message("extent %.4f\n", t.extent_x);
    assert_true(fabs(t.extent_x - 2 / 3.14159265358979) < 0.05);
}

/* S13: any number of growth steps ends in the same minimum. */
static void any_number_of_steps(void **state)
{
    (void)state;
    double energy = 0;
    for (int steps = 1; steps <= 100; steps *= 10) {
        struct sheet *s = scene_sheet(8, 8, checker);
        s->solve.steps = steps;
        struct trial t = good(s);
        assert_true(steps == 1 || same(t.energy, energy, 1e-9));
        energy = t.energy;
    }
}

/* S14: one thread or two: the same bits, from start to end. */
static void threads_keep_the_bits(void **state)
{
    (void)state;
    struct fold_record r[2];
    struct surface at[2];
    for (int i = 0; i < 2; i++) {
        struct sheet *s = scene_sheet(24, 23, miura);
        struct fold_options options = {.threads = i + 1};
        struct fold_state *end = fold_run(s, &options, NULL, &r[i]);
        at[i] = surface_make(24, 23, 1);
        fold_sample(end, &at[i]);
        fold_free(end);
        sheet_free(s);
    }
    assert_true(r[0].energy.total == r[1].energy.total && r[0].gradient_max == r[1].gradient_max);
    assert_int_equal(r[0].iterations, r[1].iterations);
    assert_memory_equal(at[0].position, at[1].position, sizeof(double) * 3 * 25 * 24);
    for (int i = 0; i < 2; i++)
        surface_free(&at[i]), fold_record_free(&r[i]);
}

/* S15: a tolerance below rounding ends as precision, with the gradient it has, by every method. */
static void below_rounding(void **state)
{
    (void)state;
    for (enum method m = METHOD_AUTO; m <= METHOD_NEWTON; m++) {
        struct sheet *s = scene_sheet(6, 6, checker);
        s->solve.tolerance = 1e-20;
        s->solve.method = m;
        struct trial t = good(s);
        assert_int_equal(t.status, FOLD_PRECISION);
        assert_true(t.gradient > 0 && t.gradient < 1e-9);
    }
}

/* S16, S17: free sheets of one stitch, one row, one column, and a thousand of them. */
static void narrow_sheets(void **state)
{
    (void)state;
    static const int size[][2] = {{1, 1}, {1, 9}, {9, 1}, {1000, 1}, {1, 1000}};
    for (size_t i = 0; i < sizeof size / sizeof *size; i++)
        for (int plain = 0; plain < 2; plain++)
            if (!plain || size[i][0] + size[i][1] < 1000)
                good(scene_sheet(size[i][0], size[i][1], plain ? NULL : seed));
}

/* Plain stitches in a row make a coil of many turns: where its iterations are more than are allowed it says so. */
static void long_coil(void **state)
{
    (void)state;
    struct sheet *s = scene_sheet(1000, 1, NULL);
    s->solve.max_iterations = 50;
    struct trial t = trial_fold(s);
    assert_int_equal(t.status, FOLD_ITERATION_LIMIT);
    assert_true(!t.wrong && t.iterations <= 51);
    sheet_free(s);
    s = scene_sheet(300, 1, NULL);
    s->solve.max_iterations = 400;
    t = trial_fold(s);
    assert_true(t.status == FOLD_CONVERGED && !t.wrong);
    sheet_free(s);
}

int main(void)
{
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_far_away),
        cmocka_unit_test(noise_flattens_out),
        cmocka_unit_test(near_a_saddle),
        cmocka_unit_test(critical_point_from_both_sides),
        cmocka_unit_test(symmetric_state_is_a_saddle),
        cmocka_unit_test(mirror_image),
        cmocka_unit_test(thin_and_thick),
        cmocka_unit_test(ends_of_ranges),
        cmocka_unit_test(turns_of_a_stitch),
        cmocka_unit_test(folds_of_half_a_circle),
        cmocka_unit_test(any_number_of_steps),
        cmocka_unit_test(threads_keep_the_bits),
        cmocka_unit_test(below_rounding),
        cmocka_unit_test(narrow_sheets),
        cmocka_unit_test(long_coil),
    };
    return cmocka_run_group_tests_name("stability", tests, NULL, NULL);
}
