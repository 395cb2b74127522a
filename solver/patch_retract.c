/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state and an increment in, the state it leads to along turning pieces out
 * (a retraction, as in rotation-strain coordinates: Huang et al. 2011).
 *
 * Straight lines stretch a sheet that turns, so a step along one is soon too
 * long.  Here every point's frame turns by exp(w), w the spin of the increment
 * there, and the surface is the one whose derivatives come closest to those of
 * the turned frames,
 *     y = x + u + S^-1 Sum_g w_g (N_x e_p + N_y e_q),  S_ab = Int N_x^a N_x^b + N_y^a N_y^b,
 * e the excess of the second order (turn_kernel.h), S^-1 of patch_poisson.h. */
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/patch_batch.h"
#include "solver/patch_poisson.h"
#include "solver/turn_kernel.h"

enum { GAUSS_TURN = 3 };        /* points a side; too few for the mass of a line of one element */

/* LAPACK, column-major. */
void dposv_(const char *uplo, const int *n, const int *columns, double *a, const int *lda, double *b, const int *ldb,
            int *info);

struct retraction {
    int         gauss;          /* points a side; 0: nothing is made yet */
    double      weight[GAUSS_MAX * GAUSS_MAX];
    double      N[GAUSS_MAX * GAUSS_MAX][D_COUNT][BASIS_MAX];      /* of which D_P and D_Q are used */
    struct poisson *poisson;
    double     *u, *right;      /* (n) scratch */
};

/* What belongs to the level; made when first asked for. */
static struct retraction *prepare(const struct patch *p)
{
    struct retraction *r = p->retraction;
    if (r->gauss)
        return r;
    r->gauss = p->nx > 1 && p->ny > 1 ? GAUSS_TURN : GAUSS_MAX;
    patch_tabulate(p, r->gauss, r->weight, r->N);
    r->poisson = poisson_make(p, r->gauss);
    r->u = MEMORY_ARRAY(double, p->d.n);
    r->right = MEMORY_ARRAY(double, p->d.n);
    return r;
}

struct retraction *patch_retraction_make(void)
{
    return MEMORY_ARRAY(struct retraction, 1);
}

void patch_retraction_free(struct retraction *r)
{
    poisson_free(r->poisson);
    free(r->u);
    free(r->right);
    free(r);
}

/* ---- a free sheet: its motion as a whole is no part of an increment (it would turn what follows) ---- */

/* out (3) += a x b */
static void add_cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] += a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* Gram matrix Z^T Z and part = Z^T v of the rigid motions Z of x (n): three translations of the nodes' positions r,
 * then omega x r of these and of slopes and twists, from the sums of r, of r r^T, of v and of r x v. */
static void rigid_sums(const struct patch *p, const double *x, const double *v, double gram[6][6], double part[6])
{
    double centre[3] = {0}, square[3][3] = {{0}}, positions = 0;
    for (int k = 0; k < p->d.n; k += 3) {
        const double *r = x + k;
        for (int c = 0; c < 3; c++)
            for (int e = 0; e < 3; e++)
                square[c][e] += r[c] * r[e];
        add_cross(r, v + k, part + 3);
        if (k % p->per_node != 0)
            continue;
        positions++;
        for (int c = 0; c < 3; c++)
            centre[c] += r[c], part[c] += v[k + c];
    }
    for (int c = 0; c < 3; c++) {
        const double turn[3] = {c == 0, c == 1, c == 2};
        gram[c][c] = positions;
        add_cross(centre, turn, gram[c] + 3);       /* e_c . (omega x r) = omega . (r x e_c) */
        for (int e = 0; e < 3; e++)
            gram[3 + c][3 + e] = (c == e ? square[0][0] + square[1][1] + square[2][2] : 0) - square[c][e];
    }
}

/* v -= Z (Z^T Z)^-1 Z^T v, Z (n x 6) the rigid motions of state x. */
static void remove_rigid(const struct patch *p, const double *x, double *v)
{
    const int six = 6, one = 1;
    double gram[6][6] = {{0}}, part[6] = {0};
    int info;
    rigid_sums(p, x, v, gram, part);
    dposv_("L", &six, &one, &gram[0][0], &six, part, &six, &info);
    if (info != 0)      /* a sheet without extent turns about nothing */
        return;
    const double back[3] = {-part[3], -part[4], -part[5]};
    for (int k = 0; k < p->d.n; k += 3) {
        add_cross(back, x + k, v + k);
        for (int c = 0; c < 3 && k % p->per_node == 0; c++)
            v[k + c] -= part[c];
    }
}

/* The retraction's own increment: length dx, at rest as a whole where no spring holds the sheet. */
static const double *increment(const struct patch *p, const double *x, double length, const double *dx)
{
    double *u = prepare(p)->u;
    for (int i = 0; i < p->d.n; i++)
        u[i] = length * dx[i];
    if (p->d.sheet->spring <= 0)
        remove_rigid(p, x, u);
    return u;
}

/* ---- one batch: out += Sum_g w_g N^T e, or, where pulled is given, Sum_g w_g N^T (de/d(dp, dq))^T N pulled ---- */

LANES_INLINE void batch_turn_of(const struct batch *b, const double *x, const double *u, const double *pulled,
                                int nfun, int per_node, double *out)
{
    const struct retraction *r = b->patch->retraction;
    struct vec X[BASIS_MAX], D[BASIS_MAX], U[BASIS_MAX], G[BASIS_MAX] = {{.x = {0}}};
    batch_gather(b, x, nfun, per_node, X);
    batch_gather(b, u, nfun, per_node, D);
    if (pulled)
        batch_gather(b, pulled, nfun, per_node, U);
    for (int g = 0; g < r->gauss * r->gauss; g++) {
        struct vec at[2], by[2], to[2], e[2];
        batch_derive(r->N[g], 2, nfun, X, at);
        batch_derive(r->N[g], 2, nfun, D, by);
        struct frame f = frame_of(at[D_P], at[D_Q], by[D_P], by[D_Q]);
        if (pulled) {
            batch_derive(r->N[g], 2, nfun, U, to);
            frame_pull(&f, to, e);
        } else {
            frame_excess(&f, by[D_P], by[D_Q], e);
        }
        batch_spread(r->N[g], 2, nfun, r->weight[g], e, G);
    }
    batch_scatter(b, G, nfun, per_node, out);
}

LANES_KERNEL void patch_batch_turn(const struct patch *p, int index, const double *x, const double *u,
                                   const double *pulled, double *out);
LANES_KERNEL void patch_batch_turn(const struct patch *p, int index, const double *x, const double *u,
                                   const double *pulled, double *out)
{
    struct batch b;
    batch_open(p, index, &b);
    if (p->basis->kind == BASIS_HERMITE)
        batch_turn_of(&b, x, u, pulled, 16, 4, out);
    else
        batch_turn_of(&b, x, u, pulled, 9, 1, out);
}

/* Even stripes, then odd ones: sums in one order, as in patch.c. */
static void all_batches(const struct patch *p, const double *x, const double *u, const double *pulled, double *out)
{
#pragma omp parallel num_threads(p->d.threads) if (p->d.threads > 1)
    for (int parity = 0; parity < 2; parity++) {
#pragma omp for schedule(dynamic)
        for (int s = parity; s < p->nstripes; s += 2)
            for (int i = p->stripe[s]; i < p->stripe[s + 1]; i++)
                patch_batch_turn(p, i, x, u, pulled, out);
    }
}

void patch_retract(const struct discretisation *d, const double *x, double length, const double *dx, double *y)
{
    const struct patch *p = (const struct patch *)d;
    const double *u = increment(p, x, length, dx);
    double *right = p->retraction->right;
    memset(right, 0, sizeof *right * (size_t)d->n);
    all_batches(p, x, u, NULL, right);
    poisson_solve(p->retraction->poisson, right);
    for (int i = 0; i < d->n; i++)
        y[i] = x[i] + u[i] + right[i];
}

void patch_retract_adjoint(const struct discretisation *d, const double *x, double length, const double *dx,
                           const double *g, double *gu)
{
    const struct patch *p = (const struct patch *)d;
    const double *u = increment(p, x, length, dx);
    double *right = p->retraction->right;
    memcpy(right, g, sizeof *g * (size_t)d->n);
    memcpy(gu, g, sizeof *g * (size_t)d->n);
    poisson_solve(p->retraction->poisson, right);
    all_batches(p, x, u, right, gu);
    if (d->sheet->spring <= 0)
        remove_rigid(p, x, gu);
}
