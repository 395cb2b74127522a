/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state and an increment in, the state it leads to along turning pieces out
 * (a retraction, as in rotation-strain coordinates: Huang et al. 2011).
 *
 * Straight lines stretch a sheet that turns, so a step along one is soon too
 * long.  Here every point's frame turns by exp(w), w the spin of the increment
 * there, and the surface is the one whose derivatives come closest to those of
 * the turned frames,
 *     y = x + u + S^-1 Sum_g w_g (N_x e_p + N_y e_q),  S_ab = Int N_x^a N_x^b + N_y^a N_y^b,
 * e the excess of the second order (turn_kernel.h).
 *
 * On the grid S = K (x) M + M (x) K, K and M the stiffness and mass of a line of
 * elements, three diagonals each side.  Across the shorter side K Q = M Q diag(l)
 * with Q^T M Q = I (Lynch, Rice and Thomas 1964); what is left along the longer one
 * is a band matrix K + l_i M for each mode i. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/patch_batch.h"
#include "solver/rigid.h"
#include "solver/turn_kernel.h"

enum { GAUSS_TURN = 3 };        /* points a side; too few for the mass of a line of one element */

/* BLAS and LAPACK, column-major. */
void dgemm_(const char *transa, const char *transb, const int *m, const int *n, const int *k, const double *alpha,
            const double *a, const int *lda, const double *b, const int *ldb, const double *beta, double *c,
            const int *ldc);
void dposv_(const char *uplo, const int *n, const int *columns, double *a, const int *lda, double *b, const int *ldb,
            int *info);
void dsbgv_(const char *job, const char *uplo, const int *n, const int *ka, const int *kb, double *a, const int *lda,
            double *b, const int *ldb, double *w, double *z, const int *ldz, double *work, int *info);
void dpbtrf_(const char *uplo, const int *n, const int *k, double *a, const int *lda, int *info);

enum { REACH = BASIS_LINE - 1, BAND = REACH + 1 };     /* diagonals below the main one; with it */

struct retraction {
    int         gauss;          /* points a side; 0: nothing is made yet */
    double      weight[GAUSS_MAX * GAUSS_MAX];
    double      N[GAUSS_MAX * GAUSS_MAX][D_COUNT][BASIS_MAX];      /* of which D_P and D_Q are used */
    bool        x_is_long;
    int         across, along;  /* functions of the shorter side's lines and of the longer one's */
    double     *Q;              /* (across x across) columns: modes */
    double     *factor;         /* (across x along x BAND) Cholesky factor of each mode's band, 1/L_jj first */
    double     *u, *right;      /* (n) scratch */
    double     *grid;           /* (2 x 3 x across x along) scratch: components on the grid of functions */
};

/* K_ab = Int f_a' f_b' and M_ab = Int f_a f_b over elements of length h, (n x BAND) by lower diagonals; by the Gauss
 * rule of the excess, so that turning as a whole stays exact. */
static void line_matrices(const struct basis *basis, int gauss, int elements, double h, double *K, double *M)
{
    double at[GAUSS_MAX], weight[GAUSS_MAX], f[BASIS_LINE][3];
    int step = basis->kind == BASIS_HERMITE ? 2 : 1;
    basis_gauss(gauss, at, weight);
    for (int g = 0; g < gauss; g++) {
        int count = basis_line(basis, at[g], f);
        for (int e = 0; e < elements; e++)
            for (int b = 0; b < count; b++)
                for (int a = b; a < count; a++) {
                    int entry = (step * e + b) * BAND + a - b;
                    K[entry] += weight[g] * f[a][1] * f[b][1] / h;
                    M[entry] += weight[g] * f[a][0] * f[b][0] * h;
                }
    }
}

/* The modes across and their eigenvalues l (across), rising from 0. */
static void find_modes(struct retraction *r, double *K, double *M, double *l)
{
    const int n = r->across, reach = REACH, band = BAND;
    double *work = MEMORY_ARRAY(double, 3 * n);
    int info;
    dsbgv_("V", "L", &n, &reach, &reach, K, &band, M, &band, l, r->Q, &n, work, &info);
    assert(info == 0);
    free(work);
}

/* K + l_i M along, factored for each mode; the first is pinned at its end: it holds the constants. */
static void factor_modes(struct retraction *r, const double *K, const double *M, const double *l)
{
    const int n = r->along, reach = REACH, band = BAND;
    for (int i = 0; i < r->across; i++) {
        double *A = r->factor + (size_t)i * (size_t)n * BAND;
        int info;
        for (int k = 0; k < n * BAND; k++)
            A[k] = K[k] + (i ? l[i] : 0) * M[k];
        if (i == 0)
            A[0] *= 2;
        dpbtrf_("L", &n, &reach, A, &band, &info);
        assert(info == 0);
        for (int j = 0; j < n; j++)
            A[j * BAND] = 1 / A[j * BAND];
    }
}

static void make_modes(const struct patch *p, struct retraction *r)
{
    int side = p->basis->kind == BASIS_HERMITE ? 2 : 1;
    r->x_is_long = p->nx > p->ny;
    r->across = side * (r->x_is_long ? p->my : p->mx);
    r->along = side * (r->x_is_long ? p->mx : p->my);
    r->Q = MEMORY_ARRAY(double, (size_t)r->across * (size_t)r->across);
    r->factor = MEMORY_ARRAY(double, (size_t)r->across * (size_t)r->along * BAND);
    double *K[2], *M[2], *l = MEMORY_ARRAY(double, r->across);
    for (int k = 0; k < 2; k++) {
        bool x = r->x_is_long == k;     /* first across, then along */
        K[k] = MEMORY_ARRAY(double, BAND * (k ? r->along : r->across));
        M[k] = MEMORY_ARRAY(double, BAND * (k ? r->along : r->across));
        line_matrices(p->basis, r->gauss, x ? p->nx : p->ny, x ? p->hx : p->hy, K[k], M[k]);
    }
    find_modes(r, K[0], M[0], l);
    factor_modes(r, K[1], M[1], l);
    for (int k = 0; k < 2; k++)
        free(K[k]), free(M[k]);
    free(l);
}

/* What belongs to the level; made when first asked for. */
static struct retraction *prepare(const struct patch *p)
{
    struct retraction *r = p->retraction;
    if (r->gauss)
        return r;
    r->gauss = p->nx > 1 && p->ny > 1 ? GAUSS_TURN : GAUSS_MAX;
    patch_tabulate(p, r->gauss, r->weight, r->N);
    make_modes(p, r);
    r->u = MEMORY_ARRAY(double, p->d.n);
    r->right = MEMORY_ARRAY(double, p->d.n);
    r->grid = MEMORY_ARRAY(double, 2 * p->d.n);
    return r;
}

struct retraction *patch_retraction_make(void)
{
    return MEMORY_ARRAY(struct retraction, 1);
}

void patch_retraction_free(struct retraction *r)
{
    free(r->Q);
    free(r->factor);
    free(r->u);
    free(r->right);
    free(r->grid);
    free(r);
}

/* b (n) := (L L^T)^-1 b.  LAPACK calls the BLAS for every row, which is longer than three multiplications take. */
static void band_solve(const double (*L)[BAND], int n, double *b)
{
    for (int j = 0; j < n; j++) {
        b[j] *= L[j][0];
        for (int k = 1; k < BAND && j + k < n; k++)
            b[j + k] -= L[j][k] * b[j];
    }
    for (int j = n - 1; j >= 0; j--) {
        for (int k = 1; k < BAND && j + k < n; k++)
            b[j] -= L[j][k] * b[j + k];
        b[j] *= L[j][0];
    }
}

/* a (across x along, the longer side fastest) := S^-1 a; b is scratch */
static void solve_component(const struct retraction *r, double *a, double *b)
{
    const double one = 1, zero = 0;
    const int m = r->across, n = r->along;
    dgemm_("N", "N", &n, &m, &m, &one, a, &n, r->Q, &m, &zero, b, &n);
    for (size_t i = 0; i < (size_t)m; i++)
        band_solve((const double(*)[BAND])(r->factor + i * (size_t)n * BAND), n, b + i * (size_t)n);
    dgemm_("N", "T", &n, &m, &m, &one, b, &n, r->Q, &m, &zero, a, &n);
}

/* Between component c of the unknowns v (n) and the grid of functions. */
static void carry(const struct patch *p, int c, double *v, double *a, bool back)
{
    const struct retraction *r = p->retraction;
    int side = p->basis->kind == BASIS_HERMITE ? 2 : 1;
    size_t x = r->x_is_long ? 1 : (size_t)r->along, y = r->x_is_long ? (size_t)r->along : 1;
    for (int node = 0; node < p->d.nnodes; node++) {
        double *from = v + p->per_node * p->place[node] + c;
        double *to = a + (size_t)(node % p->mx * side) * x + (size_t)(node / p->mx * side) * y;
        for (int k = 0; k < p->basis->per_node; k++) {
            double *one = from + 3 * k, *other = to + (size_t)(k % 2) * x + (size_t)(k / 2) * y;
            *(back ? one : other) = *(back ? other : one);
        }
    }
}

/* v := S^-1 v for each of the three components */
static void solve(const struct patch *p, double *v)
{
    const struct retraction *r = p->retraction;
    size_t size = (size_t)(p->d.n / 3);
#pragma omp parallel for num_threads(p->d.threads) if (p->d.threads > 1)
    for (int c = 0; c < 3; c++) {
        double *a = r->grid + 2 * size * (size_t)c;
        carry(p, c, v, a, false);
        solve_component(r, a, a + size);
        carry(p, c, v, a, true);
    }
}

/* ---- a free sheet: its motion as a whole is no part of an increment (it would turn what follows) ---- */

/* Coordinate c of the vector at unknowns k .. k+2 under the six rigid motions: slopes and twists turn only. */
static void velocity(const struct patch *p, const double *x, int k, int c, double z[6])
{
    rigid_velocity(x + k, c, z);
    if (k % p->per_node != 0)
        memset(z, 0, 3 * sizeof *z);
}

/* v -= Z (Z^T Z)^-1 Z^T v, Z (n x 6) the rigid motions of state x. */
static void remove_rigid(const struct patch *p, const double *x, double *v)
{
    const int six = 6, one = 1;
    double gram[6][6] = {{0}}, part[6] = {0}, z[6];
    for (int k = 0; k < p->d.n; k += 3)
        for (int c = 0; c < 3; c++) {
            velocity(p, x, k, c, z);
            for (int m = 0; m < 6; m++) {
                part[m] += z[m] * v[k + c];
                for (int l = 0; l < 6; l++)
                    gram[m][l] += z[m] * z[l];
            }
        }
    int info;
    dposv_("L", &six, &one, &gram[0][0], &six, part, &six, &info);
    if (info != 0)      /* a sheet without extent turns about nothing */
        return;
    for (int k = 0; k < p->d.n; k += 3)
        for (int c = 0; c < 3; c++) {
            velocity(p, x, k, c, z);
            for (int m = 0; m < 6; m++)
                v[k + c] -= part[m] * z[m];
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
    solve(p, right);
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
    solve(p, right);
    all_batches(p, x, u, right, gu);
    if (d->sheet->spring <= 0)
        remove_rigid(p, x, gu);
}
