/* SPDX-License-Identifier: GPL-3.0-or-later
 * Eight elements at a time: the vector type of the kernels, 3-vectors of it,
 * and the mark of a function that is built once per instruction set. */
#ifndef WEFT_LANES_H
#define WEFT_LANES_H

#include "config.h"

#include <math.h>

enum { LANES = 8 };
typedef double lanes __attribute__((vector_size(8 * LANES)));
typedef long long lanes_mask __attribute__((vector_size(8 * LANES)));

/* Vectors pass between inlined functions only, so their calling convention does not matter. */
#if defined __GNUC__ && !defined __clang__
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#define LANES_INLINE static inline __attribute__((always_inline))
#ifdef WEFT_CLONES
#define LANES_KERNEL __attribute__((target_clones(WEFT_CLONES)))
#else
#define LANES_KERNEL
#endif

LANES_INLINE lanes lanes_set(double a)
{
    return (lanes){a, a, a, a, a, a, a, a};
}

LANES_INLINE lanes lanes_sqrt(lanes a)
{
    lanes r;
    for (int l = 0; l < LANES; l++)
        r[l] = __builtin_sqrt(a[l]);
    return r;
}

/* max(a, 0) */
LANES_INLINE lanes lanes_positive(lanes a)
{
    return (lanes)((lanes_mask)a & (a > 0));
}

struct vec {
    lanes x, y, z;
};

LANES_INLINE lanes vec_dot(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

LANES_INLINE struct vec vec_cross(struct vec a, struct vec b)
{
    return (struct vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

LANES_INLINE struct vec vec_scale(lanes s, struct vec a)
{
    return (struct vec){s * a.x, s * a.y, s * a.z};
}

LANES_INLINE struct vec vec_add(struct vec a, struct vec b)
{
    return (struct vec){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* a + s b */
LANES_INLINE struct vec vec_fma(struct vec a, lanes s, struct vec b)
{
    return (struct vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

#endif
