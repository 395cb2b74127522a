/* SPDX-License-Identifier: GPL-3.0-or-later
 * Memory of sampled surfaces and records, and the names of what a fold ends as. */
#include "solver/surface.h"

#include <stdlib.h>

#include "solver/memory.h"

struct surface surface_make(int columns, int rows, int per_stitch)
{
    struct surface s = {.columns = columns, .rows = rows, .per_stitch = per_stitch,
                        .nx = columns * per_stitch, .ny = rows * per_stitch};
    size_t points = (size_t)(s.nx + 1) * (size_t)(s.ny + 1), cells = (size_t)s.nx * (size_t)s.ny;
    s.position = MEMORY_ARRAY(double, 3 * points);
    s.normal = MEMORY_ARRAY(double, 3 * points);
    s.displacement = MEMORY_ARRAY(double, 3 * points);
    s.mean = MEMORY_ARRAY(double, cells);
    s.gauss = MEMORY_ARRAY(double, cells);
    s.stretching = MEMORY_ARRAY(double, cells);
    s.bending = MEMORY_ARRAY(double, cells);
    return s;
}

void surface_free(struct surface *s)
{
    free(s->position);
    free(s->normal);
    free(s->displacement);
    free(s->mean);
    free(s->gauss);
    free(s->stretching);
    free(s->bending);
    *s = (struct surface){0};
}

const char *fold_status_name(enum fold_status status)
{
    static const char *const name[] = {"converged", "precision", "saddle", "iteration_limit", "failed"};
    return name[status];
}

void fold_record_free(struct fold_record *record)
{
    free(record->step);
    record->step = NULL;
    record->nsteps = 0;
}
