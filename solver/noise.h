/* SPDX-License-Identifier: GPL-3.0-or-later
 * The starting noise's generator, splitmix64 (Steele, Lea and Flood 2014): the
 * same numbers for a seed on every platform. */
#ifndef WEFT_NOISE_H
#define WEFT_NOISE_H

#include <stdint.h>

/* The next number in [-1, 1); state starts as the seed. */
static inline double noise_next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-52 - 1;
}

#endif
