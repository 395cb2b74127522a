/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's chart and the fabric of its written rows in; whether the two are one, out. */
#include <string.h>

#include "lang/page/page_chart.h"
#include "lang/rows/rows.h"

enum { WIDEST = 64 };       /* stitches of a chart whose repeat is looked for within it */

/* The rows of a fabric that a chart's rows are, and the columns it repeats. */
struct match {
    const struct grid *chart, *grid;
    const int         *row;     /* (chart rows) of the fabric; -1: not to be told */
    int                at, period;
};

/* Whether one row shows the same, the chart's columns at .. at+period-1 as often as there is room. */
static bool same_row(const struct match *match, int y)
{
    int more = match->grid->columns - match->chart->columns, behind = match->at + match->period;

    for (int x = 0; x < match->grid->columns; x++) {
        int column = x < behind ? x : x >= behind + more ? x - more : match->at + (x - match->at) % match->period;

        if (match->row[y] >= 0 && grid_at(match->grid, x, match->row[y]) != grid_at(match->chart, column, y))
            return false;
    }
    return true;
}

/* The chart's rows that are the same, from its bottom up to the first that is not. */
static int same_rows(const struct match *match)
{
    int y = 0;

    while (y < match->chart->rows && same_row(match, y))
        y++;
    return y;
}

/* The most rows that agree for any part of the chart that may be its repeat; -1: no repeat comes out even. */
static int most_rows(struct match *match)
{
    int columns = match->chart->columns, more = match->grid->columns - columns, most = -1;

    for (int period = columns; period > 0; period--)
        for (int at = 0; more % period == 0 && at + period <= columns; at++) {
            int rows;

            match->at = at;
            match->period = period;
            rows = same_rows(match);
            most = rows > most ? rows : most;
            if (most == match->chart->rows || more == 0 || columns > WIDEST)
                return most;
        }
    return most;
}

static bool is_open(struct diag *diag, const struct page_chart *chart, const char *why)
{
    diag_warning(diag, CODE_PROSE, chart->row[0].line, "this chart is not compared with the rows: %s", why);
    diag_hint(diag, "the rows are worked as they are written");
    return true;
}

/* `K P P K`, or the beginning of it. */
static const char *stitches_of(struct arena *arena, const struct grid *grid, int y)
{
    enum { MOST = 40 };
    int n = grid->columns < MOST ? grid->columns : MOST;
    char *text = arena_array(arena, char, MOST + 1);

    for (int x = 0; x < n; x++)
        text[x] = "KP?"[grid_at(grid, x, y) < 2 ? grid_at(grid, x, y) : 2];
    return arena_printf(arena, "%s%s", text, n < grid->columns ? ".." : "");
}

static bool disagree(struct diag *diag, const struct page_chart *chart, const struct match *match, int y)
{
    int line = page_chart_line_of(chart, y);
    long number = page_chart_number(chart, line);

    diag_error(diag, CODE_MIXED_MOTIF, chart->row[line].cells, "row %ld of this chart and the written row %ld are not the same", number, number);
    if (diag_takes_notes(diag)) {
        diag_hint(diag, "from the right side the chart shows %s, the row %s", stitches_of(diag->arena, match->chart, y),
                  stitches_of(diag->arena, match->grid, match->row[y]));
        diag_hint(diag, "mend the one that is wrong, or begin the chart's lines with #: then the rows alone count");
    }
    return false;
}

bool page_chart_agrees(struct diag *diag, const struct page_chart *chart, const struct grid *grid, const struct row_list *rows)
{
    int *row, told = 0, same;
    struct match match = {.grid = grid};

    if (chart->unread)
        return is_open(diag, chart, chart->unread);
    match.chart = page_chart_grid(diag->arena, chart);
    match.row = row = arena_array(diag->arena, int, (size_t)chart->rows);
    for (int y = 0; y < chart->rows; y++) {
        row[y] = rows_place(rows, page_chart_number(chart, page_chart_line_of(chart, y)));
        told += row[y] >= 0;
    }
    if (!told)
        return is_open(diag, chart, "no row has one of its numbers");
    if (grid->columns < chart->columns)
        return is_open(diag, chart, "it is wider than they are");
    same = most_rows(&match);
    if (same < 0)
        return is_open(diag, chart, "its repeat does not come out even over their stitches");
    return same == chart->rows || disagree(diag, chart, &match, same);
}

const struct grid *page_chart_fabric(struct diag *diag, const struct page_chart *chart, struct span cast_on, long long width)
{
    if (chart->unread || chart->step == 2 || (chart->first != 1 && page_chart_number(chart, 0) != 1)) {
        diag_error(diag, CODE_CHART, chart->row[0].line, "this chart cannot be worked: %s",
                   chart->unread ? chart->unread : chart->step == 2 ? "every second row is not on it" : "it has no row 1");
        return NULL;
    }
    if (width % chart->columns == 0)
        return grid_tile(diag->arena, page_chart_grid(diag->arena, chart), width ? (int)(width / chart->columns) : 1, 1);
    diag_error(diag, CODE_FIT, cast_on, "%lld is not a multiple of the chart's %d stitches", width, chart->columns);
    diag_note(diag, chart->row[0].line, "the chart");
    return NULL;
}
