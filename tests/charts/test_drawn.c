/* SPDX-License-Identifier: GPL-3.0-or-later
 * Drawn charts, read back: every stitch at its place in SVG and PNG, numbers on
 * their sides, the repeat, the key, sizes. */
#include <config.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/drawn.h"
#include "charts/drawn_body.h"
#include "charts/repeat.h"
#include "drawing/colours.h"
#include "drawing/lettering.h"

/* ---- scenes ---- */

static const struct stitch stitches[] = {
    {.name = "K", .symbol = "k", .ws = STITCH_P}, {.name = "P", .symbol = "p", .ws = STITCH_K},
    {.name = "T", .symbol = "t", .ws = 3},        {.name = "S", .symbol = "S1", .ws = 2},
};

static struct scene scene_of(const struct grid *grid)
{
    return (struct scene){.file = "folder/my_chart.knit", .grid = grid, .nstitches = 4, .stitch = stitches,
                          .gauge = {1.4, 1.2}};
}

/* Cells that do not repeat: any of the first n stitches. */
static struct grid random_grid(int columns, int rows, int n)
{
    stitch_id *cell = malloc((size_t)columns * (size_t)rows);
    uint32_t state = (uint32_t)(columns * 7919 + rows);
    assert_non_null(cell);
    for (int i = 0; i < columns * rows; i++) {
        state = state * 1664525u + 1013904223u;
        cell[i] = (stitch_id)((state >> 16) % (unsigned)n);
    }
    return (struct grid){columns, rows, cell};
}

/* The first grid over and over, up to a size. */
static struct grid tiled(const struct grid *part, int columns, int rows)
{
    stitch_id *cell = malloc((size_t)columns * (size_t)rows);
    assert_non_null(cell);
    for (int i = 0; i < columns * rows; i++)
        cell[i] = grid_at(part, i % columns % part->columns, i / columns % part->rows);
    return (struct grid){columns, rows, cell};
}

static void drop(struct grid grid)
{
    free((void *)(uintptr_t)grid.cell);
}

/* ---- drawings ---- */

struct bytes { char *at; size_t n, read; };

static void take(void *self, const void *bytes, size_t n)
{
    struct bytes *all = self;
    all->at = realloc(all->at, all->n + n + 1);
    assert_non_null(all->at);
    memcpy(all->at + all->n, bytes, n);
    all->at[all->n += n] = 0;
}

static const struct chart_look plain;

static struct bytes draw(const struct scene *scene, struct chart_look look, enum canvas_format format)
{
    struct bytes bytes = {0};
    assert_null(drawn_refusal(scene, &look, format));
    assert_null(drawn_chart(scene, &look, format, take, &bytes));
    return bytes;
}

/* The first closed rectangle of a colour: 'rgb(0%,0%,0%)' is the outline of all cells. */
static struct drawn_box box_of(const char *svg, const char *color)
{
    double x[4], y[4];
    for (const char *at = svg; (at = strstr(at, color)) != NULL; at++) {
        const char *d = strstr(at, " d=\"");
        if (sscanf(d, " d=\"M %lf %lf L %lf %lf L %lf %lf L %lf %lf Z", x, y, x + 1, y + 1, x + 2, y + 2, x + 3, y + 3) == 8)
            return (struct drawn_box){x[0], y[0], x[2] - x[0], y[2] - y[0]};
    }
    fail_msg("no box in %s", color);
    return (struct drawn_box){0};
}

static struct drawn_box body_of(const char *svg)
{
    return box_of(svg, "stroke:rgb(0%,0%,0%)");
}

/* Is a text drawn at this place, in this size?  The same letters are drawn
 * alone, and their path and its place looked for. */
static bool has_text(const char *svg, double x, double y, double size, enum lettering_align align, const char *text)
{
    struct bytes alone = {0};
    struct canvas *canvas = canvas_begin(CANVAS_SVG, (struct canvas_size){5000, 5000, 1}, take, &alone);
    lettering_draw(canvas->cairo, x, y, size, align, text);
    assert_null(canvas_end(canvas));
    char *path = strstr(alone.at, " d=\"");
    *strstr(path, "/>") = 0;
    bool found = strstr(svg, path) != NULL;
    free(alone.at);
    return found;
}

enum { SMALL = 8 };     /* size of numbers beside cells of full size */

struct point { double x, y; };

/* Columns and rows from 0, at the lower left corner. */
static struct point centre_of(const struct drawn_box *body, const struct grid *g, int column, int row)
{
    return (struct point){body->x + (column + 0.5) * body->width / g->columns,
                          body->y + body->height - (row + 0.5) * body->height / g->rows};
}

/* ---- cells ---- */

/* The ends of the lines in a path, cell by cell; returns their number. */
static int read_marks(const char *path, const struct drawn_box *body, const struct grid *g, double half, char *seen)
{
    double x[2], y[2], width = body->width / g->columns, height = body->height / g->rows;
    int n = 0, used = 0;
    for (; sscanf(path, " M %lf %lf L %lf %lf%n", x, y, x + 1, y + 1, &used) == 4; path += used, n++) {
        double column = ((x[0] + x[1]) / 2 - body->x) / width - 0.5, row = (body->y + body->height - y[0]) / height - 0.5;
        assert_true(fabs(column - round(column)) < 0.01 && fabs(row - round(row)) < 0.01);
        assert_true(fabs(x[1] - x[0] - 2 * half) < 0.01 && y[0] == y[1]);
        int cell = (int)round(row) * g->columns + (int)round(column);
        assert_true(cell >= 0 && cell < g->columns * g->rows && !seen[cell]);
        seen[cell] = 1;
    }
    return n;
}

static void check_marks(enum purls symbols, double pen, double half)
{
    struct grid g = random_grid(23, 17, 2);
    struct scene scene = scene_of(&g);
    char seen[23 * 17] = {0}, width[32];
    struct bytes svg = draw(&scene, (struct chart_look){.symbols = symbols}, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    assert_true(body.width == 23 * 17.5 && body.height == 17 * 15);
    snprintf(width, sizeof width, "stroke-width:%g;", pen);
    const char *path = strstr(strstr(svg.at, width), " d=\"") + 4;
    read_marks(path, &body, &g, half, seen);
    for (int i = 0; i < 23 * 17; i++)
        assert_int_equal(seen[i], g.cell[i]);
    free(svg.at);
    drop(g);
}

static void purls_are_dots_at_their_stitches(void **state)
{
    (void)state;
    check_marks(PURLS_DOT, 5.4, 0);
}

static void or_dashes(void **state)
{
    (void)state;
    check_marks(PURLS_DASH, 1.95, 17.5 / 4);
}

static void own_stitches_are_their_symbols(void **state)
{
    (void)state;
    struct grid g = random_grid(9, 5, 4);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    for (int i = 0; i < 45; i++) {
        struct point at = centre_of(&body, &g, i % 9, i / 9);
        double sizes[] = {12, fmin(12, 14 / lettering_width("S1", 1))};
        for (int own = 0; own < 2; own++)
            assert_int_equal(has_text(svg.at, at.x, at.y + LETTERING_CAPITAL / 2 * sizes[own], sizes[own], LETTERING_CENTRE,
                                      stitches[2 + own].symbol),
                             g.cell[i] == 2 + own);
    }
    free(svg.at);
    drop(g);
}

/* Two symbols without letters would look alike. */
static void a_symbol_without_letters_is_the_stitchs_name(void **state)
{
    (void)state;
    static const struct stitch arrows[] = {
        {.name = "K", .symbol = "k", .ws = STITCH_P}, {.name = "P", .symbol = "p", .ws = STITCH_K},
        {.name = "T", .symbol = "\u2192", .ws = 2},   {.name = "S", .symbol = "a\u20ac", .ws = 3},
    };
    const stitch_id cells[] = {2, 3};
    struct grid g = {2, 1, cells};
    struct scene scene = scene_of(&g);
    scene.stitch = arrows;
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    for (int i = 0; i < 2; i++) {
        struct point at = centre_of(&body, &g, i, 0);
        assert_true(has_text(svg.at, at.x, at.y + LETTERING_CAPITAL / 2 * 12, 12, LETTERING_CENTRE, arrows[2 + i].name));
    }
    free(svg.at);
}

/* ---- pixels ---- */

static cairo_status_t give(void *self, unsigned char *data, unsigned n)
{
    struct bytes *all = self;
    if (all->n - all->read < n)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(data, all->at + all->read, n);
    all->read += n;
    return CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *image_of(const struct scene *scene, struct chart_look look)
{
    struct bytes png = draw(scene, look, CANVAS_PNG);
    cairo_surface_t *image = cairo_image_surface_create_from_png_stream(give, &png);
    assert_int_equal(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
    free(png.at);
    return image;
}

/* Two pixels are one point. */
static uint32_t pixel_at(cairo_surface_t *image, double x, double y)
{
    const unsigned char *row = cairo_image_surface_get_data(image) + (int)(2 * y) * cairo_image_surface_get_stride(image);
    return ((const uint32_t *)(const void *)row)[(int)(2 * x)] & 0xffffff;
}

static struct drawn_box body_in_points(const struct scene *scene, struct chart_look look)
{
    struct bytes svg = draw(scene, look, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    free(svg.at);
    return body;
}

/* Purl is black and knit is white in the middle of a cell, whatever its size. */
static void pixels_show_the_grid(void **state)
{
    (void)state;
    static const struct { int columns, rows; } sizes[] = {{1, 1}, {1, 40}, {31, 1}, {48, 92}, {230, 190}, {620, 510}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct grid g = random_grid(sizes[i].columns, sizes[i].rows, 2);
        struct scene scene = scene_of(&g);
        struct drawn_box body = body_in_points(&scene, plain);
        cairo_surface_t *image = image_of(&scene, plain);
        for (int cell = 0; cell < g.columns * g.rows; cell++) {
            struct point at = centre_of(&body, &g, cell % g.columns, cell / g.columns);
            uint32_t wanted = g.cell[cell] == STITCH_P ? 0 : 0xffffff, found = pixel_at(image, at.x, at.y);
            if (found != wanted)
                fail_msg("%d x %d, stitch %d is %06x", g.columns, g.rows, cell, (unsigned)found);
        }
        cairo_surface_destroy(image);
        drop(g);
    }
}

static uint32_t color_of(const char *palette, int stitch)
{
    unsigned char bytes[3];
    colours_bytes(colours_stitch(colours_palette(palette), stitch), bytes);
    return (uint32_t)bytes[0] << 16 | (uint32_t)bytes[1] << 8 | bytes[2];
}

/* In colour, a quarter of a cell from its corner; large charts all over. */
static void check_colors(int columns, int rows, struct chart_look look, const char *palette)
{
    struct grid g = random_grid(columns, rows, 4);
    struct scene scene = scene_of(&g);
    struct drawn_box body = body_in_points(&scene, look);
    cairo_surface_t *image = image_of(&scene, look);
    double aside = columns > 100 ? 0 : body.width / columns / 2 - 1.5, up = columns > 100 ? 0 : body.height / rows / 2 - 1.5;
    for (int cell = 0; cell < columns * rows; cell++) {
        struct point at = centre_of(&body, &g, cell % columns, cell / columns);
        if (g.cell[cell] != STITCH_P || aside > 0)
            assert_int_equal(pixel_at(image, at.x - aside, at.y - up), color_of(palette, g.cell[cell]));
    }
    cairo_surface_destroy(image);
    drop(g);
}

static void colors_are_the_palettes(void **state)
{
    (void)state;
    check_colors(13, 11, (struct chart_look){.color = true}, "paper");
    check_colors(13, 11, (struct chart_look){.color = true, .palette = DYES_SAFE, .symbols = PURLS_DASH}, "safe");
    check_colors(230, 220, (struct chart_look){.color = true, .palette = DYES_SAFE}, "safe");
}

/* ---- numbers, title, key ---- */

static bool has_row_number(const char *svg, const struct drawn_box *body, int rows, int row, bool right, double size)
{
    char text[16];
    double y = body->y + body->height - (row - 0.5) * body->height / rows + LETTERING_CAPITAL / 2 * size;
    snprintf(text, sizeof text, "%d", row);
    return has_text(svg, right ? body->x + body->width + 0.7 * size : body->x - 0.7 * size, y, size,
                    right ? LETTERING_LEFT : LETTERING_RIGHT, text);
}

static void row_numbers_stand_where_rows_begin(void **state)
{
    (void)state;
    struct grid g = random_grid(20, 14, 2);
    struct scene scene = scene_of(&g);
    for (int round = 0; round < 2; round++) {
        scene.round = round;
        struct bytes svg = draw(&scene, plain, CANVAS_SVG);
        struct drawn_box body = body_of(svg.at);
        for (int row = 1; row <= 14; row++) {
            assert_int_equal(has_row_number(svg.at, &body, 14, row, true, SMALL), round || row % 2 == 1);
            assert_int_equal(has_row_number(svg.at, &body, 14, row, false, SMALL), !round && row % 2 == 0);
        }
        free(svg.at);
    }
    drop(g);
}

static bool has_stitch_number(const char *svg, const struct drawn_box *body, int columns, int number, double size)
{
    char text[16];
    snprintf(text, sizeof text, "%d", number);
    return has_text(svg, body->x + body->width - (number - 0.5) * body->width / columns,
                    body->y + body->height + (0.5 + LETTERING_CAPITAL) * size, size, LETTERING_CENTRE, text);
}

static void stitches_are_counted_from_the_right(void **state)
{
    (void)state;
    struct grid g = random_grid(12, 3, 2);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    for (int i = 1; i <= 12; i++)
        assert_true(has_stitch_number(svg.at, &body, 12, i, SMALL));
    assert_false(has_stitch_number(svg.at, &body, 12, 13, SMALL));
    free(svg.at);
    drop(g);
}

/* 180 x 180, cells of 4 x 3.5 points: not every number has room. */
static void numbers_are_thinned_out(void **state)
{
    (void)state;
    struct grid g = random_grid(180, 180, 2);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    double size = body.width / 90;
    for (int i = 1; i <= 180; i++) {
        assert_int_equal(has_row_number(svg.at, &body, 180, i, true, size), i % 10 == 1);
        assert_int_equal(has_row_number(svg.at, &body, 180, i, false, size), i % 10 == 0);
        assert_int_equal(has_stitch_number(svg.at, &body, 180, i, size), i % 5 == 0 || i == 1);
    }
    free(svg.at);
    drop(g);
}

static bool has_title(struct scene *scene, const char *title)
{
    struct bytes svg = draw(scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    bool found = has_text(svg.at, body.x, body.y - (LETTERING_LINE - LETTERING_CAPITAL) * 1.5 * SMALL, 1.5 * SMALL,
                          LETTERING_LEFT, title);
    free(svg.at);
    return found;
}

static void title_is_the_motifs_or_the_files(void **state)
{
    (void)state;
    struct grid g = random_grid(12, 3, 2);
    struct scene scene = scene_of(&g);
    assert_true(has_title(&scene, "my chart"));
    scene.title = "rib_2x2";
    assert_true(has_title(&scene, "rib 2x2"));
    scene.title = NULL, scene.file = "-";
    assert_false(has_title(&scene, "-"));
    drop(g);
}

/* Line i of the key says so. */
static bool key_says(const struct scene *scene, int line, const char *text)
{
    struct bytes svg = draw(scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    double top = body.y + body.height + (3 + 2.4 * line) * SMALL, height = 1.8 * SMALL;
    bool found = has_text(svg.at, body.x + height * 17.5 / 15 + SMALL, top + height / 2 + LETTERING_CAPITAL / 2 * SMALL, SMALL,
                          LETTERING_LEFT, text);
    free(svg.at);
    return found;
}

static void key_says_what_is_worked(void **state)
{
    (void)state;
    const stitch_id own[] = {STITCH_P, 2, 3}, two[] = {STITCH_K, STITCH_P, STITCH_K, STITCH_P};
    struct scene scene = scene_of(&(struct grid){3, 1, own});
    assert_true(key_says(&scene, 0, "purl on RS, knit on WS"));
    assert_true(key_says(&scene, 1, "T on RS, S on WS"));
    assert_true(key_says(&scene, 2, "S on RS, T on WS"));
    const struct stitch alike[] = {stitches[0], stitches[1], {.name = "T", .symbol = "t", .ws = 2}};
    scene.stitch = alike;
    scene.nstitches = 3;
    scene.grid = &(struct grid){1, 1, own + 1};
    assert_true(key_says(&scene, 0, "T"));
    scene = scene_of(scene.grid);
    scene.grid = &(struct grid){4, 1, two};
    scene.round = true;
    assert_true(key_says(&scene, 0, "knit"));
    assert_true(key_says(&scene, 1, "purl"));
    assert_true(key_says(&scene, 2, "repeat: 2 sts × 1 round"));
    assert_false(key_says(&scene, 1, "knit"));
}

/* ---- the repeat ---- */

static int smallest_period(const struct grid *g, bool rows)
{
    int n = rows ? g->rows : g->columns;
    for (int p = 1; p <= n / 2; p++) {
        bool same = true;
        for (int y = 0; y + (rows ? p : 0) < g->rows && same; y++)
            for (int x = 0; x + (rows ? 0 : p) < g->columns && same; x++)
                same = grid_at(g, x, y) == grid_at(g, rows ? x : x + p, rows ? y + p : y);
        if (same)
            return p;
    }
    return n;
}

static void repeats_are_the_smallest(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++) {
        struct grid part = random_grid(1 + i % 7, 1 + i / 7 % 6, 2), g = tiled(&part, 1 + i % 17, 1 + i % 19);
        struct repeat found = repeat_of(&g);
        assert_int_equal(found.columns, smallest_period(&g, false));
        assert_int_equal(found.rows, smallest_period(&g, true));
        drop(part);
        drop(g);
    }
}

static void repeat_is_boxed_at_the_lower_right(void **state)
{
    (void)state;
    struct grid part = random_grid(5, 4, 2), g = tiled(&part, 17, 12);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at), box = box_of(svg.at, "stroke:rgb(80%,0%,0%)");
    assert_true(fabs(box.width - 5 * 17.5) < 0.01 && fabs(box.height - 4 * 15) < 0.01);
    assert_true(fabs(box.x + box.width - body.x - body.width) < 0.01);
    assert_true(fabs(box.y + box.height - body.y - body.height) < 0.01);
    const char *in_key = strstr(strstr(svg.at, "stroke:rgb(80%,0%,0%)") + 1, "stroke:rgb(80%,0%,0%)");
    assert_non_null(in_key);
    assert_true(box_of(in_key, "stroke:rgb(80%,0%,0%)").y > body.y + body.height);
    free(svg.at);
    svg = draw(&scene, (struct chart_look){.color = true}, CANVAS_SVG);
    assert_null(strstr(svg.at, "rgb(80%,0%,0%)"));
    free(svg.at);
    scene.grid = &part;
    svg = draw(&scene, plain, CANVAS_SVG);
    assert_null(strstr(svg.at, "rgb(80%,0%,0%)"));
    free(svg.at);
    drop(part);
    drop(g);
}

/* ---- the page ---- */

/* Heavy lines behind every tenth stitch from the right and every tenth row. */
static void every_tenth_line_is_heavy(void **state)
{
    (void)state;
    struct grid g = random_grid(23, 34, 2);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    struct drawn_box body = body_of(svg.at);
    const char *path = strstr(strstr(svg.at, "stroke:rgb(30%,30%,30%)"), " d=\"") + 4;
    double x[2], y[2], cell[2] = {body.width / 23, body.height / 34};
    int n = 0, used;
    for (; sscanf(path, " M %lf %lf L %lf %lf%n", x, y, x + 1, y + 1, &used) == 4; path += used, n++) {
        double column = (body.x + body.width - x[0]) / cell[0], row = (body.y + body.height - y[0]) / cell[1];
        assert_true(x[0] == x[1] ? fabs(column - 10 * (n + 1)) < 0.01 : fabs(row - 10 * (n - 1)) < 0.01);
    }
    assert_int_equal(n, 2 + 3);
    free(svg.at);
    drop(g);
}

/* Is all ink at least so many pixels away from the edges of the PNG? */
static void check_margin(const struct scene *scene, int margin)
{
    cairo_surface_t *image = image_of(scene, plain);
    int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            if ((x < margin || y < margin || x >= width - margin || y >= height - margin) &&
                pixel_at(image, x / 2.0, y / 2.0) != 0xffffff)
                fail_msg("ink at %d, %d of %d x %d", x, y, width, height);
    cairo_surface_destroy(image);
}

static void nothing_is_cut_off(void **state)
{
    (void)state;
    static const struct stitch named[] = {
        {.name = "K", .symbol = "k", .ws = STITCH_P}, {.name = "P", .symbol = "p", .ws = STITCH_K},
        {.name = "a_stitch_with_a_name_wider_than_its_chart", .symbol = "t", .ws = 2},
    };
    static const struct { int columns, rows; } sizes[] = {{1, 1}, {1, 2}, {3, 120}, {20, 14}, {300, 3}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct grid g = random_grid(sizes[i].columns, sizes[i].rows, 2);
        struct scene scene = scene_of(&g);
        for (int round = 0; round < 2; round++) {
            scene.round = round;
            check_margin(&scene, 12);
        }
        scene.title = "a_motif_whose_name_is_far_longer_than_the_chart_of_it_is_wide";
        check_margin(&scene, 12);
        scene.title = NULL;
        scene.file = "-";
        check_margin(&scene, 12);
        drop(g);
    }
    struct scene scene = scene_of(&(struct grid){1, 1, (const stitch_id[]){2}});
    scene.stitch = named;
    scene.nstitches = 3;
    check_margin(&scene, 12);
}

/* ---- files ---- */

static void pdf_has_the_size_of_the_svg(void **state)
{
    (void)state;
    struct grid g = random_grid(21, 30, 2);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG), pdf = draw(&scene, plain, CANVAS_PDF);
    double width, height, page[2];
    assert_memory_equal(pdf.at, "%PDF-1.", 7);
    assert_int_equal(sscanf(strstr(svg.at, "width="), "width=\"%lf", &width), 1);
    assert_int_equal(sscanf(strstr(svg.at, "height="), "height=\"%lf", &height), 1);
    assert_int_equal(sscanf(memmem(pdf.at, pdf.n, "/MediaBox", 9), "/MediaBox [ 0 0 %lf %lf ]", page, page + 1), 2);
    assert_true(width == page[0] && height == page[1]);
    free(svg.at);
    free(pdf.at);
    drop(g);
}

/* 20,000 rows: no PNG, a PDF of a size that readers open, every format small. */
static void sizes_have_limits(void **state)
{
    (void)state;
    struct grid g = random_grid(5, 20000, 2);
    struct scene scene = scene_of(&g);
    double width, height;
    assert_non_null(strstr(drawn_refusal(&scene, &plain, CANVAS_PNG), "30000 pixels"));
    struct bytes pdf = draw(&scene, plain, CANVAS_PDF), svg = draw(&scene, plain, CANVAS_SVG);
    assert_int_equal(sscanf(memmem(pdf.at, pdf.n, "/MediaBox", 9), "/MediaBox [ 0 0 %lf %lf ]", &width, &height), 2);
    assert_true(height <= 14400 && height > 14000);
    assert_true(pdf.n < 500000 && svg.n < 1000000);
    free(pdf.at);
    free(svg.at);
    drop(g);
}

static void a_million_stitches_are_a_small_file(void **state)
{
    (void)state;
    struct grid g = random_grid(1000, 1000, 2);
    struct scene scene = scene_of(&g);
    struct bytes svg = draw(&scene, plain, CANVAS_SVG);
    assert_true(svg.n < 1000000);
    free(svg.at);
    drop(g);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(purls_are_dots_at_their_stitches),
        cmocka_unit_test(or_dashes),
        cmocka_unit_test(own_stitches_are_their_symbols),
        cmocka_unit_test(a_symbol_without_letters_is_the_stitchs_name),
        cmocka_unit_test(pixels_show_the_grid),
        cmocka_unit_test(colors_are_the_palettes),
        cmocka_unit_test(row_numbers_stand_where_rows_begin),
        cmocka_unit_test(stitches_are_counted_from_the_right),
        cmocka_unit_test(numbers_are_thinned_out),
        cmocka_unit_test(title_is_the_motifs_or_the_files),
        cmocka_unit_test(key_says_what_is_worked),
        cmocka_unit_test(repeats_are_the_smallest),
        cmocka_unit_test(repeat_is_boxed_at_the_lower_right),
        cmocka_unit_test(every_tenth_line_is_heavy),
        cmocka_unit_test(nothing_is_cut_off),
        cmocka_unit_test(pdf_has_the_size_of_the_svg),
        cmocka_unit_test(sizes_have_limits),
        cmocka_unit_test(a_million_stitches_are_a_small_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
