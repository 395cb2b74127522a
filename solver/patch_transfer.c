/* SPDX-License-Identifier: GPL-3.0-or-later
 * Between nested levels of patches: a coarse state in, the same surface on the
 * fine level out; fine gradients and Hessians in, their restrictions out. */
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/patch_grid.h"

/* Coarse functions at a fine grid line, in one direction: those that vanish
 * there with their derivative are left out. */
struct line {
    int    element;                     /* the coarse one it lies in */
    int    count;
    int    node[BASIS_LINE];            /* a function's node, counted from the element's first */
    int    kind[BASIS_LINE];            /* 0: value or spline coefficient, 1: slope */
    double weight[BASIS_LINE][2];       /* of the function in the fine value and slope */
};

/* The matrix P of prolong by its one-dimensional factors: the fine value k = kx + 2 ky
 * (r, r_s, r_t, r_st) of node (i, j) is Sum_ab column[i].weight[a][kx] row[j].weight[b][ky] x_ab. */
struct transfer {
    const struct patch *coarse, *fine;
    struct line        *column, *row;   /* (fine mx), (fine my) */
};

static struct line *make_lines(const struct basis *basis, int elements, int nlines, double ratio)
{
    struct line *lines = MEMORY_ARRAY(struct line, nlines);
    for (int i = 0; i < nlines; i++) {
        struct line *l = &lines[i];
        double f[BASIS_LINE][3];
        l->element = (int)(i * ratio) < elements ? (int)(i * ratio) : elements - 1;
        int nfun = basis_line(basis, i * ratio - l->element, f);
        for (int a = 0; a < nfun; a++) {
            if (f[a][0] == 0 && f[a][1] == 0)
                continue;
            int b = l->count++;
            l->node[b] = basis->kind == BASIS_HERMITE ? a / 2 : a;
            l->kind[b] = basis->kind == BASIS_HERMITE ? a % 2 : 0;
            l->weight[b][0] = f[a][0];
            l->weight[b][1] = ratio * f[a][1];
        }
    }
    return lines;
}

static struct transfer transfer_make(const struct discretisation *coarse, const struct discretisation *fine)
{
    const struct patch *from = (const struct patch *)coarse, *to = (const struct patch *)fine;
    double ratio = (double)from->nx / to->nx;
    return (struct transfer){.coarse = from, .fine = to,
                             .column = make_lines(from->basis, from->nx, to->mx, ratio),
                             .row = make_lines(from->basis, from->ny, to->my, ratio)};
}

static void transfer_free(struct transfer *t)
{
    free(t->column);
    free(t->row);
}

/* First unknown of coarse function (a, b) at fine node (i, j). */
static int coarse_unknown(const struct transfer *t, int i, int j, int a, int b)
{
    const struct patch *p = t->coarse;
    const struct line *c = &t->column[i], *r = &t->row[j];
    int node = p->place[(r->element + r->node[b]) * p->mx + c->element + c->node[a]];
    return p->per_node * node + 3 * (c->kind[a] + 2 * r->kind[b]);
}

static int fine_unknown(const struct transfer *t, int i, int j)
{
    return t->fine->per_node * t->fine->place[j * t->fine->mx + i];
}

/* Hermite values of the coarse surface at the fine nodes; exact, as the spaces
 * are nested.  The fine level is Hermite. */
void patch_prolong(const struct discretisation *coarse, const double *x, const struct discretisation *fine,
                   double *x_fine)
{
    struct transfer t = transfer_make(coarse, fine);
    int mx = t.fine->mx, my = t.fine->my;
#pragma omp parallel for num_threads(fine->threads) if (fine->threads > 1)
    for (int j = 0; j < my; j++)
        for (int i = 0; i < mx; i++) {
            double value[12] = {0};
            for (int b = 0; b < t.row[j].count; b++)
                for (int a = 0; a < t.column[i].count; a++) {
                    const double *r = x + coarse_unknown(&t, i, j, a, b);
                    for (int k = 0; k < 4; k++) {
                        double w = t.column[i].weight[a][k % 2] * t.row[j].weight[b][k / 2];
                        for (int c = 0; c < 3; c++)
                            value[3 * k + c] += w * r[c];
                    }
                }
            memcpy(x_fine + fine_unknown(&t, i, j), value, sizeof value);
        }
    transfer_free(&t);
}

static void restrict_row(const struct transfer *t, int j, const double *gradient_fine, double *gradient_coarse)
{
    for (int i = 0; i < t->fine->mx; i++) {
        const double *g = gradient_fine + fine_unknown(t, i, j);
        for (int b = 0; b < t->row[j].count; b++)
            for (int a = 0; a < t->column[i].count; a++) {
                double *r = gradient_coarse + coarse_unknown(t, i, j, a, b);
                for (int k = 0; k < 4; k++) {
                    double w = t->column[i].weight[a][k % 2] * t->row[j].weight[b][k / 2];
                    for (int c = 0; c < 3; c++)
                        r[c] += w * g[3 * k + c];
                }
            }
    }
}

/* Coarse rows are taken in bands; no two bands of a parity share a coarse node,
 * so that sums come in one order whatever the number of threads. */
enum { BAND = 8 };

/* The transpose of patch_prolong. */
void patch_restrict(const struct discretisation *coarse, double *gradient_coarse, const struct discretisation *fine,
                    const double *gradient_fine)
{
    struct transfer t = transfer_make(coarse, fine);
    int my = t.fine->my, per_row = (my - 1) / t.coarse->ny, nbands = t.coarse->ny / BAND + 1;
    memset(gradient_coarse, 0, sizeof *gradient_coarse * (size_t)coarse->n);
    for (int parity = 0; parity < 2; parity++) {
#pragma omp parallel for num_threads(fine->threads) if (fine->threads > 1)
        for (int band = parity; band < nbands; band += 2) {
            int end = band == nbands - 1 ? my : (band + 1) * BAND * per_row;
            for (int j = band * BAND * per_row; j < end; j++)
                restrict_row(&t, j, gradient_fine, gradient_coarse);
        }
    }
    transfer_free(&t);
}

/* ---- Hessians ---- */

/* The rows W (12 x unknowns) of P at a fine node. */
struct node_rows {
    int    count;
    int    unknown[BASIS_MAX];          /* first of the coarse function's three */
    double weight[BASIS_MAX][4];
};

static struct node_rows *make_rows(const struct transfer *t)
{
    struct node_rows *rows = MEMORY_ARRAY(struct node_rows, t->fine->d.nnodes);
    for (int j = 0; j < t->fine->my; j++)
        for (int i = 0; i < t->fine->mx; i++) {
            struct node_rows *r = &rows[t->fine->place[j * t->fine->mx + i]];
            for (int b = 0; b < t->row[j].count; b++)
                for (int a = 0; a < t->column[i].count; a++, r->count++) {
                    r->unknown[r->count] = coarse_unknown(t, i, j, a, b);
                    for (int k = 0; k < 4; k++)
                        r->weight[r->count][k] = t->column[i].weight[a][k % 2] * t->row[j].weight[b][k / 2];
                }
        }
    return rows;
}

/* Adds B (3 x 3) to rows and columns that begin at row and column, both triangles of it
 * where they are the same and it comes from two nodes. */
static void add_block(const struct pattern *pattern, double *value, int row, int column, double B[3][3], bool both)
{
    bool own = row == column, transposed = row < column;
    int low = transposed ? row : column, high = transposed ? column : row;
    for (int j = 0; j < 3; j++) {
        double *v = value + pattern_find(pattern, own ? low + j : high, low + j);
        for (int i = own ? j : 0; i < 3; i++)
            *v++ += (transposed ? B[j][i] : B[i][j]) + (own && both ? B[j][i] : 0);
    }
}

/* Adds W_i^T H_ij W_j and, for i /= j, its transpose; H (12 x 12) by columns. */
static void restrict_pair(const struct pattern *pattern, double *value, const struct node_rows *I,
                          const struct node_rows *J, double H[12][12], bool same)
{
    for (int b = 0; b < J->count; b++) {
        double T[3][12] = {{0}};        /* H_ij W_j for function b, by columns */
        for (int k = 0; k < 12; k++)
            for (int r = 0; r < 12; r++)
                T[k % 3][r] += J->weight[b][k / 3] * H[k][r];
        for (int a = 0; a < I->count; a++) {
            if (same && I->unknown[a] < J->unknown[b])
                continue;
            double B[3][3] = {{0}};
            for (int k = 0; k < 12; k++)
                for (int j = 0; j < 3; j++)
                    B[k % 3][j] += I->weight[a][k / 3] * T[j][k];
            add_block(pattern, value, I->unknown[a], J->unknown[b], B, !same);
        }
    }
}

/* The block of a node's columns from row place k of its first column on, by columns. */
static void read_block(const struct pattern *p, const double *value, int node, int k, bool own, double H[12][12])
{
    for (int c = 0; c < 12; c++) {
        const double *column = value + p->start[12 * node + c] + (k - p->start[12 * node]) - c;
        for (int r = own ? c : 0; r < 12; r++)
            H[c][r] = column[r];
        for (int r = c + 1; own && r < 12; r++)
            H[r][c] = column[r];
    }
}

/* P^T H P, node pair by node pair. */
void patch_restrict_hessian(const struct discretisation *coarse, double *value_coarse,
                            const struct discretisation *fine, const double *value_fine)
{
    struct transfer t = transfer_make(coarse, fine);
    struct node_rows *rows = make_rows(&t);
    const struct pattern *p = &fine->pattern;
    memset(value_coarse, 0, sizeof *value_coarse * (size_t)coarse->pattern.start[coarse->n]);
    for (int node = 0; node < fine->nnodes; node++)
        for (int k = p->start[12 * node]; k < p->start[12 * node + 1]; k += 12) {
            int other = p->row[k] / 12;
            double H[12][12];
            read_block(p, value_fine, node, k, other == node, H);
            restrict_pair(&coarse->pattern, value_coarse, &rows[other], &rows[node], H, other == node);
        }
    free(rows);
    transfer_free(&t);
}
