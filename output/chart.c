/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts as text: a stitch grid in, lines of letters out. */
#include "output/chart.h"

#include <stdio.h>
#include <string.h>

/* ---- the K/P grid ---- */

void chart_grid(struct file *file, const struct scene *scene)
{
    const struct grid *g = scene->grid;
    file_print(file, "# 1 1\n");
    for (int j = 0; j < g->rows; j++) {
        for (int i = 0; i < g->columns; i++) {
            const char *name = scene->stitch[grid_at(g, i, j)].name;
            file_write(file, name, strlen(name));
            file_write(file, i + 1 < g->columns ? " " : "\n", 1);
        }
    }
}

/* ---- the chart for people ---- */

/* Characters of UTF-8 text: every byte but those that go on with one. */
static int text_width(const char *text)
{
    int width = 0;
    for (; *text; text++)
        width += ((unsigned char)*text & 0xC0) != 0x80;
    return width;
}

static int symbol_width(const struct scene *scene)
{
    int width = 1;
    for (int id = 0; id < scene->nstitches; id++) {
        int w = text_width(scene->stitch[id].symbol);
        width = w > width ? w : width;
    }
    return width;
}

/* Symbols of a width, with so many blanks before each; one at least before the first. */
static void print_row(struct file *file, const struct scene *scene, int row, int width, int blanks)
{
    for (int i = 0; i < scene->grid->columns; i++) {
        const char *symbol = scene->stitch[grid_at(scene->grid, i, row)].symbol;
        file_print(file, "%*s", (i > 0 ? blanks : 1) + width - text_width(symbol), "");
        file_write(file, symbol, strlen(symbol));
    }
}

enum { TERMINAL = 80 };     /* columns: a chart that would be wider has no blanks between letters */

void chart_text(struct file *file, const struct scene *scene)
{
    char last[32];
    int digits = snprintf(last, sizeof last, "%d", scene->grid->rows), margin = scene->round ? 0 : digits;
    int width = symbol_width(scene), whole = margin + scene->grid->columns * (width + 1) + 2 + digits;
    for (int row = scene->grid->rows; row >= 1; row--) {
        bool right_side = scene_right_side(scene, row);
        if (right_side)
            file_print(file, "%*s", margin, "");
        else
            file_print(file, "%*d", margin, row);
        print_row(file, scene, row - 1, width, width == 1 && whole > TERMINAL ? 0 : 1);
        if (right_side)
            file_print(file, "  %d", row);
        file_print(file, "\n");
    }
}
