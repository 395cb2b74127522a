/* SPDX-License-Identifier: GPL-3.0-or-later
 * The fixed Poisson equation of a grid of patches, for each of three components. */
#ifndef WEFT_PATCH_POISSON_H
#define WEFT_PATCH_POISSON_H

#include "solver/patch_grid.h"

/* Factored for the grid, with integrals by a rule of gauss points an element's side. */
struct poisson *poisson_make(const struct patch *patch, int gauss);
void            poisson_free(struct poisson *poisson);

/* v (n) := S^-1 v up to a translation, by the grid's number of threads; the same bits for any.  One call at a time. */
void poisson_solve(struct poisson *poisson, double *v);

#endif
