/* SPDX-License-Identifier: GPL-3.0-or-later
 * Stitches in, a flat triangle mesh along their lines out, and an order to
 * eliminate its unknowns in. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/triangle_mesh.h"

/* How a cell is cut.  Corners 0..3 counter-clockwise from the lower left, 4 its
 * centre; edges 0..3 below, right, above, left, from 4 on those within. */
struct split {
    int nfaces, ninner;
    int corner[4][3], edge[4][3];
};

enum { SLASH, BACKSLASH, CROSS };

static const struct split splits[] = {
    [SLASH]     = { 2, 1, { { 0, 1, 2 }, { 0, 2, 3 } }, { { 0, 1, 4 }, { 4, 2, 3 } } },
    [BACKSLASH] = { 2, 1, { { 0, 1, 3 }, { 1, 2, 3 } }, { { 0, 4, 3 }, { 1, 2, 4 } } },
    [CROSS]     = { 4, 4, { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } },
                    { { 0, 5, 4 }, { 1, 6, 5 }, { 2, 7, 6 }, { 3, 4, 7 } } },
};

/* The cut of cell i, j. */
static int split_at(const struct triangle_mesh *m, int i, int j)
{
    if (m->diagonals == DIAGONALS_CRISSCROSS)
        return CROSS;
    return m->diagonals == DIAGONALS_ALTERNATING && (i + j) % 2 ? BACKSLASH : SLASH;
}

int triangle_mesh_corner(const struct triangle_mesh *m, int i, int j)
{
    return j * (m->nx + 1) + i;
}

int triangle_mesh_centre(const struct triangle_mesh *m, int i, int j)
{
    return (m->nx + 1) * (m->ny + 1) + j * m->nx + i;
}

int triangle_mesh_edge_x(const struct triangle_mesh *m, int i, int j)
{
    return j * m->nx + i;
}

int triangle_mesh_edge_y(const struct triangle_mesh *m, int i, int j)
{
    return m->nx * (m->ny + 1) + j * (m->nx + 1) + i;
}

int triangle_mesh_ninner(const struct triangle_mesh *m)
{
    return splits[split_at(m, 0, 0)].ninner;
}

int triangle_mesh_nsplit(const struct triangle_mesh *m)
{
    return splits[split_at(m, 0, 0)].nfaces;
}

int triangle_mesh_inner(const struct triangle_mesh *m, int i, int j)
{
    return m->nx * (m->ny + 1) + (m->nx + 1) * m->ny + (j * m->nx + i) * triangle_mesh_ninner(m);
}

/* Room for a mesh of known counts. */
static struct triangle_mesh *mesh_alloc(int nvertices, int nedges, int nfaces)
{
    struct triangle_mesh *m = memory_array(1, sizeof *m);
    m->nvertices = nvertices;
    m->nedges    = nedges;
    m->nfaces    = nfaces;
    m->rest      = memory_array((size_t)nvertices, sizeof *m->rest);
    m->face      = memory_array((size_t)nfaces, sizeof *m->face);
    m->face_edge = memory_array((size_t)nfaces, sizeof *m->face_edge);
    m->edge      = memory_array((size_t)nedges, sizeof *m->edge);
    m->edge_face = memory_array((size_t)nedges, sizeof *m->edge_face);
    m->natural   = memory_array((size_t)nfaces, sizeof *m->natural);
    return m;
}

void triangle_mesh_free(struct triangle_mesh *m)
{
    if (!m)
        return;
    free(m->rest);
    free(m->face);
    free(m->face_edge);
    free(m->edge);
    free(m->edge_face);
    free(m->natural);
    free(m->spring);
    free(m->shape);
    free(m);
}

/* face, face_edge -> edge, edge_face.  The first face met along an edge gives it its direction. */
static bool edges_of_faces(struct triangle_mesh *m)
{
    for (int e = 0; e < m->nedges; e++)
        m->edge_face[e][0] = m->edge_face[e][1] = -1;
    for (int f = 0; f < m->nfaces; f++)
        for (int i = 0; i < 3; i++) {
            int e = m->face_edge[f][i], a = m->face[f][i], b = m->face[f][(i + 1) % 3];
            if (m->edge_face[e][0] < 0) {
                m->edge_face[e][0] = f;
                m->edge[e][0] = a;
                m->edge[e][1] = b;
            } else if (m->edge_face[e][1] < 0 && m->edge[e][0] == b && m->edge[e][1] == a) {
                m->edge_face[e][1] = f;
            } else {
                return false;
            }
        }
    return true;
}

/* Natural curvature of the stitch a cell lies in. */
static void stitch_natural(const struct sheet *s, int per_stitch, int i, int j, double *natural)
{
    size_t at = (size_t)(j / per_stitch) * (size_t)s->columns + (size_t)(i / per_stitch);
    natural[0] = s->kx[at];
    natural[1] = s->ky[at];
    natural[2] = s->twist ? s->twist[at] : 0;
}

/* The faces of cell i, j. */
static void cell_faces(struct triangle_mesh *m, const struct sheet *s, int i, int j)
{
    int kind = split_at(m, i, j), inner = triangle_mesh_inner(m, i, j);
    const struct split *cut = &splits[kind];
    int vertex[5] = { triangle_mesh_corner(m, i, j), triangle_mesh_corner(m, i + 1, j),
                      triangle_mesh_corner(m, i + 1, j + 1), triangle_mesh_corner(m, i, j + 1),
                      triangle_mesh_centre(m, i, j) };
    int edge[8] = { triangle_mesh_edge_x(m, i, j), triangle_mesh_edge_y(m, i + 1, j),
                    triangle_mesh_edge_x(m, i, j + 1), triangle_mesh_edge_y(m, i, j),
                    inner, inner + 1, inner + 2, inner + 3 };
    for (int t = 0; t < cut->nfaces; t++) {
        int f = (j * m->nx + i) * cut->nfaces + t;
        for (int k = 0; k < 3; k++) {
            m->face[f][k]      = vertex[cut->corner[t][k]];
            m->face_edge[f][k] = edge[cut->edge[t][k]];
        }
        m->shape[f] = (unsigned char)(kind == BACKSLASH ? 2 + t : t);
        stitch_natural(s, m->per_stitch, i, j, m->natural[f]);
    }
}

/* Springs along one edge of the boundary: 1/2 k Int |r - r_flat|^2 ds of linear r, entries k d/3 and k d/6. */
static void edge_springs(struct triangle_mesh *m, double k, int a, int b, double d)
{
    m->spring[m->nsprings++] = (struct triangle_spring){a, a, k * d / 3};
    m->spring[m->nsprings++] = (struct triangle_spring){b, b, k * d / 3};
    m->spring[m->nsprings++] = (struct triangle_spring){a, b, k * d / 6};
}

static void boundary_springs(struct triangle_mesh *m, const struct sheet *s)
{
    if (!(s->spring > 0))
        return;
    m->spring = memory_array(6 * (size_t)(m->nx + m->ny), sizeof *m->spring);
    for (int far = 0; far < 2; far++) {
        int i = far ? m->nx : 0, j = far ? m->ny : 0;
        if (s->spring_edges & (far ? EDGE_RIGHT : EDGE_LEFT))
            for (int k = 0; k < m->ny; k++)
                edge_springs(m, s->spring, triangle_mesh_corner(m, i, k), triangle_mesh_corner(m, i, k + 1), m->dy);
        if (s->spring_edges & (far ? EDGE_TOP : EDGE_BOTTOM))
            for (int k = 0; k < m->nx; k++)
                edge_springs(m, s->spring, triangle_mesh_corner(m, k, j), triangle_mesh_corner(m, k + 1, j), m->dx);
    }
}

struct triangle_mesh *triangle_mesh_make(const struct sheet *s, int per_stitch)
{
    struct triangle_mesh plan = { .per_stitch = per_stitch, .nx = s->columns * per_stitch,
                                  .ny = s->rows * per_stitch, .diagonals = s->mesh.diagonals };
    int nx = plan.nx, ny = plan.ny, cells = nx * ny;
    bool cross = plan.diagonals == DIAGONALS_CRISSCROSS;
    struct triangle_mesh *m = mesh_alloc((nx + 1) * (ny + 1) + (cross ? cells : 0),
                                         triangle_mesh_inner(&plan, 0, ny), cells * triangle_mesh_nsplit(&plan));
    m->per_stitch = per_stitch;
    m->nx = nx;
    m->ny = ny;
    m->dx = s->dx / per_stitch;
    m->dy = s->dy / per_stitch;
    m->diagonals = plan.diagonals;
    m->nshapes   = plan.diagonals == DIAGONALS_UNIFORM ? 2 : 4;
    m->shape     = memory_array((size_t)m->nfaces, 1);

    for (int j = 0; j <= ny; j++)
        for (int i = 0; i <= nx; i++) {
            double *rest = m->rest[triangle_mesh_corner(m, i, j)];
            rest[0] = i * m->dx;
            rest[1] = j * m->dy;
        }
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            if (cross) {
                double *rest = m->rest[triangle_mesh_centre(m, i, j)];
                rest[0] = (i + 0.5) * m->dx;
                rest[1] = (j + 0.5) * m->dy;
            }
            cell_faces(m, s, i, j);
        }
    bool manifold = edges_of_faces(m);
    assert(manifold);
    (void)manifold;
    boundary_springs(m, s);
    return m;
}

/* A face's side on its way to an edge number: its ends in ascending order. */
struct side { int low, high, place; };

static int side_compare(const void *a, const void *b)
{
    const struct side *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return (p->place > q->place) - (p->place < q->place);
}

struct triangle_mesh *triangle_mesh_of_faces(int nvertices, const double (*rest)[2], int nfaces, const int (*face)[3])
{
    /* Sort the sides so that those of one edge stand together, then number edges in the order of their first side. */
    size_t nsides = 3 * (size_t)nfaces;
    struct side *side = memory_array(nsides, sizeof *side);
    int *first = memory_array(nsides, sizeof *first), *number = memory_array(nsides, sizeof *number);
    for (int p = 0; p < (int)nsides; p++) {
        int a = face[p / 3][p % 3], b = face[p / 3][(p % 3 + 1) % 3];
        side[p] = (struct side){ a < b ? a : b, a < b ? b : a, p };
    }
    qsort(side, nsides, sizeof *side, side_compare);
    for (size_t p = 0; p < nsides; p++) {
        bool same = p > 0 && side[p].low == side[p - 1].low && side[p].high == side[p - 1].high;
        first[side[p].place] = same ? first[side[p - 1].place] : side[p].place;
    }
    int nedges = 0;
    for (size_t p = 0; p < nsides; p++)
        number[p] = first[p] == (int)p ? nedges++ : number[first[p]];

    struct triangle_mesh *m = mesh_alloc(nvertices, nedges, nfaces);
    memcpy(m->rest, rest, (size_t)nvertices * sizeof *m->rest);
    memcpy(m->face, face, (size_t)nfaces * sizeof *m->face);
    for (size_t p = 0; p < nsides; p++)
        m->face_edge[p / 3][p % 3] = number[p];
    free(side);
    free(first);
    free(number);
    if (edges_of_faces(m))
        return m;
    triangle_mesh_free(m);
    return NULL;
}

/* ---- Order of elimination ---------------------------------------------------
 * All nodes sit on a grid of twice the cells: corners at even-even places,
 * edges along x at odd-even, along y at even-odd, a cell's inside at odd-odd.
 * A line of even places separates what lies on its two sides. */
struct dissection {
    const struct triangle_mesh *mesh;
    int *order, norder;
    int *cell, ncell;
};

/* Appends all nodes at place a, b. */
static void emit(struct dissection *d, int a, int b)
{
    const struct triangle_mesh *m = d->mesh;
    int i = a / 2, j = b / 2;
    if (a % 2 && b % 2) {
        for (int k = 0; k < triangle_mesh_ninner(m); k++)
            d->order[d->norder++] = m->nvertices + triangle_mesh_inner(m, i, j) + k;
        if (m->diagonals == DIAGONALS_CRISSCROSS)
            d->order[d->norder++] = triangle_mesh_centre(m, i, j);
        d->cell[d->ncell++] = j * m->nx + i;
    } else if (a % 2) {
        d->order[d->norder++] = m->nvertices + triangle_mesh_edge_x(m, i, j);
    } else if (b % 2) {
        d->order[d->norder++] = m->nvertices + triangle_mesh_edge_y(m, i, j);
    } else {
        d->order[d->norder++] = triangle_mesh_corner(m, i, j);
    }
}

/* The even place nearest the middle of low..high. */
static int middle(int low, int high)
{
    int m = (low + high) / 2;
    return m % 2 == 0 ? m : m - 1 >= low ? m - 1 : m + 1;
}

/* Both sides of a separating line first, then the line; depth is at most twice the bits of a side's length. */
static void dissect(struct dissection *d, int a0, int a1, int b0, int b1)
{
    if (a0 > a1 || b0 > b1)
        return;
    if (a0 == a1 && b0 == b1) {
        emit(d, a0, b0);
    } else if (a1 - a0 >= b1 - b0) {
        int a = middle(a0, a1);
        dissect(d, a0, a - 1, b0, b1);
        dissect(d, a + 1, a1, b0, b1);
        dissect(d, a, a, b0, b1);
    } else {
        int b = middle(b0, b1);
        dissect(d, a0, a1, b0, b - 1);
        dissect(d, a0, a1, b + 1, b1);
        dissect(d, a0, a1, b, b);
    }
}

void triangle_mesh_dissect(const struct triangle_mesh *m, int *order, int *cell, int parts[2])
{
    struct dissection d = {.mesh = m, .order = order, .cell = cell};
    bool wide = m->nx >= m->ny;
    int a1 = 2 * m->nx, b1 = 2 * m->ny, cut = wide ? middle(0, a1) : middle(0, b1);
    dissect(&d, 0, wide ? cut - 1 : a1, 0, wide ? b1 : cut - 1);
    parts[0] = d.norder;
    dissect(&d, wide ? cut + 1 : 0, a1, wide ? 0 : cut + 1, b1);
    parts[1] = d.norder;
    dissect(&d, wide ? cut : 0, wide ? cut : a1, wide ? 0 : cut, wide ? b1 : cut);
    assert(d.norder == m->nvertices + m->nedges && d.ncell == m->nx * m->ny);
}
