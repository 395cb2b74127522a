/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sheet and state in; energy, gradient and Hessian of C1 patches out: gather
 * eight elements, compute at Gauss points, scatter. */
#include "solver/patch.h"

#include <stdlib.h>
#include <string.h>

#include "solver/patch_batch.h"
#include "solver/patch_kernel.h"

enum { WORTH_THREADS = 200 };      /* elements from which a second thread helps */

/* ---- one batch of eight elements ---- */

/* The natural curvatures of a batch's stitches, grown. */
LANES_INLINE struct tensor batch_curvature(const struct batch *b, double growth)
{
    const struct sheet *sheet = b->patch->d.sheet;
    struct tensor b0;
    for (int l = 0; l < LANES; l++) {
        size_t stitch = patch_stitch(b->patch, b->element[l]);
        b0.xx[l] = growth * sheet->kx[stitch];
        b0.yy[l] = growth * sheet->ky[stitch];
        b0.xy[l] = growth * sheet->twist[stitch];
    }
    return b0;
}

/* e = Sum_g w (1/2 S:E + 1/2 M:B); G_a += Sum_g w N_i^a de/dd_i */
LANES_INLINE void batch_energy_of(const struct batch *b, const double *x, double growth, int nfun, int per_node,
                                  double *gradient, double energy[2])
{
    const struct patch *p = b->patch;
    struct vec X[BASIS_MAX], G[BASIS_MAX] = {{.x = {0}}};
    struct tensor b0 = batch_curvature(b, growth);
    lanes stretching = {0}, bending = {0};
    batch_gather(b, x, nfun, per_node, X);
    for (int g = 0; g < p->ngauss; g++) {
        struct vec d[D_COUNT], f[D_COUNT];
        batch_derive(p->N[g], D_COUNT, nfun, X, d);
        struct point at = point_forms(&p->plate, d, &b0);
        lanes w = lanes_set(p->weight[g]);
        stretching += 0.5 * w * tensor_dot(at.S, at.E);
        bending += 0.5 * w * tensor_dot(at.M, at.B);
        if (!gradient)
            continue;
        point_gradient(&at, d, f);
        batch_spread(p->N[g], D_COUNT, nfun, p->weight[g], f, G);
    }
    energy[0] = energy[1] = 0;
    for (int l = 0; l < b->count; l++)
        energy[0] += stretching[l], energy[1] += bending[l];
    if (gradient)
        batch_scatter(b, G, nfun, per_node, gradient);
}

LANES_KERNEL void patch_batch_energy(const struct patch *p, int index, const double *x, double growth,
                                     double *gradient, double *energy);
LANES_KERNEL void patch_batch_energy(const struct patch *p, int index, const double *x, double growth,
                                     double *gradient, double *energy)
{
    struct batch b;
    batch_open(p, index, &b);
    if (p->basis->kind == BASIS_HERMITE)
        batch_energy_of(&b, x, growth, 16, 4, gradient, energy);
    else
        batch_energy_of(&b, x, growth, 9, 1, gradient, energy);
}

/* T_i = Sum_j K_ij N_j^b, the Hessian at a Gauss point applied to function b, for i = p, q, r_xx, r_yy, r_xy. */
LANES_INLINE void point_apply(const struct patch *p, int g, const struct point_hessian *K, int b, mat3 T[D_COUNT])
{
    const double(*N)[BASIS_MAX] = p->N[g];
    double w = p->weight[g], P = w * N[D_P][b], Q = w * N[D_Q][b];
    double xx = w * N[D_XX][b], yy = w * N[D_YY][b], xy = w * N[D_XY][b];
    double b11 = p->plate.b1 + p->plate.b2, b12 = p->plate.b1, b33 = 2 * p->plate.b2;
    double C[3] = {b11 * xx + b12 * yy, b12 * xx + b11 * yy, b33 * xy};
    static const int symmetric[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            T[D_P][i][j] = P * K->pp[i][j] + Q * K->pq[i][j] + xx * K->kp[0][j][i] + yy * K->kp[1][j][i] +
                           xy * K->kp[2][j][i];
            T[D_Q][i][j] = P * K->pq[j][i] + Q * K->qq[i][j] + xx * K->kq[0][j][i] + yy * K->kq[1][j][i] +
                           xy * K->kq[2][j][i];
            for (int k = 0; k < 3; k++)
                T[D_XX + k][i][j] = P * K->kp[k][i][j] + Q * K->kq[k][i][j] + C[k] * K->nn[symmetric[i][j]];
        }
}

/* Adds the 3x3 blocks of functions a (rows) and b (columns) to the lower triangle. */
LANES_INLINE void block_scatter(const struct batch *b, int fa, int fb, int per_node, const mat3 H, double *value)
{
    const struct patch *p = b->patch;
    int na = fa / per_node, nb = fb / per_node, ka = 3 * (fa % per_node), kb = 3 * (fb % per_node);
    for (int l = 0; l < b->count; l++) {
        int I = b->first[l][na], J = b->first[l][nb];
        int off = patch_offset(p, b->element[l], na, nb);
        bool transposed = I < J;
        int column = transposed ? I + ka : J + kb, row = transposed ? kb : ka;
        for (int j = 0; j < 3; j++) {
            double *v = value + p->d.pattern.start[column + j] + off + row - ((transposed ? ka : kb) + j);
            for (int i = I == J && ka == kb ? j : 0; i < 3; i++)
                v[i] += transposed ? H[j][i][l] : H[i][j][l];
        }
    }
}

/* H_ab = Sum_g w Sum_ij N_i^a K_ij N_j^b, a >= b */
LANES_INLINE void batch_hessian_of(const struct batch *b, const double *x, double growth, int nfun, int per_node,
                                   int exact, double *value)
{
    const struct patch *p = b->patch;
    struct vec X[BASIS_MAX];
    struct tensor b0 = batch_curvature(b, growth);
    struct point_hessian K[GAUSS_MAX * GAUSS_MAX];
    batch_gather(b, x, nfun, per_node, X);
    for (int g = 0; g < p->ngauss; g++) {
        struct vec d[D_COUNT];
        batch_derive(p->N[g], D_COUNT, nfun, X, d);
        struct point at = point_forms(&p->plate, d, &b0);
        point_second(&p->plate, &at, d, exact, &K[g]);
    }
    for (int fb = 0; fb < nfun; fb++) {
        mat3 T[GAUSS_MAX * GAUSS_MAX][D_COUNT];
        for (int g = 0; g < p->ngauss; g++)
            point_apply(p, g, &K[g], fb, T[g]);
        for (int fa = fb; fa < nfun; fa++) {
            mat3 H = {{{0}}};
            for (int g = 0; g < p->ngauss; g++)
                for (int i = 0; i < D_COUNT; i++)
                    for (int e = 0; e < 9; e++)
                        (&H[0][0])[e] += p->N[g][i][fa] * (&T[g][i][0][0])[e];
            block_scatter(b, fa, fb, per_node, H, value);
        }
    }
}

LANES_KERNEL void patch_batch_hessian(const struct patch *p, int index, const double *x, double growth, int exact,
                                      double *value);
LANES_KERNEL void patch_batch_hessian(const struct patch *p, int index, const double *x, double growth, int exact,
                                      double *value)
{
    struct batch b;
    batch_open(p, index, &b);
    if (p->basis->kind == BASIS_HERMITE)
        batch_hessian_of(&b, x, growth, 16, 4, exact, value);
    else
        batch_hessian_of(&b, x, growth, 9, 1, exact, value);
}

/* ---- all batches: even stripes, then odd ones.  No two stripes of a parity share an unknown,
 *      so sums come in one order whatever the number of threads ---- */

static struct fold_energy patch_energy(const struct discretisation *d, const double *restrict x, double growth,
                                       double *restrict gradient)
{
    const struct patch *p = (const struct patch *)d;
#pragma omp parallel num_threads(d->threads) if (d->threads > 1)
    for (int parity = 0; parity < 2; parity++) {
#pragma omp for schedule(dynamic)
        for (int s = parity; s < p->nstripes; s += 2)
            for (int i = p->stripe[s]; i < p->stripe[s + 1]; i++)
                patch_batch_energy(p, i, x, growth, gradient, p->energy + 2 * i);
    }
    struct fold_energy e = {0};
    for (int i = 0; i < p->nbatches; i++)
        e.stretching += p->energy[2 * i], e.bending += p->energy[2 * i + 1];
    if (p->springs.count)
        e.springs = springs_energy(&p->springs, x, gradient);
    e.total = e.stretching + e.bending + e.springs;
    return e;
}

static void patch_hessian(const struct discretisation *d, const double *restrict x, double growth,
                          enum hessian_kind kind, double *restrict value)
{
    const struct patch *p = (const struct patch *)d;
#pragma omp parallel num_threads(d->threads) if (d->threads > 1)
    {
#pragma omp for schedule(static)
        for (int j = 0; j < d->n; j++)
            memset(value + d->pattern.start[j], 0,
                   sizeof *value * (size_t)(d->pattern.start[j + 1] - d->pattern.start[j]));
        for (int parity = 0; parity < 2; parity++) {
#pragma omp for schedule(dynamic)
            for (int s = parity; s < p->nstripes; s += 2)
                for (int i = p->stripe[s]; i < p->stripe[s + 1]; i++)
                    patch_batch_hessian(p, i, x, growth, kind == HESSIAN_EXACT, value);
        }
    }
    if (p->springs.count)
        springs_hessian(&p->springs, value);
}

static void patch_free(struct discretisation *d)
{
    patch_grid_free((struct patch *)d);
}

#define PATCH_OPS(name)                                                                                               \
    {                                                                                                                 \
        .kind = name, .flat = patch_flat, .energy = patch_energy, .hessian = patch_hessian, .mass = patch_mass,       \
        .prolong = patch_prolong, .restrict_gradient = patch_restrict, .restrict_hessian = patch_restrict_hessian,           \
        .retract = patch_retract, .retract_adjoint = patch_retract_adjoint, .sample = patch_sample, .doubt = patch_doubt,                                                                 \
        .free = patch_free                                                                                            \
    }

static const struct discretisation_ops patch_ops = PATCH_OPS("patch"), spline_ops = PATCH_OPS("spline");

struct discretisation *patch_make(const struct sheet *sheet, const struct basis *basis, int per_stitch, int gauss,
                                  int threads)
{
    struct patch *p = patch_grid_make(sheet, basis, per_stitch, gauss);
    p->d.op = basis->kind == BASIS_HERMITE ? &patch_ops : &spline_ops;
    p->d.threads = p->d.elements < WORTH_THREADS ? 1 : threads;
    patch_springs(p);
    return &p->d;
}
