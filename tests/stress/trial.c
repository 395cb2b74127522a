/* SPDX-License-Identifier: GPL-3.0-or-later
 * A fold judged by other means than its own: gradient computed again, inertia
 * by a dense factor, every number looked at. */
#include "tests/stress/trial.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "solver/fold_state.h"
#include "solver/memory.h"
#include "solver/problem.h"
#include "solver/stopwatch.h"

enum { MOST_DENSE = 3000 };

void dpotrf_(const char *uplo, const int *n, double *a, const int *lda, int *info);

/* ---- numbers ---- */

static bool finite_all(size_t n, const double *a)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(a[i]))
            return false;
    return true;
}

static bool finite_surface(const struct sheet *sheet, const struct fold_state *state)
{
    struct surface s = surface_make(sheet->columns, sheet->rows, 2);
    fold_sample(state, &s);
    size_t points = 3 * (size_t)(s.nx + 1) * (size_t)(s.ny + 1), cells = (size_t)s.nx * (size_t)s.ny;
    bool finite = finite_all(points, s.position) && finite_all(points, s.normal) && finite_all(points, s.displacement) &&
                  finite_all(cells, s.mean) && finite_all(cells, s.gauss) && finite_all(cells, s.stretching) &&
                  finite_all(cells, s.bending);
    surface_free(&s);
    return finite;
}

static bool finite_record(const struct fold_record *r)
{
    const double number[] = {r->energy.total, r->energy.stretching, r->energy.bending, r->energy.springs, r->energy_flat,
                             r->energy_error, r->gradient_max, r->extent_x, r->extent_y, r->extent_z, r->rms_height,
                             r->max_normal_curvature, r->shape_error};
    for (int i = 0; i < r->nsteps; i++)
        if (!isfinite(r->step[i].energy.total) || !isfinite(r->step[i].gradient_max))
            return false;
    return finite_all(sizeof number / sizeof *number, number);
}

/* ---- inertia ---- */

/* The six rigid motions of patches: a translation moves the values, a turn all
 * of a node's vectors; orthonormal, z (6 x n). */
static void rigid_modes(const struct discretisation *d, const double *x, double *z)
{
    int n = d->n;
    for (int i = 0; i < d->nnodes; i++)
        for (int c = 0; c < 3; c++)
            z[c * n + d->node[i] + c] = 1;
    for (int i = 0; i < n; i += 3)
        for (int m = 0; m < 3; m++) {
            z[(3 + m) * n + i + (m + 1) % 3] = -x[i + (m + 2) % 3];
            z[(3 + m) * n + i + (m + 2) % 3] = x[i + (m + 1) % 3];
        }
    for (int m = 0; m < 6; m++)
        for (int round = 0; round < 2; round++)
            for (int b = 0; b <= m; b++) {
                double along = 0;
                for (int i = 0; i < n; i++)
                    along += z[m * n + i] * z[b * n + i];
                for (int i = 0; i < n; i++)
                    z[m * n + i] = b < m ? z[m * n + i] - along * z[b * n + i] : z[m * n + i] / sqrt(along);
            }
}

/* H, and as stiff as its mean along the rigid motions of a free sheet, is
 * positive definite; but for rounding, 1e-14 of the mean. */
static bool dense_minimum(const struct fold_state *state)
{
    const struct discretisation *d = state->d;
    int n = d->n, info;
    double *value = MEMORY_ARRAY(double, d->pattern.start[n]), *A = MEMORY_ARRAY(double, (size_t)n * (size_t)n), mean = 0;
    d->op->hessian(d, state->x, state->growth, HESSIAN_EXACT, value);
    for (int j = 0; j < n; j++) {
        mean += value[d->pattern.start[j]] / n;
        for (int k = d->pattern.start[j]; k < d->pattern.start[j + 1]; k++)
            A[(size_t)j * (size_t)n + (size_t)d->pattern.row[k]] = value[k];
    }
    if (d->sheet->spring <= 0) {
        double *z = MEMORY_ARRAY(double, 6 * n);
        rigid_modes(d, state->x, z);
        for (int m = 0; m < 6; m++)
            for (int j = 0; j < n; j++)
                for (int i = j; i < n; i++)
                    A[(size_t)j * (size_t)n + (size_t)i] += mean * z[m * n + i] * z[m * n + j];
        free(z);
    }
    for (int j = 0; j < n; j++)
        A[(size_t)j * (size_t)(n + 1)] += 1e-14 * mean;
    dpotrf_("L", &n, A, &n, &info);
    free(value), free(A);
    return info == 0;
}

/* Without dense room, and for triangles: the solver's own test, begun afresh. */
static bool own_minimum(const struct fold_state *state)
{
    struct effort effort = {0};
    struct problem p;
    double *direction = MEMORY_ARRAY(double, state->d->n);
    problem_open(&p, state->d, &effort);
    p.growth = state->growth;
    bool minimum = newton_is_minimum(&p, state->x, direction);
    problem_close(&p);
    free(direction);
    return minimum;
}

/* ---- the whole ---- */

static unsigned judge_gradient(const struct sheet *sheet, const struct fold_state *state, const struct fold_record *r)
{
    const struct discretisation *d = state->d;
    double *g = MEMORY_ARRAY(double, d->n), largest = 0;
    d->op->energy(d, state->x, state->growth, g);
    for (int i = 0; i < d->n; i++)
        largest = fmax(largest, fabs(g[i]));
    free(g);
    largest /= sheet->thickness * sheet->thickness;
    bool same = fabs(largest - r->gradient_max) <= 1e-9 * largest + 1e-300;
    return same && (r->status != FOLD_CONVERGED || largest <= sheet->solve.tolerance) ? 0 : WRONG_GRADIENT;
}

static unsigned judge(const struct sheet *sheet, const struct fold_state *state, const struct fold_record *r, bool *dense)
{
    bool good = r->status == FOLD_CONVERGED || r->status == FOLD_PRECISION;
    unsigned wrong = finite_record(r) && finite_surface(sheet, state) ? 0 : WRONG_NUMBER;
    *dense = state->d->n <= MOST_DENSE && sheet->mesh.discretisation == DISCRETISATION_PATCH;
    if (!good)
        return wrong | (r->status == FOLD_FAILED && !r->remark ? WRONG_CLAIM : 0);
    wrong |= judge_gradient(sheet, state, r) | (r->positive_definite ? 0 : WRONG_CLAIM);
    return wrong | ((*dense ? dense_minimum(state) : own_minimum(state)) ? 0 : WRONG_INERTIA);
}

struct trial trial_fold(const struct sheet *sheet)
{
    struct fold_options options = {.threads = 1};
    struct fold_record r;
    double begun = stopwatch();
    struct fold_state *state = fold_run(sheet, &options, NULL, &r);
    struct trial t = {.status = r.status, .minimum = r.positive_definite, .iterations = r.iterations,
                      .unknowns = r.unknowns, .energy = r.energy.total, .gradient = r.gradient_max,
                      .seconds = stopwatch() - begun, .extent_x = r.extent_x, .extent_y = r.extent_y,
                      .extent_z = r.extent_z};
    t.pushed = r.remark && strstr(r.remark, "left to its lower side");
    snprintf(t.remark, sizeof t.remark, "%s", r.remark ? r.remark : "");
    t.wrong = judge(sheet, state, &r, &t.dense);
    fold_free(state);
    fold_record_free(&r);
    return t;
}

bool trial_crushed(const struct trial *trial)
{
    return trial->status == FOLD_FAILED && !trial->wrong &&
           (strstr(trial->remark, "crushed") || strstr(trial->remark, "too coarse"));
}

bool trial_apart(const struct sheet *sheet, int limit, struct trial *trial, char how[24])
{
    int ends[2], status = 0;
    fflush(stdout);
    if (pipe(ends) != 0)
        abort();
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        alarm((unsigned)limit);
        struct trial t = trial_fold(sheet);
        _exit(write(ends[1], &t, sizeof t) == sizeof t ? 0 : 1);
    }
    close(ends[1]);
    bool complete = read(ends[0], trial, sizeof *trial) == sizeof *trial;
    close(ends[0]);
    waitpid(child, &status, 0);
    if (complete)
        return true;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
        snprintf(how, 24, "time");
    else if (WIFSIGNALED(status))
        snprintf(how, 24, "signal %d", WTERMSIG(status));
    else
        snprintf(how, 24, "exit %d", WEXITSTATUS(status));
    return false;
}
