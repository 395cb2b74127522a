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
typedef unsigned long long lanes_bits __attribute__((vector_size(8 * LANES)));

#define LANES_INLINE static inline __attribute__((always_inline))
#ifdef WEFT_CLONES
#define LANES_KERNEL __attribute__((target_clones(WEFT_CLONES)))
#else
#define LANES_KERNEL
#endif

/* Unrolls the loop it stands before. */
#ifdef __clang__
#define LANES_UNROLL _Pragma("unroll")
#else
#define LANES_UNROLL _Pragma("GCC unroll 8")
#endif

/* A function that takes or gives bare lanes has no calling convention that code for two instruction sets agrees on,
 * inlined or not (clang refuses the call); in a struct they pass in memory.  So these are macros around functions
 * of structs. */
struct lanes_one {
    lanes v;
};

struct vec {
    lanes x, y, z;
};

#define lanes_set(a)       (lanes_set_(a).v)
#define lanes_sqrt(a)      (lanes_sqrt_((struct lanes_one){a}).v)
#define lanes_rsqrt(a)     (lanes_rsqrt_((struct lanes_one){a}).v)     /* 1/sqrt(a), a normal and > 0 */
#define lanes_positive(a)  (lanes_positive_((struct lanes_one){a}).v)  /* max(a, 0) */
#define vec_dot(a, b)      (vec_dot_(a, b).v)
#define vec_scale(s, a)    vec_scale_((struct lanes_one){s}, a)
#define vec_fma(a, s, b)   vec_fma_(a, (struct lanes_one){s}, b)       /* a + s b */

LANES_INLINE struct lanes_one lanes_set_(double a)
{
    return (struct lanes_one){{a, a, a, a, a, a, a, a}};
}

LANES_INLINE struct lanes_one lanes_sqrt_(struct lanes_one a)
{
    struct lanes_one r;
    for (int l = 0; l < LANES; l++)
        r.v[l] = __builtin_sqrt(a.v[l]);
    return r;
}

/* Halving the exponent guesses y = 1/sqrt(a) to 4 %; then twice, with r = 1 - a y^2,
 * y (1 - r)^(-1/2) to the third order.  A quarter of the time of a root and a division. */
LANES_INLINE struct lanes_one lanes_rsqrt_(struct lanes_one a)
{
    lanes y = (lanes)(0x5fe6eb50c7b537a9 - ((lanes_bits)a.v >> 1));
    LANES_UNROLL
    for (int k = 0; k < 2; k++) {
        lanes r = 1 - a.v * y * y;
        y += y * r * (0.5 + r * (0.375 + r * 0.3125));
    }
    return (struct lanes_one){y};
}

LANES_INLINE struct lanes_one lanes_positive_(struct lanes_one a)
{
    return (struct lanes_one){(lanes)((lanes_mask)a.v & (a.v > 0))};
}

LANES_INLINE struct lanes_one vec_dot_(struct vec a, struct vec b)
{
    return (struct lanes_one){a.x * b.x + a.y * b.y + a.z * b.z};
}

LANES_INLINE struct vec vec_cross(struct vec a, struct vec b)
{
    return (struct vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

LANES_INLINE struct vec vec_scale_(struct lanes_one s, struct vec a)
{
    return (struct vec){s.v * a.x, s.v * a.y, s.v * a.z};
}

LANES_INLINE struct vec vec_add(struct vec a, struct vec b)
{
    return (struct vec){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* a - b */
LANES_INLINE struct vec vec_sub(struct vec a, struct vec b)
{
    return (struct vec){a.x - b.x, a.y - b.y, a.z - b.z};
}

LANES_INLINE struct vec vec_fma_(struct vec a, struct lanes_one s, struct vec b)
{
    return (struct vec){a.x + s.v * b.x, a.y + s.v * b.y, a.z + s.v * b.z};
}

#endif
