/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in; the chart of signs or letters that it has beside its written rows out. */
#include "lang/page/page_chart.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "lang/page/page_key.h"
#include "lang/page/words.h"

enum { LEAST_ROWS = 2, DIGITS = 6 };

struct reader {
    struct arena      *arena;
    struct page_key    key;
    struct page_chart *chart;
    int                room, lines_room;
};

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

static struct span next_line(const struct source *source, struct span line)
{
    unsigned start = line.end + (unsigned)strspn(source->text + line.end, "\r");

    start += source->text[start] == '\n' || (!source->text[start] && start < source->size);
    return (struct span){source, start, start + (unsigned)words_line_length(source->text + start)};
}

/* ---- one line ---- */

static bool is_number(const struct page_key *key, const char *text, size_t n)
{
    return n > 0 && n < DIGITS && !key->figures && strspn(text, "0123456789") >= n;
}

/* Blanks and bars around what is between two bytes. */
static struct span trimmed(const struct page_key *key, struct span span)
{
    const char *text = span.source->text;
    bool bars = !page_key_find(key, "|", 1);

    while (span.start < span.end && (is_blank(text[span.start]) || (bars && text[span.start] == '|')))
        span.start++;
    while (span.end > span.start && (is_blank(text[span.end - 1]) || (bars && text[span.end - 1] == '|')))
        span.end--;
    return span;
}

/* A line without the row numbers at its ends, `4: . . - -  4`. */
static struct page_row parted(const struct page_key *key, struct span line)
{
    struct page_row row = {.line = line, .cells = trimmed(key, line)};
    const char *text = line.source->text;
    struct span cells = row.cells;
    size_t left = strspn(text + cells.start, "0123456789"), right = 0;

    if (is_number(key, text + cells.start, left)) {
        row.number = atol(text + cells.start);
        cells.start += (unsigned)left;
        cells.start += !page_key_find(key, text + cells.start, 1) && strchr(".:)", text[cells.start]) && text[cells.start];
    }
    while (cells.end - right > cells.start && isdigit((unsigned char)text[cells.end - right - 1]))
        right++;
    if (is_number(key, text + cells.end - right, right)) {
        row.number = atol(text + cells.end - right);
        cells.end -= (unsigned)right;
    }
    row.cells = trimmed(key, cells);
    return row;
}

/* How many signs of the key a line's cells are; 0: something else is among them. The letters K and P that no key
 * explains stand without blanks, `KKPP`: else they are a row in words. */
static int count_cells(const struct page_key *key, struct span cells, stitch_id *cell)
{
    const char *text = cells.source->text;
    unsigned word = cells.start;
    int n = 0;

    for (unsigned at = cells.start, length; at < cells.end; at += length) {
        const struct page_sign *sign;

        length = (unsigned)page_key_character(text + at);
        sign = page_key_find(key, text + at, length);
        if (!sign && !is_blank(text[at]) && text[at] != '|')
            return 0;
        if (!sign) {
            word = at + 1;
            continue;
        }
        if (sign->letter && at == word && (at + 1 == cells.end || is_blank(text[at + 1]) || text[at + 1] == '|'))
            return 0;
        if (cell)
            cell[n] = sign->stitch;
        n++;
    }
    return n;
}

/* Whether a chart's row is on a line; a comment is none, nor a line of a script. */
static bool is_row(const struct page_key *key, struct span line, struct page_row *row)
{
    const char *text = line.source->text + line.start;

    if (line.end - line.start > WORDS_LINE || text[strspn(text, " \t")] == '#')
        return false;
    *row = parted(key, line);
    return row->cells.end > row->cells.start + 1 && count_cells(key, row->cells, NULL) > 1;
}

/* `4 3 2 1` below a chart: the numbers of its stitches. */
static bool is_scale(struct span line)
{
    const char *text = line.source->text + line.start;
    size_t n = strspn(text, "0123456789 \t|");

    return n == line.end - line.start && strcspn(text, "0123456789") < n && n <= WORDS_LINE && memchr(text, ' ', n);
}

/* ---- the chart's lines ---- */

static void add_line(struct reader *reader, struct span line)
{
    struct page_chart *chart = reader->chart;

    if (chart->lines == reader->lines_room)
        chart->line = arena_larger(reader->arena, chart->line, &reader->lines_room, sizeof *chart->line);
    chart->line[chart->lines++] = line;
}

static void add_row(struct reader *reader, struct page_row row)
{
    struct page_chart *chart = reader->chart;

    if (chart->rows == reader->room)
        chart->row = arena_larger(reader->arena, chart->row, &reader->room, sizeof *chart->row);
    chart->row[chart->rows++] = row;
}

/* The rows from a line on that follow each other; the line behind the last. */
static struct span count_rows(const struct page_key *key, struct span line, int *n)
{
    struct page_row row;

    for (*n = 0; line.start < line.source->size && is_row(key, line, &row); ++*n)
        line = next_line(line.source, line);
    return line;
}

/* Takes the lines up to another as the chart's rows; those of a further chart are text. The other. */
static struct span take_rows(struct reader *reader, struct span line, struct span end)
{
    reader->chart->others = reader->chart->rows > 0;
    for (struct page_row row; line.start != end.start; line = next_line(line.source, line)) {
        if (is_row(&reader->key, line, &row) && !reader->chart->others)
            add_row(reader, row);
        add_line(reader, line);
    }
    return end;
}

/* Takes the lines of the first chart, and of the key. */
static void take_lines(struct reader *reader, const struct source *source)
{
    struct span line = {source, 0, (unsigned)words_line_length(source->text)}, end, behind = {0};
    int depth = 0, n = 0;

    for (; line.start < source->size; line = end) {
        const char *text = source->text + line.start;
        bool braces = depth > 0 || memchr(text, '{', line.end - line.start);

        depth = words_depth(text, line.end - line.start, depth);
        end = braces ? line : count_rows(&reader->key, line, &n);
        if (end.start > line.start && n >= LEAST_ROWS) {
            behind = end = take_rows(reader, line, end);
            continue;
        }
        if (!braces && (page_key_is_line(&reader->key, line) || (line.start == behind.start && is_scale(line))))
            add_line(reader, line);
        end = next_line(source, line);
    }
}

/* ---- numbers and cells ---- */

/* The numbers of the rows: as written, each line one or two more than the one below it, or fewer; 1, 2, .. where none is. */
static const char *number_rows(struct page_chart *chart)
{
    int first = -1, last = -1;

    chart->first = chart->step = 1;
    for (int i = chart->rows - 1; i >= 0; i--)
        if (chart->row[i].number) {
            first = first < 0 ? i : first;
            last = i;
        }
    if (first < 0)
        return NULL;
    if (first > last) {
        long by = chart->row[last].number - chart->row[first].number, lines = first - last;

        chart->step = by % lines == 0 && labs(by / lines) < 3 ? (int)(by / lines) : 0;
    }
    if (!chart->step || chart->step == -2)
        return "its rows are not numbered one by one";
    chart->first = chart->row[first].number - (long)chart->step * (chart->rows - 1 - first);
    for (int i = 0; i < chart->rows; i++)
        if (chart->row[i].number && chart->row[i].number != page_chart_number(chart, i))
            return "its rows are not numbered one by one";
    return chart->first < 1 || page_chart_number(chart, 0) < 1 ? "its numbers begin below 1" : NULL;
}

static const char *read_cells(struct reader *reader)
{
    struct page_chart *chart = reader->chart;
    const char *text = chart->source->text + chart->row[0].cells.start;
    bool letters = page_key_find(&reader->key, text, page_key_character(text))->letter, seen[2] = {letters, letters};

    chart->columns = count_cells(&reader->key, chart->row[0].cells, NULL);
    for (int i = 0; i < chart->rows; i++) {
        int n = count_cells(&reader->key, chart->row[i].cells, NULL);
        stitch_id *cell = arena_array(reader->arena, stitch_id, (size_t)n);

        count_cells(&reader->key, chart->row[i].cells, cell);
        chart->row[i].cell = cell;
        if (n != chart->columns)
            return "its lines have different numbers of stitches";
    }
    for (int i = 0; i < reader->key.n; i++)
        seen[reader->key.sign[i].stitch] |= !reader->key.sign[i].letter;
    return seen[STITCH_K] && seen[STITCH_P] ? number_rows(chart) : "its key has one kind of stitch only";
}

struct page_chart *page_chart_find(struct arena *arena, const struct source *source)
{
    struct page_chart *chart = arena_new(arena, struct page_chart);
    struct reader reader = {.arena = arena, .chart = chart};

    if (source->size > WORDS_PAGE)
        return NULL;
    chart->source = source;
    page_key_read(&reader.key, source);
    take_lines(&reader, source);
    if (!chart->rows)
        return NULL;
    chart->unread = chart->others ? "there is more than one" : read_cells(&reader);
    return chart;
}

struct span page_chart_line(const struct page_chart *chart, unsigned at)
{
    int low = 0, high = chart ? chart->lines : 0;

    while (low < high) {
        int middle = low + (high - low) / 2;

        if (chart->line[middle].end <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return chart && low < chart->lines && at >= chart->line[low].start ? chart->line[low] : (struct span){0};
}

const struct grid *page_chart_grid(struct arena *arena, const struct page_chart *chart)
{
    size_t columns = (size_t)chart->columns;
    stitch_id *cell;
    struct grid *grid = grid_new(arena, chart->columns, chart->rows, &cell);

    for (int y = 0; y < chart->rows; y++)
        memcpy(cell + (size_t)y * columns, chart->row[page_chart_line_of(chart, y)].cell, columns);
    return grid;
}
