/* SPDX-License-Identifier: GPL-3.0-or-later
 * A grid in, its rows in words out, in the order and from the side they are worked. */
#include "charts/written.h"

#include <string.h>

#include "charts/row.h"

enum {
    TABLE      = 4 * 1000 * 1000,   /* entries of the table of repeats */
    BLOCK      = 64,                /* rows that are at least looked at together */
    COST_LINE  = 4,                 /* of a line of words, and of `Repeat rows ..` */
    COST_LABEL = 1,                 /* of a further row number before the words */
    SMALL      = 200 * 1000,        /* stitches of a grid that is searched for a multiple */
    EDGE       = 8,                 /* stitches at each side that may lie outside the repeat */
    REPEAT     = 64                 /* stitches of a repeat that is looked for */
};

/* How the rows from one on are written: a block of rows, perhaps repeated. */
struct plan {
    int cost;       /* to the end */
    int rows;       /* of the block */
    int times;      /* the block is worked, in all; 0: to the last row of the grid */
};

struct writer {
    struct text                *text;
    const struct written_style *style;
    const struct grid          *grid;
    stitch_id                  *worked;     /* (rows x columns) in working order */
    int                        *words;      /* (rows) the first row with the same words */
    int                         most;       /* rows of a block that is repeated */
    int                        *same;       /* (most + 1 x rows) rows from one on that equal those `block` further up */
    struct plan                *plan;       /* (rows + 1) */
    int                        *stamp;      /* (rows) */
};

static const stitch_id *worked_row(const struct writer *w, int row)
{
    return w->worked + (size_t)row * (size_t)w->grid->columns;
}

/* ---- rows as they are worked ---- */

/* row counts from 0. */
static bool is_right_side(const struct writer *w, int row)
{
    return w->style->round || (row % 2 == 0) != w->style->ws_first;
}

static void work_rows(struct writer *w)
{
    int columns = w->grid->columns;
    for (int row = 0; row < w->grid->rows; row++)
        for (int i = 0; i < columns; i++) {
            stitch_id *to = w->worked + (size_t)row * (size_t)columns + i;
            if (is_right_side(w, row))
                *to = grid_at(w->grid, columns - 1 - i, row);
            else
                *to = (stitch_id)w->style->words->entry[grid_at(w->grid, i, row)].on_ws;
        }
}

static unsigned hash(const stitch_id *row, int n)
{
    unsigned h = 2166136261u;
    for (int i = 0; i < n; i++)
        h = (h ^ row[i]) * 16777619u;
    return h;
}

/* Gives rows of the same words one number, by an open table of hashes. */
static void compare_rows(struct writer *w)
{
    int rows = w->grid->rows, columns = w->grid->columns;
    unsigned size = 16;
    while (size < 2 * (unsigned)rows)
        size *= 2;
    int *slot = arena_array(w->text->arena, int, size);
    for (int row = 0; row < rows; row++) {
        unsigned at = hash(worked_row(w, row), columns) % size;
        while (slot[at] && memcmp(worked_row(w, slot[at] - 1), worked_row(w, row), (size_t)columns) != 0)
            at = (at + 1) % size;
        slot[at] = slot[at] ? slot[at] : row + 1;
        w->words[row] = slot[at] - 1;
    }
}

/* ---- the plan ---- */

static int *same_from(const struct writer *w, int block)
{
    return w->same + (size_t)block * (size_t)w->grid->rows;
}

static void find_repeats(struct writer *w)
{
    int rows = w->grid->rows;
    for (int block = 1; block <= w->most; block++) {
        int *same = same_from(w, block);
        for (int row = rows - block - 1; row >= 0; row--)
            same[row] = w->words[row] == w->words[row + block] ? (row + 1 < rows ? same[row + 1] : 0) + 1 : 0;
    }
}

static void offer(struct plan *best, int cost, int rows, int times)
{
    if (cost < best->cost)
        *best = (struct plan){cost, rows, times};
}

/* The cheapest way from a row on, all later ones being known. */
static void plan_from(struct writer *w, int row)
{
    int left = w->grid->rows - row, look = w->most > BLOCK ? w->most : BLOCK;
    int cost = 0;
    struct plan *best = &w->plan[row];
    *best = (struct plan){.cost = 1 << 30};
    if (w->grid->rows <= TABLE / w->grid->rows || look > left)
        look = left;
    for (int rows = 1; rows <= look; rows++) {
        int last = row + rows - 1, words = w->words[last];
        if (w->stamp[words] != row + 1)
            cost += COST_LINE;
        else if (w->words[last - 1] != words)
            cost += COST_LABEL;
        w->stamp[words] = row + 1;
        int same = rows <= w->most && rows < left ? same_from(w, rows)[row] : 0;
        if (same >= rows && (w->style->round || rows % 2 == 0)) {
            int times = same / rows + 1;
            offer(best, cost + COST_LINE + w->plan[row + rows * times].cost, rows, times);
            if (rows + same == left)
                offer(best, cost + COST_LINE, rows, 0);
        }
        offer(best, cost + w->plan[row + rows].cost, rows, 1);
    }
}

static void make_plan(struct writer *w)
{
    w->plan[w->grid->rows] = (struct plan){0};
    for (int row = w->grid->rows - 1; row >= 0; row--)
        plan_from(w, row);
}

/* ---- lines ---- */

/* The next rows of a block that have the words of its row `first`: three and more in a run
 * together, else one. False behind the last. */
static bool next_label(const struct writer *w, int first, int end, int *row, int label[2])
{
    int words = w->words[first];
    while (*row < end && w->words[*row] != words)
        (*row)++;
    label[0] = *row + 1;
    while (*row < end && w->words[*row] == words)
        (*row)++;
    if (*row == label[0] + 1)
        (*row)--;
    label[1] = *row;
    return label[0] <= label[1];
}

/* `1`, `1 and 2`, `1-3, 5 and 7` */
static void write_labels(struct writer *w, int first, int end)
{
    int label[2], row = first, n = 0, i = 0;
    while (next_label(w, first, end, &row, label))
        n++;
    for (row = first; next_label(w, first, end, &row, label); i++) {
        const char *between = i == 0 ? "" : i == n - 1 ? " and " : ", ";
        text_print(w->text, label[0] == label[1] ? "%s%d" : "%s%d-%d", between, label[0], label[1]);
    }
}

/* Is this the text of all WS rows, the even ones, of three at least, and no other row of the fabric's? */
static bool is_all_ws(const struct writer *w, int first, int end)
{
    const struct plan *plan = &w->plan[0];
    int count = 0, block = plan->times == 1 ? plan->rows : plan->rows * (plan->times ? plan->times : 1);
    bool alone = w->grid->rows % 2 == 0 && end == plan->rows && (plan->times == 0 || block == w->grid->rows);
    for (int row = 0; row < end && alone; row++) {
        alone = (w->words[row] == w->words[first]) == (row % 2 == 1);
        count += row % 2;
    }
    return alone && first == 1 && count >= 3 && !w->style->round && !w->style->ws_first && !w->style->open;
}

/* `Row`, `Rows`, `Rnd`, `Rnds` and the side, if the rows have one. */
static void write_head(struct writer *w, int first, int end)
{
    int count = 0, right = 0;
    if (is_all_ws(w, first, end)) {
        text_print(w->text, "%sRow 2 and all WS rows: ", w->style->indent);
        return;
    }
    for (int row = first; row < end; row++)
        if (w->words[row] == w->words[first]) {
            count++;
            right += is_right_side(w, row);
        }
    text_print(w->text, "%s%s%s ", w->style->indent, w->style->round ? "Rnd" : "Row", count > 1 ? "s" : "");
    write_labels(w, first, end);
    text_print(w->text, "%s: ", w->style->round ? "" : right == count ? " (RS)" : right == 0 ? " (WS)" : "");
}

static void write_line(struct writer *w, int first, int end)
{
    size_t begin = w->text->length;
    struct arena *arena = w->text->arena;
    int columns = w->grid->columns;
    bool counted = !w->style->open && !w->style->uncounted;
    write_head(w, first, end);
    struct row_writer row = {
        .text = w->text,
        .words = w->style->words,
        .indent = arena_printf(arena, "%s    ", w->style->indent),
        .end = counted ? arena_printf(arena, ". (%d st%s)", columns, columns == 1 ? "" : "s") : "",
        .column = (int)(w->text->length - begin),
        .open = w->style->open,
    };
    row_write(&row, worked_row(w, first), columns);
    text_print(w->text, "\n");
}

/* A line for each of the block's words, at its first row. */
static void write_block(struct writer *w, int from, int end)
{
    for (int row = from; row < end; row++)
        w->stamp[w->words[row]] = 0;
    for (int row = from; row < end; row++)
        if (!w->stamp[w->words[row]]) {
            w->stamp[w->words[row]] = 1;
            write_line(w, row, end);
        }
}

static void write_again(struct writer *w, int from, const struct plan *plan)
{
    const char *noun = w->style->round ? "rnd" : "row", *dot = w->style->open ? "" : ".";
    text_print(w->text, plan->rows > 1 ? "%sRepeat %ss %d-%d " : "%sRepeat %s %d ", w->style->indent, noun, from + 1,
               from + plan->rows);
    if (plan->times == 0)
        text_print(w->text, "until piece has %d %ss%s\n", w->grid->rows, noun, dot);
    else if (plan->times == 2)
        text_print(w->text, "once more%s\n", dot);
    else
        text_print(w->text, "%d more times%s\n", plan->times - 1, dot);
}

void written_rows(struct text *text, const struct grid *grid, const struct written_style *style)
{
    struct writer w = {.text = text, .style = style, .grid = grid};
    size_t rows = (size_t)grid->rows;
    w.most = grid->rows / 2 < TABLE / grid->rows ? grid->rows / 2 : TABLE / grid->rows;
    w.worked = arena_array(text->arena, stitch_id, rows * (size_t)grid->columns);
    w.words = arena_array(text->arena, int, rows);
    w.same = arena_array(text->arena, int, ((size_t)w.most + 1) * rows);
    w.plan = arena_array(text->arena, struct plan, rows + 1);
    w.stamp = arena_array(text->arena, int, rows);
    work_rows(&w);
    compare_rows(&w);
    find_repeats(&w);
    make_plan(&w);
    for (int row = 0; row < grid->rows;) {
        const struct plan *plan = &w.plan[row];
        write_block(&w, row, row + plan->rows);
        if (plan->times != 1)
            write_again(&w, row, plan);
        row = plan->times ? row + plan->rows * plan->times : grid->rows;
    }
}

/* ---- a whole pattern ---- */

/* Does every row equal itself moved by a period, but for some stitches at both edges? */
static bool repeats(const struct grid *g, int period, int edge)
{
    for (int row = 0; row < g->rows; row++) {
        const stitch_id *cell = g->cell + (size_t)row * (size_t)g->columns + edge;
        if (memcmp(cell, cell + period, (size_t)(g->columns - 2 * edge - period)) != 0)
            return false;
    }
    return true;
}

/* Would the words be the same with one repeat more? */
static bool words_fit(struct arena *arena, const struct grid *g, struct written_style style, int period, int edge)
{
    struct text words = {.arena = arena}, wider = {.arena = arena};
    style.uncounted = true;
    written_rows(&words, g, &style);
    written_rows(&wider, grid_stretch(arena, g, edge, period, 2), &style);
    return words.length == wider.length && memcmp(words.bytes, wider.bytes, words.length) == 0;
}

/* `Multiple of 4 sts + 2.`, where at least two repeats stand side by side. */
static void write_multiple(struct text *text, const struct grid *g, const struct written_style *style)
{
    for (int edge = 0; edge <= EDGE && g->rows <= SMALL / g->columns; edge++)
        for (int period = 2; period <= REPEAT && 2 * period + 2 * edge <= g->columns; period++) {
            int plus = g->columns - (g->columns - 2 * edge) / period * period;
            if (!repeats(g, period, edge) || repeats(g, 1, edge))
                continue;
            if (words_fit(text->arena, g, *style, period, edge))
                text_print(text, plus ? "Multiple of %d sts + %d.\n" : "Multiple of %d sts.\n", period, plus);
            return;
        }
}

void written_pattern(struct text *text, const struct grid *grid, const struct written_style *style)
{
    write_multiple(text, grid, style);
    text_print(text, "Cast on %d st%s%s.\n", grid->columns, grid->columns == 1 ? "" : "s",
               style->round ? "; join to work in the round" : "");
    written_rows(text, grid, style);
    text_print(text, "Bind off.\n");
}
