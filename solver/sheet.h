/* SPDX-License-Identifier: GPL-3.0-or-later
 * The constant model of an elastic sheet with natural curvatures: what the
 * solver computes with.  Made once from a scene, never changed. */
#ifndef WEFT_SHEET_H
#define WEFT_SHEET_H

#include <stdint.h>

#include "lang/scene.h"

struct sheet {
    int      columns, rows;     /* of stitches */
    double   dx, dy;            /* length, one stitch */
    double   thickness;         /* length, h */
    double   young, poisson;    /* force/length^2, Y; nu */
    double  *kx, *ky, *twist;   /* 1/length (rows x columns): natural curvature b0 = [[kx, twist], [twist, ky]] */
    double   spring;            /* stiffness per unit length of boundary, over young */
    unsigned spring_edges;      /* set of enum edge */
    struct mesh  mesh;
    struct solve solve;
};

struct sheet *sheet_build(const struct scene *scene);
void          sheet_free(struct sheet *sheet);

#endif
