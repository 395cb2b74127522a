/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sheet's mesh settings in, the chain of its discretisations out. */
#include "solver/levels.h"

#include <string.h>

#include "solver/patch.h"
#include "solver/triangle.h"

enum { GAUSS_COARSE = 3, GAUSS = 4, LEAST_CELLS = 2 };  /* points a side; triangles a stitch's side at the least */

bool levels_is_spline(const struct discretisation *d)
{
    return strcmp(d->op->kind, "spline") == 0;
}

static bool one_level(const struct sheet *sheet)
{
    return sheet->solve.method == METHOD_LBFGS;
}

/* The cells a stitch's side the wanted ones halve to, LEAST_CELLS or more. */
static int coarsest_cells(int wanted)
{
    while (wanted % 2 == 0 && wanted / 2 >= LEAST_CELLS)
        wanted /= 2;
    return wanted;
}

struct discretisation *levels_patches(const struct sheet *sheet, int per_stitch, int threads)
{
    return patch_make(sheet, &basis_hermite, per_stitch, GAUSS, threads);
}

struct discretisation *levels_first(const struct sheet *sheet, int threads)
{
    int wanted = sheet->mesh.per_stitch;
    if (sheet->mesh.discretisation == DISCRETISATION_TRIANGLE) {
        wanted = wanted ? wanted : 2 * LEAST_CELLS;
        return triangle_make(sheet, one_level(sheet) ? wanted : coarsest_cells(wanted), threads);
    }
    if (one_level(sheet))
        return levels_patches(sheet, wanted ? wanted : 1, threads);
    return patch_make(sheet, &basis_spline, 1, GAUSS_COARSE, threads);
}

struct discretisation *levels_flat(const struct sheet *sheet, int threads)
{
    int wanted = sheet->mesh.per_stitch ? sheet->mesh.per_stitch : 1;
    return sheet->mesh.discretisation == DISCRETISATION_TRIANGLE
               ? triangle_make(sheet, wanted, threads)
               : levels_patches(sheet, wanted, threads);
}

struct discretisation *levels_next(const struct discretisation *d, int threads)
{
    const struct sheet *sheet = d->sheet;
    int wanted = sheet->mesh.per_stitch, twice = 2 * d->per_stitch;
    if (sheet->mesh.discretisation == DISCRETISATION_TRIANGLE)
        return triangle_make(sheet, twice, threads);
    int per_stitch = levels_is_spline(d) ? 1 : wanted > twice && wanted % twice ? wanted : twice;
    return levels_patches(sheet, per_stitch, threads);
}

bool levels_passing(const struct discretisation *d)
{
    return levels_is_spline(d) || d->per_stitch < d->sheet->mesh.per_stitch;
}
