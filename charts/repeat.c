/* SPDX-License-Identifier: GPL-3.0-or-later
 * A grid in, the smallest piece that repeats out. */
#include "charts/repeat.h"

#include <stdlib.h>
#include <string.h>

typedef bool same_lines(const struct grid *, int a, int b);

static bool same_rows(const struct grid *g, int a, int b)
{
    return memcmp(&g->cell[(size_t)a * (size_t)g->columns], &g->cell[(size_t)b * (size_t)g->columns],
                  (size_t)g->columns) == 0;
}

static bool same_columns(const struct grid *g, int a, int b)
{
    int row = 0;
    while (row < g->rows && grid_at(g, a, row) == grid_at(g, b, row))
        row++;
    return row == g->rows;
}

/* Knuth, Morris and Pratt: border[i] is the length of the longest beginning of
 * lines 0..i that also ends them; what it leaves of them is their period. */
static int period_of(const struct grid *g, int n, same_lines *same)
{
    int *border = calloc((size_t)n, sizeof *border), length = 0;
    if (!border)
        abort();
    for (int i = 1; i < n; i++) {
        while (length > 0 && !same(g, i, length))
            length = border[length - 1];
        length += same(g, i, length);
        border[i] = length;
    }
    free(border);
    int period = n - length;
    return period <= n / 2 ? period : n;
}

struct repeat repeat_of(const struct grid *g)
{
    return (struct repeat){period_of(g, g->columns, same_columns), period_of(g, g->rows, same_rows)};
}
