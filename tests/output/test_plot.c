/* SPDX-License-Identifier: GPL-3.0-or-later
 * Plots of made-up numbers: ticks, where points and cells appear, in which
 * colours; the plot and the table of a fold's steps. */
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
#include "output/growth.h"
#include "output/plot.h"
#include "tests/output/sample.h"

enum { TEXTS = 5 };

/* ---- axes ---- */

static struct axis axis_of(double low, double high, struct axis_wish wish)
{
    struct axis_range range = AXIS_NOTHING;
    wish.texts = TEXTS;
    axis_see(&range, (double[]){low, high}, 2);
    return axis_make(&range, &wish);
}

/* The texts of an axis, with a blank behind each; small ticks are dots. */
static void check_ticks(const struct axis *axis, const char *wanted)
{
    char all[AXIS_TICKS * AXIS_TEXT] = "";
    for (int i = 0; i < axis->nticks; i++) {
        strcat(all, *axis->tick[i].text ? axis->tick[i].text : ".");
        strcat(all, " ");
    }
    assert_string_equal(all, wanted);
    assert_true(axis->low < axis->high);
}

static void check_axis(double low, double high, struct axis_wish wish, const char *wanted)
{
    struct axis axis = axis_of(low, high, wish);
    check_ticks(&axis, wanted);
}

static void ticks_are_round(void **state)
{
    (void)state;
    const struct axis_wish plain = {0}, zero = {.zero = true}, whole = {.whole = true}, log = {.scale = AXIS_LOG, .zero = true};
    check_axis(0.1, 1, plain, "0 0.2 0.4 0.6 0.8 1.0 ");
    check_axis(2.1, 9.9, plain, "2 4 6 8 10 ");
    check_axis(5.1, 5.9, zero, "0 2 4 6 ");
    check_axis(-5.9, -5.1, zero, "−6 −4 −2 0 ");
    check_axis(3, 5, whole, "3 4 5 ");
    check_axis(-0.03, 0.01, plain, "−0.03 −0.02 −0.01 0 0.01 ");
    check_axis(5.6149, 5.61494, plain, "5.61490 5.61491 5.61492 5.61493 5.61494 ");
    check_axis(0, 4e-7, plain, "0 10⁻⁷ 2×10⁻⁷ 3×10⁻⁷ 4×10⁻⁷ ");
    check_axis(1e12, 1.5e12, plain, "1.0×10¹² 1.1×10¹² 1.2×10¹² 1.3×10¹² 1.4×10¹² 1.5×10¹² ");
    check_axis(200000, 300000, plain, "200000 220000 240000 260000 280000 300000 ");
    check_axis(2e-5, 3e2, log, ". 10⁻⁴ . 10⁻² . 10⁰ . 10² . ");
    check_axis(3, 150, log, "2 . . 5 . . . . 10 20 . . 50 . . . . 100 200 ");
    check_axis(0.02, 30, log, "0.01 . . . . . . . . 0.1 . . . . . . . . 1 . . . . . . . . 10 . . . . . . . . 100 ");
    check_axis(1, 1e60, log, "10⁰ 10¹¹ 10²² 10³³ 10⁴⁴ 10⁵⁵ ");
}

/* Scales choose themselves; one number or none is a range, too. */
static void ranges_without_a_width(void **state)
{
    (void)state;
    const struct axis_wish plain = {0}, chosen = {.scale = AXIS_AUTO}, log = {.scale = AXIS_LOG};
    assert_true(axis_of(1, 1000, chosen).log);
    assert_false(axis_of(1, 999, chosen).log);
    assert_false(axis_of(0, 1000, chosen).log);
    assert_false(axis_of(-1, 1000, chosen).log);
    check_axis(NAN, INFINITY, plain, "0 0.2 0.4 0.6 0.8 1.0 ");
    check_axis(NAN, 1e300, chosen, "0 0.2 0.4 0.6 0.8 1.0 ");
    check_axis(0, -3, log, "1 2 . . 5 . . . . 10 ");
    check_axis(-7, -INFINITY, plain, "−8.0 −7.5 −7.0 −6.5 −6.0 ");
    check_axis(0, 0, plain, "−1.0 −0.5 0 0.5 1.0 ");
    check_axis(10, 10, log, "10 20 ");
    const double hard[] = {1e-300, 1e-289, -1e290, 1e290, 1e-5, 1 + 1e-15, 1, 123456789, 5e-324};
    const int n = sizeof hard / sizeof *hard;
    for (int i = 0; i < n * n * 3; i++) {
        struct axis axis = axis_of(hard[i % n], hard[i / n % n], (struct axis_wish){.scale = (enum axis_scale)(i / n / n)});
        assert_true(axis.nticks >= 2 && axis.low < axis.high && axis.nticks <= AXIS_TICKS);
    }
}

static void numbers_have_their_places(void **state)
{
    (void)state;
    struct axis linear = axis_of(2, 10, (struct axis_wish){0}), log = axis_of(0.01, 100, (struct axis_wish){.scale = AXIS_LOG});
    assert_true(fabs(axis_place(&linear, 4) - 0.25) < 1e-12);
    assert_true(fabs(axis_place(&log, 10) - 0.75) < 1e-12);
    assert_true(isnan(axis_place(&log, 0)) && isnan(axis_place(&log, -1)));
    assert_true(isnan(axis_place(&linear, NAN)) && isnan(axis_place(&linear, -INFINITY)));
    for (int i = 0; i < log.nticks; i++)
        assert_true(fabs(axis_place(&log, log.tick[i].value) * 4 - log10(log.tick[i].value) - 2) < 1e-12);
}

static void numbers_are_printed_short(void **state)
{
    (void)state;
    static const struct { double value; const char *text; } wanted[] = {
        {0.25, "0.25"}, {3, "3"}, {-1.5, "−1.5"}, {0, "0"}, {1e-5, "10⁻⁵"}, {2.5e-7, "2.5×10⁻⁷"}, {1e6, "10⁶"},
        {123456, "123456"}, {0.1 + 0.2, "0.3"}, {NAN, "–"}, {-2e100, "−2×10¹⁰⁰"}, {0.0001, "0.0001"}, {99.99999, "100"},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        char text[AXIS_TEXT];
        axis_print(text, wanted[i].value, 6);
        assert_string_equal(text, wanted[i].text);
    }
}

/* ---- files ---- */

static char *svg_of(struct place *p, const struct plot *plot)
{
    size_t size;
    assert_true(plot_lines(&p->log, sample_path(p, "x.svg"), plot));
    char *svg = sample_read(p->path, &size);
    assert_non_null(svg);
    return svg;
}

/* The coordinates of the n-th path of a width and a colour that is stroked without a
 * transform, a NAN where it is interrupted; how many numbers. */
static int read_path(const char *svg, struct rgb color, int nth, double *number, int room)
{
    char stroke[80];
    int n = 0;
    snprintf(stroke, sizeof stroke, "stroke:rgb(%.6g%%,", 100 * color.red);
    size_t until = strlen(stroke) - 2;
    for (const char *at = svg; (at = strstr(at, "<path style=\"fill:none;stroke-width:1.6;")); at++) {
        const char *colored = strstr(at, "stroke:rgb("), *d = strstr(at, " d=\"") + 4;
        if (strncmp(colored, stroke, until - 1) != 0 || nth-- > 0)
            continue;
        while (*d != '"' && n < room) {
            char *end;
            if (*d == 'M' && n > 0)
                number[n++] = NAN;
            double value = strtod(d, &end);
            if (end > d)
                number[n++] = value;
            d = end > d ? end : d + 1;
        }
        return n;
    }
    return 0;
}

/* The box of the first frame: x, y, width, height. */
static void read_frame(const char *svg, double box[4])
{
    double x1, y1;
    const char *at = svg;
    while ((at = strstr(at, "stroke:rgb(15%,15%,15%)"))) {
        at = strstr(at, " d=\"");
        if (sscanf(at, " d=\"M %lf %lf L %lf %*f L %*f %lf L %*f %*f Z", &box[0], &box[1], &x1, &y1) == 4)
            break;
    }
    assert_non_null(at);
    box[2] = x1 - box[0];
    box[3] = y1 - box[1];
}

static const struct rgb first = {0x1F / 255., 0, 0}, second = {0xC8 / 255., 0, 0};

static void near(double a, double b)
{
    if (!(fabs(a - b) < 0.02))
        fail_msg("%g is not near %g", a, b);
}

/* x: 0..1, y: 0..6 linear or 10^-1..10^3. */
static void points_are_where_the_axes_say(void **state)
{
    struct place *p = *state;
    const double x[] = {0.1, 0.5, 1}, y[] = {6, 1.5, 3}, z[] = {0.1, 1, 1000};
    const struct plot_line line[] = {{"a", 3, x, y}, {"b", 3, x, z}};
    double box[4], at[16];
    for (int log = 0; log < 2; log++) {
        const struct plot_panel panel = {.x = {"x", .zero = true}, .y = {"y", log ? AXIS_LOG : AXIS_LINEAR, .zero = true},
                                         .nlines = 1, .line = &line[log]};
        char *svg = svg_of(p, &(struct plot){.npanels = 1, .panel = &panel});
        read_frame(svg, box);
        assert_int_equal(read_path(svg, first, 0, at, 16), 6);
        for (int i = 0; i < 3; i++) {
            near(at[2 * i], box[0] + box[2] * x[i]);
            near(at[2 * i + 1], box[1] + box[3] * (1 - (log ? (log10(z[i]) + 1) / 4 : y[i] / 6)));
        }
        free(svg);
    }
}

/* A gap where a number is missing; the other line is whole; both have their line in the legend. */
static void what_is_not_finite_is_a_gap(void **state)
{
    struct place *p = *state;
    const double x[] = {0, 1, 2, 3, 4}, y[] = {1, 2, NAN, 4, 5}, z[] = {INFINITY, 1, 2, -3, 4};
    const struct plot_line line[] = {{"a", 5, x, y}, {"b", 5, x, z}};
    struct plot_panel panel = {.x = {.title = "x"}, .y = {.title = "y"}, .nlines = 2, .line = line};
    double at[32];
    char *svg = svg_of(p, &(struct plot){.npanels = 1, .panel = &panel});
    assert_int_equal(read_path(svg, first, 0, at, 32), 9);
    assert_true(isnan(at[4]));
    assert_int_equal(read_path(svg, second, 0, at, 32), 8);
    assert_int_equal(read_path(svg, first, 1, at, 32), 4);
    assert_int_equal(read_path(svg, second, 1, at, 32), 4);
    assert_null(strstr(svg, "nan"));
    assert_null(strstr(svg, "inf"));
    free(svg);
    panel.y.scale = AXIS_LOG;       /* and so is what a log axis cannot show */
    svg = svg_of(p, &(struct plot){.npanels = 1, .panel = &panel});
    assert_int_equal(read_path(svg, second, 0, at, 32), 7);
    free(svg);
}

/* Nothing, one point, no number at all: a whole file. */
static void there_may_be_little_to_show(void **state)
{
    struct place *p = *state;
    const double one[] = {3}, none[] = {NAN};
    const struct plot_line line[] = {{NULL, 0, NULL, NULL}, {NULL, 1, one, one}, {NULL, 1, one, none}};
    const char *const names[] = {"x.svg", "x.pdf", "x.png"};
    for (int i = 0; i < 36; i++) {
        struct plot_panel panel[2] = {{.x = {.title = "x", .scale = AXIS_AUTO}, .y = {.title = "y", .scale = (enum axis_scale)(i % 3)},
                                       .nlines = i / 9 < 3, .line = &line[i / 9 % 3]}};
        panel[1] = panel[0];
        assert_true(plot_lines(&p->log, sample_path(p, names[i / 3 % 3]), &(struct plot){.width = 100, .npanels = 2, .panel = panel}));
        const struct plot_map map = {.x_title = "x", .y_title = "y", .title = "t", .scale = (enum axis_scale)(i % 3), .nx = i < 18,
                                     .ny = 1, .x = one, .y = one, .value = i % 2 ? one : none};
        assert_true(plot_map(&p->log, p->path, &map));
    }
    char *svg = svg_of(p, &(struct plot){.npanels = 1, .panel = &(struct plot_panel){.x = {.title = "x"}, .y = {.title = "y"}, .nlines = 1, .line = &line[1]}});
    assert_non_null(strstr(svg, "fill:rgb(12.156863%,30.588235%,54.901961%)"));     /* a mark */
    free(svg);
    assert_false(plot_lines(&p->log, sample_path(p, "none/x.svg"), &(struct plot){0}));
    assert_non_null(p->log.error);
}

static void same_numbers_same_bytes(void **state)
{
    struct place *p = *state;
    const double x[] = {0, 1, 2, 3};
    const struct plot_line line[] = {{"a", 4, x, x}, {"b", 2, x, x + 2}};
    const struct plot_panel panel = {.x = {.title = "x"}, .y = {.title = "y"}, .legend = "c", .ordered = true, .nlines = 2, .line = line};
    const struct plot_map map = {.x_title = "x", .y_title = "y", .title = "t", .nx = 2, .ny = 2, .x = x, .y = x, .value = x};
    const char *const names[] = {"x.svg", "x.pdf", "x.png"};
    for (int i = 0; i < 6; i++) {
        char before[FILE_HASH] = "";
        for (int turn = 0; turn < 2; turn++) {
            const struct plot plot = {.title = "two", .npanels = 1, .panel = &panel};
            assert_true(i < 3 ? plot_lines(&p->log, sample_path(p, names[i % 3]), &plot) : plot_map(&p->log, sample_path(p, names[i % 3]), &map));
            if (turn)
                assert_string_equal(file_log_find(&p->log, p->path)->sha256, before);
            strcpy(before, file_log_find(&p->log, p->path)->sha256);
        }
    }
}

/* ---- maps ---- */

static uint32_t pixel_at(cairo_surface_t *image, int x, int y)
{
    const unsigned char *row = cairo_image_surface_get_data(image) + y * cairo_image_surface_get_stride(image);
    return ((const uint32_t *)(const void *)row)[x] & 0xffffff;
}

static uint32_t pixel_of(struct rgb c)
{
    return (uint32_t)lround(255 * c.red) << 16 | (uint32_t)lround(255 * c.green) << 8 | (uint32_t)lround(255 * c.blue);
}

static void check_color(uint32_t pixel, struct rgb wanted)
{
    uint32_t other = pixel_of(wanted);
    for (int shift = 0; shift < 24; shift += 8)
        if (abs((int)(pixel >> shift & 255) - (int)(other >> shift & 255)) > 1)
            fail_msg("%06x is not %06x", (unsigned)pixel, (unsigned)other);
}

/* Its box from the rectangles of its cells in SVG; a third from a cell's corner no line of a missing one runs. */
static void check_map(struct place *p, const struct plot_map *map, enum colours_scale scale, const double *wanted)
{
    size_t size;
    double box[4];
    assert_true(plot_map(&p->log, sample_path(p, "x.svg"), map));
    char *svg = sample_read(p->path, &size);
    read_frame(svg, box);
    free(svg);
    assert_true(plot_map(&p->log, sample_path(p, "x.png"), map));
    cairo_surface_t *image = cairo_image_surface_create_from_png(p->path);
    assert_int_equal(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
    for (int k = 0; k < map->nx * map->ny; k++) {
        int x = (int)(box[0] + box[2] * (k % map->nx + 0.3) / map->nx);
        int y = (int)(box[1] + box[3] * (map->ny - k / map->nx - 0.5) / map->ny);
        struct rgb grey = {0.88, 0.88, 0.88};
        check_color(pixel_at(image, x, y), isnan(wanted[k]) ? grey : colours_at(scale, wanted[k]));
    }
    cairo_surface_destroy(image);
}

static void cells_have_the_scales_colors(void **state)
{
    struct place *p = *state;
    const double at[] = {1, 2, 3};
    struct plot_map map = {.x_title = "x", .y_title = "y", .title = "t", .nx = 3, .ny = 2, .x = at, .y = at};
    map.value = (const double[]){0, 1, 2, 3, NAN, 4};
    check_map(p, &map, COLOURS_SEQUENTIAL, (const double[]){0, 0.25, 0.5, 0.75, NAN, 1});
    map.value = (const double[]){-1, 1, 2, 0, INFINITY, 4};
    check_map(p, &map, COLOURS_DIVERGING, (const double[]){0.375, 0.625, 0.75, 0.5, NAN, 1});
    map.value = (const double[]){1e-4, 1, 1e-2, 0, 1e-3, 0.1};
    map.scale = AXIS_LOG;
    check_map(p, &map, COLOURS_SEQUENTIAL, (const double[]){0, 1, 0.5, NAN, 0.25, 0.75});
}

/* ---- growth ---- */

static struct fold_step steps[] = {
    {.growth = 0.1 + 0.2, .energy = {1. / 3, 1e-300, 5e300, 0}, .iterations = 7, .gradient_max = 1e-4},
    {.growth = 1, .energy = {2. / 3, 0.1, NAN, 0}, .iterations = 2147483647, .gradient_max = 2e-9 / 3},
};

static void table_reads_back_exactly(void **state)
{
    struct place *p = *state;
    size_t size;
    const struct fold_record record = {.nsteps = 2, .step = steps};
    assert_true(growth_table(&p->log, sample_path(p, "x.csv"), &record));
    char *text = sample_read(p->path, &size), *rest = text;
    assert_string_equal(strsep(&rest, "\n"), "growth,energy,stretching,bending,springs,iterations,gradient_max");
    for (int i = 0; i < 2; i++) {
        const struct fold_step *s = &steps[i];
        const double wanted[] = {s->growth, s->energy.total, s->energy.stretching, s->energy.bending, s->energy.springs,
                                 s->iterations, s->gradient_max};
        char *line = strsep(&rest, "\n");
        for (int c = 0; c < 7; c++) {
            const char *cell = strsep(&line, ",");
            assert_non_null(cell);
            assert_true(isnan(wanted[c]) ? !*cell : strtod(cell, NULL) == wanted[c]);
        }
        assert_null(line);
    }
    assert_string_equal(rest, "");
    free(text);
    assert_true(growth_table(&p->log, sample_path(p, "x.csv"), &(struct fold_record){0}));
    text = sample_read(p->path, &size);
    assert_string_equal(text, "growth,energy,stretching,bending,springs,iterations,gradient_max\n");
    free(text);
}

/* How many lines of data and of the legend a plot of these steps has. */
static int count_lines(struct place *p, const struct output *output, const struct fold_record *record)
{
    size_t size;
    int n = 0;
    assert_true(growth_plot(&p->log, output, record));
    char *svg = sample_read(output->path, &size);
    for (const char *at = svg; (at = strstr(at, "<path style=\"fill:none;stroke-width:1.6;")); at++)
        n++;
    free(svg);
    return n;
}

static void growth_is_plotted(void **state)
{
    struct place *p = *state;
    struct fold_step made[3];
    for (int i = 0; i < 3; i++)
        made[i] = (struct fold_step){.growth = (i + 1) / 3., .energy = {i + 2, i, 2, 0}, .iterations = i, .gradient_max = pow(10, -i)};
    const struct fold_record record = {.nsteps = 3, .step = made};
    struct output output = {.kind = OUTPUT_PLOT, .path = sample_path(p, "x.svg"), .graph = {.width = 640}};
    assert_int_equal(count_lines(p, &output, &record), 6);
    made[1].energy.springs = 1e-3;
    assert_int_equal(count_lines(p, &output, &record), 8);
    output.graph.show = GRAPH_CONVERGENCE;
    assert_int_equal(count_lines(p, &output, &record), 2);
    output.graph.scale = GRAPH_LINEAR;
    assert_int_equal(count_lines(p, &output, &record), 2);
    assert_int_equal(count_lines(p, &output, &(struct fold_record){0}), 0);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, sample_begin, sample_end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ticks_are_round),
        cmocka_unit_test(ranges_without_a_width),
        cmocka_unit_test(numbers_have_their_places),
        cmocka_unit_test(numbers_are_printed_short),
        TEST(points_are_where_the_axes_say),
        TEST(what_is_not_finite_is_a_gap),
        TEST(there_may_be_little_to_show),
        TEST(same_numbers_same_bytes),
        TEST(cells_have_the_scales_colors),
        TEST(table_reads_back_exactly),
        TEST(growth_is_plotted),
    };
    return cmocka_run_group_tests_name("plot", tests, NULL, NULL);
}
