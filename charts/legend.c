/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text with a chart of signs and their key in, the pattern it shows out. */
#include "charts/legend.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "charts/lines.h"
#include "charts/raster.h"
#include "lang/page/words.h"

enum { SIGNS = 16 };

struct sign {
    struct span span;
    stitch_id   stitch;
};

struct legend {
    struct sign sign[SIGNS];
    int         n;
    bool        figures;        /* a sign is one: lines have no numbers */
};

static bool same(struct span a, struct span b)
{
    return a.end - a.start == b.end - b.start && memcmp(a.source->text + a.start, b.source->text + b.start, a.end - a.start) == 0;
}

/* ---- the key ---- */

/* What `knit on RS, purl on WS` is from the right side; -1: no stitch. */
static int meaning(const char *text)
{
    static const char *const words[] = {"knit", "k", "purl", "p"};
    int word = words_find(text, words, 4);
    const char *behind = text;

    if (word < 0)
        return -1;
    behind += words_length(text);
    behind = words_skip_blanks(behind + (*behind == 's'));
    if (words_is(behind, "on"))
        behind = words_skip_blanks(behind + 2);
    return (word < 2) != (words_is(behind, "ws") || words_is(behind, "wrong")) ? STITCH_K : STITCH_P;
}

/* `. = purl`, `□: knit` at a place: the sign's length; 0: none. */
static size_t entry_length(struct span line, size_t at, struct sign *sign)
{
    const char *text = line.source->text, *behind;
    struct span mark = raster_character(line.source, at, line.end);
    int stitch;

    if (lines_is_blank(text[at]) || (at > line.start && isalnum((unsigned char)text[at - 1])))
        return 0;
    behind = words_skip_blanks(text + mark.end);
    if (!strchr("=:", *behind) || !*behind)
        return 0;
    stitch = meaning(words_skip_blanks(behind + 1));
    *sign = (struct sign){mark, stitch == STITCH_P ? STITCH_P : STITCH_K};
    return stitch < 0 ? 0 : mark.end - mark.start;
}

/* The entries of a line; how many there are. */
static int read_entries(struct legend *legend, struct span line)
{
    int n = 0;

    for (size_t at = line.start; at < line.end; at++) {
        struct sign sign;
        size_t length = entry_length(line, at, &sign);

        if (!length)
            continue;
        if (legend->n < SIGNS)
            legend->sign[legend->n++] = sign;
        legend->figures |= isdigit((unsigned char)line.source->text[at]) != 0;
        at += length;
        n++;
    }
    return n;
}

static const struct sign *find_sign(const struct legend *legend, struct span mark)
{
    for (int i = 0; i < legend->n; i++)
        if (same(legend->sign[i].span, mark))
            return &legend->sign[i];
    return NULL;
}

/* ---- the chart ---- */

struct row {
    struct span cells;      /* without the numbers */
    long        number;     /* 0: none */
};

static bool is_digit(const struct span *line, unsigned at)
{
    return isdigit((unsigned char)line->source->text[at]) != 0;
}

/* A line without the row number at either end. */
static struct row parted(const struct legend *legend, struct span line)
{
    struct row row = {line, 0};

    if (legend->figures)
        return row;
    while (row.cells.start < row.cells.end && is_digit(&line, row.cells.start))
        row.cells.start++;
    while (row.cells.end > row.cells.start && is_digit(&line, row.cells.end - 1))
        row.cells.end--;
    row.number = row.cells.start > line.start ? atol(line.source->text + line.start) : row.cells.end < line.end ? atol(line.source->text + row.cells.end) : 0;
    return row;
}

/* Whether a line has signs of the key, and nothing else but bars between them. */
static bool is_row(const struct legend *legend, const struct row *row)
{
    bool any = false;

    for (size_t at = row->cells.start; at < row->cells.end;) {
        struct span mark = raster_character(row->cells.source, at, row->cells.end);
        char c = row->cells.source->text[at];

        if (find_sign(legend, mark))
            any = true;
        else if (!lines_is_blank(c) && c != '|')
            return false;
        at = mark.end;
    }
    return any;
}

static bool read_row(struct raster *raster, const struct legend *legend, const struct row *row)
{
    for (size_t at = row->cells.start; at < row->cells.end;) {
        struct span mark = raster_character(row->cells.source, at, row->cells.end);
        const struct sign *sign = find_sign(legend, mark);

        if (sign && !raster_stitch(raster, sign->stitch, mark))
            return false;
        at = mark.end;
    }
    raster_row(raster, row->cells);
    return true;
}

/* Rows are numbered up or down in ones. */
static bool check_numbers(struct diag *diag, const struct row *row, const struct row *before, int *step)
{
    long by = row->number - before->number;

    if (!row->number || !before->number)
        return true;
    if ((by == 1 || by == -1) && (!*step || *step == by)) {
        *step = (int)by;
        return true;
    }
    diag_error(diag, CODE_CHART_HEADER, row->cells, "row %ld follows row %ld", row->number, before->number);
    diag_hint(diag, by == 2 || by == -2 ? "a chart needs its wrong-side rows, too" : "rows of a chart are numbered one by one");
    return false;
}

bool legend_is(const struct source *source)
{
    struct legend legend = {0};
    struct lines lines = lines_of(source);
    struct span line;
    int rows = 0;

    if (memchr(source->text, '{', source->size))
        return false;
    while (lines_next(&lines, &line))
        read_entries(&legend, line);
    for (lines = lines_of(source); legend.n && lines_next(&lines, &line);) {
        struct row row = parted(&legend, line);

        rows += is_row(&legend, &row);
    }
    return rows > 0;
}

struct pattern legend_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct raster raster = {.arena = arena, .diag = diag};
    struct legend legend = {0};
    struct lines lines = lines_of(source);
    struct row row, before = {.number = 0};
    struct span line;
    int step = 0;

    while (lines_next(&lines, &line))
        read_entries(&legend, line);
    for (lines = lines_of(source); lines_next(&lines, &line); before = row) {
        row = parted(&legend, line);
        if (!is_row(&legend, &row))
            row.number = 0;
        else if (!check_numbers(diag, &row, &before, &step) || !read_row(&raster, &legend, &row))
            break;
    }
    return (struct pattern){.grid = raster_grid(&raster, source, step > 0 ? RASTER_BOTTOM_FIRST : RASTER_TOP_FIRST), .across = 1, .up = 1};
}
