/* SPDX-License-Identifier: GPL-3.0-or-later
 * A coarse factor and a fine Hessian in, solutions on the fine level out. */
#include "solver/two_level.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/problem.h"
#include "solver/vector.h"

static const double FIRST_SHIFT = 1e-5, LAST_SHIFT = 1e6;

struct two_level {
    const struct discretisation *coarse, *fine;
    const double  *x_coarse;        /* (coarse n) */
    struct factor *factor;
    double        *H;               /* (pattern.start[n]) of the fine level */
    double        *H_coarse;        /* (coarse pattern.start[n]) with the next two NULL until the factor is renewed */
    double        *diagonal, *mass; /* (coarse n) */
    double        *blocks;          /* (n x block) Cholesky factors of the nodes' own blocks */
    double        *down, *up;       /* (coarse n), (n) */
    double        *r, *z, *v, *Hv;  /* (n) residual, preconditioned, direction, its image */
    double        *part;            /* (2 x (n - parts[1])) what the halves add to the separator's rows */
};

struct two_level *two_level_make(const struct discretisation *coarse, const double *x_coarse, struct factor *factor,
                                 const struct discretisation *fine)
{
    struct two_level *t = MEMORY_ARRAY(struct two_level, 1);
    *t = (struct two_level){.coarse = coarse, .fine = fine, .x_coarse = x_coarse, .factor = factor,
                            .H = MEMORY_ARRAY(double, fine->pattern.start[fine->n]),
                            .blocks = MEMORY_ARRAY(double, (size_t)fine->n * (size_t)fine->block),
                            .down = MEMORY_ARRAY(double, coarse->n), .up = MEMORY_ARRAY(double, fine->n),
                            .r = MEMORY_ARRAY(double, fine->n), .z = MEMORY_ARRAY(double, fine->n),
                            .v = MEMORY_ARRAY(double, fine->n), .Hv = MEMORY_ARRAY(double, fine->n),
                            .part = MEMORY_ARRAY(double, 2 * (fine->n - fine->parts[1]))};
    return t;
}

void two_level_free(struct two_level *t)
{
    if (!t)
        return;
    free(t->H), free(t->H_coarse), free(t->diagonal), free(t->mass), free(t->blocks), free(t->down), free(t->up);
    free(t->r), free(t->z), free(t->v), free(t->Hv), free(t->part);
    free(t);
}

/* Adds to y and, for rows from `last` on, to beyond what a node's columns of
 * the lower triangle say of y = H v.  Rows come in whole nodes. */
static void multiply_node(const struct pattern *p, int m, const double *H, const double *v, int node, int last,
                          double *y, double *beyond)
{
    for (int j = node * m; j < (node + 1) * m; j++) {
        const double *h = H + p->start[j];
        const int *row = p->row + p->start[j], *end = p->row + p->start[j + 1];
        double vj = v[j], own = *h++ * vj;
        for (row++; row < end && *row < (node + 1) * m; row++, h++) {
            y[*row] += *h * vj;
            own += *h * v[*row];
        }
        for (; row < end; row += m, h += m) {
            double *to = *row < last ? y + *row : beyond + *row - last;
            const double *from = v + *row;
            for (int i = 0; i < m; i++) {
                to[i] += h[i] * vj;
                own += h[i] * from[i];
            }
        }
        y[j] += own;
    }
}

/* Columns [first, end) of y = H v, whose rows from `last` on go to beyond. */
static void multiply_part(const struct two_level *t, const double *v, int first, int end, int last, double *y,
                          double *beyond)
{
    const struct pattern *p = &t->fine->pattern;
    int m = t->fine->block;
    if (m == 12)    /* known to the compiler */
        for (int node = first / 12; node < end / 12; node++)
            multiply_node(p, 12, t->H, v, node, last, y, beyond);
    else
        for (int node = first / m; node < end / m; node++)
            multiply_node(p, m, t->H, v, node, last, y, beyond);
}

/* y = H v: the halves side by side, each with its own sums for the separator;
 * then the separator.  The same sums for any number of threads. */
static void multiply(const struct two_level *t, const double *v, double *y)
{
    int n = t->fine->n, middle = t->fine->parts[0], last = t->fine->parts[1];
    int begin[2] = {0, middle}, end[2] = {middle, last};
#pragma omp parallel for num_threads(2) if (t->fine->threads > 1)
    for (int h = 0; h < 2; h++) {
        double *beyond = t->part + (size_t)h * (size_t)(n - last);
        memset(y + begin[h], 0, sizeof *y * (size_t)(end[h] - begin[h]));
        memset(beyond, 0, sizeof *beyond * (size_t)(n - last));
        multiply_part(t, v, begin[h], end[h], last, y, beyond);
    }
    for (int i = last; i < n; i++)
        y[i] = t->part[i - last] + t->part[i - last + n - last];
    multiply_part(t, v, last, n, n, y, NULL);
}

/* L (m x m, row by row) of the block of the node whose first unknown is given; false: not positive definite. */
static bool factor_block(const struct pattern *p, const double *H, int first, int m, double *L)
{
    for (int j = 0; j < m; j++)
        for (int i = j; i < m; i++) {
            double a = H[p->start[first + j] + i - j];
            for (int k = 0; k < j; k++)
                a -= L[i * m + k] * L[j * m + k];
            if (i == j && !(a > 0))
                return false;
            L[i * m + j] = i == j ? sqrt(a) : a / L[j * m + j];
        }
    return true;
}

static bool factor_blocks(struct two_level *t)
{
    int m = t->fine->block, nblocks = t->fine->n / m, failed = 0;
#pragma omp parallel for num_threads(t->fine->threads) reduction(+ : failed) if (t->fine->threads > 1)
    for (int i = 0; i < nblocks; i++)
        failed += !factor_block(&t->fine->pattern, t->H, i * m, m, t->blocks + (size_t)i * (size_t)(m * m));
    return failed == 0;
}

/* z += half of L^-T L^-1 r */
static void add_half_of_block(const double *L, int m, const double *r, double *z)
{
    double x[m];
    for (int i = 0; i < m; i++) {
        x[i] = r[i];
        for (int k = 0; k < i; k++)
            x[i] -= L[i * m + k] * x[k];
        x[i] /= L[i * m + i];
    }
    for (int i = m - 1; i >= 0; i--) {
        for (int k = i + 1; k < m; k++)
            x[i] -= L[k * m + i] * x[k];
        x[i] /= L[i * m + i];
        z[i] += 0.5 * x[i];
    }
}

/* H = H + blend (S - H) */
static void blend_semidefinite(struct two_level *t, const double *x, double growth, double blend)
{
    size_t size = (size_t)t->fine->pattern.start[t->fine->n];
    double *S = MEMORY_ARRAY(double, size);
    t->fine->op->hessian(t->fine, x, growth, HESSIAN_SEMIDEFINITE, S);
    for (size_t i = 0; i < size; i++)
        t->H[i] += blend * (S[i] - t->H[i]);
    free(S);
}

bool two_level_update(struct two_level *t, const double *x, double growth, double blend)
{
    t->fine->op->hessian(t->fine, x, growth, blend < 1 ? HESSIAN_EXACT : HESSIAN_SEMIDEFINITE, t->H);
    if (blend > 0 && blend < 1)
        blend_semidefinite(t, x, growth, blend);
    return factor_blocks(t);
}

bool two_level_renew(struct two_level *t, bool shifted)
{
    const struct discretisation *coarse = t->coarse;
    enum factor_result result;
    if (!t->H_coarse) {
        t->H_coarse = MEMORY_ARRAY(double, coarse->pattern.start[coarse->n]);
        t->diagonal = MEMORY_ARRAY(double, coarse->n);
        t->mass = MEMORY_ARRAY(double, coarse->n);
        coarse->op->mass(coarse, t->mass);
    }
    coarse->op->restrict_hessian(coarse, t->H_coarse, t->fine, t->H);
    for (int i = 0; i < coarse->n; i++)
        t->diagonal[i] = t->H_coarse[coarse->pattern.start[i]];
    double shift = 0;
    do {
        problem_regularise(coarse, t->x_coarse, t->diagonal, t->mass, shift, t->H_coarse);
        result = factor_numeric(t->factor, t->H_coarse);
        shift = fmax(8 * shift, FIRST_SHIFT);
    } while (result == FACTOR_INDEFINITE && shifted && shift < LAST_SHIFT);
    return result == FACTOR_DONE;
}

void two_level_multiply(const struct two_level *t, const double *v, double *y)
{
    multiply(t, v, y);
}

/* z += D^-1 r / 2.  Four nodes share an element: where the elements' own Hessians are positive semidefinite, as in the
 * semidefinite one, so is 4 D - H, no eigenvalue of D^-1 H is above four and half a step overshoots by no more than it
 * was off.  Of the exact one that is not certain: a negative r.z ends the iteration as a negative direction does. */
static void add_half_of_blocks(const struct two_level *t, const double *r, double *z)
{
    int m = t->fine->block;
#pragma omp parallel for num_threads(t->fine->threads) if (t->fine->threads > 1)
    for (int i = 0; i < t->fine->n; i += m)
        add_half_of_block(t->blocks + (size_t)i * (size_t)m, m, r + i, z + i);
}

/* left = r - H z */
static void subtract(const struct two_level *t, const double *r, const double *z, double *left)
{
    multiply(t, z, t->Hv);
    for (int i = 0; i < t->fine->n; i++)
        left[i] = r[i] - t->Hv[i];
}

/* z = M^-1 r: the nodes' blocks, the coarse level on what they leave, and the blocks again. */
static void precondition(struct two_level *t, const double *r, double *z)
{
    const struct discretisation *coarse = t->coarse, *fine = t->fine;
    memset(z, 0, sizeof *z * (size_t)fine->n);
    add_half_of_blocks(t, r, z);
    subtract(t, r, z, t->up);
    coarse->op->restrict_gradient(coarse, t->down, fine, t->up);
    factor_solve(t->factor, t->down, t->down);
    coarse->op->prolong(coarse, t->down, fine, t->up);
    for (int i = 0; i < fine->n; i++)
        z[i] += t->up[i];
    subtract(t, r, z, t->up);
    add_half_of_blocks(t, t->up, z);
}

struct two_level_result two_level_solve(struct two_level *t, const double *g, double enough, int most, double *e,
                                        double *negative)
{
    const int n = t->fine->n;
    struct two_level_result result = {.end = TWO_LEVEL_CAP};
    double rho = 0;
    memcpy(t->r, g, sizeof *g * (size_t)n);
    memset(e, 0, sizeof *e * (size_t)n);
    while (result.iterations < most) {
        precondition(t, t->r, t->z);
        double before = rho;
        rho = vector_dot(n, t->r, t->z);
        double keep = result.iterations++ ? rho / before : 0;
        for (int i = 0; i < n; i++)
            t->v[i] = -t->z[i] + keep * t->v[i];
        multiply(t, t->v, t->Hv);
        double curvature = vector_dot(n, t->v, t->Hv);
        if (!(curvature > 0) || !(rho > 0)) {
            result.end = rho == 0 ? TWO_LEVEL_DONE : TWO_LEVEL_NEGATIVE;
            if (negative)
                memcpy(negative, t->v, sizeof *negative * (size_t)n);
            break;
        }
        double alpha = rho / curvature, gain = 0.5 * alpha * rho;
        for (int i = 0; i < n; i++) {
            e[i] += alpha * t->v[i];
            t->r[i] += alpha * t->Hv[i];
        }
        result.decrease += gain;
        if (gain <= enough * result.decrease) {
            result.end = TWO_LEVEL_DONE;
            break;
        }
    }
    return result;
}
