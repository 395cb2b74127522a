/* SPDX-License-Identifier: GPL-3.0-or-later
 * The extent and pattern of a sheet in, the sheet with the paper's material out. */
#include "tests/solver/scenes.h"

#include "solver/memory.h"

struct sheet *scene_sheet(int columns, int rows, int (*purl)(int x, int y))
{
    struct sheet *s = MEMORY_ARRAY(struct sheet, 1);
    int count = columns * rows;
    *s = (struct sheet){.columns = columns, .rows = rows, .dx = 1.4, .dy = 1.2, .thickness = 0.5, .young = 1,
                        .poisson = 0.4, .spring_edges = EDGE_ALL};
    s->kx = MEMORY_ARRAY(double, count);
    s->ky = MEMORY_ARRAY(double, count);
    s->twist = MEMORY_ARRAY(double, count);
    for (int i = 0; i < count; i++) {
        double sign = purl && purl(i % columns, i / columns) ? -1 : 1;
        s->kx[i] = -sign;
        s->ky[i] = sign;
    }
    s->mesh = (struct mesh){.discretisation = DISCRETISATION_PATCH, .per_stitch = 1};
    s->solve = (struct solve){.accuracy = 0.01, .steps = 1, .noise = 0.01, .seed = 1, .method = METHOD_AUTO,
                              .tolerance = 1e-8, .max_iterations = 10000};
    return s;
}

int rib(int x, int y)
{
    (void)y;
    return x / 2 % 2 == 0;
}

int checker(int x, int y)
{
    return (x / 2 + y / 2) % 2 == 0;
}

int seed(int x, int y)
{
    return (x + y) % 2 == 0;
}

int miura(int x, int y)
{
    int up = y < 23 - y ? y : 23 - y;
    return (x - (up + 1) / 2 + 12) % 12 < 6;
}

double scene_random(void)
{
    static unsigned long long state = 88172645463325252ull;
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return (double)(state >> 11) / 4503599627370496.0 - 1;
}

double *scene_vector(int n, double amplitude)
{
    double *v = MEMORY_ARRAY(double, n);
    for (int i = 0; i < n; i++)
        v[i] = amplitude * scene_random();
    return v;
}

double *scene_state(const struct discretisation *d, double amplitude)
{
    double *x = MEMORY_ARRAY(double, d->n);
    d->op->flat(d, x);
    for (int i = 0; i < d->n; i++)
        x[i] += amplitude * scene_random();
    return x;
}
