/* SPDX-License-Identifier: GPL-3.0-or-later
 * Stitches in working order in, what the right side shows of them out. */
#include "lang/rows/row_draw.h"

#include <string.h>

/* Whether none of the stitches depends on the rows below or on the side. */
static bool is_plain(const stitch_id *worked, int width)
{
    for (int stitch = STITCH_REVERSE; stitch <= STITCH_SAME; stitch++)
        if (memchr(worked, stitch, (size_t)width))
            return false;
    return true;
}

bool row_draw_asks_below(const stitch_id *worked, int width)
{
    return memchr(worked, STITCH_SAME, (size_t)width) || memchr(worked, STITCH_OTHER, (size_t)width);
}

/* The column of the x-th stitch worked. */
static int column_of(const struct row_place *row, int x)
{
    return row->side == SIDE_RS ? row->width - 1 - x : x;
}

/* Whether each stitch worked shows its other face. */
static bool is_turned(const struct row_place *row)
{
    return row->side != SIDE_RS && !row->front;
}

/* ---- seed ---- */

/* Whether the stitches below n of a row take turns, so that seed goes on from them. */
static bool takes_turns(const stitch_id *cell, int column, int step, int n, const struct row_place *row)
{
    const stitch_id *below = cell - row->width;

    if (row->first || below[column] > STITCH_P)
        return false;
    for (int i = 1; i < n; i++)
        if (below[column + i * step] > STITCH_P || below[column + i * step] == below[column + (i - 1) * step])
            return false;
    return true;
}

/* Seed over n stitches: purl over knit and knit over purl, or k1, p1 where nothing below says which. */
static void draw_seed(stitch_id *cell, int x, int n, const struct row_place *row)
{
    int column = column_of(row, x), step = row->side == SIDE_RS ? -1 : 1;
    bool turns = takes_turns(cell, column, step, n, row);
    stitch_id first = is_turned(row) ? STITCH_P : STITCH_K;

    if (turns)
        first = cell[column - row->width] == STITCH_K ? STITCH_P : STITCH_K;
    for (int i = 0; i < n; i++)
        cell[column + i * step] = i % 2 == (first == STITCH_P) ? STITCH_K : STITCH_P;
}

/* ---- garter ---- */

/* Garter over n stitches: knitted on both sides; in the round purled where all below are knit. */
static void draw_garter(stitch_id *cell, int x, int n, const struct row_place *row)
{
    int column = column_of(row, x), left = row->side == SIDE_RS ? column - n + 1 : column;
    bool purl = row->round ? !row->first : row->side != SIDE_RS;

    for (int i = 0; row->round && purl && i < n; i++)
        purl = cell[left + i - row->width] == STITCH_K;
    memset(cell + left, purl ? STITCH_P : STITCH_K, (size_t)n);
}

/* ---- all stitches ---- */

/* What a stitch shows that is of a fabric, or as the one below. */
static stitch_id shown(stitch_id stitch, const stitch_id *cell, const struct row_place *row)
{
    switch (stitch) {
    case STITCH_SAME:
        return cell[-row->width];
    case STITCH_OTHER:
        return row->ws[cell[-row->width]];
    case STITCH_STOCKINETTE:
        return STITCH_K;
    case STITCH_REVERSE:
        return STITCH_P;
    default:
        return is_turned(row) ? row->ws[stitch] : stitch;
    }
}

static void draw_plain(stitch_id *cell, const stitch_id *worked, const struct row_place *row)
{
    for (int x = 0; row->side == SIDE_RS && x < row->width; x++)
        cell[x] = worked[row->width - 1 - x];
    for (int x = 0; row->side != SIDE_RS && x < row->width; x++)
        cell[x] = row->front ? worked[x] : row->ws[worked[x]];
}

bool row_draw(stitch_id *cell, const stitch_id *worked, struct row_place row)
{
    if (is_plain(worked, row.width)) {
        draw_plain(cell, worked, &row);
        return true;
    }
    for (int x = 0, n; x < row.width; x += n) {
        stitch_id *to = cell + column_of(&row, x);

        bool seed = worked[x] == STITCH_SEED, garter = worked[x] == STITCH_GARTER;

        for (n = 1; (seed || garter) && x + n < row.width && worked[x + n] == worked[x];)
            n++;
        if (seed)
            draw_seed(cell, x, n, &row);
        else if (garter)
            draw_garter(cell, x, n, &row);
        else
            *to = worked[x] < STITCH_REVERSE && row.side == SIDE_RS ? worked[x] : shown(worked[x], to, &row);
    }
    return false;
}
