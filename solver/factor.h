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
 * CHOLMOD's best order.  parts: unknowns [0, parts[0]) and [parts[0], parts[1])
 * do not couple, but through the rest; they are factored side by side, by the
 * same arithmetic for one thread as for two.  parts[0] = 0: in one piece.
 * NULL where the factor would not fit (CHOLMOD's limits or memory). */
struct factor *factor_make(const struct pattern *pattern, bool ordered, const int parts[2], int threads);
void           factor_free(struct factor *factor);

enum factor_result { FACTOR_DONE, FACTOR_INDEFINITE, FACTOR_NO_MEMORY };

/* Factors the matrix with these values (pattern.start[n]), lower triangle. */
enum factor_result factor_numeric(struct factor *factor, const double *value);

/* x (n) := H^-1 b (n); x = L^-1 P b; x = P^T L^-T b.  b and x may be the same. */
void factor_solve(struct factor *factor, const double *b, double *x);
void factor_lower(struct factor *factor, const double *b, double *x);
void factor_upper(struct factor *factor, const double *b, double *x);

/* CHOLMOD's version: "3.0.14". */
enum { FACTOR_VERSION = 48 };
void factor_version(char text[FACTOR_VERSION]);

/* Nonzeros of the factor and floating-point operations to make it. */
double factor_nonzeros(const struct factor *factor);
double factor_flops(const struct factor *factor);

#endif
