/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the triangle discretisation keeps: its faces in batches of lanes, and
 * where their unknowns stand.  Private to solver/triangle*.c and their tests. */
#ifndef WEFT_TRIANGLE_MODEL_H
#define WEFT_TRIANGLE_MODEL_H

#include "solver/springs.h"
#include "solver/triangle_kernel.h"
#include "solver/triangle_mesh.h"

enum { TRIANGLE_CHUNKS = 256, TRIANGLE_SLOTS = 15 };

/* Eight faces; lanes from count on repeat the first. */
struct triangle_batch {
    lanes       natural[3];             /* 1/length: kx, ky, twist */
    lanes       share[3];               /* of N in the direction that edge i's angle counts from: +1/2 for the edge's
                                           first face, -1/2 for the second (the angle turns the other way), 1 on
                                           the boundary */
    int         vertex[3][LANES];       /* into x: position of v_i */
    int         opposite[3][LANES];     /* into x: position of the corner across edge i (of v_{i+2} on the boundary) */
    int         edge[3][LANES];         /* into x: angle of edge i */
    int         face[LANES];            /* of the mesh */
    int         rest;                   /* of the table of rest shapes */
    int         count;
};

/* Where a face's blocks stand in the Hessian: the place, within the column of the lower node's first unknown, of the
 * higher node's first.  Pairs 01 02 12 of corners; corner k, edge j at 3 + 3 k + j; edges 01 02 12 from 12. */
struct triangle_slots { int at[TRIANGLE_SLOTS][LANES]; };

struct triangle {
    struct discretisation     base;
    struct triangle_mesh     *mesh;
    struct triangle_material  material;
    int                      *vertex_at;    /* into x (nvertices) */
    int                      *edge_at;      /* into x (nedges) */
    int                       nrest;
    struct triangle_rest     *rest;         /* (nrest) */
    int                       nbatches;
    struct triangle_batch    *batch;        /* (nbatches) */
    struct triangle_slots    *slots;        /* (nbatches) */

    /* Batches in runs that fit a thread's turn; runs of one colour share no unknown. */
    int                       nchunks, ncolours;
    int                       chunk_start[TRIANGLE_CHUNKS + 1];     /* batches */
    int                       colour_start[TRIANGLE_CHUNKS + 1];    /* into chunk */
    int                       chunk[TRIANGLE_CHUNKS];

    struct spring_form        springs;
};

/* What a face of the mesh holds in some state. */
struct triangle_face {
    double metric[3];           /* xx, yy, xy of the first fundamental form */
    double curvature[3];        /* 1/length, of the second */
    double stretching, bending; /* energies */
    double angle;               /* radians, the largest |alpha| */
};

/* Numbers unknowns, makes the Hessian's pattern, the batches and their colours: triangle_layout.c. */
void triangle_layout(struct triangle *t);

/* triangle_evaluate.c */
struct fold_energy triangle_energy(const struct discretisation *d, const double *restrict x, double growth,
                                   double *restrict gradient);
void triangle_hessian_values(const struct discretisation *d, const double *restrict x, double growth,
                             enum hessian_kind kind, double *restrict value);
void triangle_tangent(const struct discretisation *d, const double *x, const double *dz, double *dx);
void triangle_cotangent(const struct discretisation *d, const double *x, const double *gx, double *gz);
void triangle_faces(const struct discretisation *d, const double *x, double growth, struct triangle_face *face);

/* triangle_transfer.c */
void triangle_prolong(const struct discretisation *coarse, const double *x, const struct discretisation *fine,
                      double *x_fine);
void triangle_sample(const struct discretisation *d, const double *x, double growth, struct surface *surface);

#endif
