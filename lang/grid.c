/* SPDX-License-Identifier: GPL-3.0-or-later
 * The algebra of stitch grids: grids in, a new grid out. */
#include "lang/grid.h"

#include <string.h>

#include "lang/arena.h"

/* Cyclic index: the remainder that is never negative. */
static int wrap(long long i, int n)
{
    long long r = i % n;

    return (int)(r < 0 ? r + n : r);
}

static const stitch_id *row_of(const struct grid *g, int row)
{
    return g->cell + (size_t)row * (size_t)g->columns;
}

struct grid *grid_new(struct arena *arena, int columns, int rows, stitch_id **cell)
{
    struct grid *g = arena_new(arena, struct grid);

    g->columns = columns;
    g->rows = rows;
    *cell = arena_array(arena, stitch_id, (size_t)columns * (size_t)rows);
    g->cell = *cell;
    return g;
}

struct grid *grid_constant(struct arena *arena, int columns, int rows, stitch_id stitch)
{
    stitch_id *cell;
    struct grid *g = grid_new(arena, columns, rows, &cell);

    memset(cell, stitch, (size_t)columns * (size_t)rows);
    return g;
}

/* Fills `length` cells by repeating the first `period` of them. */
static void repeat_cells(stitch_id *cell, size_t period, size_t length)
{
    for (size_t done = period; done < length;) {
        size_t n = done < length - done ? done : length - done;

        memcpy(cell + done, cell, n);
        done += n;
    }
}

struct grid *grid_tile(struct arena *arena, const struct grid *g, int columns, int rows)
{
    stitch_id *cell;
    struct grid *tiled = grid_new(arena, g->columns * columns, g->rows * rows, &cell);
    size_t width = (size_t)tiled->columns;

    /* One band of rows, then copies of the band. */
    for (int y = 0; y < g->rows; y++) {
        memcpy(cell + (size_t)y * width, row_of(g, y), (size_t)g->columns);
        repeat_cells(cell + (size_t)y * width, (size_t)g->columns, width);
    }
    repeat_cells(cell, width * (size_t)g->rows, width * (size_t)tiled->rows);
    return tiled;
}

struct grid *grid_window(struct arena *arena, const struct grid *g, long long x, long long y, int columns,
                         int rows)
{
    stitch_id *cell;
    struct grid *window = grid_new(arena, columns, rows, &cell);

    for (int v = 0; v < rows; v++) {
        const stitch_id *from = row_of(g, wrap(y + v, g->rows));
        stitch_id *to = cell + (size_t)v * (size_t)columns;
        int at = wrap(x, g->columns);

        for (int u = 0; u < columns;) {
            int n = g->columns - at < columns - u ? g->columns - at : columns - u;

            memcpy(to + u, from + at, (size_t)n);
            u += n;
            at = 0;
        }
    }
    return window;
}

struct grid *grid_stretch(struct arena *arena, const struct grid *g, int at, int period, int n)
{
    stitch_id *cell;
    struct grid *wide = grid_new(arena, g->columns + period * (n - 1), g->rows, &cell);
    size_t before = (size_t)at, middle = (size_t)period * (size_t)n;
    size_t after = (size_t)(g->columns - at - period);

    for (int y = 0; y < g->rows; y++) {
        const stitch_id *from = row_of(g, y);
        stitch_id *to = cell + (size_t)y * (size_t)wide->columns;

        memcpy(to, from, before + (size_t)period);
        repeat_cells(to + before, (size_t)period, middle);
        memcpy(to + before + middle, from + before + (size_t)period, after);
    }
    return wide;
}

struct grid *grid_beside(struct arena *arena, const struct grid *const *part, int nparts)
{
    stitch_id *cell;
    struct grid *wide;
    int columns = 0;

    for (int i = 0; i < nparts; i++)
        columns += part[i]->columns;
    wide = grid_new(arena, columns, part[0]->rows, &cell);
    for (int y = 0; y < wide->rows; y++)
        for (int i = 0; i < nparts; i++) {
            memcpy(cell, row_of(part[i], y), (size_t)part[i]->columns);
            cell += part[i]->columns;
        }
    return wide;
}

struct grid *grid_above(struct arena *arena, const struct grid *const *part, int nparts)
{
    stitch_id *cell;
    struct grid *tall;
    int rows = 0;

    for (int i = 0; i < nparts; i++)
        rows += part[i]->rows;
    tall = grid_new(arena, part[0]->columns, rows, &cell);
    for (int i = 0; i < nparts; i++) {
        size_t n = (size_t)part[i]->rows * (size_t)part[i]->columns;

        memcpy(cell, part[i]->cell, n);
        cell += n;
    }
    return tall;
}

struct grid *grid_mirror(struct arena *arena, const struct grid *g)
{
    stitch_id *cell;
    struct grid *mirrored = grid_new(arena, g->columns, g->rows, &cell);

    for (int y = 0; y < g->rows; y++)
        for (int x = 0; x < g->columns; x++)
            *cell++ = grid_at(g, g->columns - 1 - x, y);
    return mirrored;
}

struct grid *grid_flip(struct arena *arena, const struct grid *g)
{
    stitch_id *cell;
    struct grid *flipped = grid_new(arena, g->columns, g->rows, &cell);

    for (int y = 0; y < g->rows; y++)
        memcpy(cell + (size_t)y * (size_t)g->columns, row_of(g, g->rows - 1 - y), (size_t)g->columns);
    return flipped;
}

struct grid *grid_invert(struct arena *arena, const struct grid *g, const stitch_id *ws)
{
    stitch_id *cell;
    struct grid *inverted = grid_new(arena, g->columns, g->rows, &cell);
    size_t n = (size_t)g->columns * (size_t)g->rows;

    for (size_t i = 0; i < n; i++)
        cell[i] = ws[g->cell[i]];
    return inverted;
}

struct grid *grid_turn(struct arena *arena, const struct grid *g, const stitch_id *ws)
{
    return grid_invert(arena, grid_mirror(arena, g), ws);
}

struct grid *grid_rotate(struct arena *arena, const struct grid *g)
{
    stitch_id *cell;
    struct grid *rotated = grid_new(arena, g->columns, g->rows, &cell);
    size_t n = (size_t)g->columns * (size_t)g->rows;

    for (size_t i = 0; i < n; i++)
        cell[i] = g->cell[n - 1 - i];
    return rotated;
}

struct grid *grid_shift(struct arena *arena, const struct grid *g, long long dx, long long dy)
{
    return grid_window(arena, g, -(dx % g->columns), -(dy % g->rows), g->columns, g->rows);
}

struct grid *grid_inset(struct arena *arena, const struct grid *part, const struct grid *ground, int x, int y)
{
    stitch_id *cell;
    struct grid *both = grid_new(arena, ground->columns, ground->rows, &cell);

    memcpy(cell, ground->cell, (size_t)ground->columns * (size_t)ground->rows);
    for (int v = 0; v < part->rows; v++)
        memcpy(cell + (size_t)(y + v) * (size_t)ground->columns + x, row_of(part, v), (size_t)part->columns);
    return both;
}

long long grid_count(const struct grid *g, stitch_id stitch)
{
    size_t n = (size_t)g->columns * (size_t)g->rows;
    long long count = 0;

    for (size_t i = 0; i < n; i++)
        count += g->cell[i] == stitch;
    return count;
}

bool grid_equal(const struct grid *a, const struct grid *b)
{
    return a->columns == b->columns && a->rows == b->rows &&
           memcmp(a->cell, b->cell, (size_t)a->columns * (size_t)a->rows) == 0;
}
