/* SPDX-License-Identifier: GPL-3.0-or-later
 * Pictures: where things appear, what hides what, which colours they have. */
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

#include "drawing/colours.h"
#include "output/field.h"
#include "output/portrait.h"
#include "output/render.h"
#include "tests/output/sample.h"

static const double top[2] = {0, 90}, below[2] = {0, -90}, front[2] = {0, 0}, side[2] = {90, 0}, head_on[2] = {0, 0};

/* ---- views ---- */

static void check_seen(const double angles[2], double x, double y, double depth)
{
    const double point[3] = {1, 2, 3}, wanted[3] = {x, y, depth};
    struct view view = view_make(angles);
    double seen[3];
    view_project(&view, point, seen);
    for (int c = 0; c < 3; c++)
        assert_true(fabs(seen[c] - wanted[c]) < 1e-12);
}

/* (1, 2, 3): x to the right edge, y up the rows, z to the right side's viewer. */
static void views_have_their_axes(void **state)
{
    (void)state;
    check_seen(top, 1, 2, 3);
    check_seen(below, 1, -2, -3);
    check_seen(front, 1, 3, -2);
    check_seen(side, 2, 3, 1);
    check_seen((double[]){-90, 0}, -2, 3, -1);
}

static void light_goes_with_the_eye(void **state)
{
    (void)state;
    struct view view = view_make((double[]){30, 40});
    double light[3], seen[3];
    view_direction(&view, (double[]){-40, 30}, light);
    view_project(&view, light, seen);
    assert_true(seen[0] < 0 && fabs(seen[1] - 0.5) < 1e-12 && seen[2] > 0);
}

/* ---- the renderer ---- */

enum { WIDTH = 120, HEIGHT = 100 };
static uint32_t pixels[WIDTH * HEIGHT];

static void shoot(const struct surface *s, const struct rgb *right, const struct rgb *wrong, const double angles[2], double scale, bool edges)
{
    struct render render = {.surface = s, .color = {right, wrong}, .view = view_make(angles), .shade = 0.5, .edges = edges, .samples = 4,
                            .width = WIDTH, .height = HEIGHT, .scale = scale};
    view_direction(&render.view, head_on, render.light);
    assert_true(render_pixels(&render, pixels));
}

static uint32_t pixel_at(int x, int y)
{
    return pixels[y * WIDTH + x];
}

/* A dome, turned: the pixels that are not empty reach as far as its points do. */
static void silhouette_is_the_projected_extent(void **state)
{
    (void)state;
    enum { N = 24 };
    static struct rgb color[N * N];
    const double angles[2] = {25, 35}, scale = 40;
    struct surface s = surface_make(N, N, 1);
    struct view view = view_make(angles);
    double low[2] = {9, 9}, high[2] = {-9, -9};
    for (int i = 0; i < (N + 1) * (N + 1); i++) {
        double x = 1.4 * (i % (N + 1)) / N - 0.9, y = 1.4 * (i / (N + 1)) / N - 0.6, z = sqrt(2 - x * x - y * y), seen[3];
        memcpy(s.position + 3 * i, (double[]){x, y, z - 1}, 3 * sizeof x);
        memcpy(s.normal + 3 * i, (double[]){x / sqrt(2), y / sqrt(2), z / sqrt(2)}, 3 * sizeof x);
        view_project(&view, s.position + 3 * i, seen);
        for (int c = 0; c < 2; c++)
            low[c] = fmin(low[c], seen[c]), high[c] = fmax(high[c], seen[c]);
    }
    shoot(&s, color, color, angles, scale, false);
    int left = WIDTH, right = -1, up = HEIGHT, down = -1;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        if (!pixels[i])
            continue;
        left = i % WIDTH < left ? i % WIDTH : left, right = i % WIDTH > right ? i % WIDTH : right;
        up = i / WIDTH < up ? i / WIDTH : up, down = i / WIDTH > down ? i / WIDTH : down;
    }
    assert_true(fabs(left - (WIDTH / 2. + scale * low[0])) <= 1);
    assert_true(fabs(right + 1 - (WIDTH / 2. + scale * high[0])) <= 1);
    assert_true(fabs(up - (HEIGHT / 2. - scale * high[1])) <= 1);
    assert_true(fabs(down + 1 - (HEIGHT / 2. - scale * low[1])) <= 1);
    surface_free(&s);
}

/* Three cells in a row, profile z(x): a red one up, a green one back on top, a blue
 * one down through the red one. */
static void sheets_that_cross_hide_each_other(void **state)
{
    (void)state;
    static const double x[4] = {-1, 1, -1, 1}, z[4] = {-1, 1, 1, -1};
    static const struct rgb color[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct surface s = surface_make(3, 1, 1);
    for (int i = 0; i < 8; i++) {
        memcpy(s.position + 3 * i, (double[]){x[i % 4], i < 4 ? -1 : 1, z[i % 4]}, 3 * sizeof *x);
        s.normal[3 * i + 2] = 1;
    }
    shoot(&s, color, color, below, 40, false);
    assert_int_equal(pixel_at(WIDTH / 2 - 20, HEIGHT / 2) & 0x00ffff, 0);
    assert_true((pixel_at(WIDTH / 2 - 20, HEIGHT / 2) >> 16 & 255) > 50);
    assert_int_equal(pixel_at(WIDTH / 2 + 20, HEIGHT / 2) & 0xffff00, 0);
    assert_true((pixel_at(WIDTH / 2 + 20, HEIGHT / 2) & 255) > 50);
    assert_int_equal(pixel_at(WIDTH / 2 - 45, HEIGHT / 2), 0);
    shoot(&s, color, color, top, 40, false);
    for (int at = -30; at <= 30; at += 15)
        assert_true((pixel_at(WIDTH / 2 + at, HEIGHT / 2) & 0x00ff00) && !(pixel_at(WIDTH / 2 + at, HEIGHT / 2) & 0xff00ff));
    surface_free(&s);
}

/* Flat, 2 x 1 stitches of 1 x 1 around the middle. */
static struct surface flat_pair(void)
{
    struct surface s = surface_make(2, 1, 2);
    for (int i = 0; i < 15; i++) {
        memcpy(s.position + 3 * i, (double[]){i % 5 / 2. - 1, i / 5 / 2. - 0.5, 0}, 3 * sizeof(double));
        s.normal[3 * i + 2] = 1;
    }
    return s;
}

static const struct rgb white[8] = {[0 ... 7] = {1, 1, 1}}, mint[8] = {[0 ... 7] = {0.5, 1, 0.5}};

static void wrong_side_is_its_own_and_darker(void **state)
{
    (void)state;
    struct surface s = flat_pair();
    shoot(&s, white, mint, top, 40, false);
    assert_int_equal(pixel_at(40, 50), 0xffffffff);
    shoot(&s, white, mint, below, 40, false);
    assert_int_equal(pixel_at(40, 50), 0xff66cc66);     /* 0.8 of the other side's colour */
    surface_free(&s);
}

static void lines_stand_between_stitches_only(void **state)
{
    (void)state;
    struct surface s = flat_pair();
    shoot(&s, white, mint, top, 40, true);
    assert_int_equal(pixel_at(WIDTH / 2 - 20, HEIGHT / 2 + 10), 0xffffffff);    /* between cells of one stitch */
    assert_true((pixel_at(WIDTH / 2, HEIGHT / 2 + 10) & 255) < 220);
    assert_true((pixel_at(WIDTH / 2 - 1, HEIGHT / 2 + 10) & 255) < 220);
    surface_free(&s);
}

/* ---- fields ---- */

static void scales_leave_out_two_percent(void **state)
{
    (void)state;
    struct surface s = surface_make(50, 20, 1);
    for (int i = 0; i < 1000; i++) {
        s.bending[i] = (i * 7) % 1000;      /* all of 0 .. 999, not in order */
        s.mean[i] = s.bending[i] - 300;
        s.stretching[i] = 5;
    }
    for (int i = 0; i < 51 * 21; i++)
        s.position[3 * i + 2] = i / 51;
    struct field f = field_of(&s, COLOR_BENDING);
    assert_true(f.low == 20 && f.high == 979 && !f.diverging);
    field_free(&f);
    f = field_of(&s, COLOR_MEAN);
    assert_true(f.low == -679 && f.high == 679 && f.diverging);
    field_free(&f);
    f = field_of(&s, COLOR_STRETCHING);
    assert_true(f.low < 5 && f.high > 5);
    field_free(&f);
    f = field_of(&s, COLOR_HEIGHT);         /* rows of cells at 0.5 .. 19.5, the mean taken off */
    assert_true(fabs(f.low + 9.5) < 1e-9 && fabs(f.high - 9.5) < 1e-9 && f.value[0] == f.low);
    field_free(&f);
    surface_free(&s);
}

/* ---- files ---- */

/* The flat sheet of the sample scene. */
static struct surface flat_sample(int per_stitch)
{
    struct surface s = sample_surface(per_stitch);
    for (int i = 0; i < (s.nx + 1) * (s.ny + 1); i++) {
        memcpy(s.position + 3 * i, (double[]){1.4 * (i % (s.nx + 1)) / per_stitch, 1.2 * (i / (s.nx + 1)) / per_stitch, 0},
               3 * sizeof(double));
        memcpy(s.normal + 3 * i, (double[]){0, 0, 1}, 3 * sizeof(double));
    }
    return s;
}

static char *write_it(const char *name, struct picture picture, size_t *size)
{
    char path[2 * PATH_MAX];
    struct file_log log = {0};
    struct surface s = flat_sample(2);
    snprintf(path, sizeof path, "%s/%s", sample_shared, name);
    assert_true(portrait_write(&log, &(struct output){.kind = OUTPUT_PICTURE, .path = path, .picture = picture},
                              &sample_scene, &s));
    assert_null(log.error);
    file_log_free(&log);
    surface_free(&s);
    return sample_read(path, size);
}

static const struct picture plain = {.view = {0, 90}, .light = {0, 0}, .width = 400};

static cairo_surface_t *read_png(struct picture picture)
{
    char path[2 * PATH_MAX];
    size_t size;
    free(write_it("x.png", picture, &size));
    snprintf(path, sizeof path, "%s/x.png", sample_shared);
    cairo_surface_t *image = cairo_image_surface_create_from_png(path);
    assert_int_equal(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
    return image;
}

static uint32_t image_at(cairo_surface_t *image, double x, double y)
{
    const unsigned char *row = cairo_image_surface_get_data(image) + (int)y * cairo_image_surface_get_stride(image);
    return ((const uint32_t *)(const void *)row)[(int)x];
}

static uint32_t bytes_of(struct rgb c)
{
    unsigned char byte[3];
    colours_bytes(c, byte);
    return (uint32_t)byte[0] << 16 | (uint32_t)byte[1] << 8 | byte[2];
}

/* Cell by cell in a box of the picture: row 1 at the bottom, column 1 left. */
static void check_cells(cairo_surface_t *image, const struct palette *palette, double left, double width)
{
    double height = cairo_image_surface_get_height(image), tall = width * 2.4 / 4.2;
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 3; column++)
            assert_int_equal(image_at(image, left + width * (column + 0.5) / 3, height / 2 + tall * (0.5 - row) / 2) & 0xffffff,
                             bytes_of(colours_stitch(palette, grid_at(sample_scene.grid, column, row))));
}

static void flat_from_above_is_the_chart(void **state)
{
    (void)state;
    struct picture picture = plain;
    cairo_surface_t *image = read_png(picture);
    check_cells(image, colours_palette("paper"), 8, 384);
    cairo_surface_destroy(image);
    picture.palette = DYES_SAFE;
    picture.chart = true;
    image = read_png(picture);
    check_cells(image, colours_palette("safe"), 8, 184);        /* chart and fold have one size, */
    check_cells(image, colours_palette("safe"), 208, 184);      /* and stand side by side */
    cairo_surface_destroy(image);
}

/* From below the rows run downward, and a knit stitch is a purl: in purl's colour, darker. */
static void from_behind_knit_is_purl(void **state)
{
    (void)state;
    struct picture picture = plain;
    picture.view[1] = -90;
    cairo_surface_t *image = read_png(picture);
    double height = cairo_image_surface_get_height(image), tall = 384 * 2.4 / 4.2;
    for (int row = 0; row < 2; row++) {
        for (int column = 0; column < 3; column++) {
            int shown = sample_scene.stitch[grid_at(sample_scene.grid, column, row)].ws;
            struct rgb c = colours_stitch(colours_palette("paper"), shown);
            assert_int_equal(image_at(image, 8 + 384 * (column + 0.5) / 3, height / 2 + tall * (row - 0.5) / 2) & 0xffffff,
                             bytes_of((struct rgb){0.8 * c.red, 0.8 * c.green, 0.8 * c.blue}));
        }
    }
    cairo_surface_destroy(image);
}

static void background_is_as_asked_for(void **state)
{
    (void)state;
    struct picture picture = plain;
    cairo_surface_t *image = read_png(picture);
    assert_int_equal(image_at(image, 2, 2) & 0xffffff, 0xffffff);
    cairo_surface_destroy(image);
    picture.transparent = true;
    image = read_png(picture);
    assert_int_equal(cairo_image_surface_get_format(image), CAIRO_FORMAT_ARGB32);
    assert_int_equal(image_at(image, 2, 2), 0);
    assert_int_equal(image_at(image, 200, cairo_image_surface_get_height(image) / 2) >> 24, 255);
    cairo_surface_destroy(image);
}

static bool row_has(cairo_surface_t *image, int y, uint32_t wanted)
{
    for (int x = 250; x < 400; x++) {
        uint32_t pixel = image_at(image, x, y);
        int off = 0;
        for (int c = 0; c < 24; c += 8)
            off += abs((int)(pixel >> c & 255) - (int)(wanted >> c & 255));
        if (off < 12)
            return true;
    }
    return false;
}

static void scale_runs_from_low_to_high(void **state)
{
    (void)state;
    struct picture picture = plain;
    picture.color = COLOR_MEAN;
    cairo_surface_t *image = read_png(picture);
    int height = cairo_image_surface_get_height(image);
    assert_true(row_has(image, 9, bytes_of(colours_at(COLOURS_DIVERGING, 1))));
    assert_true(row_has(image, height - 10, bytes_of(colours_at(COLOURS_DIVERGING, 0))));
    assert_false(row_has(image, 9, bytes_of(colours_at(COLOURS_DIVERGING, 0))));
    cairo_surface_destroy(image);
}

static void all_formats_are_complete_and_repeat(void **state)
{
    (void)state;
    static const struct { const char *name, *begin, *end; } kinds[] = {
        {"a.png", "\x89PNG", "IEND\xAE\x42\x60\x82"}, {"a.svg", "<?xml", "</svg>\n"}, {"a.pdf", "%PDF-", "%%EOF\n"},
    };
    struct picture picture = {.view = {30, 40}, .light = {-40, 40}, .width = 200, .color = COLOR_GAUSS, .edges = true, .chart = true};
    for (int i = 0; i < 3; i++) {
        size_t size, again;
        char *one = write_it(kinds[i].name, picture, &size), *two = write_it(kinds[i].name, picture, &again);
        size_t tail = strlen(kinds[i].end);
        assert_memory_equal(one, kinds[i].begin, strlen(kinds[i].begin));
        assert_memory_equal(one + size - tail, kinds[i].end, tail);
        assert_int_equal(size, again);
        assert_memory_equal(one, two, size);
        free(one);
        free(two);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_have_their_axes),
        cmocka_unit_test(light_goes_with_the_eye),
        cmocka_unit_test(silhouette_is_the_projected_extent),
        cmocka_unit_test(sheets_that_cross_hide_each_other),
        cmocka_unit_test(wrong_side_is_its_own_and_darker),
        cmocka_unit_test(lines_stand_between_stitches_only),
        cmocka_unit_test(scales_leave_out_two_percent),
        cmocka_unit_test(flat_from_above_is_the_chart),
        cmocka_unit_test(from_behind_knit_is_purl),
        cmocka_unit_test(background_is_as_asked_for),
        cmocka_unit_test(scale_runs_from_low_to_high),
        cmocka_unit_test(all_formats_are_complete_and_repeat),
    };
    return cmocka_run_group_tests(tests, sample_shared_begin, sample_shared_end);
}
