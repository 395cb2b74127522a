/* SPDX-License-Identifier: GPL-3.0-or-later
 * A minimum on triangles in; where the same sheet comes to rest on patches, and
 * so the triangles' error, out. */
#include "solver/cross_check.h"

#include <math.h>
#include <stdlib.h>

#include "solver/descent.h"
#include "solver/levels.h"
#include "solver/memory.h"
#include "solver/shape.h"

static const double TOLERANCE = 1e-5;   /* of the patches' gradient, young * thickness^2 */
enum { FINE = 4, MOST_ITERATIONS = 1000 };  /* samples of a stitch's side that slopes are taken from */

/* ---- the triangles' state on patches ---- */

/* Weights on three samples in a row that give the slope at one of them, all per sample. */
struct slope {
    int    first;
    double weight[3];
};

static struct slope slope_at(int i, int last)
{
    if (i == 0)
        return (struct slope){0, {-1.5, 2, -0.5}};
    if (i == last)
        return (struct slope){last - 2, {0.5, -2, 1.5}};
    return (struct slope){i - 1, {-0.5, 0, 0.5}};
}

/* The twelve unknowns of the node at sample (i, j): r, its slopes along a patch's sides, its twist. */
static void node_from_samples(const struct surface *s, int i, int j, double *node)
{
    struct slope a = slope_at(i, s->nx), b = slope_at(j, s->ny);
    const double *position = s->position;
    size_t width = (size_t)s->nx + 1;
    for (int c = 0; c < 3; c++) {
        node[c] = position[3 * ((size_t)j * width + (size_t)i) + (size_t)c];
        node[3 + c] = node[6 + c] = node[9 + c] = 0;
        for (int k = 0; k < 3; k++) {
            node[3 + c] += FINE * a.weight[k] * position[3 * ((size_t)j * width + (size_t)(a.first + k)) + (size_t)c];
            node[6 + c] += FINE * b.weight[k] * position[3 * ((size_t)(b.first + k) * width + (size_t)i) + (size_t)c];
            for (int l = 0; l < 3; l++)
                node[9 + c] += FINE * FINE * a.weight[k] * b.weight[l] *
                               position[3 * ((size_t)(b.first + l) * width + (size_t)(a.first + k)) + (size_t)c];
        }
    }
}

static void patches_from_samples(const struct discretisation *patches, const struct surface *s, double *y)
{
    const struct sheet *sheet = patches->sheet;
    patches->op->flat(patches, y);
    for (int k = 0; k < patches->nnodes; k++) {
        double *node = y + patches->node[k];
        int i = (int)lround(node[0] / sheet->dx), j = (int)lround(node[1] / sheet->dy);
        node_from_samples(s, FINE * i, FINE * j, node);
    }
}

/* ---- the comparison ---- */

/* The largest distance between two states' corners of stitches, a free sheet's rigid motion aside. */
static double furthest_apart(const struct discretisation *d, const double *x, const struct discretisation *other,
                             const double *y, double growth)
{
    const struct sheet *sheet = d->sheet;
    struct surface a = surface_make(sheet->columns, sheet->rows, 1), b = surface_make(sheet->columns, sheet->rows, 1);
    double furthest = 0;
    d->op->sample(d, x, growth, &a);
    other->op->sample(other, y, growth, &b);
    if (sheet->spring <= 0)
        shape_align(&a), shape_align(&b);
    for (size_t i = 0; i < 3 * (size_t)(a.nx + 1) * (size_t)(a.ny + 1); i += 3) {
        double move[3] = {a.position[i] - b.position[i], a.position[i + 1] - b.position[i + 1],
                          a.position[i + 2] - b.position[i + 2]};
        furthest = fmax(furthest, sqrt(move[0] * move[0] + move[1] * move[1] + move[2] * move[2]));
    }
    surface_free(&a), surface_free(&b);
    return furthest;
}

/* What is known of the limit: it is below the patches' energy by the predicted
 * decrease at the least, by the patches' stated error at the most. */
static struct estimate compare(const struct problem *p, const double *x, const struct problem *other, const double *y)
{
    struct discretisation *finer = levels_patches(p->d->sheet, 2, p->d->threads);
    double *z = MEMORY_ARRAY(double, finer->n), ours = p->energy.total, theirs = other->energy.total;
    struct estimate error = estimate_error(other, other->d, other->factor, y, finer, z);
    double low = fabs(ours - (theirs - error.energy)), high = fabs(ours - (theirs - error.energy / ESTIMATE_BEYOND));
    finer->op->free(finer);
    free(z);
    return (struct estimate){fmax(low, high), error.shape + furthest_apart(p->d, x, other->d, y, p->growth)};
}

struct estimate cross_check(const struct problem *p, const double *x)
{
    const struct sheet *sheet = p->d->sheet;
    struct discretisation *patches = levels_patches(sheet, 1, p->d->threads);
    struct surface samples = surface_make(sheet->columns, sheet->rows, FINE);
    double *y = MEMORY_ARRAY(double, patches->n);
    p->d->op->sample(p->d, x, p->growth, &samples);
    patches_from_samples(patches, &samples, y);
    surface_free(&samples);

    struct problem other;
    problem_open(&other, patches, p->effort);
    other.growth = p->growth;
    other.progress = p->progress;
    other.progress_self = p->progress_self;
    other.limit = p->effort->iterations + MOST_ITERATIONS;
    other.tolerance = TOLERANCE * sheet->thickness * sheet->thickness;
    struct estimate error = {-1, -1};
    if (descent_to_minimum(&other, METHOD_AUTO, y).minimum)
        error = compare(p, x, &other, y);
    problem_close(&other);
    patches->op->free(patches);
    free(y);
    return error;
}
