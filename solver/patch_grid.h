/* SPDX-License-Identifier: GPL-3.0-or-later
 * The patches' structured grid: numbering, sparsity, stripes, tables of shape
 * functions, and what follows from a state without derivatives of the energy. */
#ifndef WEFT_PATCH_GRID_H
#define WEFT_PATCH_GRID_H

#include "solver/lanes.h"
#include "solver/patch.h"
#include "solver/patch_kernel.h"
#include "solver/springs.h"

struct patch_batch {
    int count;                  /* elements in use, <= LANES */
    int element[LANES];
};

struct patch {
    struct discretisation d;
    const struct basis   *basis;
    int                   nx, ny;       /* elements */
    int                   mx, my;       /* nodes; spline coefficients count as nodes */
    int                   per_node;     /* unknowns of a node: 12 or 3 */
    double                hx, hy;       /* length, one element */
    struct plate          plate;

    int                   ngauss;                                           /* points an element */
    double                weight[GAUSS_MAX * GAUSS_MAX];                    /* area */
    double                N[GAUSS_MAX * GAUSS_MAX][D_COUNT][BASIS_MAX];     /* derivatives of the functions */

    int                  *place;        /* (my x mx) a node's place in the elimination order */
    int                  *node;         /* (mx x my) by place: first unknown */
    short                *offset;       /* (elements x pairs) see patch_offset */
    int                   npairs;       /* of distinct nodes of an element */

    int                   nstripes;
    int                  *stripe;       /* (nstripes + 1) first batch of each stripe */
    int                   nbatches;
    struct patch_batch   *batch;        /* (nbatches) */
    double               *energy;       /* (nbatches x 2) scratch: stretching, bending */
    struct spring_form        springs;
    struct retraction        *retraction;   /* patch_retract.c's own */
};

struct patch *patch_grid_make(const struct sheet *sheet, const struct basis *basis, int per_stitch, int gauss);
void          patch_grid_free(struct patch *patch);

/* Weights (area) and derivatives of the functions at the gauss x gauss points of every element. */
void patch_tabulate(const struct patch *p, int gauss, double *area, double (*table)[D_COUNT][BASIS_MAX]);

/* Fills the boundary's mass matrix; after patch_grid_make and with d.op set. */
void patch_springs(struct patch *patch);

/* Index into the sheet's per-stitch arrays. */
static inline size_t patch_stitch(const struct patch *p, int element)
{
    int ps = p->d.per_stitch, x = element % p->nx / ps, y = element / p->nx / ps;
    return (size_t)y * (size_t)p->d.sheet->columns + (size_t)x;
}

/* First unknown of each node of an element, nodes x fastest. */
static inline void patch_nodes(const struct patch *p, int element, int *first)
{
    int span = p->basis->span, x = element % p->nx, y = element / p->nx;
    for (int j = 0; j < span; j++)
        for (int i = 0; i < span; i++)
            *first++ = p->per_node * p->place[(y + j) * p->mx + x + i];
}

/* Where, from the diagonal of a column of one of two nodes (the earlier in the
 * order), the rows of the other begin, as if the column were its node's first. */
static inline int patch_offset(const struct patch *p, int element, int a, int b)
{
    if (a == b)
        return 0;
    int high = a > b ? a : b, low = a > b ? b : a;
    return p->offset[(size_t)element * (size_t)p->npairs + (size_t)(high * (high - 1) / 2 + low)];
}

/* The operations that need no derivative of the energy. */
void patch_flat(const struct discretisation *d, double *x);
void patch_mass(const struct discretisation *d, double *mass);
const char *patch_doubt(const struct discretisation *d, const double *x);
void patch_sample(const struct discretisation *d, const double *x, double growth, struct surface *surface);

/* Between nested levels: patch_transfer.c. */
void patch_prolong(const struct discretisation *coarse, const double *x, const struct discretisation *fine,
                   double *x_fine);
void patch_restrict(const struct discretisation *coarse, double *gradient_coarse, const struct discretisation *fine,
                    const double *gradient_fine);
void patch_restrict_hessian(const struct discretisation *coarse, double *value_coarse,
                            const struct discretisation *fine, const double *value_fine);

/* Along turning pieces: patch_retract.c. */
void patch_retract(const struct discretisation *d, const double *x, double length, const double *dx, double *y);
void patch_retract_adjoint(const struct discretisation *d, const double *x, double length, const double *dx,
                           const double *g, double *gu);
struct retraction *patch_retraction_make(void);
void               patch_retraction_free(struct retraction *retraction);

#endif
