/* SPDX-License-Identifier: GPL-3.0-or-later
 * A chart of signs or letters that a page has beside its written rows. */
#ifndef WEFT_PAGE_CHART_H
#define WEFT_PAGE_CHART_H

#include "lang/diag.h"
#include "lang/grid.h"

/* One line of it, as seen from the right side. */
struct page_row {
    struct span      line, cells;   /* with and without the numbers at its ends */
    long             number;        /* as written; 0: none */
    const stitch_id *cell;          /* (columns), left to right */
};

struct page_chart {
    const struct source *source;
    struct page_row     *row;       /* (rows), the top line first */
    int                  rows, columns;
    long                 first;     /* the row's number that the bottom line is, */
    int                  step;      /* and how much the numbers grow from line to line: 1, -1; 2 for right-side rows alone */
    const char          *unread;    /* why its lines are no chart; NULL: they are */
    struct span         *line;      /* (lines) it takes, the key's among them, in the order of the text */
    int                  lines;
    bool                 others;    /* there is another chart behind it, which is not read */
};

/* The line, from the top, of row y of its grid, and the number that a line's row has. */
static inline int page_chart_line_of(const struct page_chart *chart, int y)
{
    return chart->step > 0 ? chart->rows - 1 - y : y;
}

static inline long page_chart_number(const struct page_chart *chart, int line)
{
    return chart->first + (long)chart->step * (chart->rows - 1 - line);
}

/* The page's first chart of two lines at least, whose signs a key explains (`. = purl`) or which has the letters K and P
 * without blanks between; NULL: there is none. */
struct page_chart *page_chart_find(struct arena *, const struct source *);

/* The line of it that a byte is on; no source: the byte is on none. NULL has none. */
struct span page_chart_line(const struct page_chart *, unsigned at);

/* The chart's grid, the row of the least number first. */
const struct grid *page_chart_grid(struct arena *, const struct page_chart *);

/* Whether the fabric of written rows shows what the chart does, a repeat of it worked as often as their width asks for:
 * an error says where they do not; a warning, why that cannot be told. */
struct row_list;
bool page_chart_agrees(struct diag *, const struct page_chart *, const struct grid *, const struct row_list *);

/* The fabric of a page without written rows: the chart as wide as the cast-on, 0: as it is. NULL: an error was reported. */
const struct grid *page_chart_fabric(struct diag *, const struct page_chart *, struct span cast_on, long long width);

#endif
