/* SPDX-License-Identifier: GPL-3.0-or-later
 * Eight elements of a patch grid side by side: where their unknowns are, and
 * the ways from the unknowns to lanes and back. */
#ifndef WEFT_PATCH_BATCH_H
#define WEFT_PATCH_BATCH_H

#include "solver/patch_grid.h"

struct batch {
    const struct patch *patch;
    int                 count;              /* elements in use, the rest repeat the first */
    int                 element[LANES];
    int                 first[LANES][9];    /* first unknown of each of an element's nodes */
};

static inline void batch_open(const struct patch *p, int index, struct batch *b)
{
    b->patch = p;
    b->count = p->batch[index].count;
    for (int l = 0; l < LANES; l++) {
        b->element[l] = p->batch[index].element[l < b->count ? l : 0];
        patch_nodes(p, b->element[l], b->first[l]);
    }
}

LANES_INLINE void batch_gather(const struct batch *b, const double *x, int nfun, int per_node, struct vec *X)
{
    for (int l = 0; l < LANES; l++)
        for (int a = 0; a < nfun; a++) {
            const double *r = x + b->first[l][a / per_node] + 3 * (a % per_node);
            X[a].x[l] = r[0], X[a].y[l] = r[1], X[a].z[l] = r[2];
        }
}

/* Adds to the elements' unknowns. */
LANES_INLINE void batch_scatter(const struct batch *b, const struct vec *G, int nfun, int per_node, double *gradient)
{
    for (int l = 0; l < b->count; l++)
        for (int a = 0; a < nfun; a++) {
            double *g = gradient + b->first[l][a / per_node] + 3 * (a % per_node);
            g[0] += G[a].x[l], g[1] += G[a].y[l], g[2] += G[a].z[l];
        }
}

/* d_i = Sum_a N_i^a X_a, i < count */
LANES_INLINE void batch_derive(const double (*N)[BASIS_MAX], int count, int nfun, const struct vec *X, struct vec *d)
{
    for (int i = 0; i < count; i++) {
        struct vec s = {.x = {0}};
        for (int a = 0; a < nfun; a++)
            s = vec_fma(s, lanes_set(N[i][a]), X[a]);
        d[i] = s;
    }
}

/* G_a += Sum_i w N_i^a f_i, i < count */
LANES_INLINE void batch_spread(const double (*N)[BASIS_MAX], int count, int nfun, double weight, const struct vec *f,
                               struct vec *G)
{
    for (int i = 0; i < count; i++) {
        struct vec scaled = vec_scale(lanes_set(weight), f[i]);
        for (int a = 0; a < nfun; a++)
            G[a] = vec_fma(G[a], lanes_set(N[i][a]), scaled);
    }
}

#endif
