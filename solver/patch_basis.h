/* SPDX-License-Identifier: GPL-3.0-or-later
 * Shape functions of one rectangular element on the unit square: the bicubic
 * Hermite patch of Bogner, Fox and Schmit (1965), and the C1 biquadratic
 * B-spline, a subspace of it on the same lines with a quarter of the unknowns. */
#ifndef WEFT_PATCH_BASIS_H
#define WEFT_PATCH_BASIS_H

enum { BASIS_MAX = 16, GAUSS_MAX = 4 };

enum basis_kind { BASIS_HERMITE, BASIS_SPLINE };

/* Function a = node * per_node + k belongs to the element's node (a / per_node),
 * nodes x fastest.  Hermite: k = 0 value, 1 s-slope, 2 t-slope, 3 twist, all in
 * lengths (slopes are per element side). */
struct basis {
    enum basis_kind kind;
    int             span;       /* nodes along a side: 2 or 3 */
    int             per_node;   /* functions of one node: 4 or 1 */
    int             count;      /* span^2 * per_node */
};

extern const struct basis basis_hermite, basis_spline;

/* N (3 x 3 x BASIS_MAX): N[i][j][a] is the i-th derivative in s and j-th in t at (s, t). */
void basis_at(const struct basis *basis, double s, double t, double N[3][3][BASIS_MAX]);

/* f (BASIS_LINE x 3): the functions of one direction and their derivatives at t,
 * whose products are those of the element; returns their number.  Hermite: value
 * and slope of the first node, then of the second. */
enum { BASIS_LINE = 4 };
int basis_line(const struct basis *basis, double t, double f[BASIS_LINE][3]);

/* Points and weights of the n-point Gauss rule on [0, 1], n <= GAUSS_MAX. */
void basis_gauss(int n, double *point, double *weight);

#endif
