/* SPDX-License-Identifier: GPL-3.0-or-later
 * A pattern in, a script as a person would write it out. */
#include "charts/import.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "charts/written.h"
#include "lang/limits.h"
#include "lang/names.h"
#include "lang/parse.h"

/* ---- the motif's name ---- */

static bool is_taken(const char *name)
{
    static const char *const others[] = {"tile", "each", "mod", "else", "std", "from", "purl", "true", "false"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcasecmp(name, others[i]) == 0)
            return true;
    for (int i = 0; i < nstatement_words; i++)
        if (strcasecmp(name, statement_word[i]) == 0)
            return true;
    return strlen(name) < 3;
}

/* The file's name without folder and extension, as a name of the language. */
static const char *motif_name(struct arena *arena, const char *path)
{
    const char *slash = strrchr(path, '/'), *stem = slash ? slash + 1 : path, *dot = strrchr(stem, '.');
    size_t length = dot && dot > stem ? (size_t)(dot - stem) : strlen(stem);
    char *name = arena_copy(arena, stem, length < LIMIT_NAME / 2 ? length : LIMIT_NAME / 2);
    for (char *c = name; *c; c++)
        *c = isalnum((unsigned char)*c) ? (char)tolower((unsigned char)*c) : '_';
    if (!isalpha((unsigned char)*name))
        return arena_printf(arena, "chart%s%s", *name && *name != '_' ? "_" : "", strcmp(path, "-") == 0 ? "" : name);
    return is_taken(name) ? arena_printf(arena, "%s_chart", name) : name;
}

/* ---- its repeat ---- */

/* Does every row equal itself moved by a period; does the grid, moved up? */
static bool repeats_across(const struct grid *g, int period)
{
    for (int row = 0; row < g->rows; row++) {
        const stitch_id *cell = g->cell + (size_t)row * (size_t)g->columns;
        if (memcmp(cell, cell + period, (size_t)(g->columns - period)) != 0)
            return false;
    }
    return true;
}

static bool repeats_up(const struct grid *g, int period)
{
    size_t columns = (size_t)g->columns;
    return memcmp(g->cell, g->cell + columns * (size_t)period, columns * (size_t)(g->rows - period)) == 0;
}

/* The fewest rows that make all, of first, first + 2, ...; all if none do. */
static int rows_of_repeat(const struct grid *g, int first)
{
    int rows = first;
    while (rows < g->rows && !(g->rows % rows == 0 && repeats_up(g, rows)))
        rows += 2;
    return rows < g->rows ? rows : g->rows;
}

/* The smallest part that makes the grid, if possible of an even number of rows: those can be written out. */
static struct pattern find_repeat(struct arena *arena, const struct pattern *whole)
{
    struct pattern part = *whole;
    int columns = 1, rows, width = whole->grid->columns, height = whole->grid->rows;
    if (whole->across > 1 || whole->up > 1 || whole->words)
        return part;
    while (columns < width && !(width % columns == 0 && repeats_across(whole->grid, columns)))
        columns++;
    rows = rows_of_repeat(whole->grid, 2);
    if (rows == height)
        rows = rows_of_repeat(whole->grid, 1);
    part.grid = grid_window(arena, whole->grid, 0, 0, columns, rows);
    part.across = width / columns;
    part.up = height / rows;
    return part;
}

/* ---- its body ---- */

static void write_chart(struct text *text, const struct grid *g)
{
    char last[32];
    int width = snprintf(last, sizeof last, "%d", g->rows);
    text_print(text, "  chart (x = P, . = K) {\n");
    for (int row = g->rows - 1; row >= 0; row--) {
        text_print(text, "    ");
        for (int i = 0; i < g->columns; i++)
            text_bytes(text, grid_at(g, i, row) == STITCH_K ? "." : "x", 1);
        text_print(text, "  %*d\n", width, row + 1);
    }
    text_print(text, "  }\n");
}

static size_t chart_length(const struct grid *g)
{
    return ((size_t)g->columns + 8) * (size_t)g->rows;
}

/* Rows are copied with their sides, so an odd number of them cannot be stacked. */
static bool rows_can(const struct pattern *p)
{
    const struct grid *g = p->grid;
    return (p->up == 1 || g->rows % 2 == 0) && g->rows <= LIMIT_WRITTEN_ROWS && g->columns <= LIMIT_ITEMS / g->rows;
}

static void write_body(struct text *text, const struct pattern *p)
{
    static const struct written_style style = {.words = &dictionary_plain, .open = true, .indent = "  "};
    struct text rows = {.arena = text->arena};
    bool can = rows_can(p), must = p->grid->columns > LIMIT_LINE / 2;
    if (can)
        written_rows(&rows, p->grid, &style);
    if (can && (must || rows.length <= chart_length(p->grid)))
        text_bytes(text, rows.bytes, rows.length);
    else
        write_chart(text, p->grid);
}

static const char *one_line(struct arena *arena, const char *path)
{
    const char *slash = strrchr(path, '/');
    char *name = arena_copy(arena, slash ? slash + 1 : path, strlen(slash ? slash + 1 : path));
    for (char *c = name; *c; c++)
        *c = (unsigned char)*c < 0x20 || *c == 0x7F ? '?' : *c;
    return strcmp(path, "-") == 0 ? "standard input" : name;
}

void import_script(struct text *text, const struct pattern *whole, const char *path, const char *what)
{
    struct pattern part = find_repeat(text->arena, whole), *p = &part;
    const char *name = motif_name(text->arena, path);
    const char *end = p->across > 1 || p->up > 1 ? "}\nswatch tile(%s, %d, %d)\n" : "}\nswatch %s\n";
    text_print(text, "# %s, from %s: %d %s x %d %s\n", what, one_line(text->arena, path), whole->grid->columns,
               names_count(whole->grid->columns, "stitch", "stitches"), whole->grid->rows, names_count(whole->grid->rows, "row", "rows"));
    if (p->remark)
        text_print(text, "# %s\n", p->remark);
    if (p->words) {
        text_bytes(text, p->words, strlen(p->words));
        return;
    }
    text_print(text, "motif %s multiple of %d {\n", name, p->grid->columns);
    write_body(text, p);
    text_print(text, end, name, p->across, p->up);
}
