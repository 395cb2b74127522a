/* SPDX-License-Identifier: GPL-3.0-or-later
 * A table of k and p in, the pattern it shows out; and the other way round. */
#include "charts/csv.h"

#include <string.h>
#include <strings.h>

#include "charts/lines.h"
#include "charts/raster.h"
#include "lang/limits.h"

/* ---- lines and cells ---- */

/* What stands between cells: the first of the three marks in a line. */
static char find_separator(struct span line)
{
    for (size_t at = line.start; at < line.end; at++)
        if (strchr(",;\t", line.source->text[at]) && line.source->text[at])
            return line.source->text[at];
    return ',';
}

/* `sep=;`, which some spreadsheets want above a table. */
static bool names_separator(struct span line)
{
    return line.end - line.start == 5 && strncasecmp(line.source->text + line.start, "sep=", 4) == 0;
}

/* A line with the tabs around it, as they may part cells. */
static struct span with_blanks(struct span line)
{
    const char *text = line.source->text;
    while (line.start > 0 && lines_is_blank(text[line.start - 1]))
        line.start--;
    while (line.end < line.source->size && lines_is_blank(text[line.end]))
        line.end++;
    return line;
}

/* The lines of a table; separator: of the first, 0 before it. */
struct table_lines {
    struct lines lines;
    char         separator;
    bool         empty;         /* the last line has no cell */
};

static bool next_line(struct table_lines *t, struct span *line)
{
    if (!lines_next(&t->lines, line))
        return false;
    if (!t->separator && names_separator(*line)) {
        t->separator = line->source->text[line->end - 1];
        return next_line(t, line);
    }
    bool blank = line->start == line->end;
    *line = with_blanks(*line);
    if (!t->separator && line->start < line->end)
        t->separator = find_separator(*line);
    t->empty = blank && !memchr(line->source->text + line->start, t->separator, line->end - line->start);
    return true;
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

/* The next cell of a line, whose rest is `line`; false behind the last. */
static bool next_cell(struct span *line, char separator, struct span *cell)
{
    const char *text = line->source->text;
    if (line->start > line->end)
        return false;
    const char *next = memchr(text + line->start, separator, line->end - line->start);
    unsigned end = next ? (unsigned)(next - text) : line->end;
    *cell = trim((struct span){line->source, line->start, end});
    line->start = end + 1;
    return true;
}

/* ---- what a cell holds ---- */

/* Numbers are themselves; 0 and 1 may be stitches, too. */
enum { EMPTY = -1, KNIT = -2, PURL = -3, SIGN = -4, OTHER = -5, MOST = LIMIT_STITCHES, EDGE = 16 };

static bool is_any(struct span cell, const char *const *word, bool (*same)(const char *, const char *, size_t))
{
    size_t n = cell.end - cell.start;
    while (*word && !(strlen(*word) == n && same(cell.source->text + cell.start, *word, n)))
        word++;
    return *word;
}

static bool same_letters(const char *a, const char *b, size_t n)
{
    return strncasecmp(a, b, n) == 0;
}

static bool same_bytes(const char *a, const char *b, size_t n)
{
    return memcmp(a, b, n) == 0;
}

/* A number, or that of a row: `3`, `Row 3`, `R3:`; else OTHER. */
static int read_number(struct span cell)
{
    static const char *const words[] = {"round", "rnd", "row", "r"};
    const char *at = cell.source->text + cell.start, *end = cell.source->text + cell.end;
    int number = 0;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if ((size_t)(end - at) > strlen(words[i]) && strncasecmp(at, words[i], strlen(words[i])) == 0) {
            at += strlen(words[i]);
            break;
        }
    while (at < end && lines_is_blank(*at))
        at++;
    const char *digits = at;
    for (; at < end && *at >= '0' && *at <= '9' && number < MOST; at++)
        number = 10 * number + *at - '0';
    if (at > digits && at < end && (*at == '.' || *at == ':'))
        at++;
    return at > digits && at == end ? number : OTHER;
}

static int read_cell(struct span cell)
{
    static const char *const knit[] = {"k", "knit", NULL}, *const purl[] = {"p", "purl", NULL};
    static const char *const sign[] = {"-", ".", "–", "—", "−", "•", "·", "●", NULL};
    return cell.start == cell.end              ? EMPTY
           : is_any(cell, knit, same_letters)  ? KNIT
           : is_any(cell, purl, same_letters)  ? PURL
           : is_any(cell, sign, same_bytes)    ? SIGN
                                               : read_number(cell);
}

static bool is_digit(struct span cell)
{
    return cell.end - cell.start == 1;
}

static bool same_text(struct span a, struct span b)
{
    size_t n = a.end - a.start;
    return b.end - b.start == n && memcmp(a.source->text + a.start, b.source->text + b.start, n) == 0;
}

/* ---- where the stitches are ---- */

/* All cells of a table, and its part without numbers of rows and stitches and without empty edges. */
struct table {
    struct arena *arena;
    int          *cell;         /* (ncells) */
    size_t       *line;         /* (nlines): its first cell */
    size_t        ncells;
    int           room, rooms;
    int           nlines;
    int           width, filled;        /* cells of the longest line; without empty ones at its end */
    bool          letters;      /* k or p is among them */
    bool          knits;        /* so an empty cell is not knit: k is, or neither letters nor signs */
    struct span   sign;         /* the first of them, without letters: purl, and an empty cell knit */
    int           top, bottom, left, right;     /* the part: [top, bottom) x [left, right) */
};

static void add_line(struct table *t, struct span line, char separator)
{
    struct span cell;
    size_t first = t->ncells;
    if (t->nlines == t->rooms)
        t->line = arena_larger(t->arena, t->line, &t->rooms, sizeof *t->line);
    t->line[t->nlines++] = first;
    while (t->ncells < 2 * (size_t)LIMIT_STITCHES && next_cell(&line, separator, &cell)) {
        if (t->ncells == (size_t)t->room)
            t->cell = arena_larger(t->arena, t->cell, &t->room, sizeof *t->cell);
        int what = t->cell[t->ncells++] = read_cell(cell);
        t->letters |= what == KNIT || what == PURL;
        t->knits |= what == KNIT;
        if (what == SIGN && !t->sign.source)
            t->sign = cell;
    }
    int width = (int)(t->ncells - first), filled = width;
    while (filled > 0 && t->cell[first + (size_t)filled - 1] == EMPTY)
        filled--;
    t->width = width > t->width ? width : t->width;
    t->filled = filled > t->filled ? filled : t->filled;
}

static int cells_of(const struct table *t, int line)
{
    return (int)((line + 1 < t->nlines ? t->line[line + 1] : t->ncells) - t->line[line]);
}

static int cell_at(const struct table *t, int line, int column)
{
    return column < cells_of(t, line) ? t->cell[t->line[line] + (size_t)column] : EMPTY;
}

/* Are the numbers of a line, from 1 up, each its column plus `left`, or each `right` minus its column? */
static bool counts_columns(const struct table *t, int line, int left, int right)
{
    bool from_left = true, from_right = true;
    for (int column = 0; column < cells_of(t, line); column++) {
        int cell = cell_at(t, line, column);
        from_left &= cell < 0 || (cell > 0 && cell - column == left);
        from_right &= cell < 0 || (cell > 0 && cell + column == right);
    }
    return from_left || from_right;
}

/* Is a line no part of the fabric: empty, or numbers that count something across and are not only stitches? */
static bool is_edge_line(const struct table *t, int line)
{
    int most = EMPTY, first = 0, n = cells_of(t, line);
    for (int column = n - 1; column >= 0; column--) {
        int cell = cell_at(t, line, column);
        if (cell < EMPTY)
            return false;
        first = cell > EMPTY ? column : first;
        most = cell > most ? cell : most;
    }
    if (most == EMPTY)
        return t->knits;
    int number = cell_at(t, line, first);
    return (most > 1 || t->sign.source) && counts_columns(t, line, number - first, number + first);
}

/* Is a column: empty, or numbers that count the rows from the bottom?  1 alone may be a stitch. */
static bool is_edge_column(const struct table *t, int column)
{
    int most = EMPTY;
    bool empty = false;
    for (int line = t->top; line < t->bottom; line++) {
        int cell = cell_at(t, line, column);
        if (cell != EMPTY && cell != t->bottom - line)
            return false;
        empty |= cell == EMPTY;
        most = cell > most ? cell : most;
    }
    return most == EMPTY ? t->knits : most > 1 || t->sign.source || (t->letters && empty);
}

/* Now that the columns are known, is 1 at an end of them? */
static bool is_placed(const struct table *t, int line)
{
    return counts_columns(t, line, 1 - t->left, t->right);
}

/* Lines first, then columns; then it can be said whether the numbers above and below count those. */
static void find_part(struct table *t)
{
    t->bottom = t->nlines;
    t->right = t->knits ? t->filled : t->width;
    while (t->top < t->bottom && is_edge_line(t, t->top))
        t->top++;
    while (t->bottom > t->top && is_edge_line(t, t->bottom - 1))
        t->bottom--;
    while (t->left < t->right && t->left < EDGE && is_edge_column(t, t->left))
        t->left++;
    for (int i = 0; i < EDGE && t->right > t->left && is_edge_column(t, t->right - 1); i++)
        t->right--;
    while (t->top > 0 && !is_placed(t, t->top - 1))
        t->top--;
    while (t->bottom < t->nlines && !is_placed(t, t->bottom))
        t->bottom++;
}

static struct table survey(struct arena *arena, const struct source *source)
{
    struct table t = {.arena = arena};
    struct table_lines lines = {.lines = lines_of(source)};
    struct span line;
    while (t.nlines <= 2 * LIMIT_ROWS && next_line(&lines, &line))
        if (!lines.empty)
            add_line(&t, line, lines.separator);
    if (t.letters)
        t.sign = (struct span){0};
    t.knits |= !t.letters && !t.sign.source;
    find_part(&t);
    return t;
}

/* ---- reading ---- */

/* The stitch a cell stands for; -1: none. */
static int stitch_of(const struct table *t, struct span cell)
{
    int what = read_cell(cell);
    bool signs = t->sign.source;
    if (what == KNIT || (signs ? what == EMPTY : what == 1 && is_digit(cell)))
        return STITCH_K;
    if (what == PURL || (signs ? what == SIGN && same_text(cell, t->sign) : what == 0 && is_digit(cell)))
        return STITCH_P;
    return -1;
}

static void no_stitch(struct diag *diag, struct span cell)
{
    int what = read_cell(cell);
    diag_error(diag, CODE_CHART_MARK, cell, what == EMPTY ? "this cell is empty" : "this cell holds no stitch");
    if (what > 1)
        diag_hint(diag, "numbers of rows count from 1 at the bottom, those of stitches from 1 at one end");
    else if (what != EMPTY)
        diag_hint(diag, "a stitch is k or 1 (knit), p or 0 (purl)");
}

/* False: no use to read on. */
static bool read_row(struct raster *raster, const struct table *t, struct span line, char separator)
{
    struct span cell, rest = line;
    raster_row_follows(raster);
    for (int column = 0; column < t->right && next_cell(&rest, separator, &cell); column++) {
        int stitch = column < t->left ? -1 : stitch_of(t, cell);
        if (column >= t->left && stitch < 0) {
            no_stitch(raster->diag, cell);
            raster_give_up(raster);
            return true;
        }
        if (column >= t->left && !raster_stitch(raster, (stitch_id)stitch, cell))
            return false;
    }
    raster_row(raster, line);
    return raster->rows <= LIMIT_ROWS;
}

static const char *remark(struct arena *arena, const struct table *t)
{
    if (!t->sign.source)
        return NULL;
    return arena_printf(arena, "an empty cell is taken as knit, '%.*s' as purl", (int)(t->sign.end - t->sign.start),
                        t->sign.source->text + t->sign.start);
}

struct pattern csv_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct raster raster = {.arena = arena, .diag = diag};
    struct table table = survey(arena, source);
    struct table_lines lines = {.lines = lines_of(source)};
    struct span line;
    bool going_on = true;

    for (int i = 0; going_on && next_line(&lines, &line); i += !lines.empty)
        if (lines.empty)
            raster_blank(&raster, line);
        else if (i >= table.top && i < table.bottom)
            going_on = read_row(&raster, &table, line, lines.separator);
    return (struct pattern){.grid = raster_grid(&raster, source, RASTER_TOP_FIRST), .across = 1, .up = 1,
                            .remark = remark(arena, &table)};
}

bool csv_is(const struct source *source)
{
    struct table_lines lines = {.lines = lines_of(source)};
    struct span line, cell;
    const char *dot = strrchr(source->name, '.');
    if (!dot || (strcasecmp(dot, ".csv") != 0 && strcasecmp(dot, ".tsv") != 0))
        return false;
    while (next_line(&lines, &line))
        if (next_cell(&line, lines.separator, &cell) && read_number(cell) >= 0 && !is_digit(cell))
            return read_number(cell) > 1;
    return false;
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
