/* SPDX-License-Identifier: GPL-3.0-or-later
 * The patch discretisation: bicubic Hermite patches, or biquadratic splines on
 * the same lines as their coarse level. */
#ifndef WEFT_PATCH_H
#define WEFT_PATCH_H

#include "solver/discretisation.h"
#include "solver/patch_basis.h"

/* per_stitch x per_stitch elements a stitch, gauss x gauss points each; freed by op->free. */
struct discretisation *patch_make(const struct sheet *sheet, const struct basis *basis, int per_stitch, int gauss,
                                  int threads);

#endif
