/* SPDX-License-Identifier: GPL-3.0-or-later
 * A boundary mass matrix in; energy, gradient and Hessian of the springs out:
 * U = 1/2 u^T K u, u = x - x_flat. */
#include "solver/springs.h"

#include <stdlib.h>

#include "solver/memory.h"

void springs_add(struct spring_form *s, int i, int j, double value)
{
    if (s->count == s->capacity) {
        s->capacity = s->capacity ? 2 * s->capacity : 256;
        s->row = memory_grow(s->row, (size_t)s->capacity, sizeof *s->row);
        s->col = memory_grow(s->col, (size_t)s->capacity, sizeof *s->col);
        s->value = memory_grow(s->value, (size_t)s->capacity, sizeof *s->value);
    }
    s->row[s->count] = i > j ? i : j;
    s->col[s->count] = i > j ? j : i;
    s->value[s->count++] = value;
}

void springs_finish(struct spring_form *s, const struct discretisation *d)
{
    s->position = MEMORY_ARRAY(int, 3 * s->count);
    for (int e = 0; e < s->count; e++)
        for (int c = 0; c < 3; c++)
            s->position[3 * e + c] = pattern_find(&d->pattern, s->row[e] + c, s->col[e] + c);
    s->flat = MEMORY_ARRAY(double, d->n);
    d->op->flat(d, s->flat);
}

double springs_energy(const struct spring_form *s, const double *restrict x, double *restrict gradient)
{
    double twice = 0;
    for (int e = 0; e < s->count; e++) {
        int i = s->row[e], j = s->col[e];
        double k = s->value[e], weight = i == j ? k : 2 * k;
        for (int c = 0; c < 3; c++) {
            double ui = x[i + c] - s->flat[i + c], uj = x[j + c] - s->flat[j + c];
            twice += weight * ui * uj;
            if (gradient) {
                gradient[i + c] += k * uj;
                if (i != j)
                    gradient[j + c] += k * ui;
            }
        }
    }
    return twice / 2;
}

void springs_hessian(const struct spring_form *s, double *restrict value)
{
    for (int e = 0; e < s->count; e++)
        for (int c = 0; c < 3; c++)
            value[s->position[3 * e + c]] += s->value[e];
}

void springs_free(struct spring_form *s)
{
    free(s->row);
    free(s->col);
    free(s->value);
    free(s->position);
    free(s->flat);
}
