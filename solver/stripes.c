/* SPDX-License-Identifier: GPL-3.0-or-later
 * Stripes in, the curve they bend to out.  A wide strip that is straight along
 * y takes the curvature k = kx + nu ky in x, which leaves Y h^3 ky^2/24 an area
 * (likewise across). */
#include "solver/stripes.h"

#include <math.h>
#include <stdlib.h>

#include "solver/levels.h"
#include "solver/memory.h"

enum { X, Y, Z };

/* Where a stripe begins on the curve, and its curvature. */
struct stripe {
    double r, z, angle, curvature;
};

/* Does no stitch differ from the first one of its column (across = X) or row (Y)? */
static bool striped(const struct sheet *s, int across)
{
    for (int j = 0; j < s->rows; j++)
        for (int i = 0; i < s->columns; i++) {
            size_t at = (size_t)j * (size_t)s->columns + (size_t)i;
            size_t first = across == X ? (size_t)i : at - (size_t)i;
            if (s->kx[at] != s->kx[first] || s->ky[at] != s->ky[first] || s->twist[at] != 0)
                return false;
        }
    return true;
}

/* A plain sheet rolls so that less curvature is left unbent, or along its longer side: what its ends save is
 * in proportion to that. */
static int choose_axis(const struct sheet *s)
{
    bool x = striped(s, X), y = striped(s, Y);
    if (!x || !y)
        return x ? X : y ? Y : -1;
    double left_by_x = fabs(s->ky[0]), left_by_y = fabs(s->kx[0]);
    if (left_by_x != left_by_y)
        return left_by_x < left_by_y ? X : Y;
    return s->columns * s->dx >= s->rows * s->dy ? X : Y;
}

/* The point of the curve at arc length s from the stripe's beginning, and its direction there. */
static struct stripe along(const struct stripe *from, double s)
{
    double half = from->curvature * s / 2, chord = fabs(half) < 1e-9 ? s : s * sin(half) / half;
    return (struct stripe){from->r + chord * cos(from->angle + half), from->z + chord * sin(from->angle + half),
                           from->angle + 2 * half, from->curvature};
}

/* (count): the curve from its start at rest. */
static struct stripe *curve_make(const struct sheet *s, int axis, double growth, int count, double width)
{
    struct stripe *curve = MEMORY_ARRAY(struct stripe, count);
    for (int c = 0; c < count; c++) {
        size_t at = axis == X ? (size_t)c : (size_t)c * (size_t)s->columns;
        if (c > 0)
            curve[c] = along(&curve[c - 1], width);
        curve[c].curvature = growth * (axis == X ? s->kx[at] + s->poisson * s->ky[at]
                                                 : s->ky[at] + s->poisson * s->kx[at]);
    }
    return curve;
}

bool stripes_bend(const struct discretisation *d, double growth, double *x)
{
    const struct sheet *s = d->sheet;
    int axis = s->spring > 0 ? -1 : choose_axis(s);
    if (axis < 0)
        return false;
    int count = axis == X ? s->columns : s->rows;
    double width = axis == X ? s->dx : s->dy, h = width / d->per_stitch;
    struct stripe *curve = curve_make(s, axis, growth, count, width);
    /* The control point of a uniform quadratic spline stands h^2/8 r'' outside of its curve. */
    double outside = levels_is_spline(d) ? h * h / 8 : 0;
    for (int i = 0; i < d->nnodes; i++) {
        double *r = x + d->node[i];
        int c = (int)fmin(fmax(floor(r[axis] / width), 0), count - 1);
        struct stripe at = along(&curve[c], r[axis] - c * width);
        r[axis] = at.r + outside * at.curvature * sin(at.angle);
        r[Z] += at.z - outside * at.curvature * cos(at.angle);
    }
    free(curve);
    return true;
}
