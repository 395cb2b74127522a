/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state in; its energy, gradient and a factor of its Hessian out, counted and timed. */
#include "solver/problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/stopwatch.h"

void problem_open(struct problem *p, const struct discretisation *d, struct effort *effort)
{
    *p = (struct problem){.d = d, .growth = 1, .effort = effort};
    p->gradient = MEMORY_ARRAY(double, d->n);
    p->trial = MEMORY_ARRAY(double, d->n);
    p->step = MEMORY_ARRAY(double, d->n);
    p->mass = MEMORY_ARRAY(double, d->n);
    d->op->mass(d, p->mass);
}

void problem_close(struct problem *p)
{
    factor_free(p->factor);
    free(p->hessian);
    free(p->diagonal);
    free(p->mass);
    free(p->gradient);
    free(p->trial);
    free(p->step);
    *p = (struct problem){0};
}

double problem_evaluate(struct problem *p, const double *x)
{
    double start = stopwatch();
    memset(p->gradient, 0, sizeof *p->gradient * (size_t)p->d->n);
    p->energy = p->d->op->energy(p->d, x, p->growth, p->gradient);
    double largest = 0;
    for (int i = 0; i < p->d->n; i++)
        largest = fabs(p->gradient[i]) > largest ? fabs(p->gradient[i]) : largest;
    p->gradient_max = isfinite(p->energy.total) ? largest : INFINITY;
    p->effort->evaluations++;
    p->effort->evaluate_s += stopwatch() - start;
    return p->energy.total;
}

void problem_move(const struct problem *p, const double *x, double length, const double *step, double *y)
{
    if (p->d->op->retract) {
        p->d->op->retract(p->d, x, length, step, y);
        return;
    }
    for (int i = 0; i < p->d->n; i++)
        y[i] = x[i] + length * step[i];
}

/* Such a shift holds the rigid motions by itself, and as symmetric as the sheet. */
static const double UNPINNED = 1e-6;

/* The velocities of coordinate c of a point at r under the six rigid motions: three
 * translations, then omega x r about each axis. */
static void rigid_velocity(const double *r, int c, double z[6])
{
    const double turn[3][3] = {{0, -r[2], r[1]}, {r[2], 0, -r[0]}, {-r[1], r[0], 0}};
    for (int m = 0; m < 3; m++) {
        z[m] = m == c;
        z[3 + m] = turn[m][c];
    }
}

/* Six positions that no rigid motion leaves at rest: rows of the rigid modes by
 * complete pivoting, so that they hold in any folded state. */
static void choose_pins(const struct discretisation *d, const double *x, int pin[6])
{
    double size = 0, basis[6][6];
    for (int i = 0; i < d->nnodes; i++)
        for (int c = 0; c < 3; c++)
            size = fmax(size, fabs(x[d->node[i] + c]));
    for (int k = 0; k < 6; k++) {
        double largest = -1;
        for (int i = 0; i < d->nnodes; i++)
            for (int c = 0; c < 3; c++) {
                double z[6], length = 0;
                rigid_velocity(x + d->node[i], c, z);
                for (int m = 3; m < 6; m++)
                    z[m] /= size;
                for (int b = 0; b < k; b++) {
                    double along = 0;
                    for (int m = 0; m < 6; m++)
                        along += z[m] * basis[b][m];
                    for (int m = 0; m < 6; m++)
                        z[m] -= along * basis[b][m];
                }
                for (int m = 0; m < 6; m++)
                    length += z[m] * z[m];
                if (length <= largest)
                    continue;
                largest = length;
                pin[k] = d->node[i] + c;
                for (int m = 0; m < 6; m++)
                    basis[k][m] = z[m] / sqrt(length);
            }
    }
}

void problem_regularise(const struct discretisation *d, const double *x, const double *diagonal, const double *mass,
                        double shift, double *hessian)
{
    const int *at = d->pattern.start;
    double mean = 0;
    for (int i = 0; i < d->n; i++) {
        mean += diagonal[i] / d->n;
        hessian[at[i]] = diagonal[i] + shift * mass[i];
    }
    if (d->sheet->spring > 0 || shift >= UNPINNED)
        return;
    int pin[6];
    choose_pins(d, x, pin);
    for (int k = 0; k < 6; k++)
        hessian[at[pin[k]]] += mean;
}

void problem_assemble(struct problem *p, const double *x, enum hessian_kind kind)
{
    const int n = p->d->n, *start = p->d->pattern.start;
    double begin = stopwatch();
    if (!p->hessian) {
        p->hessian = MEMORY_ARRAY(double, start[n]);
        p->diagonal = MEMORY_ARRAY(double, n);
    }
    p->d->op->hessian(p->d, x, p->growth, kind, p->hessian);
    for (int i = 0; i < n; i++)
        p->diagonal[i] = p->hessian[start[i]];
    p->effort->assemble_s += stopwatch() - begin;
}

enum factor_result problem_factor(struct problem *p, const double *x, double shift)
{
    double start = stopwatch();
    problem_regularise(p->d, x, p->diagonal, p->mass, shift, p->hessian);
    if (!p->factor)
        p->factor = factor_make(&p->d->pattern, p->d->ordered, p->d->parts, p->d->threads);
    enum factor_result result = p->factor ? factor_numeric(p->factor, p->hessian) : FACTOR_NO_MEMORY;
    p->effort->factorisations++;
    p->effort->factor_s += stopwatch() - start;
    return result;
}

bool problem_lost(struct problem *p, const double *x)
{
    enum { BETWEEN_LOOKS = 20, MOST_DOUBTS = 10 };
    if (!p->d->op->doubt || p->effort->iterations < p->looked + BETWEEN_LOOKS)
        return false;
    p->looked = p->effort->iterations;
    p->doubts = p->d->op->doubt(p->d, x) ? p->doubts + 1 : 0;
    return p->doubts >= MOST_DOUBTS;
}

bool problem_report(struct problem *p)
{
    return !p->progress || p->progress(p->progress_self, p->growth, p->effort->iterations, p->energy.total);
}
