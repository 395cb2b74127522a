/* SPDX-License-Identifier: GPL-3.0-or-later
 * Differences of a discretisation's energy and gradient, against which its
 * derivatives are tested. */
#ifndef WEFT_TEST_DIFFERENCES_H
#define WEFT_TEST_DIFFERENCES_H

#include "solver/discretisation.h"

/* Relative errors of derivatives at x by central differences, the least over steps from 1e-3 to 1e-8: longer steps
 * see higher derivatives, shorter ones rounding. */
double difference_gradient_error(const struct discretisation *d, const double *x);
double difference_hessian_error(const struct discretisation *d, const double *x);

/* Smallest pivot of the Cholesky factorisation of value + shift I, as a dense matrix; -1 where it breaks down. */
double difference_cholesky(const struct pattern *pattern, const double *value, double shift);

#endif
