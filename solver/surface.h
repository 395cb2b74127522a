/* SPDX-License-Identifier: GPL-3.0-or-later
 * The folded sheet as every writer reads it: a sampled surface, and the record
 * of how it came about.  Nothing here knows unknowns or elements. */
#ifndef WEFT_SURFACE_H
#define WEFT_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

/* Samples on a grid aligned with the stitches: per_stitch x per_stitch equal
 * cells a stitch.  Points run x fastest, bottom row first, as the stitch grid. */
struct surface {
    int     columns, rows;      /* of stitches */
    int     per_stitch;         /* cells along a stitch's side */
    int     nx, ny;             /* cells: columns * per_stitch, rows * per_stitch */
    double *position;           /* length            ((ny+1) x (nx+1) x 3) */
    double *normal;             /* unit, to the RS   ((ny+1) x (nx+1) x 3) */
    double *displacement;       /* length, from flat ((ny+1) x (nx+1) x 3) */
    double *mean;               /* 1/length   (ny x nx), (k1 + k2)/2 at the cell's centre */
    double *gauss;              /* 1/length^2 (ny x nx) */
    double *stretching;         /* energy/area (ny x nx) */
    double *bending;            /* energy/area (ny x nx) */
};

/* Allocates all arrays; out of memory does not return.  Free with surface_free. */
struct surface surface_make(int columns, int rows, int per_stitch);
void           surface_free(struct surface *surface);

enum fold_status { FOLD_CONVERGED, FOLD_PRECISION, FOLD_SADDLE, FOLD_ITERATION_LIMIT, FOLD_FAILED };

/* "converged", "precision", "saddle", "iteration_limit", "failed" */
const char *fold_status_name(enum fold_status status);

/* force * length */
struct fold_energy { double total, stretching, bending, springs; };

struct fold_step {
    double             growth;          /* in (0, 1] */
    struct fold_energy energy;
    int                iterations;
    double             gradient_max;    /* in young * thickness^2 */
};

/* All that the report says of a fold besides the scene and the files. */
struct fold_record {
    const char        *kind;                /* "patch" | "triangle" */
    int                per_stitch;          /* of the final level */
    long               unknowns, elements;

    struct fold_energy energy;              /* of the final state */
    double             energy_flat;         /* of the flat sheet under the full natural curvatures */
    double             energy_error;        /* error estimate, relative; < 0: none */

    enum fold_status   status;
    const char        *method;              /* what ran: "plbfgs+newton", ... */
    int                growth_steps;        /* as asked */
    int                iterations, evaluations, factorisations;
    double             gradient_max;        /* in young * thickness^2 */
    bool               positive_definite;   /* of the exact Hessian, rigid modes aside */
    int                threads;
    const char        *remark;              /* what a user should know (a push off a saddle, a failure's reason), or NULL */

    double             extent_x, extent_y;  /* folded bounding box over flat size */
    double             extent_z, rms_height;/* length */
    double             max_normal_curvature;/* 1/length */
    double             shape_error;         /* over the swatch's size; < 0: none */

    int                nsteps;
    struct fold_step  *step;                /* (nsteps) owned; fold_record_free */

    double             assemble_s, factor_s, evaluate_s, solve_s;   /* wall seconds */
};

void fold_record_free(struct fold_record *record);

#endif
