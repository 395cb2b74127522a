/* SPDX-License-Identifier: GPL-3.0-or-later
 * A number for each cell of a surface, by name, and the range in which to show it. */
#include "output/field.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Cells beyond the scale at each end, as a part of all. */
static const double left_out = 0.02;

static const struct {
    const char *title;
    bool        diverging, whole;   /* whole: from the least value to the greatest */
} kinds[] = {
    [COLOR_HEIGHT]     = {"height (length)",                      false, true},
    [COLOR_MEAN]       = {"mean curvature (1/length)",            true,  false},
    [COLOR_GAUSS]      = {"Gaussian curvature (1/length²)",      true,  false},
    [COLOR_BENDING]    = {"bending energy (energy/area)",         false, false},
    [COLOR_STRETCHING] = {"stretching energy (energy/area)",      false, false},
};

/* Each cell's height: the mean of its corners. */
static void fill_height(const struct surface *s, double *value)
{
    size_t cells = (size_t)s->nx * (size_t)s->ny, up = (size_t)s->nx + 1;
    double mean = 0;
    for (size_t i = 0; i < cells; i++) {
        const double *corner = s->position + 3 * (i / (size_t)s->nx * up + i % (size_t)s->nx) + 2;
        value[i] = (corner[0] + corner[3] + corner[3 * up] + corner[3 * up + 3]) / 4;
        mean += value[i] / (double)cells;
    }
    for (size_t i = 0; i < cells; i++)
        value[i] -= mean;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The scale's ends, from the values in order. */
static void set_range(struct field *field, const double *ordered, size_t n, bool whole)
{
    size_t out = whole ? 0 : (size_t)(left_out * (double)n);
    field->low = ordered[out];
    field->high = ordered[n - 1 - out];
    if (field->diverging) {
        field->high = fmax(fabs(field->low), fabs(field->high));
        field->low = -field->high;
    }
    if (!(field->low < field->high)) {      /* the same everywhere */
        double around = fmax(fabs(field->high), 1);
        field->low -= around;
        field->high += around;
    }
}

struct field field_of(const struct surface *s, enum coloring color)
{
    size_t cells = (size_t)s->nx * (size_t)s->ny;
    const double *of[] = {[COLOR_MEAN] = s->mean, [COLOR_GAUSS] = s->gauss,
                          [COLOR_BENDING] = s->bending, [COLOR_STRETCHING] = s->stretching};
    struct field field = {
        .title = kinds[color].title,
        .ends = kinds[color].whole ? "full range" : "2nd to 98th percentile",
        .diverging = kinds[color].diverging,
        .value = malloc(cells * sizeof *field.value),
    };
    double *ordered = malloc(cells * sizeof *ordered);
    if (!field.value || !ordered) {
        free(ordered);
        field_free(&field);
        return field;
    }
    if (color == COLOR_HEIGHT)
        fill_height(s, field.value);
    else
        memcpy(field.value, of[color], cells * sizeof *field.value);
    memcpy(ordered, field.value, cells * sizeof *ordered);
    qsort(ordered, cells, sizeof *ordered, compare);
    set_range(&field, ordered, cells, kinds[color].whole);
    free(ordered);
    return field;
}

void field_free(struct field *field)
{
    free(field->value);
    field->value = NULL;
}
