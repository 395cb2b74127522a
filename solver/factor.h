/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sparse Cholesky factors of Hessians, P H P^T = L L^T, through CHOLMOD: one
 * symbolic analysis a level, as many numeric factors as wanted. */
#ifndef WEFT_FACTOR_H
#define WEFT_FACTOR_H

#include <stdbool.h>
#include <stddef.h>

#include "solver/discretisation.h"

struct factor;

/* Analyses a pattern; with ordered it is factored as numbered, else in
 * CHOLMOD's best order.  NULL where the factor would not fit (CHOLMOD's limits or memory). */
struct factor *factor_make(const struct pattern *pattern, bool ordered);
void           factor_free(struct factor *factor);

/* Factors the matrix with these values (pattern.start[n]), lower triangle.
 * false: not positive definite (or out of memory: see factor_out_of_memory). */
bool factor_numeric(struct factor *factor, const double *value);
bool factor_out_of_memory(const struct factor *factor);

/* x (n) := H^-1 b (n); x = L^-1 P b; x = P^T L^-T b.  b and x may be the same. */
void factor_solve(struct factor *factor, const double *b, double *x);
void factor_lower(struct factor *factor, const double *b, double *x);
void factor_upper(struct factor *factor, const double *b, double *x);

/* Nonzeros of the factor and floating-point operations to make it. */
double factor_nonzeros(const struct factor *factor);
double factor_flops(const struct factor *factor);

#endif
