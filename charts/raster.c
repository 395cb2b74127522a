/* SPDX-License-Identifier: GPL-3.0-or-later
 * Stitches in reading order in, a grid out; ragged, empty and too large ones are errors. */
#include "charts/raster.h"

#include <string.h>

#include "lang/limits.h"

bool raster_stitch(struct raster *r, stitch_id stitch, struct span span)
{
    if (r->ncells == LIMIT_STITCHES) {
        diag_error(r->diag, CODE_LIMIT_STITCHES, span, "a fabric may have %d stitches", LIMIT_STITCHES);
        return false;
    }
    if (r->ncells == (size_t)r->room)
        r->cell = arena_larger(r->arena, r->cell, &r->room, sizeof *r->cell);
    r->cell[r->ncells++] = stitch;
    if (r->width && r->here == r->width)
        r->excess = span;
    r->here++;
    return true;
}

static const char *stitches(struct arena *arena, int n)
{
    return arena_printf(arena, n == 1 ? "%d stitch" : "%d stitches", n);
}

static void ragged(struct raster *r, struct span line)
{
    struct span place = {line.source, line.end, line.end};
    if (r->here > r->width)
        place = span_join(r->excess, line);
    diag_error(r->diag, CODE_RAGGED, place, "this row has %s, but the first has %d", stitches(r->arena, r->here), r->width);
    diag_note(r->diag, r->first, "the first row");
}

void raster_give_up(struct raster *r)
{
    r->ncells -= (size_t)r->here;
    r->here = 0;
}

void raster_row(struct raster *r, struct span line)
{
    if (!r->here && !r->width) {
        diag_error(r->diag, CODE_RAGGED, line, "this row has no stitch");
        return;
    }
    if (!r->width) {
        r->width = r->here;
        r->first = line;
    }
    if (r->here != r->width) {
        ragged(r, line);
        raster_give_up(r);
    }
    r->here = 0;
    if (++r->rows > LIMIT_ROWS)
        diag_error(r->diag, CODE_LIMIT_ROWS, line, "a fabric may have %d rows", LIMIT_ROWS);
}

void raster_blank(struct raster *r, struct span line)
{
    if (!r->blank.source)
        r->blank = line;
}

void raster_row_follows(struct raster *r)
{
    if (r->blank.source)
        diag_error(r->diag, CODE_BLANK_ROW, r->blank, "an empty line stands %s",
                   r->width ? "between two rows" : "before the first row");
    r->blank = (struct span){0};
}

static void turn_over(struct raster *r)
{
    size_t width = (size_t)r->width;
    stitch_id *cell = arena_array(r->arena, stitch_id, r->ncells);
    for (size_t row = 0; row < (size_t)r->rows; row++)
        memcpy(cell + row * width, r->cell + ((size_t)r->rows - 1 - row) * width, width);
    r->cell = cell;
}

const struct grid *raster_grid(struct raster *r, const struct source *source, enum raster_order order)
{
    if (!r->diag->nerrors && !r->ncells)
        diag_error(r->diag, CODE_NO_STITCH, (struct span){source, 0, 0}, "there is no stitch in this file");
    if (r->diag->nerrors)
        return NULL;
    if (order == RASTER_TOP_FIRST)
        turn_over(r);
    struct grid *grid = arena_new(r->arena, struct grid);
    *grid = (struct grid){.columns = r->width, .rows = r->rows, .cell = r->cell};
    return grid;
}

struct span raster_character(const struct source *source, size_t at, size_t end)
{
    size_t next = at + 1;
    if ((unsigned char)source->text[at] >= 0xC0)
        while (next < end && ((unsigned char)source->text[next] & 0xC0) == 0x80)
            next++;
    return (struct span){source, (unsigned)at, (unsigned)next};
}

const char *raster_mark(struct arena *arena, struct span span)
{
    const char *text = span.source->text + span.start;
    unsigned char c = (unsigned char)*text;
    if (c < 0x20 || c == 0x7F || (c >= 0x80 && span.end == span.start + 1))
        return arena_printf(arena, "the byte 0x%02X", c);
    return arena_printf(arena, "'%.*s'", (int)(span.end - span.start), text);
}
