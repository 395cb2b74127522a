/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state of another program in, its energies by the triangles compared. */
#include "tests/solver/reference.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "solver/memory.h"
#include "solver/triangle.h"
#include "solver/triangle_model.h"
#include "tests/solver/scenes.h"

void *reference_array(int count, size_t size)
{
    return memory_array((size_t)count, size);
}

void reference_free(struct reference *r)
{
    free(r->rest);
    free(r->position);
    free(r->face);
    free(r->knit);
    free(r->angle);
    free(r->face_energy);
}

/* Natural curvatures of the stitches, and the reference's springs: one stiffness on every boundary vertex. */
static struct discretisation *discretise(const struct reference *r, const struct sheet *sheet, double **x)
{
    struct triangle_mesh *mesh = triangle_mesh_of_faces(r->nvertices, (const double(*)[2])r->rest, r->nfaces,
                                                        (const int(*)[3])r->face);
    assert_non_null(mesh);
    assert_int_equal(mesh->nedges, r->nedges);
    for (int f = 0; f < r->nfaces; f++) {
        mesh->natural[f][0] = r->knit[f] * sheet->kx[0];
        mesh->natural[f][1] = r->knit[f] * sheet->ky[0];
    }
    if (r->springs > 0) {
        mesh->spring = memory_array((size_t)r->nvertices, sizeof *mesh->spring);
        char *held = memory_array((size_t)r->nvertices, 1);
        for (int e = 0; e < mesh->nedges; e++)
            for (int k = 0; k < 2 && mesh->edge_face[e][1] < 0; k++)
                if (!held[mesh->edge[e][k]]++)
                    mesh->spring[mesh->nsprings++] =
                        (struct triangle_spring){mesh->edge[e][k], mesh->edge[e][k], r->spring};
        free(held);
    }
    struct discretisation *d = triangle_make_of_mesh(sheet, mesh, 1);
    const struct triangle *t = (const struct triangle *)d;
    *x = memory_array((size_t)d->n, sizeof **x);
    for (int v = 0; v < r->nvertices; v++)
        memcpy(*x + t->vertex_at[v], r->position[v], 3 * sizeof **x);
    for (int e = 0; e < r->nedges; e++)
        (*x)[t->edge_at[e]] = r->angle[e];
    return d;
}

static void assert_close(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%.17g is not %.17g: off by %.2e", value, expected, value / expected - 1);
}

void reference_check(const struct reference *r)
{
    struct sheet *sheet = scene_sheet(1, 1, NULL);
    double *x;
    struct discretisation *d = discretise(r, sheet, &x);
    struct fold_energy e = d->op->energy(d, x, 1, NULL);
    assert_close(e.stretching, r->stretching, 1e-9);
    assert_close(e.bending, r->bending, 1e-9);
    if (r->springs > 0)
        assert_close(e.springs, r->springs, 1e-9);
    if (r->face_energy) {
        struct triangle_face *face = memory_array((size_t)r->nfaces, sizeof *face);
        triangle_faces(d, x, 1, face);
        for (int f = 0; f < r->nfaces; f++) {
            assert_close(face[f].stretching, r->face_energy[f][0], 1e-9);
            assert_close(face[f].bending, r->face_energy[f][1], 1e-9);
        }
        free(face);
    }
    /* A state its program calls minimised: no force is left. */
    double *g = memory_array((size_t)d->n, sizeof *g), largest = 0;
    d->op->energy(d, x, 1, g);
    for (int i = 0; i < d->n; i++)
        largest = fmax(largest, fabs(g[i]));
    assert_true(largest < 1e-6);
    print_message("# largest gradient %.1e, largest angle %.1f degrees\n", largest,
                  triangle_max_angle(d, x) * 180 / M_PI);
    free(g);
    free(x);
    d->op->free(d);
    sheet_free(sheet);
}
