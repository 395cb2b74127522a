/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a minimiser may know of a discretised sheet: its unknowns, energy,
 * gradient and Hessian; what the driver may know besides: how to reach the next
 * finer level and how to sample a state. */
#ifndef WEFT_DISCRETISATION_H
#define WEFT_DISCRETISATION_H

#include "solver/sheet.h"
#include "solver/surface.h"

enum hessian_kind {
    HESSIAN_EXACT,              /* the second derivatives */
    HESSIAN_SEMIDEFINITE        /* Gauss-Newton + clamped membrane stress: never a negative eigenvalue */
};

/* Lower triangle of the symmetric Hessian by compressed columns; rows of a
 * column ascend, the diagonal comes first. */
struct pattern {
    int  n;
    int *start;                 /* (n + 1) */
    int *row;                   /* (start[n]) */
};

/* Where an entry of the pattern stands among the values; row >= column. */
static inline int pattern_find(const struct pattern *pattern, int row, int column)
{
    int low = pattern->start[column], high = pattern->start[column + 1] - 1;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (pattern->row[middle] < row)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

struct discretisation;

struct discretisation_ops {
    const char *kind;           /* "patch", "spline", "triangle" */

    /* x (n): the flat sheet, at rest but for its natural curvature. */
    void (*flat)(const struct discretisation *d, double *x);

    /* Energy of state x (n) with natural curvatures scaled by growth in [0, 1].
     * The gradient is ADDED to gradient (n) unless that is NULL.  Young's modulus
     * is taken as 1: energies are in young * length^3. */
    struct fold_energy (*energy)(const struct discretisation *d, const double *restrict x, double growth,
                                 double *restrict gradient);

    /* Sets value (pattern.start[n]), in the order of the pattern. */
    void (*hessian)(const struct discretisation *d, const double *restrict x, double growth,
                    enum hessian_kind kind, double *restrict value);

    /* mass (n) > 0: lumped weights that make steps and shifts independent of the mesh. */
    void (*mass)(const struct discretisation *d, double *mass);

    /* Where the Hessian lives in other increments than x: dx = T(x) dz, gz = T(x)^T gx.
     * Both NULL: they are the same. */
    void (*tangent)(const struct discretisation *d, const double *x, const double *dz, double *dx);
    void (*cotangent)(const struct discretisation *d, const double *x, const double *gx, double *gz);

    /* y (n): where the increment u = length dx (n) leads from x; y = x + u + O(u^2), but a piece that turns does
     * not stretch, and a free sheet as a whole stays where it is.  And the pull of a gradient g (n) at y: gu (n) := (dy/du)^T g.  Both NULL: y = x + u. */
    void (*retract)(const struct discretisation *d, const double *x, double length, const double *dx, double *y);
    void (*retract_adjoint)(const struct discretisation *d, const double *x, double length, const double *dx,
                            const double *g, double *gu);

    /* The state of the next finer level (made with fine_of this one) that is, or comes closest to, x. */
    void (*prolong)(const struct discretisation *coarse, const double *x,
                    const struct discretisation *fine, double *x_fine);

    /* gradient_coarse (coarse n) := P^T gradient_fine, P the matrix of prolong; NULL where that is not linear. */
    void (*restrict_gradient)(const struct discretisation *coarse, double *gradient_coarse,
                              const struct discretisation *fine, const double *gradient_fine);

    /* value_coarse (coarse pattern.start[n]) := P^T H_fine P; NULL where restrict_gradient is. */
    void (*restrict_hessian)(const struct discretisation *coarse, double *value_coarse,
                             const struct discretisation *fine, const double *value_fine);

    /* Fills all arrays of a surface with the sheet's stitches, any per_stitch. */
    void (*sample)(const struct discretisation *d, const double *x, double growth, struct surface *surface);

    /* Why a state must not be called converged, NULL where nothing speaks against it.  NULL: there is no such test. */
    const char *(*doubt)(const struct discretisation *d, const double *x);

    void (*free)(struct discretisation *d);
};

/* One level of one kind.  First member of each kind's own struct. */
struct discretisation {
    const struct discretisation_ops *op;
    const struct sheet              *sheet;
    int            per_stitch;      /* cells along a stitch's side */
    int            n;               /* unknowns */
    long           elements;
    struct pattern pattern;
    bool           ordered;         /* unknowns are numbered in a fill-reducing elimination order */
    int            parts[2];        /* ordered: [0, parts[0]) and [parts[0], parts[1]) couple through the rest alone; or 0, 0 */
    int            block;           /* unknowns of a node, consecutive; 0: no such blocks */
    int            nnodes;
    const int     *node;            /* (nnodes) first of the three unknowns that are a node's position */
    int            threads;
};

#endif
