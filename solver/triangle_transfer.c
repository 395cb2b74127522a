/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state of a stitch-aligned triangle mesh in; the state of a finer mesh, or a
 * sampled surface, out.  Between vertices the surface is a cubic through the
 * corners nearby. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "solver/memory.h"
#include "solver/triangle_model.h"

/* ---- A smooth surface through the corners ---------------------------------- */

enum { REACH = 5 };

/* Lagrange's weights of value and slope at u on the lines low..high: of the four around u, of five where u is one. */
struct interpolant {
    int    first, count;
    double value[REACH], slope[REACH];
};

static struct interpolant interpolant_at(int low, int high, double u)
{
    double nearest = round(u);
    bool line = fabs(u - nearest) < 1e-9;
    struct interpolant at = {.count = line ? 5 : 4};
    if (at.count > high - low + 1)
        at.count = high - low + 1;
    at.first = line ? (int)nearest - 2 : (int)floor(u) - 1;
    if (at.first > high + 1 - at.count)
        at.first = high + 1 - at.count;
    if (at.first < low)
        at.first = low;
    u = (line ? nearest : u) - at.first;
    for (int i = 0; i < at.count; i++) {
        double scale = 1, value = 1, slope = 0;
        for (int j = 0; j < at.count; j++)
            if (j != i) {
                scale *= i - j;
                slope = slope * (u - j) + value;
                value *= u - j;
            }
        at.value[i] = value / scale;
        at.slope[i] = slope / scale;
    }
    return at;
}

/* The lines of one stitch only, where curvature may jump at its sides and it has enough of them. */
static struct interpolant interpolant_within(int per_stitch, int n, double u)
{
    if (per_stitch < 3)
        return interpolant_at(0, n, u);
    int stitch = (int)(u / per_stitch);
    stitch -= stitch == n / per_stitch;
    return interpolant_at(stitch * per_stitch, (stitch + 1) * per_stitch, u);
}

/* Position and its derivatives by u and v, counted in cells from the lower left. */
static void surface_at(const struct triangle *t, const double *x, struct interpolant a, struct interpolant b,
                       double r[3], double ru[3], double rv[3])
{
    for (int c = 0; c < 3; c++)
        r[c] = ru[c] = rv[c] = 0;
    for (int j = 0; j < b.count; j++)
        for (int i = 0; i < a.count; i++) {
            const double *p = x + t->vertex_at[triangle_mesh_corner(t->mesh, a.first + i, b.first + j)];
            for (int c = 0; c < 3; c++) {
                r[c] += a.value[i] * b.value[j] * p[c];
                ru[c] += a.slope[i] * b.value[j] * p[c];
                rv[c] += a.value[i] * b.slope[j] * p[c];
            }
        }
}

/* ---- Means over a cell ------------------------------------------------------ */

struct cell {
    double area;
    double metric[3], curvature[3];     /* xx, yy, xy */
    double stretching, bending;         /* energies */
};

/* cell (nx * ny): what the faces of each hold, weighted by area. */
static void cells_of(const struct triangle *t, const double *x, double growth, struct cell *cell)
{
    const struct triangle_mesh *m = t->mesh;
    int nsplit = triangle_mesh_nsplit(m);
    struct triangle_face *face = MEMORY_ARRAY(struct triangle_face, m->nfaces);
    triangle_faces(&t->base, x, growth, face);
    for (int k = 0; k < m->nx * m->ny; k++) {
        cell[k] = (struct cell){.area = m->dx * m->dy};
        for (int s = 0; s < nsplit; s++) {
            const struct triangle_face *f = &face[k * nsplit + s];
            cell[k].stretching += f->stretching;
            cell[k].bending += f->bending;
            for (int c = 0; c < 3; c++) {       /* the faces of a cell are equal */
                cell[k].metric[c] += f->metric[c] / nsplit;
                cell[k].curvature[c] += f->curvature[c] / nsplit;
            }
        }
    }
    free(face);
}

/* ---- Prolongation ----------------------------------------------------------- */

/* sin(alpha_i) = w_i/h_i of a fine face that has curvature K: from e_i.K e_i = -2 (w_{i+1} + w_{i+2}). */
static void face_angles(const struct triangle *fine, int f, const double K[3], const double *x, double alpha[3])
{
    const struct triangle_mesh *m = fine->mesh;
    double k[3], q[3], e[3][3];
    for (int i = 0; i < 3; i++) {
        int a = m->face[f][i], b = m->face[f][(i + 1) % 3];
        double ex = m->rest[b][0] - m->rest[a][0], ey = m->rest[b][1] - m->rest[a][1];
        k[i] = -0.5 * (K[0] * ex * ex + K[1] * ey * ey + 2 * K[2] * ex * ey);
        for (int c = 0; c < 3; c++)
            e[i][c] = x[fine->vertex_at[b] + c] - x[fine->vertex_at[a] + c];
        q[i] = e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2];
    }
    double dot = e[0][0] * e[1][0] + e[0][1] * e[1][1] + e[0][2] * e[1][2], twice = sqrt(q[0] * q[1] - dot * dot);
    for (int i = 0; i < 3; i++) {
        double sine = 0.5 * (k[(i + 1) % 3] + k[(i + 2) % 3] - k[i]) * sqrt(q[i]) / twice;
        alpha[i] = asin(fmax(-1, fmin(1, sine)));
    }
}

/* Vertices lie on the smooth surface.  Each fine face takes the curvature of the coarse cell it lies in, which asks
 * for an angle to each of its edges; an edge's angle is half the difference of what its two faces ask for. */
void triangle_prolong(const struct discretisation *coarse, const double *x, const struct discretisation *fine,
                      double *x_fine)
{
    const struct triangle *from = (const struct triangle *)coarse, *to = (const struct triangle *)fine;
    const struct triangle_mesh *m = to->mesh;
    assert(from->mesh->nx > 0 && m->nx > 0);
    double ratio = (double)coarse->per_stitch / fine->per_stitch, ru[3], rv[3];
    for (int i = 0; i < fine->n; i++)
        x_fine[i] = 0;
    for (int v = 0; v < m->nvertices; v++)
        surface_at(from, x, interpolant_within(coarse->per_stitch, from->mesh->nx, m->rest[v][0] / m->dx * ratio),
                   interpolant_within(coarse->per_stitch, from->mesh->ny, m->rest[v][1] / m->dy * ratio),
                   x_fine + to->vertex_at[v], ru, rv);

    struct cell *cell = MEMORY_ARRAY(struct cell, from->mesh->nx * from->mesh->ny);
    cells_of(from, x, 0, cell);
    int nsplit = triangle_mesh_nsplit(m);
    for (int f = 0; f < m->nfaces; f++) {
        int i = (int)((f / nsplit % m->nx + 0.5) * ratio), j = (int)((f / nsplit / m->nx + 0.5) * ratio);
        double alpha[3];
        face_angles(to, f, cell[j * from->mesh->nx + i].curvature, x_fine, alpha);
        for (int k = 0; k < 3; k++) {
            int e = m->face_edge[f][k];
            double share = m->edge_face[e][1] < 0 ? 1 : m->edge_face[e][0] == f ? 0.5 : -0.5;
            x_fine[to->edge_at[e]] += share * alpha[k];
        }
    }
    free(cell);
}

/* ---- Sampling --------------------------------------------------------------- */

static void sample_points(const struct triangle *t, const double *x, struct surface *s)
{
    double step = (double)t->base.per_stitch / s->per_stitch;
    for (int j = 0; j <= s->ny; j++)
        for (int i = 0; i <= s->nx; i++) {
            size_t at = 3 * ((size_t)j * (size_t)(s->nx + 1) + (size_t)i);
            double ru[3], rv[3], *r = s->position + at, *n = s->normal + at;
            surface_at(t, x, interpolant_at(0, t->mesh->nx, i * step), interpolant_at(0, t->mesh->ny, j * step), r,
                       ru, rv);
            n[0] = ru[1] * rv[2] - ru[2] * rv[1];
            n[1] = ru[2] * rv[0] - ru[0] * rv[2];
            n[2] = ru[0] * rv[1] - ru[1] * rv[0];
            double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            double flat[3] = {i * step * t->mesh->dx, j * step * t->mesh->dy, 0};
            for (int c = 0; c < 3; c++) {
                n[c] /= length;
                s->displacement[at + (size_t)c] = r[c] - flat[c];
            }
        }
}

/* Adds share of a cell. */
static void cell_add(struct cell *sum, const struct cell *c, double share)
{
    sum->area += share * c->area;
    sum->stretching += share * c->stretching;
    sum->bending += share * c->bending;
    for (int k = 0; k < 3; k++) {
        sum->metric[k] += share * c->area * c->metric[k];
        sum->curvature[k] += share * c->area * c->curvature[k];
    }
}

/* Cells of the sample take from those of the mesh what they have in common: energies add up to the same. */
static void sample_cells(const struct triangle *t, const struct cell *cell, struct surface *s)
{
    const struct triangle_mesh *m = t->mesh;
    double step = (double)t->base.per_stitch / s->per_stitch;
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++) {
            struct cell sum = {0};
            double u = i * step, v = j * step;
            for (int b = (int)(v + 1e-9); b < m->ny && b < v + step - 1e-9; b++)
                for (int a = (int)(u + 1e-9); a < m->nx && a < u + step - 1e-9; a++)
                    cell_add(&sum, &cell[b * m->nx + a], (fmin(a + 1, u + step) - fmax(a, u)) *
                                                         (fmin(b + 1, v + step) - fmax(b, v)));
            double a11 = sum.metric[0] / sum.area, a22 = sum.metric[1] / sum.area, a12 = sum.metric[2] / sum.area;
            double b11 = sum.curvature[0] / sum.area, b22 = sum.curvature[1] / sum.area;
            double b12 = sum.curvature[2] / sum.area;
            double det = a11 * a22 - a12 * a12;
            size_t at = (size_t)j * (size_t)s->nx + (size_t)i;
            s->mean[at]       = 0.5 * (a22 * b11 + a11 * b22 - 2 * a12 * b12) / det;
            s->gauss[at]      = (b11 * b22 - b12 * b12) / det;
            s->stretching[at] = sum.stretching / sum.area;
            s->bending[at]    = sum.bending / sum.area;
        }
}

void triangle_sample(const struct discretisation *d, const double *x, double growth, struct surface *s)
{
    const struct triangle *t = (const struct triangle *)d;
    assert(t->mesh->nx > 0);
    struct cell *cell = MEMORY_ARRAY(struct cell, t->mesh->nx * t->mesh->ny);
    cells_of(t, x, growth, cell);
    sample_points(t, x, s);
    sample_cells(t, cell, s);
    free(cell);
}
