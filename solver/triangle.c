/* SPDX-License-Identifier: GPL-3.0-or-later
 * The triangle discretisation: a sheet in, the struct every minimiser knows out. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/triangle.h"
#include "solver/triangle_model.h"

static void triangle_flat(const struct discretisation *d, double *x)
{
    const struct triangle *t = (const struct triangle *)d;
    memset(x, 0, (size_t)d->n * sizeof *x);
    for (int v = 0; v < t->mesh->nvertices; v++) {
        x[t->vertex_at[v]]     = t->mesh->rest[v][0];
        x[t->vertex_at[v] + 1] = t->mesh->rest[v][1];
    }
}

/* A third of each face's area at its corners, a third of its area times h^2/12 (rotary inertia) at its edges. */
static void triangle_mass(const struct discretisation *d, double *mass)
{
    const struct triangle *t = (const struct triangle *)d;
    double h = d->sheet->thickness;
    memset(mass, 0, (size_t)d->n * sizeof *mass);
    for (int k = 0; k < t->nbatches; k++) {
        const struct triangle_batch *b = &t->batch[k];
        for (int l = 0; l < b->count; l++)
            for (int i = 0; i < 3; i++) {
                double third = t->rest[b->rest].area[l] / 3;
                mass[b->edge[i][l]] += third * h * h / 12;
                for (int c = 0; c < 3; c++)
                    mass[b->vertex[i][l] + c] += third;
            }
    }
}

static void triangle_free(struct discretisation *d)
{
    struct triangle *t = (struct triangle *)d;
    if (!t)
        return;
    triangle_mesh_free(t->mesh);
    free(t->vertex_at);
    free(t->edge_at);
    free(t->rest);
    free(t->batch);
    free(t->slots);
    springs_free(&t->springs);
    free(t->base.pattern.start);
    free(t->base.pattern.row);
    free(t);
}

static const char *triangle_doubt(const struct discretisation *d, const double *x)
{
    return triangle_max_angle(d, x) > acos(-1) / 2 ? "an edge's normal is turned by more than 90 degrees: spurious, "
                                                     "the mesh is too coarse for this curvature" : NULL;
}

static const struct discretisation_ops triangle_ops = {
    .kind      = "triangle",
    .flat      = triangle_flat,
    .energy    = triangle_energy,
    .hessian   = triangle_hessian_values,
    .mass      = triangle_mass,
    .tangent   = triangle_tangent,
    .cotangent = triangle_cotangent,
    .prolong   = triangle_prolong,
    .sample    = triangle_sample,
    .doubt     = triangle_doubt,
    .free      = triangle_free,
};

static void make_springs(struct triangle *t)
{
    const struct triangle_mesh *m = t->mesh;
    for (int k = 0; k < m->nsprings; k++)
        springs_add(&t->springs, t->vertex_at[m->spring[k].a], t->vertex_at[m->spring[k].b], m->spring[k].stiffness);
    if (m->nsprings)
        springs_finish(&t->springs, &t->base);
}

struct discretisation *triangle_make_of_mesh(const struct sheet *sheet, struct triangle_mesh *mesh, int threads)
{
    struct triangle *t = memory_array(1, sizeof *t);
    double h = sheet->thickness, nu = sheet->poisson;
    t->base.op         = &triangle_ops;
    t->base.sheet      = sheet;
    t->base.per_stitch = mesh->per_stitch;
    t->base.elements   = mesh->nfaces;
    t->base.threads    = threads;
    t->mesh            = mesh;
    t->material = (struct triangle_material){ .c1 = nu / (1 - nu * nu), .c2 = 1 / (1 + nu),
                                              .stretch = h / 4, .bend = h * h * h / 12 };
    triangle_layout(t);
    make_springs(t);
    return &t->base;
}

struct discretisation *triangle_make(const struct sheet *sheet, int per_stitch, int threads)
{
    assert(per_stitch >= 1 && threads >= 1);
    return triangle_make_of_mesh(sheet, triangle_mesh_make(sheet, per_stitch), threads);
}

double triangle_max_angle(const struct discretisation *d, const double *x)
{
    struct triangle_face *face = memory_array((size_t)d->elements, sizeof *face);
    double angle = 0;
    triangle_faces(d, x, 0, face);
    for (long f = 0; f < d->elements; f++)
        angle = face[f].angle <= angle ? angle : face[f].angle;     /* nan wins */
    free(face);
    return angle;
}
