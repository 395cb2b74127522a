/* SPDX-License-Identifier: GPL-3.0-or-later
 * A right side in, the displacement whose first derivatives come closest to it out:
 * S^-1 on a grid of patches, S_ab = Int N_x^a N_x^b + N_y^a N_y^b.
 *
 * On the grid S = K (x) M + M (x) K, K and M the stiffness and mass of a line of
 * elements, three diagonals each side.  Across the shorter side K Q = M Q diag(l)
 * with Q^T M Q = I (Lynch, Rice and Thomas 1964); what is left along the longer one
 * is a band matrix K + l_i M for each mode i. */
#include "solver/patch_poisson.h"

#include <assert.h>
#include <stdlib.h>

#include "solver/memory.h"

/* BLAS and LAPACK, column-major. */
void dgemm_(const char *transa, const char *transb, const int *m, const int *n, const int *k, const double *alpha,
            const double *a, const int *lda, const double *b, const int *ldb, const double *beta, double *c,
            const int *ldc);
void dsbgv_(const char *job, const char *uplo, const int *n, const int *ka, const int *kb, double *a, const int *lda,
            double *b, const int *ldb, double *w, double *z, const int *ldz, double *work, int *info);
void dpbtrf_(const char *uplo, const int *n, const int *k, double *a, const int *lda, int *info);

enum { REACH = BASIS_LINE - 1, BAND = REACH + 1 };     /* diagonals below the main one; with it */
enum { SHARES = 12 };           /* of the rows of a product, so that its bits do not depend on the threads */

struct poisson {
    const struct patch *patch;
    bool         x_is_long;
    int          across, along;     /* functions of the shorter side's lines and of the longer one's */
    double      *Q;                 /* (across x across) columns: modes */
    double      *factor;            /* (across x along x BAND) Cholesky factor of each mode's band, 1/L_jj first */
    double      *grid, *modes;      /* (across x 3 x along) scratch: functions, then modes, across; components */
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
static void find_modes(struct poisson *s, double *K, double *M, double *l)
{
    const int n = s->across, reach = REACH, band = BAND;
    double *work = MEMORY_ARRAY(double, 3 * n);
    int info;
    dsbgv_("V", "L", &n, &reach, &reach, K, &band, M, &band, l, s->Q, &n, work, &info);
    assert(info == 0);
    free(work);
}

/* K + l_i M along, factored for each mode; the first is pinned at its end: it holds the constants. */
static void factor_modes(struct poisson *s, const double *K, const double *M, const double *l)
{
    const int n = s->along, reach = REACH, band = BAND;
    for (int i = 0; i < s->across; i++) {
        double *A = s->factor + (size_t)i * (size_t)n * BAND;
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

static void make_modes(struct poisson *s, int gauss)
{
    const struct patch *p = s->patch;
    int side = p->basis->kind == BASIS_HERMITE ? 2 : 1;
    s->x_is_long = p->nx > p->ny;
    s->across = side * (s->x_is_long ? p->my : p->mx);
    s->along = side * (s->x_is_long ? p->mx : p->my);
    s->Q = MEMORY_ARRAY(double, (size_t)s->across * (size_t)s->across);
    s->factor = MEMORY_ARRAY(double, (size_t)s->across * (size_t)s->along * BAND);
    double *K[2], *M[2], *l = MEMORY_ARRAY(double, s->across);
    for (int k = 0; k < 2; k++) {
        bool x = s->x_is_long == k;     /* first across, then along */
        K[k] = MEMORY_ARRAY(double, BAND * (k ? s->along : s->across));
        M[k] = MEMORY_ARRAY(double, BAND * (k ? s->along : s->across));
        line_matrices(p->basis, gauss, x ? p->nx : p->ny, x ? p->hx : p->hy, K[k], M[k]);
    }
    find_modes(s, K[0], M[0], l);
    factor_modes(s, K[1], M[1], l);
    for (int k = 0; k < 2; k++)
        free(K[k]), free(M[k]);
    free(l);
}

struct poisson *poisson_make(const struct patch *p, int gauss)
{
    struct poisson *s = MEMORY_ARRAY(struct poisson, 1);
    s->patch = p;
    make_modes(s, gauss);
    s->grid = MEMORY_ARRAY(double, p->d.n);
    s->modes = MEMORY_ARRAY(double, p->d.n);
    return s;
}

void poisson_free(struct poisson *s)
{
    if (!s)
        return;
    free(s->Q);
    free(s->factor);
    free(s->grid);
    free(s->modes);
    free(s);
}

/* b (3 x n) := (L L^T)^-1 b.  LAPACK calls the BLAS for every row, which is longer than its few multiplications
 * take; three columns at once hide how each row waits for the one before. */
static void band_solve(const double (*L)[BAND], int n, double *b)
{
    double *x = b, *y = b + n, *z = b + 2 * n;
    for (int j = 0; j < n; j++) {
        x[j] *= L[j][0], y[j] *= L[j][0], z[j] *= L[j][0];
        for (int k = 1; k < BAND && j + k < n; k++)
            x[j + k] -= L[j][k] * x[j], y[j + k] -= L[j][k] * y[j], z[j + k] -= L[j][k] * z[j];
    }
    for (int j = n - 1; j >= 0; j--) {
        for (int k = 1; k < BAND && j + k < n; k++)
            x[j] -= L[j][k] * x[j + k], y[j] -= L[j][k] * y[j + k], z[j] -= L[j][k] * z[j + k];
        x[j] *= L[j][0], y[j] *= L[j][0], z[j] *= L[j][0];
    }
}

/* to := from Q, or from Q^T, for one share of the rows (component and place along). */
static void change_modes(const struct poisson *s, const char *transposed, int share, const double *from, double *to)
{
    const int m = s->across, n = 3 * s->along, first = n * share / SHARES, rows = n * (share + 1) / SHARES - first;
    const double one = 1, zero = 0;
    if (rows > 0)
        dgemm_("N", transposed, &rows, &m, &m, &one, from + first, &n, s->Q, &m, &zero, to + first, &n);
}

/* Between a node's unknowns in v (n) and the grid of functions. */
static void carry_node(const struct poisson *s, int node, double *v, bool back)
{
    const struct patch *p = s->patch;
    int side = p->basis->kind == BASIS_HERMITE ? 2 : 1;
    size_t column = 3 * (size_t)s->along, x = s->x_is_long ? 1 : column, y = s->x_is_long ? column : 1;
    double *of_node = v + p->per_node * p->place[node];
    double *to = s->grid + (size_t)(node % p->mx * side) * x + (size_t)(node / p->mx * side) * y;
    for (int k = 0; k < p->basis->per_node; k++)
        for (int c = 0; c < 3; c++) {
            double *one = of_node + 3 * k + c;
            double *other = to + (size_t)(k % 2) * x + (size_t)(k / 2) * y + (size_t)(c * s->along);
            *(back ? one : other) = *(back ? other : one);
        }
}

void poisson_solve(struct poisson *s, double *v)
{
    const struct discretisation *d = &s->patch->d;
    const size_t column = 3 * (size_t)s->along, band = (size_t)s->along;
#pragma omp parallel num_threads(d->threads) if (d->threads > 1)
    {
#pragma omp for
        for (int node = 0; node < d->nnodes; node++)
            carry_node(s, node, v, false);
#pragma omp for
        for (int share = 0; share < SHARES; share++)
            change_modes(s, "N", share, s->grid, s->modes);
#pragma omp for
        for (int i = 0; i < s->across; i++)
            band_solve((const double(*)[BAND])s->factor + (size_t)i * band, s->along, s->modes + (size_t)i * column);
#pragma omp for
        for (int share = 0; share < SHARES; share++)
            change_modes(s, "T", share, s->modes, s->grid);
#pragma omp for
        for (int node = 0; node < d->nnodes; node++)
            carry_node(s, node, v, true);
    }
}
