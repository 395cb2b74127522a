/* SPDX-License-Identifier: GPL-3.0-or-later
 * A minimum and the next level in; the energy decrease and the step that
 * Newton's method would make there out, by a few conjugate gradients on
 *     H e = -g at the prolonged state, preconditioned by the sum of the nodes'
 * own blocks and the coarse level's factor, P H_coarse^-1 P^T.  The decrease
 * 1/2 Sum alpha_k r_k.z_k of the first k steps grows towards 1/2 g.H^-1 g. */
#include "solver/estimate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"

/* What lies beyond the next level, and what the conjugate gradients leave out:
 * the energy's order in the element size is at least 2 (curvature jumps at
 * patch lines), so 1/(1 - 2^-2) = 4/3, and the iteration stops at a twentieth. */
static const double BEYOND = 1.5;
static const double ENOUGH = 0.02;      /* of the decrease so far: a step that adds less is the last */
enum { MOST_STEPS = 40, BLOCK_MAX = 12 };

struct solve_for {
    struct problem              *coarse;
    const struct discretisation *fine;
    double *H;                  /* (pattern.start[n]) at the prolonged state */
    double *blocks;             /* (n x block) Cholesky factors of the nodes' own blocks */
    double *down, *up;          /* (coarse n), (n) work */
};

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

/* Dense Cholesky factor of each node's block, row by row; false: not positive definite. */
static bool factor_blocks(struct solve_for *s)
{
    const struct pattern *p = &s->fine->pattern;
    int m = s->fine->block;
    for (int first = 0; first < p->n; first += m) {
        double *L = s->blocks + (size_t)first * (size_t)m;
        for (int j = 0; j < m; j++)
            for (int i = j; i < m; i++) {
                double a = s->H[p->start[first + j] + i - j];
                for (int k = 0; k < j; k++)
                    a -= L[i * m + k] * L[j * m + k];
                if (i == j && !(a > 0))
                    return false;
                L[i * m + j] = i == j ? sqrt(a) : a / L[j * m + j];
            }
    }
    return true;
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

/* z = M^-1 r */
static void precondition(struct solve_for *s, const double *r, double *z)
{
    const struct discretisation *coarse = s->coarse->d, *fine = s->fine;
    coarse->op->restrict_gradient(coarse, s->down, fine, r);
    factor_solve(s->coarse->factor, s->down, s->down);
    coarse->op->prolong(coarse, s->down, fine, s->up);
    for (int i = 0; i < fine->n; i += fine->block)
        solve_block(s->blocks + (size_t)i * (size_t)fine->block, fine->block, r + i, z + i);
    for (int i = 0; i < fine->n; i++)
        z[i] += s->up[i];
}

static double dot(int n, const double *a, const double *b)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
}

/* Conjugate gradients on H e = -g from e = 0; r holds g and is used up.
 * Returns the decrease, < 0 where a direction of no curvature turns up. */
static double predicted_decrease(struct solve_for *s, double *r, double *e)
{
    int n = s->fine->n;
    double *z = MEMORY_ARRAY(double, n), *v = MEMORY_ARRAY(double, n), *Hv = MEMORY_ARRAY(double, n);
    double decrease = 0, rho = 0;
    for (int k = 0; k < MOST_STEPS; k++) {
        precondition(s, r, z);
        double before = rho;
        rho = dot(n, r, z);
        for (int i = 0; i < n; i++)
            v[i] = -z[i] + (k ? rho / before : 0) * v[i];
        multiply(&s->fine->pattern, s->H, v, Hv);
        double curvature = dot(n, v, Hv);
        if (!(curvature > 0)) {
            decrease = -1;
            break;
        }
        double alpha = rho / curvature, gain = 0.5 * alpha * rho;
        for (int i = 0; i < n; i++) {
            e[i] += alpha * v[i];
            r[i] += alpha * Hv[i];
        }
        decrease += gain;
        if (gain < ENOUGH * decrease)
            break;
    }
    free(z), free(v), free(Hv);
    return decrease;
}

/* The exact Hessian, or the semidefinite one where that has no factor. */
static double solve_fine(struct solve_for *s, const double *x_fine, double growth, const double *gradient, double *e)
{
    const struct discretisation *fine = s->fine;
    double *r = MEMORY_ARRAY(double, fine->n), decrease = -1;
    for (enum hessian_kind kind = HESSIAN_EXACT; decrease < 0 && kind <= HESSIAN_SEMIDEFINITE; kind++) {
        fine->op->hessian(fine, x_fine, growth, kind, s->H);
        memcpy(r, gradient, sizeof *r * (size_t)fine->n);
        memset(e, 0, sizeof *e * (size_t)fine->n);
        if (factor_blocks(s))
            decrease = predicted_decrease(s, r, e);
    }
    free(r);
    return decrease;
}

struct estimate estimate_error(struct problem *p, const double *x, const struct discretisation *fine, double *x_fine)
{
    struct solve_for s = {.coarse = p, .fine = fine,
                          .H = MEMORY_ARRAY(double, fine->pattern.start[fine->n]),
                          .blocks = MEMORY_ARRAY(double, (size_t)fine->n * (size_t)fine->block),
                          .down = MEMORY_ARRAY(double, p->d->n), .up = MEMORY_ARRAY(double, fine->n)};
    double *gradient = MEMORY_ARRAY(double, fine->n), *e = MEMORY_ARRAY(double, fine->n);
    p->d->op->prolong(p->d, x, fine, x_fine);
    double prolonged = fine->op->energy(fine, x_fine, p->growth, gradient).total;
    double decrease = fmax(solve_fine(&s, x_fine, p->growth, gradient, e), 0), furthest = 0;
    for (int i = 0; i < fine->n; i++)
        x_fine[i] += e[i];
    for (int i = 0; i < fine->nnodes; i++) {
        const double *move = e + fine->node[i];
        furthest = fmax(furthest, sqrt(dot(3, move, move)));
    }
    free(s.H), free(s.blocks), free(s.down), free(s.up), free(gradient), free(e);
    return (struct estimate){BEYOND * fabs(p->energy.total - prolonged + decrease), BEYOND * furthest};
}
