/* SPDX-License-Identifier: GPL-3.0-or-later
 * What is done with whole vectors of unknowns; sums in one fixed order. */
#ifndef WEFT_VECTOR_H
#define WEFT_VECTOR_H

static inline double vector_dot(int n, const double *a, const double *b)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
}

#endif
