/* SPDX-License-Identifier: GPL-3.0-or-later
 * A grid and a rectangle in, colours and symbols of its stitches out. */
#include "charts/drawn_body.h"

#include <math.h>
#include <stdint.h>

#include "drawing/lettering.h"

enum {
    MARKS_MAX   = 40000,        /* that are drawn one by one */
    LETTER      = 8,            /* marks as long as one letter */
    MANY        = 300 * 1000,   /* stitches that get three pixels a side in an image; fewer get four */
    PART        = 8000          /* stitches of an image's side; cairo's images have 32767 pixels at most */
};

const struct palette *drawn_palette(enum dyes dyes)
{
    static const char *const names[] = {[DYES_PAPER] = "paper", [DYES_SAFE] = "safe"};
    return colours_palette(names[dyes]);
}

static void set_rgb(cairo_t *cairo, struct rgb c)
{
    cairo_set_source_rgb(cairo, c.red, c.green, c.blue);
}

/* ---- one cell ---- */

/* Black on light cells, white on dark ones (luma of ITU-R BT.601). */
static struct rgb ink(const struct drawn_style *style, int stitch)
{
    struct rgb white = {1, 1, 1}, black = {0, 0, 0};
    if (!style->palette)
        return black;
    struct rgb c = colours_stitch(style->palette, stitch);
    return 0.299 * c.red + 0.587 * c.green + 0.114 * c.blue < 0.5 ? white : black;
}

static struct drawn_box cell_box(const struct grid *g, const struct drawn_box *box, int column, int row)
{
    double width = box->width / g->columns, height = box->height / g->rows;
    return (struct drawn_box){box->x + column * width, box->y + (g->rows - 1 - row) * height, width, height};
}

static double purl_pen(const struct drawn_box *cell, enum purls purls)
{
    return fmin(cell->width, cell->height) * (purls == PURLS_DOT ? 0.36 : 0.13);
}

/* A dot is a line of no length with a round cap, a dash half a cell long. */
static void trace_purl(cairo_t *cairo, const struct drawn_box *cell, enum purls purls)
{
    double x = cell->x + cell->width / 2, y = cell->y + cell->height / 2;
    double half = purls == PURLS_DOT ? 0 : 0.25 * cell->width;
    cairo_move_to(cairo, x - half, y);
    cairo_line_to(cairo, x + half, y);
}

/* A stitch of one's own: its symbol, as large as the cell takes it; its name where the symbol has no letters here. */
static void draw_letter(cairo_t *cairo, const struct drawn_box *cell, const struct stitch *stitch)
{
    const char *symbol = lettering_knows(stitch->symbol) ? stitch->symbol : stitch->name;
    double size = fmin(0.8 * cell->height, 0.8 * cell->width / fmax(lettering_width(symbol, 1), 0.1));
    lettering_draw(cairo, cell->x + cell->width / 2, cell->y + cell->height / 2 + LETTERING_CAPITAL / 2 * size, size,
                   LETTERING_CENTRE, symbol);
}

/* ---- all cells of one stitch ---- */

/* As one area, so that no seam shows between them. */
static void fill_cells(cairo_t *cairo, const struct grid *g, const struct drawn_box *box, int stitch)
{
    for (int row = 0; row < g->rows; row++)
        for (int column = 0, end; column < g->columns; column = end) {
            for (end = column + 1; end < g->columns && grid_at(g, end, row) == grid_at(g, column, row);)
                end++;
            struct drawn_box cell = cell_box(g, box, column, row);
            if (grid_at(g, column, row) == stitch)
                cairo_rectangle(cairo, cell.x, cell.y, (end - column) * cell.width, cell.height);
        }
    cairo_fill(cairo);
}

static void draw_symbols(cairo_t *cairo, const struct scene *scene, const struct drawn_box *box, int stitch,
                         enum purls purls)
{
    const struct grid *g = scene->grid;
    for (int row = 0; row < g->rows; row++)
        for (int column = 0; column < g->columns; column++) {
            struct drawn_box cell = cell_box(g, box, column, row);
            if (grid_at(g, column, row) != stitch)
                continue;
            if (stitch == STITCH_P)
                trace_purl(cairo, &cell, purls);
            else
                draw_letter(cairo, &cell, &scene->stitch[stitch]);
        }
    struct drawn_box one = cell_box(g, box, 0, 0);
    cairo_set_line_width(cairo, purl_pen(&one, purls));
    cairo_stroke(cairo);
}

static void draw_lines(cairo_t *cairo, const struct scene *scene, const struct drawn_box *box,
                       const struct drawn_style *style)
{
    if (style->palette) {
        cairo_rectangle(cairo, box->x, box->y, box->width, box->height);
        set_rgb(cairo, colours_stitch(style->palette, STITCH_K));
        cairo_fill(cairo);
    }
    for (int stitch = STITCH_K + 1; stitch < scene->nstitches; stitch++) {
        if (style->palette) {
            set_rgb(cairo, colours_stitch(style->palette, stitch));
            fill_cells(cairo, scene->grid, box, stitch);
        }
        if (style->symbols) {
            set_rgb(cairo, ink(style, stitch));
            draw_symbols(cairo, scene, box, stitch, style->purls);
        }
    }
}

/* ---- an image ---- */

static uint32_t pixel_of(struct rgb c)
{
    return (uint32_t)lround(255 * c.red) << 16 | (uint32_t)lround(255 * c.green) << 8 | (uint32_t)lround(255 * c.blue);
}

/* The colours of a stitch without room for its symbol: the cell's, and that of
 * the pixels within its border. */
static void two_colors(const struct drawn_style *style, int stitch, uint32_t color[2])
{
    const struct palette *palette = style->palette ? style->palette : drawn_palette(DYES_PAPER);
    struct rgb white = {1, 1, 1};
    bool own = stitch > STITCH_P;
    color[0] = color[1] = pixel_of(style->palette || own ? colours_stitch(palette, stitch) : white);
    if (style->symbols && stitch == STITCH_P)
        color[1] = pixel_of(ink(style, stitch));
}

/* A window of the grid. */
struct part { int column, row, columns, rows; };

static void paint_cell(uint32_t *at, size_t stride, int side, const uint32_t color[2])
{
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++)
            at[(size_t)y * stride + (size_t)x] = color[x > 0 && x < side - 1 && y > 0 && y < side - 1];
}

static void paint_cells(uint32_t *pixels, size_t stride, const struct scene *scene, int side,
                        const struct drawn_style *style, struct part part)
{
    uint32_t color[STITCH_MAX + 1][2];
    for (int stitch = 0; stitch < scene->nstitches; stitch++)
        two_colors(style, stitch, color[stitch]);
    for (int row = 0; row < part.rows; row++) {
        uint32_t *line = pixels + (size_t)(part.rows - 1 - row) * (size_t)side * stride;
        for (int column = 0; column < part.columns; column++)
            paint_cell(line + column * side, stride, side,
                       color[grid_at(scene->grid, part.column + column, part.row + row)]);
    }
}

/* A part of the grid as an image, at its place in the box. */
static void draw_part(cairo_t *cairo, const struct scene *scene, const struct drawn_box *box, int side,
                      const struct drawn_style *style, struct part part)
{
    const struct grid *g = scene->grid;
    double width = box->width / g->columns, height = box->height / g->rows, x = side, y = side;
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, part.columns * side, part.rows * side);
    uint32_t *pixels = (uint32_t *)(void *)cairo_image_surface_get_data(image);
    if (pixels) {
        paint_cells(pixels, (size_t)cairo_image_surface_get_stride(image) / sizeof *pixels, scene, side, style, part);
        cairo_surface_mark_dirty(image);
    }
    cairo_save(cairo);
    cairo_translate(cairo, box->x + part.column * width, box->y + (g->rows - part.row - part.rows) * height);
    cairo_scale(cairo, width / side, height / side);
    cairo_user_to_device_distance(cairo, &x, &y);
    bool smaller = fmin(x, y) < 0.999 * side && cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_IMAGE;
    cairo_set_source_surface(cairo, image, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo), smaller ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(image);
}

static void draw_image(cairo_t *cairo, const struct scene *scene, const struct drawn_box *box,
                       const struct drawn_style *style)
{
    const struct grid *g = scene->grid;
    int side = drawn_pixels(scene, style);
    for (int row = 0; row < g->rows; row += PART)
        for (int column = 0; column < g->columns; column += PART) {
            int columns = g->columns - column, rows = g->rows - row;
            draw_part(cairo, scene, box, side, style,
                      (struct part){column, row, columns < PART ? columns : PART, rows < PART ? rows : PART});
        }
}

/* ---- all ---- */

int drawn_pixels(const struct scene *scene, const struct drawn_style *style)
{
    const struct grid *g = scene->grid;
    size_t marks = 0, cells = (size_t)g->columns * (size_t)g->rows;
    for (size_t i = 0; i < cells && marks <= MARKS_MAX; i++)
        marks += style->symbols && g->cell[i] > STITCH_P ? LETTER : 1;
    return marks <= MARKS_MAX ? 0 : cells <= MANY ? 4 : 3;
}

void drawn_body(cairo_t *cairo, const struct scene *scene, struct drawn_box box, const struct drawn_style *style)
{
    (drawn_pixels(scene, style) ? draw_image : draw_lines)(cairo, scene, &box, style);
}

void drawn_cell(cairo_t *cairo, const struct scene *scene, stitch_id stitch, struct drawn_box box,
                const struct drawn_style *style)
{
    const struct grid one = {1, 1, &stitch};
    struct scene alone = *scene;
    alone.grid = &one;
    draw_lines(cairo, &alone, &box, style);
}
