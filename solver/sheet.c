/* SPDX-License-Identifier: GPL-3.0-or-later
 * Scene in, constant elastic model out. */
#include "solver/sheet.h"

#include <stdlib.h>

#include "solver/memory.h"

struct sheet *sheet_build(const struct scene *scene)
{
    struct sheet *sheet = MEMORY_ARRAY(struct sheet, 1);
    const struct grid *grid = scene->grid;
    size_t count = (size_t)grid->columns * (size_t)grid->rows;
    *sheet = (struct sheet){
        .columns = grid->columns,
        .rows = grid->rows,
        .dx = scene->gauge.width,
        .dy = scene->gauge.height,
        .thickness = scene->material.thickness,
        .young = scene->material.young,
        .poisson = scene->material.poisson,
        .kx = MEMORY_ARRAY(double, count),
        .ky = MEMORY_ARRAY(double, count),
        .twist = MEMORY_ARRAY(double, count),
        .spring = scene->springs.stiffness / scene->material.young,
        .spring_edges = scene->springs.edges,
        .mesh = scene->mesh,
        .solve = scene->solve,
    };
    for (size_t i = 0; i < count; i++) {
        const struct stitch *stitch = &scene->stitch[grid->cell[i]];
        sheet->kx[i] = stitch->kx;
        sheet->ky[i] = stitch->ky;
        sheet->twist[i] = stitch->twist;
    }
    return sheet;
}

void sheet_free(struct sheet *sheet)
{
    if (!sheet)
        return;
    free(sheet->kx);
    free(sheet->ky);
    free(sheet->twist);
    free(sheet);
}
