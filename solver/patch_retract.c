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
 * elements.  With K Q = M Q diag(l), Q^T M Q = I for either direction,
 *     S^-1 = (Q (x) Q) diag(1/(l_i + l_j)) (Q (x) Q)^T
 * (Lynch, Rice and Thomas 1964), but for the constants, which stay where they are. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/patch_batch.h"
#include "solver/turn_kernel.h"

enum { GAUSS_TURN = 3 };        /* points a side; too few for the mass of a line of one element */

/* BLAS and LAPACK, column-major. */
void dgemm_(const char *transa, const char *transb, const int *m, const int *n, const int *k, const double *alpha,
            const double *a, const int *lda, const double *b, const int *ldb, const double *beta, double *c,
            const int *ldc);
void dposv_(const char *uplo, const int *n, const int *columns, double *a, const int *lda, double *b, const int *ldb,
            int *info);
void dsygv_(const int *type, const char *job, const char *uplo, const int *n, double *a, const int *lda, double *b,
            const int *ldb, double *w, double *work, const int *lwork, int *info);

/* The functions along one direction of the grid. */
struct line {
    int     n;
    double *Q;                  /* (n x n) columns: eigenvectors */
    double *l;                  /* (n) eigenvalues, rising from 0 */
};

struct retraction {
    int         gauss;          /* points a side; 0: nothing is made yet */
    double      weight[GAUSS_MAX * GAUSS_MAX];
    double      N[GAUSS_MAX * GAUSS_MAX][D_COUNT][BASIS_MAX];      /* of which D_P and D_Q are used */
    struct line line[2];        /* x, y */
    double     *u, *right;      /* (n) scratch */
    double     *grid;           /* (2 x 3 x ny x nx) scratch: components on the grid of functions */
};

/* K_ab = Int f_a' f_b' and M_ab = Int f_a f_b over elements of length h, by the Gauss rule of the excess: so
 * turning as a whole stays exact. */
static void line_matrices(const struct basis *basis, int gauss, int elements, double h, int n, double *K, double *M)
{
    double at[GAUSS_MAX], weight[GAUSS_MAX], f[BASIS_LINE][3];
    int step = basis->kind == BASIS_HERMITE ? 2 : 1;
    basis_gauss(gauss, at, weight);
    for (int g = 0; g < gauss; g++) {
        int count = basis_line(basis, at[g], f);
        for (int e = 0; e < elements; e++)
            for (int a = 0; a < count; a++)
                for (int b = 0; b < count; b++) {
                    int entry = (step * e + a) * n + step * e + b;
                    K[entry] += weight[g] * f[a][1] * f[b][1] / h;
                    M[entry] += weight[g] * f[a][0] * f[b][0] * h;
                }
    }
}

static void line_make(const struct basis *basis, int gauss, int elements, int nodes, double h, struct line *line)
{
    int n = basis->kind == BASIS_HERMITE ? 2 * nodes : nodes, type = 1, info, nwork = 64 * n;
    double *M = MEMORY_ARRAY(double, (size_t)n * (size_t)n), *work = MEMORY_ARRAY(double, nwork);
    *line = (struct line){n, MEMORY_ARRAY(double, (size_t)n * (size_t)n), MEMORY_ARRAY(double, n)};
    line_matrices(basis, gauss, elements, h, n, line->Q, M);
    dsygv_(&type, "V", "L", &n, line->Q, &n, M, &n, line->l, work, &nwork, &info);
    assert(info == 0);
    line->l[0] = 0;
    free(M), free(work);
}

/* What belongs to the level; made when first asked for. */
static struct retraction *prepare(const struct patch *p)
{
    struct retraction *r = p->retraction;
    if (r->gauss)
        return r;
    r->gauss = p->nx > 1 && p->ny > 1 ? GAUSS_TURN : GAUSS_MAX;
    patch_tabulate(p, r->gauss, r->weight, r->N);
    line_make(p->basis, r->gauss, p->nx, p->mx, p->hx, &r->line[0]);
    line_make(p->basis, r->gauss, p->ny, p->my, p->hy, &r->line[1]);
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
    for (int k = 0; k < 2; k++)
        free(r->line[k].Q), free(r->line[k].l);
    free(r->u);
    free(r->right);
    free(r->grid);
    free(r);
}

/* a (ny x nx, x fastest) := S^-1 a; b is scratch */
static void solve_component(const struct line *x, const struct line *y, double *a, double *b)
{
    const double one = 1, zero = 0;
    dgemm_("T", "N", &x->n, &y->n, &x->n, &one, x->Q, &x->n, a, &x->n, &zero, b, &x->n);
    dgemm_("N", "N", &x->n, &y->n, &y->n, &one, b, &x->n, y->Q, &y->n, &zero, a, &x->n);
    for (int j = 0; j < y->n; j++)
        for (int i = 0; i < x->n; i++)
            a[(size_t)j * (size_t)x->n + (size_t)i] *= i || j ? 1 / (x->l[i] + y->l[j]) : 0;
    dgemm_("N", "N", &x->n, &y->n, &x->n, &one, x->Q, &x->n, a, &x->n, &zero, b, &x->n);
    dgemm_("N", "T", &x->n, &y->n, &y->n, &one, b, &x->n, y->Q, &y->n, &zero, a, &x->n);
}

/* Between the unknowns v (n) and component c of the grid. */
static void carry(const struct patch *p, int c, double *v, double *a, bool back)
{
    int side = p->basis->kind == BASIS_HERMITE ? 2 : 1, nx = p->retraction->line[0].n;
    for (int node = 0; node < p->d.nnodes; node++) {
        double *from = v + p->per_node * p->place[node] + c;
        double *to = a + (size_t)(node / p->mx * side) * (size_t)nx + (size_t)(node % p->mx * side);
        for (int k = 0; k < p->basis->per_node; k++) {
            double *one = from + 3 * k, *other = to + k / 2 * nx + k % 2;
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
        solve_component(&r->line[0], &r->line[1], a, a + size);
        carry(p, c, v, a, true);
    }
}

/* ---- a free sheet: its motion as a whole is no part of an increment (it would turn what follows) ---- */

/* Unknowns k, k+1, k+2 under the six rigid motions: z[m] is the velocity in motion m; a node's first three are its
 * position, the others turn only. */
static void rigid_velocities(const struct patch *p, const double *x, int k, double z[6][3])
{
    bool position = k % p->per_node == 0;
    const double *r = x + k;
    memset(z, 0, 6 * sizeof *z);
    for (int m = 0; m < 3; m++) {
        z[m][m] = position;
        z[3 + m][(m + 1) % 3] = -r[(m + 2) % 3];
        z[3 + m][(m + 2) % 3] = r[(m + 1) % 3];
    }
}

/* v -= Z (Z^T Z)^-1 Z^T v, Z (n x 6) the rigid motions of state x. */
static void remove_rigid(const struct patch *p, const double *x, double *v)
{
    const int six = 6, one = 1;
    double gram[6][6] = {{0}}, part[6] = {0}, z[6][3];
    for (int k = 0; k < p->d.n; k += 3) {
        rigid_velocities(p, x, k, z);
        for (int m = 0; m < 6; m++)
            for (int c = 0; c < 3; c++) {
                part[m] += z[m][c] * v[k + c];
                for (int l = 0; l < 6; l++)
                    gram[m][l] += z[m][c] * z[l][c];
            }
    }
    int info;
    dposv_("L", &six, &one, &gram[0][0], &six, part, &six, &info);
    if (info != 0)
        return;
    for (int k = 0; k < p->d.n; k += 3) {
        rigid_velocities(p, x, k, z);
        for (int m = 0; m < 6; m++)
            for (int c = 0; c < 3; c++)
                v[k + c] -= part[m] * z[m][c];
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
