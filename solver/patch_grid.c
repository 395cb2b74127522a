/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sheet and resolution in; numbering, sparsity pattern, stripes and tables of
 * the patches out. */
#include "solver/patch_grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver/dissection.h"
#include "solver/memory.h"

enum {
    SIDE_BY_SIDE = 3000,    /* unknowns from which halves are worth factoring apart */
    MOST_STRIPES = 32
};

/* Derivatives on the sheet from those on the unit square: d/dx = 1/hx d/ds. */
static void scale_derivatives(const struct patch *p, const double N[3][3][BASIS_MAX],
                              double D[D_COUNT][BASIS_MAX])
{
    for (int a = 0; a < p->basis->count; a++) {
        D[D_P][a] = N[1][0][a] / p->hx;
        D[D_Q][a] = N[0][1][a] / p->hy;
        D[D_XX][a] = N[2][0][a] / (p->hx * p->hx);
        D[D_YY][a] = N[0][2][a] / (p->hy * p->hy);
        D[D_XY][a] = N[1][1][a] / (p->hx * p->hy);
    }
}

void patch_tabulate(const struct patch *p, int gauss, double *area, double (*table)[D_COUNT][BASIS_MAX])
{
    double at[GAUSS_MAX], weight[GAUSS_MAX], N[3][3][BASIS_MAX];
    basis_gauss(gauss, at, weight);
    for (int g = 0; g < gauss * gauss; g++) {
        basis_at(p->basis, at[g % gauss], at[g / gauss], N);
        scale_derivatives(p, N, table[g]);
        area[g] = weight[g % gauss] * weight[g / gauss] * p->hx * p->hy;
    }
}

/* Later neighbours of the node at (x, y), by place; returns their number. */
static int later_neighbours(const struct patch *p, int x, int y, int *places)
{
    int reach = p->basis->span - 1, own = p->place[y * p->mx + x], count = 0;
    for (int j = y - reach; j <= y + reach; j++)
        for (int i = x - reach; i <= x + reach; i++) {
            if (i < 0 || j < 0 || i >= p->mx || j >= p->my || p->place[j * p->mx + i] <= own)
                continue;
            int place = p->place[j * p->mx + i], k = count++;
            for (; k > 0 && places[k - 1] > place; k--)
                places[k] = places[k - 1];
            places[k] = place;
        }
    return count;
}

/* Columns in elimination order; a node's columns hold its own rows from the
 * diagonal down, then all rows of its later neighbours. */
static void make_pattern(struct patch *p)
{
    int nnodes = p->mx * p->my, m = p->per_node, *at = MEMORY_ARRAY(int, nnodes), later[24];
    for (int i = 0; i < nnodes; i++)
        at[p->place[i]] = i;
    struct pattern *pattern = &p->d.pattern;
    pattern->n = p->d.n;
    pattern->start = MEMORY_ARRAY(int, p->d.n + 1);
    for (int node = 0; node < nnodes; node++) {
        int count = later_neighbours(p, at[node] % p->mx, at[node] / p->mx, later);
        for (int c = 0; c < m; c++)
            pattern->start[node * m + c + 1] = pattern->start[node * m + c] + m - c + m * count;
    }
    pattern->row = MEMORY_ARRAY(int, pattern->start[p->d.n]);
    for (int node = 0; node < nnodes; node++) {
        int count = later_neighbours(p, at[node] % p->mx, at[node] / p->mx, later);
        for (int c = 0; c < m; c++) {
            int *row = pattern->row + pattern->start[node * m + c];
            for (int r = c; r < m; r++)
                *row++ = node * m + r;
            for (int k = 0; k < count; k++)
                for (int r = 0; r < m; r++)
                    *row++ = later[k] * m + r;
        }
    }
    free(at);
}

/* The offset of each pair of an element's nodes: the later one's rank among the neighbours of the earlier. */
static void make_offsets(struct patch *p)
{
    int span = p->basis->span, nen = span * span, m = p->per_node, first[9];
    p->npairs = nen * (nen - 1) / 2;
    p->offset = MEMORY_ARRAY(short, (size_t)p->d.elements * (size_t)p->npairs);
    short *offset = p->offset;
    for (int e = 0; e < p->d.elements; e++) {
        patch_nodes(p, e, first);
        for (int high = 1; high < nen; high++)
            for (int low = 0; low < high; low++) {
                int I = first[high] > first[low] ? first[high] : first[low];
                int J = first[high] > first[low] ? first[low] : first[high];
                int k = p->d.pattern.start[J] + m;
                while (p->d.pattern.row[k] != I)
                    k += m;
                *offset++ = (short)(k - p->d.pattern.start[J]);
            }
    }
}

/* Stripes across the longer side, each at least `span` elements deep: every
 * other one shares no node with the next but one. */
static void make_stripes(struct patch *p)
{
    bool across = p->nx > p->ny;
    int deep = across ? p->nx : p->ny, wide = across ? p->ny : p->nx, span = p->basis->span;
    p->nstripes = deep / span < MOST_STRIPES ? deep / span : MOST_STRIPES;
    p->nstripes = p->nstripes ? p->nstripes : 1;
    p->stripe = MEMORY_ARRAY(int, p->nstripes + 1);
    p->batch = MEMORY_ARRAY(struct patch_batch, p->d.elements / LANES + p->nstripes);
    for (int s = 0; s < p->nstripes; s++) {
        p->stripe[s] = p->nbatches;
        int filled = LANES, end = (int)((long)deep * (s + 1) / p->nstripes);
        for (int i = (int)((long)deep * s / p->nstripes); i < end; i++)
            for (int j = 0; j < wide; j++) {
                if (filled == LANES)
                    filled = 0, p->nbatches++;
                struct patch_batch *b = &p->batch[p->nbatches - 1];
                b->element[filled++] = across ? j * p->nx + i : i * p->nx + j;
                b->count = filled;
            }
    }
    p->stripe[p->nstripes] = p->nbatches;
    p->energy = MEMORY_ARRAY(double, 2 * p->nbatches);
}

struct patch *patch_grid_make(const struct sheet *sheet, const struct basis *basis, int per_stitch, int gauss)
{
    struct patch *p = MEMORY_ARRAY(struct patch, 1);
    p->basis = basis;
    p->nx = sheet->columns * per_stitch;
    p->ny = sheet->rows * per_stitch;
    p->mx = p->nx + basis->span - 1;
    p->my = p->ny + basis->span - 1;
    p->per_node = 3 * basis->per_node;
    p->hx = sheet->dx / per_stitch;
    p->hy = sheet->dy / per_stitch;
    p->plate = plate_make(sheet->thickness, sheet->poisson);
    p->d.sheet = sheet;
    p->d.per_stitch = per_stitch;
    p->d.nnodes = p->mx * p->my;
    p->d.block = p->per_node;
    p->d.n = p->per_node * p->d.nnodes;
    p->d.elements = (long)p->nx * p->ny;
    p->d.ordered = true;
    p->ngauss = gauss * gauss;
    patch_tabulate(p, gauss, p->weight, p->N);
    p->retraction = patch_retraction_make();

    p->place = MEMORY_ARRAY(int, p->d.nnodes);
    p->node = MEMORY_ARRAY(int, p->d.nnodes);
    int parts[2];
    dissection_order(p->mx, p->my, basis->span - 1, p->place, parts);
    for (int k = 0; k < 2 && p->d.n > SIDE_BY_SIDE; k++)
        p->d.parts[k] = p->per_node * parts[k];
    for (int i = 0; i < p->d.nnodes; i++)
        p->node[i] = p->per_node * i;
    p->d.node = p->node;
    make_pattern(p);
    make_offsets(p);
    make_stripes(p);
    return p;
}

void patch_grid_free(struct patch *p)
{
    free(p->place);
    free(p->node);
    free(p->d.pattern.start);
    free(p->d.pattern.row);
    free(p->offset);
    free(p->stripe);
    free(p->batch);
    free(p->energy);
    springs_free(&p->springs);
    patch_retraction_free(p->retraction);
    free(p);
}

/* Stiffness times Int N_a N_b ds along one side of an element; four Gauss points are exact. */
static void spring_side(struct patch *p, int element, unsigned side)
{
    double at[4], weight[4], N[3][3][BASIS_MAX];
    bool vertical = side & (EDGE_LEFT | EDGE_RIGHT);
    double along = vertical ? p->hy : p->hx, end = side & (EDGE_RIGHT | EDGE_TOP) ? 1 : 0;
    double K[BASIS_MAX][BASIS_MAX] = {{0}};
    int first[9], nfun = p->basis->count, per_node = p->basis->per_node;
    basis_gauss(4, at, weight);
    for (int g = 0; g < 4; g++) {
        basis_at(p->basis, vertical ? end : at[g], vertical ? at[g] : end, N);
        for (int a = 0; a < nfun; a++)
            for (int b = 0; b <= a; b++)
                K[a][b] += p->d.sheet->spring * along * weight[g] * N[0][0][a] * N[0][0][b];
    }
    patch_nodes(p, element, first);
    for (int a = 0; a < nfun; a++)
        for (int b = 0; b <= a; b++)
            if (K[a][b] != 0)
                springs_add(&p->springs, first[a / per_node] + 3 * (a % per_node),
                            first[b / per_node] + 3 * (b % per_node), K[a][b]);
}

void patch_springs(struct patch *p)
{
    const struct sheet *sheet = p->d.sheet;
    if (sheet->spring <= 0)
        return;
    for (int e = 0; e < p->d.elements; e++) {
        int x = e % p->nx, y = e / p->nx;
        unsigned sides = (x == 0 ? EDGE_LEFT : 0u) | (x == p->nx - 1 ? EDGE_RIGHT : 0u) |
                         (y == 0 ? EDGE_BOTTOM : 0u) | (y == p->ny - 1 ? EDGE_TOP : 0u);
        for (unsigned side = EDGE_LEFT; side <= EDGE_BOTTOM; side *= 2)
            if (sides & sheet->spring_edges & side)
                spring_side(p, e, side);
    }
    if (p->springs.count)
        springs_finish(&p->springs, &p->d);
}

/* A Hermite node stands at its grid point; a spline coefficient half an element
 * before it (the Greville abscissa of a uniform quadratic). */
void patch_flat(const struct discretisation *d, double *x)
{
    const struct patch *p = (const struct patch *)d;
    bool spline = p->basis->kind == BASIS_SPLINE;
    double shift = spline ? 0.5 : 0;
    for (int j = 0; j < p->my; j++)
        for (int i = 0; i < p->mx; i++) {
            double *r = x + p->per_node * p->place[j * p->mx + i];
            for (int k = 0; k < p->per_node; k++)
                r[k] = 0;
            r[0] = (i - shift) * p->hx;
            r[1] = (j - shift) * p->hy;
            if (!spline)
                r[3] = p->hx, r[7] = p->hy;
        }
}

/* The diagonal of the mass matrix: Int N_a^2. */
void patch_mass(const struct discretisation *d, double *mass)
{
    const struct patch *p = (const struct patch *)d;
    double at[4], weight[4], N[3][3][BASIS_MAX], M[BASIS_MAX] = {0};
    int first[9];
    basis_gauss(4, at, weight);
    for (int g = 0; g < 16; g++) {
        basis_at(p->basis, at[g % 4], at[g / 4], N);
        for (int a = 0; a < p->basis->count; a++)
            M[a] += weight[g % 4] * weight[g / 4] * p->hx * p->hy * N[0][0][a] * N[0][0][a];
    }
    for (int i = 0; i < d->n; i++)
        mass[i] = 0;
    for (int e = 0; e < d->elements; e++) {
        patch_nodes(p, e, first);
        for (int a = 0; a < p->basis->count; a++)
            for (int c = 0; c < 3; c++)
                mass[first[a / p->basis->per_node] + 3 * (a % p->basis->per_node) + c] += M[a];
    }
}

/* Shape functions at place (u, v), counted in elements from the lower left, and first unknowns of their nodes. */
static void locate(const struct patch *p, double u, double v, double N[3][3][BASIS_MAX], int first[9])
{
    int ex = (int)u < p->nx ? (int)u : p->nx - 1, ey = (int)v < p->ny ? (int)v : p->ny - 1;
    basis_at(p->basis, u - ex, v - ey, N);
    patch_nodes(p, ey * p->nx + ex, first);
}

/* Position and derivatives on the unit square at place (u, v). */
static void evaluate(const struct patch *p, const double *x, double u, double v, double r[3][3][3])
{
    int first[9];
    double N[3][3][BASIS_MAX];
    locate(p, u, v, N, first);
    for (int i = 0; i < 3; i++)
        for (int j = 0; i + j < 3; j++)
            for (int c = 0; c < 3; c++) {
                r[i][j][c] = 0;
                for (int a = 0; a < p->basis->count; a++)
                    r[i][j][c] += N[i][j][a] * x[first[a / p->basis->per_node] + 3 * (a % p->basis->per_node) + c];
            }
}

static double dot3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit_normal(const double *p, const double *q, double *n)
{
    double m[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    double J = sqrt(dot3(m, m));
    for (int c = 0; c < 3; c++)
        n[c] = m[c] / J;
}

/* Curvatures and energy densities at a cell's centre; a, b: first and second fundamental form. */
static void sample_cell(const struct patch *p, const double *x, double growth, double u, double v, size_t cell,
                        struct surface *s)
{
    const struct sheet *sheet = p->d.sheet;
    double r[3][3][3], n[3];
    evaluate(p, x, u, v, r);
    unit_normal(r[1][0], r[0][1], n);
    double hx = p->hx, hy = p->hy;
    double a11 = dot3(r[1][0], r[1][0]) / (hx * hx), a22 = dot3(r[0][1], r[0][1]) / (hy * hy);
    double a12 = dot3(r[1][0], r[0][1]) / (hx * hy);
    double b11 = dot3(r[2][0], n) / (hx * hx), b22 = dot3(r[0][2], n) / (hy * hy), b12 = dot3(r[1][1], n) / (hx * hy);
    double det = a11 * a22 - a12 * a12;
    s->mean[cell] = 0.5 * (a22 * b11 + a11 * b22 - 2 * a12 * b12) / det;
    s->gauss[cell] = (b11 * b22 - b12 * b12) / det;

    size_t stitch = (size_t)(int)(v / p->d.per_stitch) * (size_t)sheet->columns + (size_t)(int)(u / p->d.per_stitch);
    double e11 = a11 - 1, e22 = a22 - 1, k11 = b11 - growth * sheet->kx[stitch];
    double k22 = b22 - growth * sheet->ky[stitch], k12 = b12 - growth * sheet->twist[stitch];
    s->stretching[cell] = 0.5 * (p->plate.s1 * (e11 + e22) * (e11 + e22) +
                                 p->plate.s2 * (e11 * e11 + e22 * e22 + 2 * a12 * a12));
    s->bending[cell] = 0.5 * (p->plate.b1 * (k11 + k22) * (k11 + k22) +
                              p->plate.b2 * (k11 * k11 + k22 * k22 + 2 * k12 * k12));
}

/* Area over that at rest, at a Gauss point of an element. */
static double stretch_of_area(const struct patch *p, const double *x, const int *first, int g)
{
    double d[2][3] = {{0}};
    for (int a = 0; a < p->basis->count; a++) {
        const double *r = x + first[a / p->basis->per_node] + 3 * (a % p->basis->per_node);
        for (int c = 0; c < 3; c++)
            d[0][c] += p->N[g][D_P][a] * r[c], d[1][c] += p->N[g][D_Q][a] * r[c];
    }
    double pq = dot3(d[0], d[1]);
    return sqrt(fmax(dot3(d[0], d[0]) * dot3(d[1], d[1]) - pq * pq, 0));
}

/* The energy stays finite where area vanishes, and the normal may jump there:
 * where that pays, there is no minimum to find. */
const char *patch_doubt(const struct discretisation *d, const double *x)
{
    static const double CRUSHED = 0.01;
    const struct patch *p = (const struct patch *)d;
    int first[9];
    for (int e = 0; e < p->nx * p->ny; e++) {
        patch_nodes(p, e, first);
        for (int g = 0; g < p->ngauss; g++)
            if (stretch_of_area(p, x, first, g) < CRUSHED)
                return "the sheet is crushed to a hundredth of its area somewhere: with this thickness, curvature and "
                       "Poisson's ratio it is no thin sheet";
    }
    return NULL;
}

void patch_sample(const struct discretisation *d, const double *x, double growth, struct surface *s)
{
    const struct patch *p = (const struct patch *)d;
    double step = (double)d->per_stitch / s->per_stitch;
    for (int j = 0; j <= s->ny; j++)
        for (int i = 0; i <= s->nx; i++) {
            size_t point = (size_t)j * (size_t)(s->nx + 1) + (size_t)i;
            double r[3][3][3];
            evaluate(p, x, i * step, j * step, r);
            unit_normal(r[1][0], r[0][1], s->normal + 3 * point);
            double flat[3] = {i * step * p->hx, j * step * p->hy, 0};
            for (int c = 0; c < 3; c++) {
                s->position[3 * point + c] = r[0][0][c];
                s->displacement[3 * point + c] = r[0][0][c] - flat[c];
            }
            if (i < s->nx && j < s->ny)
                sample_cell(p, x, growth, (i + 0.5) * step, (j + 0.5) * step,
                            (size_t)j * (size_t)s->nx + (size_t)i, s);
        }
}
