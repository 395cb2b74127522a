/* SPDX-License-Identifier: GPL-3.0-or-later
 * A minimum on meshes that are not nested in; its discretisation error, found
 * on patches, out: the two kinds' energies tend to one limit from two sides. */
#ifndef WEFT_CROSS_CHECK_H
#define WEFT_CROSS_CHECK_H

#include "solver/estimate.h"

/* x (n): a minimum of p.  Minimises from it on one patch a stitch, whose own
 * error is estimated from two.  energy < 0: there is no minimum there. */
struct estimate cross_check(const struct problem *p, const double *x);

#endif
