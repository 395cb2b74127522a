/* SPDX-License-Identifier: GPL-3.0-or-later
 * A table of k and p in, the pattern it shows out; and the other way round. */
#include "charts/csv.h"

#include <string.h>

#include "charts/lines.h"
#include "charts/raster.h"
#include "lang/limits.h"

/* ---- reading ---- */

/* What stands between cells: the first of the three marks in the first line. */
static char find_separator(struct span line)
{
    for (size_t at = line.start; at < line.end; at++)
        if (strchr(",;\t", line.source->text[at]) && line.source->text[at])
            return line.source->text[at];
    return ',';
}

/* The cell that starts here, without blanks and quotes. */
static struct span trim(struct span cell)
{
    const char *text = cell.source->text;
    while (cell.start < cell.end && lines_is_blank(text[cell.start]))
        cell.start++;
    while (cell.end > cell.start && lines_is_blank(text[cell.end - 1]))
        cell.end--;
    if (cell.end - cell.start >= 2 && text[cell.start] == '"' && text[cell.end - 1] == '"') {
        cell.start++;
        cell.end--;
    }
    return cell;
}

static bool read_cell(struct raster *raster, struct span cell, stitch_id *stitch)
{
    char c = cell.source->text[cell.start];
    if (cell.start == cell.end) {
        diag_error(raster->diag, CODE_CHART_MARK, cell, "this cell is empty");
    } else if (cell.end - cell.start == 1 && c && strchr("kK1pP0", c)) {
        *stitch = strchr("kK1", c) ? STITCH_K : STITCH_P;
        return true;
    } else {
        diag_error(raster->diag, CODE_CHART_MARK, cell, "this cell holds no stitch");
        diag_hint(raster->diag, "a stitch is k or 1 (knit), p or 0 (purl)");
    }
    return false;
}

/* False: no use to read on. */
static bool read_row(struct raster *raster, struct span line, char separator)
{
    const char *text = line.source->text;
    raster_row_follows(raster);
    for (size_t at = line.start; at <= line.end;) {
        const char *next = memchr(text + at, separator, line.end - at);
        size_t end = next ? (size_t)(next - text) : line.end;
        struct span cell = trim((struct span){line.source, (unsigned)at, (unsigned)end});
        stitch_id stitch;
        if (!read_cell(raster, cell, &stitch)) {
            raster_give_up(raster);
            return true;
        }
        if (!raster_stitch(raster, stitch, cell))
            return false;
        at = end + 1;
    }
    raster_row(raster, line);
    return raster->rows <= LIMIT_ROWS;
}

struct pattern csv_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct raster raster = {.arena = arena, .diag = diag};
    struct lines lines = lines_of(source);
    struct span line;
    char separator = 0;
    bool going_on = true;

    while (going_on && lines_next(&lines, &line)) {
        if (line.start == line.end) {
            raster_blank(&raster, line);
            continue;
        }
        separator = separator ? separator : find_separator(line);
        going_on = read_row(&raster, line, separator);
    }
    return (struct pattern){.grid = raster_grid(&raster, source, RASTER_TOP_FIRST), .across = 1, .up = 1};
}

/* ---- writing ---- */

static const char *cell_text(const struct scene *scene, stitch_id id)
{
    return id == STITCH_K ? "k" : id == STITCH_P ? "p" : scene->stitch[id].name;
}

void csv_write(struct text *text, const struct scene *scene)
{
    const struct grid *g = scene->grid;
    for (int row = g->rows - 1; row >= 0; row--)
        for (int i = 0; i < g->columns; i++) {
            const char *cell = cell_text(scene, grid_at(g, i, row));
            text_bytes(text, cell, strlen(cell));
            text_bytes(text, i + 1 < g->columns ? "," : "\n", 1);
        }
}
