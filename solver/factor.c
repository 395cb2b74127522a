/* SPDX-License-Identifier: GPL-3.0-or-later
 * Pattern and values in, triangular solves out; the only user of CHOLMOD.
 *
 * A matrix ordered as [A, B, S], where A and B couple through the separator S
 * alone, is factored as two matrices [A, S] and [B, S], each with the whole of
 * H_SS.  Their last blocks are L1 L1^T = H_SS - U1 and L2 L2^T = H_SS - U2, U the
 * update from each side, so what is left to factor densely is
 *     H_SS - U1 - U2 = L1 L1^T + L2 L2^T - H_SS,
 * and all of these are positive definite exactly when H is. */
#include "config.h"

#include "solver/factor.h"

#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif
#ifdef HAVE_SUITESPARSE_CHOLMOD_H
#include <suitesparse/cholmod.h>
#else
#include <cholmod.h>
#endif

#include <stdio.h>
#include <stdlib.h>

#include "solver/memory.h"

/* Threads are ours: where the BLAS is OpenBLAS it is told to use one. */
extern void openblas_set_num_threads(int threads) __attribute__((weak));

/* BLAS and LAPACK, column-major. */
void dpotrf_(const char *uplo, const int *n, double *a, const int *lda, int *info);
void dsyrk_(const char *uplo, const char *trans, const int *n, const int *k, const double *alpha, const double *a,
            const int *lda, const double *beta, double *c, const int *ldc);
void dtrmv_(const char *uplo, const char *trans, const char *diag, const int *n, const double *a, const int *lda,
            double *x, const int *incx);
void dtrsv_(const char *uplo, const char *trans, const char *diag, const int *n, const double *a, const int *lda,
            double *x, const int *incx);

/* One matrix for CHOLMOD: the columns [first, first + own) and the separator's. */
struct piece {
    cholmod_common  common;
    cholmod_sparse  matrix;         /* a view of the values; rows renumbered */
    cholmod_factor *L;
    cholmod_dense  *x, *y, *e;      /* kept between solves */
    int             first, own;
    double         *b;              /* (own + ns) right side and result */
    double         *Lss;            /* (ns x ns) last block of the factor */
    double         *product;        /* (ns x ns) Lss Lss^T */
    enum factor_result result;
};

struct factor {
    const struct pattern *pattern;
    bool         ordered;
    int          threads, npieces;
    int          n, ns;             /* unknowns, those of the separator; they come last */
    struct piece piece[2];
    double      *S;                 /* (ns x ns) dense factor of what the pieces leave */
};

/* CHOLMOD as built by Debian runs its supernodal loops on 4 OpenMP threads
 * fixed at compile time; no further level of parallelism keeps them to one. */
static int quiet_begin(int levels)
{
#ifdef _OPENMP
    int before = omp_get_max_active_levels();
    omp_set_max_active_levels(levels);
    return before;
#else
    return levels;
#endif
}

static void quiet_end(int levels)
{
#ifdef _OPENMP
    omp_set_max_active_levels(levels);
#else
    (void)levels;
#endif
}

static void choose_order(cholmod_common *common, bool ordered)
{
    common->supernodal = CHOLMOD_SUPERNODAL;
    common->final_ll = 1;
    common->print = 0;
    common->quick_return_if_not_posdef = 1;
    if (ordered) {
        common->nmethods = 1;
        common->method[0].ordering = CHOLMOD_NATURAL;
        common->postorder = 0;
    }
}

/* Columns stay where they are in the values: only starts, counts and row
 * numbers are the piece's own. */
static void view_columns(struct factor *f, struct piece *piece)
{
    const struct pattern *pattern = f->pattern;
    int last = f->n - f->ns, n = piece->own + f->ns, nonzeros = pattern->start[f->n];
    int *start = MEMORY_ARRAY(int, n + 1), *count = MEMORY_ARRAY(int, n), *row = MEMORY_ARRAY(int, nonzeros);
    for (int j = 0; j < n; j++) {
        int column = j < piece->own ? piece->first + j : last + j - piece->own;
        start[j] = pattern->start[column];
        count[j] = pattern->start[column + 1] - start[j];
        for (int k = start[j]; k < start[j] + count[j]; k++)
            row[k] = pattern->row[k] < last ? pattern->row[k] - piece->first : pattern->row[k] - last + piece->own;
    }
    start[n] = nonzeros;
    piece->matrix = (cholmod_sparse){.nrow = (size_t)n, .ncol = (size_t)n, .nzmax = (size_t)nonzeros, .p = start,
                                     .i = row, .nz = count, .stype = -1, .itype = CHOLMOD_INT,
                                     .xtype = CHOLMOD_PATTERN, .dtype = CHOLMOD_DOUBLE, .sorted = 1, .packed = 0};
}

static bool piece_analyse(struct factor *f, struct piece *piece, int first, int own)
{
    piece->first = first;
    piece->own = own;
    cholmod_start(&piece->common);
    choose_order(&piece->common, f->ordered);
    view_columns(f, piece);
    piece->L = cholmod_analyze(&piece->matrix, &piece->common);
    piece->matrix.xtype = CHOLMOD_REAL;
    piece->b = MEMORY_ARRAY(double, own + f->ns);
    size_t square = (size_t)f->ns * (size_t)f->ns;
    piece->Lss = MEMORY_ARRAY(double, square);
    piece->product = MEMORY_ARRAY(double, square);
    return piece->L;
}

struct factor *factor_make(const struct pattern *pattern, bool ordered, const int parts[2], int threads)
{
    struct factor *f = MEMORY_ARRAY(struct factor, 1);
    *f = (struct factor){.pattern = pattern, .ordered = ordered, .threads = threads, .n = pattern->n, .npieces = 1};
    if (openblas_set_num_threads)
        openblas_set_num_threads(1);
    int levels = quiet_begin(0);
    bool made;
    if (parts[0] > 0) {
        f->npieces = 2;
        f->ns = f->n - parts[1];
        f->S = MEMORY_ARRAY(double, (size_t)f->ns * (size_t)f->ns);
        made = piece_analyse(f, &f->piece[0], 0, parts[0]);
        made = piece_analyse(f, &f->piece[1], parts[0], parts[1] - parts[0]) && made;
    } else {
        made = piece_analyse(f, &f->piece[0], 0, f->n);
    }
    quiet_end(levels);
    if (made)
        return f;
    factor_free(f);
    return NULL;
}

static void piece_free(struct piece *piece)
{
    cholmod_free_dense(&piece->x, &piece->common);
    cholmod_free_dense(&piece->y, &piece->common);
    cholmod_free_dense(&piece->e, &piece->common);
    cholmod_free_factor(&piece->L, &piece->common);
    cholmod_finish(&piece->common);
    free(piece->matrix.p);
    free(piece->matrix.i);
    free(piece->matrix.nz);
    free(piece->b);
    free(piece->Lss);
    free(piece->product);
}

void factor_free(struct factor *f)
{
    if (!f)
        return;
    for (int k = 0; k < f->npieces; k++)
        piece_free(&f->piece[k]);
    free(f->S);
    free(f);
}

/* The separator's columns of the supernodal factor, as a dense lower triangle. */
static void take_last_block(struct piece *piece, int ns)
{
    const cholmod_factor *L = piece->L;
    const int *super = L->super, *start = L->pi, *values = L->px, *row = L->s;
    for (int s = (int)L->nsuper - 1; s >= 0 && super[s + 1] > piece->own; s--) {
        int height = start[s + 1] - start[s];
        for (int j = super[s]; j < super[s + 1]; j++) {
            if (j < piece->own)
                continue;
            const double *column = (const double *)L->x + values[s] + (size_t)(j - super[s]) * (size_t)height;
            for (int k = j - super[s]; k < height; k++)
                piece->Lss[(size_t)(j - piece->own) * (size_t)ns + (size_t)(row[start[s] + k] - piece->own)] =
                    column[k];
        }
    }
}

static void piece_factor(struct piece *piece, const double *value, int ns)
{
    const double one = 1, zero = 0;
    piece->matrix.x = (void *)value;
    int done = cholmod_factorize(&piece->matrix, piece->L, &piece->common);
    if (piece->common.status == CHOLMOD_OUT_OF_MEMORY || piece->common.status == CHOLMOD_TOO_LARGE)
        piece->result = FACTOR_NO_MEMORY;
    else
        piece->result = done && piece->common.status == CHOLMOD_OK ? FACTOR_DONE : FACTOR_INDEFINITE;
    if (ns == 0 || piece->result != FACTOR_DONE)
        return;
    take_last_block(piece, ns);
    dsyrk_("L", "N", &ns, &ns, &one, piece->Lss, &ns, &zero, piece->product, &ns);
}

static enum factor_result join(struct factor *f, const double *value)
{
    const struct pattern *pattern = f->pattern;
    int last = f->n - f->ns, info;
    for (size_t i = 0; i < (size_t)f->ns * (size_t)f->ns; i++)
        f->S[i] = f->piece[0].product[i] + f->piece[1].product[i];
    for (int j = last; j < f->n; j++)
        for (int k = pattern->start[j]; k < pattern->start[j + 1]; k++)
            f->S[(size_t)(j - last) * (size_t)f->ns + (size_t)(pattern->row[k] - last)] -= value[k];
    dpotrf_("L", &f->ns, f->S, &f->ns, &info);
    return info == 0 ? FACTOR_DONE : FACTOR_INDEFINITE;
}

enum factor_result factor_numeric(struct factor *f, const double *value)
{
    int levels = quiet_begin(f->npieces > 1 && f->threads > 1);
#pragma omp parallel for num_threads(f->threads) if (f->npieces > 1 && f->threads > 1)
    for (int k = 0; k < f->npieces; k++)
        piece_factor(&f->piece[k], value, f->ns);
    quiet_end(levels);
    enum factor_result result = f->piece[0].result;
    if (f->npieces == 1)
        return result;
    if (f->piece[1].result != FACTOR_DONE && result != FACTOR_NO_MEMORY)
        result = f->piece[1].result;
    return result == FACTOR_DONE ? join(f, value) : result;
}

static void piece_solve(struct piece *piece, int system)
{
    size_t n = piece->L->n;
    cholmod_dense right = {.nrow = n, .ncol = 1, .nzmax = n, .d = n, .x = piece->b, .xtype = CHOLMOD_REAL,
                           .dtype = CHOLMOD_DOUBLE};
    cholmod_solve2(system, piece->L, &right, NULL, &piece->x, NULL, &piece->y, &piece->e, &piece->common);
    memcpy(piece->b, piece->x->x, sizeof(double) * n);
}

/* L [y; z] = [b; 0] leaves z = -Lss^-1 (L_SA y); its product with Lss is what the side takes from the separator. */
static void piece_lower(struct factor *f, struct piece *piece, const double *b)
{
    const int one = 1;
    memcpy(piece->b, b + piece->first, sizeof *b * (size_t)piece->own);
    memset(piece->b + piece->own, 0, sizeof *b * (size_t)f->ns);
    if (!f->ordered)
        piece_solve(piece, CHOLMOD_P);
    piece_solve(piece, CHOLMOD_L);
    if (f->ns)
        dtrmv_("L", "N", "N", &f->ns, piece->Lss, &f->ns, piece->b + piece->own, &one);
}

/* L^T [x; s] = [y; Lss^T s] gives x for a known s. */
static void piece_upper(struct factor *f, struct piece *piece, const double *b, const double *s)
{
    const int one = 1;
    memcpy(piece->b, b + piece->first, sizeof *b * (size_t)piece->own);
    if (f->ns) {
        memcpy(piece->b + piece->own, s, sizeof *s * (size_t)f->ns);
        dtrmv_("L", "T", "N", &f->ns, piece->Lss, &f->ns, piece->b + piece->own, &one);
    }
    piece_solve(piece, CHOLMOD_Lt);
    if (!f->ordered)
        piece_solve(piece, CHOLMOD_Pt);
}

void factor_lower(struct factor *f, const double *b, double *x)
{
    const int one = 1;
    int levels = quiet_begin(f->npieces > 1 && f->threads > 1);
#pragma omp parallel for num_threads(f->threads) if (f->npieces > 1 && f->threads > 1)
    for (int k = 0; k < f->npieces; k++)
        piece_lower(f, &f->piece[k], b);
    quiet_end(levels);
    memmove(x, b, sizeof *x * (size_t)f->n);
    double *xs = x + f->n - f->ns;
    for (int k = 0; k < f->npieces; k++) {
        const struct piece *piece = &f->piece[k];
        memcpy(x + piece->first, piece->b, sizeof *x * (size_t)piece->own);
        for (int i = 0; i < f->ns; i++)
            xs[i] += piece->b[piece->own + i];
    }
    if (f->ns)
        dtrsv_("L", "N", "N", &f->ns, f->S, &f->ns, xs, &one);
}

void factor_upper(struct factor *f, const double *b, double *x)
{
    const int one = 1;
    memmove(x, b, sizeof *x * (size_t)f->n);
    double *xs = x + f->n - f->ns;
    if (f->ns)
        dtrsv_("L", "T", "N", &f->ns, f->S, &f->ns, xs, &one);
    int levels = quiet_begin(f->npieces > 1 && f->threads > 1);
#pragma omp parallel for num_threads(f->threads) if (f->npieces > 1 && f->threads > 1)
    for (int k = 0; k < f->npieces; k++) {
        struct piece *piece = &f->piece[k];
        piece_upper(f, piece, x, xs);
        memcpy(x + piece->first, piece->b, sizeof *x * (size_t)piece->own);
    }
    quiet_end(levels);
}

void factor_solve(struct factor *f, const double *b, double *x)
{
    factor_lower(f, b, x);
    factor_upper(f, x, x);
}

double factor_nonzeros(const struct factor *f)
{
    return f->piece[0].common.lnz + (f->npieces > 1 ? f->piece[1].common.lnz : 0);
}

double factor_flops(const struct factor *f)
{
    return f->piece[0].common.fl + (f->npieces > 1 ? f->piece[1].common.fl : 0);
}

void factor_version(char text[FACTOR_VERSION])
{
    int version[3] = {0};
    cholmod_version(version);
    snprintf(text, FACTOR_VERSION, "%d.%d.%d", version[0], version[1], version[2]);
}
