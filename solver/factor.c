/* SPDX-License-Identifier: GPL-3.0-or-later
 * Pattern and values in, triangular solves out; the only user of CHOLMOD. */
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

#include <stdlib.h>

#include "solver/memory.h"

/* Threads are ours: where the BLAS is OpenBLAS it is told to use one. */
extern void openblas_set_num_threads(int threads) __attribute__((weak));

struct factor {
    cholmod_common  common;
    cholmod_sparse  matrix;     /* a view of pattern and values */
    cholmod_factor *L;
    cholmod_dense  *x, *y, *e;  /* kept between solves */
    double          nonzeros, flops;
    bool            ordered;
};

/* CHOLMOD as built by Debian runs its supernodal loops on 4 OpenMP threads
 * fixed at compile time; no active level of parallelism keeps them to one. */
static int quiet_begin(void)
{
#ifdef _OPENMP
    int levels = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
    return levels;
#else
    return 0;
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

struct factor *factor_make(const struct pattern *pattern, bool ordered)
{
    struct factor *f = MEMORY_ARRAY(struct factor, 1);
    if (openblas_set_num_threads)
        openblas_set_num_threads(1);
    int levels = quiet_begin();
    cholmod_start(&f->common);
    choose_order(&f->common, ordered);
    f->ordered = ordered;
    f->matrix = (cholmod_sparse){.nrow = (size_t)pattern->n, .ncol = (size_t)pattern->n,
                                 .nzmax = (size_t)pattern->start[pattern->n], .p = pattern->start, .i = pattern->row,
                                 .stype = -1, .itype = CHOLMOD_INT, .xtype = CHOLMOD_PATTERN, .dtype = CHOLMOD_DOUBLE,
                                 .sorted = 1, .packed = 1};
    f->L = cholmod_analyze(&f->matrix, &f->common);
    f->nonzeros = f->common.lnz;
    f->flops = f->common.fl;
    f->matrix.xtype = CHOLMOD_REAL;
    quiet_end(levels);
    if (!f->L) {
        factor_free(f);
        return NULL;
    }
    return f;
}

void factor_free(struct factor *f)
{
    if (!f)
        return;
    cholmod_free_dense(&f->x, &f->common);
    cholmod_free_dense(&f->y, &f->common);
    cholmod_free_dense(&f->e, &f->common);
    cholmod_free_factor(&f->L, &f->common);
    cholmod_finish(&f->common);
    free(f);
}

bool factor_numeric(struct factor *f, const double *value)
{
    int levels = quiet_begin();
    f->matrix.x = (void *)value;
    int done = cholmod_factorize(&f->matrix, f->L, &f->common);
    quiet_end(levels);
    return done && f->common.status == CHOLMOD_OK && f->L->minor == f->L->n;
}

bool factor_out_of_memory(const struct factor *f)
{
    return f->common.status == CHOLMOD_OUT_OF_MEMORY || f->common.status == CHOLMOD_TOO_LARGE;
}

static void solve(struct factor *f, int system, const double *b, double *x)
{
    cholmod_dense right = {.nrow = f->L->n, .ncol = 1, .nzmax = f->L->n, .d = f->L->n, .x = (void *)b,
                           .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE};
    cholmod_solve2(system, f->L, &right, NULL, &f->x, NULL, &f->y, &f->e, &f->common);
    memcpy(x, f->x->x, sizeof *x * f->L->n);
}

void factor_solve(struct factor *f, const double *b, double *x)
{
    int levels = quiet_begin();
    solve(f, CHOLMOD_A, b, x);
    quiet_end(levels);
}

void factor_lower(struct factor *f, const double *b, double *x)
{
    int levels = quiet_begin();
    if (!f->ordered) {
        solve(f, CHOLMOD_P, b, x);
        b = x;
    }
    solve(f, CHOLMOD_L, b, x);
    quiet_end(levels);
}

void factor_upper(struct factor *f, const double *b, double *x)
{
    int levels = quiet_begin();
    solve(f, CHOLMOD_Lt, b, x);
    if (!f->ordered)
        solve(f, CHOLMOD_Pt, x, x);
    quiet_end(levels);
}

double factor_nonzeros(const struct factor *f)
{
    return f->nonzeros;
}

double factor_flops(const struct factor *f)
{
    return f->flops;
}
