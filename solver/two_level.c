/* SPDX-License-Identifier: GPL-3.0-or-later
 * A coarse factor and a fine Hessian in, solutions on the fine level out. */
#include "solver/two_level.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"

struct two_level {
    const struct discretisation *coarse, *fine;
    struct factor *factor;
    double        *H;               /* (pattern.start[n]) of the fine level */
    double        *blocks;          /* (n x block) Cholesky factors of the nodes' own blocks */
    double        *down, *up;       /* (coarse n), (n) */
    double        *r, *z, *v, *Hv;  /* (n) residual, preconditioned, direction, its image */
};

struct two_level *two_level_make(const struct discretisation *coarse, struct factor *factor,
                                 const struct discretisation *fine)
{
    struct two_level *t = MEMORY_ARRAY(struct two_level, 1);
    *t = (struct two_level){.coarse = coarse, .fine = fine, .factor = factor,
                            .H = MEMORY_ARRAY(double, fine->pattern.start[fine->n]),
                            .blocks = MEMORY_ARRAY(double, (size_t)fine->n * (size_t)fine->block),
                            .down = MEMORY_ARRAY(double, coarse->n), .up = MEMORY_ARRAY(double, fine->n),
                            .r = MEMORY_ARRAY(double, fine->n), .z = MEMORY_ARRAY(double, fine->n),
                            .v = MEMORY_ARRAY(double, fine->n), .Hv = MEMORY_ARRAY(double, fine->n)};
    return t;
}

void two_level_free(struct two_level *t)
{
    if (!t)
        return;
    free(t->H), free(t->blocks), free(t->down), free(t->up);
    free(t->r), free(t->z), free(t->v), free(t->Hv);
    free(t);
}

/* y = H v, from the lower triangle. */
static void multiply(const struct pattern *p, const double *H, const double *v, double *y)
{
    memset(y, 0, sizeof *y * (size_t)p->n);
    for (int j = 0; j < p->n; j++) {
        const int *row = p->row;
        double own = H[p->start[j]] * v[j], vj = v[j];
        for (int k = p->start[j] + 1; k < p->start[j + 1]; k++) {
            y[row[k]] += H[k] * vj;
            own += H[k] * v[row[k]];
        }
        y[j] += own;
    }
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

static void solve_block(const double *L, int m, const double *b, double *x)
{
    for (int i = 0; i < m; i++) {
        x[i] = b[i];
        for (int k = 0; k < i; k++)
            x[i] -= L[i * m + k] * x[k];
        x[i] /= L[i * m + i];
    }
    for (int i = m - 1; i >= 0; i--) {
        for (int k = i + 1; k < m; k++)
            x[i] -= L[k * m + i] * x[k];
        x[i] /= L[i * m + i];
    }
}

bool two_level_update(struct two_level *t, const double *x, double growth, enum hessian_kind kind)
{
    t->fine->op->hessian(t->fine, x, growth, kind, t->H);
    return factor_blocks(t);
}

void two_level_multiply(const struct two_level *t, const double *v, double *y)
{
    multiply(&t->fine->pattern, t->H, v, y);
}

/* z = M^-1 r */
static void precondition(struct two_level *t, const double *r, double *z)
{
    const struct discretisation *coarse = t->coarse, *fine = t->fine;
    coarse->op->restrict_gradient(coarse, t->down, fine, r);
    factor_solve(t->factor, t->down, t->down);
    coarse->op->prolong(coarse, t->down, fine, t->up);
    int m = fine->block;
#pragma omp parallel for num_threads(fine->threads) if (fine->threads > 1)
    for (int i = 0; i < fine->n; i += m) {
        solve_block(t->blocks + (size_t)i * (size_t)m, m, r + i, z + i);
        for (int k = i; k < i + m; k++)
            z[k] += t->up[k];
    }
}

static double dot(int n, const double *a, const double *b)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
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
        rho = dot(n, t->r, t->z);
        double keep = result.iterations++ ? rho / before : 0;
        for (int i = 0; i < n; i++)
            t->v[i] = -t->z[i] + keep * t->v[i];
        multiply(&t->fine->pattern, t->H, t->v, t->Hv);
        double curvature = dot(n, t->v, t->Hv);
        if (!(curvature > 0)) {
            result.end = rho > 0 ? TWO_LEVEL_NEGATIVE : TWO_LEVEL_DONE;
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
