/* SPDX-License-Identifier: GPL-3.0-or-later
 * Paper and pen: files that repeat, letters that have a shape and keep to their
 * place, colours, limits. */
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

#include "drawing/canvas.h"
#include "drawing/colours.h"
#include "drawing/lettering.h"
#include "drawing/packed.h"

/* ---- files ---- */

struct bytes { char *at; size_t n; };

static void take(void *self, const void *bytes, size_t n)
{
    struct bytes *all = self;
    all->at = realloc(all->at, all->n + n + 1);
    assert_non_null(all->at);
    memcpy(all->at + all->n, bytes, n);
    all->at[all->n += n] = 0;
}

/* Lines, letters and two images: all that gets names in an SVG. */
static struct bytes draw(enum canvas_format format, bool clear)
{
    struct bytes bytes = {0};
    struct canvas *canvas = (clear ? canvas_begin_clear : canvas_begin)(format, (struct canvas_size){60, 40, 2}, take, &bytes);
    for (int i = 0; i < 2; i++) {
        cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 4, 4);
        cairo_set_source_surface(canvas->cairo, image, 5 + 10 * i, 20);
        cairo_paint(canvas->cairo);
        cairo_surface_destroy(image);
    }
    cairo_set_source_rgb(canvas->cairo, 1, 0, 0);
    cairo_rectangle(canvas->cairo, 40, 0, 20, 20);
    cairo_fill(canvas->cairo);
    lettering_draw(canvas->cairo, 2, 12, 8, LETTERING_LEFT, "weft");
    assert_null(canvas_end(canvas));
    return bytes;
}

static void bytes_do_not_depend_on_what_was_drawn_before(void **state)
{
    (void)state;
    for (enum canvas_format format = CANVAS_SVG; format <= CANVAS_PNG; format++) {
        struct bytes one = draw(format, false);
        for (enum canvas_format other = CANVAS_SVG; other <= CANVAS_PNG; other++)
            free(draw(other, other % 2).at);
        struct bytes two = draw(format, false);
        assert_int_equal(one.n, two.n);
        assert_memory_equal(one.at, two.at, one.n);
        free(one.at);
        free(two.at);
    }
}

static const char *head_of(enum canvas_format format)
{
    static const char *const heads[] = {[CANVAS_SVG] = "<?xml", [CANVAS_PDF] = "%PDF-", [CANVAS_PNG] = "\x89PNG\r\n"};
    return heads[format];
}

static void formats_are_those_of_the_extension(void **state)
{
    (void)state;
    static const char *const paths[] = {[CANVAS_SVG] = "a/b.svg", [CANVAS_PDF] = "x.y.PDF", [CANVAS_PNG] = "x.Png"};
    for (int i = 0; i < 3; i++) {
        enum canvas_format format;
        assert_true(canvas_format_of(paths[i], &format));
        assert_int_equal(format, i);
        struct bytes bytes = draw(format, false);
        assert_memory_equal(bytes.at, head_of(format), strlen(head_of(format)));
        free(bytes.at);
    }
    static const char *const none[] = {"svg", ".svg", "x.svgz", "x.txt", "", "png.x"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_false(canvas_format_of(none[i], &(enum canvas_format){0}));
}

static void pdf_has_the_date_it_is_given_or_none(void **state)
{
    (void)state;
    setenv("SOURCE_DATE_EPOCH", "86400", 1);
    struct bytes bytes = draw(CANVAS_PDF, false);
    unsetenv("SOURCE_DATE_EPOCH");
    assert_non_null(strstr(memmem(bytes.at, bytes.n, "/CreationDate", 13), "(19700102000000"));
    free(bytes.at);
    bytes = draw(CANVAS_PDF, false);
    assert_null(memmem(bytes.at, bytes.n, "(19700102", 9));
    assert_null(memmem(bytes.at, bytes.n, "(20", 3));
    free(bytes.at);
}

static void png_has_its_pixels(void **state)
{
    (void)state;
    struct bytes bytes = draw(CANVAS_PNG, false);
    const unsigned char *size = (const unsigned char *)bytes.at + 16;
    assert_int_equal(size[2] << 8 | size[3], 120);
    assert_int_equal(size[6] << 8 | size[7], 80);
    free(bytes.at);
}

static bool refused(enum canvas_format format, double width, double height, double scale)
{
    return canvas_refusal(format, (struct canvas_size){width, height, scale}) != NULL;
}

static void png_has_limits(void **state)
{
    (void)state;
    assert_false(refused(CANVAS_PNG, CANVAS_SIDE_MAX, 1, 1));
    assert_true(refused(CANVAS_PNG, CANVAS_SIDE_MAX + 0.1, 1, 1));
    assert_true(refused(CANVAS_PNG, 1, CANVAS_SIDE_MAX + 1, 1));
    assert_true(refused(CANVAS_PNG, 1, CANVAS_SIDE_MAX / 2 + 1, 2));
    assert_false(refused(CANVAS_PNG, 10000, 10000, 1));
    assert_true(refused(CANVAS_PNG, 10001, 10000, 1));
    assert_false(refused(CANVAS_SVG, 1e6, 1e6, 1));
    assert_false(refused(CANVAS_PDF, 1e6, 1e6, 1));
}

/* ---- packed images ---- */

enum { EDGE = 37 };

/* Every alpha and colours of all kinds, as cairo has them: none above its alpha. */
static cairo_surface_t *paint_image(cairo_format_t format)
{
    cairo_surface_t *image = cairo_image_surface_create(format, EDGE, EDGE);
    uint32_t *pixel = (uint32_t *)(void *)cairo_image_surface_get_data(image);
    for (uint32_t i = 0; i < EDGE * EDGE; i++) {
        uint32_t alpha = format == CAIRO_FORMAT_RGB24 ? 255 : i % 256;
        pixel[i] = alpha << 24 | alpha * (i % 7) / 6 << 16 | alpha * (i % 11) / 10 << 8 | alpha * (i % 3) / 2;
    }
    cairo_surface_mark_dirty(image);
    return image;
}

static cairo_status_t give(void *self, unsigned char *bytes, unsigned n)
{
    struct bytes *rest = self;
    if (n > rest->n)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(bytes, rest->at, n);
    rest->at += n;
    rest->n -= n;
    return CAIRO_STATUS_SUCCESS;
}

/* cairo's own reader finds the pixels that were packed. */
static void check_packed(cairo_format_t format, enum packed_as as)
{
    cairo_surface_t *image = paint_image(format);
    size_t size;
    unsigned char *png = packed_png(image, as, &size);
    assert_non_null(png);
    struct bytes rest = {(char *)png, size};
    cairo_surface_t *back = cairo_image_surface_create_from_png_stream(give, &rest);
    assert_int_equal(cairo_surface_status(back), CAIRO_STATUS_SUCCESS);
    assert_int_equal(cairo_image_surface_get_format(back), format);
    assert_int_equal(cairo_image_surface_get_width(back), EDGE);
    assert_int_equal(cairo_image_surface_get_height(back), EDGE);
    assert_memory_equal(cairo_image_surface_get_data(back), cairo_image_surface_get_data(image), 4 * EDGE * EDGE);
    cairo_surface_destroy(back);
    cairo_surface_destroy(image);
    free(png);
}

static void packed_images_come_back(void **state)
{
    (void)state;
    for (enum packed_as as = PACKED_FLAT; as <= PACKED_GRADUAL; as++) {
        check_packed(CAIRO_FORMAT_ARGB32, as);
        check_packed(CAIRO_FORMAT_RGB24, as);
    }
}

/* An image that was packed and one that was not are two texts in an SVG. */
static struct bytes paint_svg(bool packed)
{
    struct bytes bytes = {0};
    struct canvas *canvas = canvas_begin(CANVAS_SVG, (struct canvas_size){60, 40, 1}, take, &bytes);
    cairo_surface_t *image = paint_image(CAIRO_FORMAT_ARGB32);
    assert_true(!packed || packed_attach(image, PACKED_FLAT));
    cairo_set_source_surface(canvas->cairo, image, 0, 0);
    cairo_paint(canvas->cairo);
    cairo_surface_destroy(image);
    assert_null(canvas_end(canvas));
    return bytes;
}

static void svg_holds_an_image_as_it_was_packed(void **state)
{
    (void)state;
    struct bytes packed = paint_svg(true), plain = paint_svg(false);
    assert_non_null(strstr(packed.at, "data:image/png;base64,"));
    assert_string_not_equal(packed.at, plain.at);
    free(packed.at);
    free(plain.at);
}

/* ---- letters ---- */

/* The ink of a text at (x, 0): left, top, width and height, in units of its size. */
static void ink_at(const char *text, double x, enum lettering_align align, double box[4])
{
    cairo_surface_t *record = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(record);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    lettering_draw(cairo, 100 * x, 0, 100, align, text);
    cairo_destroy(cairo);
    cairo_recording_surface_ink_extents(record, &box[0], &box[1], &box[2], &box[3]);
    cairo_surface_destroy(record);
    for (int i = 0; i < 4; i++)
        box[i] /= 100;
}

/* Within its width and between descenders and brackets, but for half the pen, a dot and ink rounded to hundredths. */
static void every_ascii_glyph_keeps_to_its_place(void **state)
{
    (void)state;
    for (char letter = '!'; letter <= '~'; letter++) {
        const char text[] = {letter, 0};
        double ink[4], pen = 0.075, right = lettering_width(text, 1);
        ink_at(text, 0, LETTERING_LEFT, ink);
        if (ink[2] <= 0 || ink[3] <= 0)
            fail_msg("'%c' has no shape", letter);
        if (ink[0] < -pen || ink[0] + ink[2] > right + pen || ink[1] < -LETTERING_CAPITAL - 0.15 - pen ||
            ink[1] + ink[3] > LETTERING_DEPTH + pen)
            fail_msg("'%c' is at %g %g, %g x %g, and %g wide", letter, ink[0], ink[1], ink[2], ink[3], right);
    }
}

static void letters_and_digits_stand_on_the_line(void **state)
{
    (void)state;
    for (const char *at = "ABCDEFGHIKLMNOPRSTUVWXYZ0123456789"; *at; at++) {
        double ink[4];
        ink_at((const char[]){*at, 0}, 0, LETTERING_LEFT, ink);
        assert_true(fabs(ink[1] + LETTERING_CAPITAL) < 0.07 && fabs(ink[1] + ink[3]) < 0.07);
    }
}

/* The pixels of one letter. */
enum { SIDE = 40 };
static void paint(const char *text, unsigned char pixels[SIDE * SIDE])
{
    cairo_surface_t *image = cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_A8, SIDE, SIDE, SIDE);
    memset(pixels, 0, SIDE * SIDE);
    cairo_t *cairo = cairo_create(image);
    lettering_draw(cairo, 4, 28, 30, LETTERING_LEFT, text);
    cairo_destroy(cairo);
    cairo_surface_flush(image);
    cairo_surface_destroy(image);
}

static void every_ascii_glyph_is_another(void **state)
{
    (void)state;
    static unsigned char pixels[128][SIDE * SIDE], unknown[SIDE * SIDE];
    paint("\xE2\x82\xAC", unknown);
    for (int a = '!'; a <= '~'; a++) {
        paint((const char[]){(char)a, 0}, pixels[a]);
        assert_memory_not_equal(pixels[a], unknown, SIDE * SIDE);
        for (int b = '!'; b < a; b++)
            if (memcmp(pixels[a], pixels[b], SIDE * SIDE) == 0)
                fail_msg("'%c' looks like '%c'", a, b);
    }
}

static void letters_with_accents_are_others(void **state)
{
    (void)state;
    static const char *const letters[] = {"a", "á", "à", "â", "ä", "ã", "å", "A", "Á", "Ä", "Å", "i", "í", "ï", "c", "ç", "č", "š", "s", "C", "Ç", "ß", "ø", "o", "ö", "Ø", "æ", "ñ", "…", "—"};
    enum { N = sizeof letters / sizeof *letters };
    static unsigned char pixels[N][SIDE * SIDE], unknown[SIDE * SIDE];
    paint("\xE2\x82\xAC", unknown);
    for (int a = 0; a < N; a++) {
        assert_true(lettering_knows(letters[a]));
        paint(letters[a], pixels[a]);
        assert_memory_not_equal(pixels[a], unknown, SIDE * SIDE);
        for (int b = 0; b < a; b++)
            if (memcmp(pixels[a], pixels[b], SIDE * SIDE) == 0)
                fail_msg("'%s' looks like '%s'", letters[a], letters[b]);
    }
    assert_true(lettering_width("ä", 1) == lettering_width("a", 1));
    assert_false(lettering_knows("\xE2\x82\xAC"));
}

static void text_is_aligned(void **state)
{
    (void)state;
    double width = lettering_width("10", 20);
    assert_true(fabs(lettering_width("1010", 20) - 2 * width - 20 * LETTERING_CAPITAL / 3) < 1e-9);
    assert_true(lettering_width("", 20) == 0);
    for (int align = LETTERING_LEFT; align <= LETTERING_RIGHT; align++) {
        double ink[4], plain[4];
        ink_at("10", 0, LETTERING_LEFT, plain);
        ink_at("10", 3, (enum lettering_align)align, ink);
        assert_true(fabs(ink[0] - (3 + plain[0] - width / 20 * align / 2)) < 0.02);
    }
}

/* ---- colours ---- */

static void colours_are_found_and_kept_apart(void **state)
{
    (void)state;
    static const char *const names[] = {"paper", "safe"};
    unsigned char one[3], other[3];
    for (int i = 0; i < 2; i++) {
        const struct palette *palette = colours_palette(names[i]);
        for (int a = 0; a < 2 + PALETTE_OTHERS; a++) {
            colours_bytes(colours_stitch(palette, a), one);
            for (int b = 0; b < a; b++) {
                colours_bytes(colours_stitch(palette, b), other);
                assert_true(abs(one[0] - other[0]) + abs(one[1] - other[1]) + abs(one[2] - other[2]) > 40);
            }
        }
        colours_bytes(colours_stitch(palette, 2), one);
        colours_bytes(colours_stitch(palette, 2 + PALETTE_OTHERS), other);
        assert_memory_equal(one, other, 3);
    }
    assert_null(colours_palette("papers"));
    colours_bytes((struct rgb){0, 0.5, 1}, one);
    assert_memory_equal(one, ((unsigned char[]){0, 128, 255}), 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_do_not_depend_on_what_was_drawn_before),
        cmocka_unit_test(formats_are_those_of_the_extension),
        cmocka_unit_test(pdf_has_the_date_it_is_given_or_none),
        cmocka_unit_test(png_has_its_pixels),
        cmocka_unit_test(png_has_limits),
        cmocka_unit_test(packed_images_come_back),
        cmocka_unit_test(svg_holds_an_image_as_it_was_packed),
        cmocka_unit_test(every_ascii_glyph_keeps_to_its_place),
        cmocka_unit_test(letters_and_digits_stand_on_the_line),
        cmocka_unit_test(every_ascii_glyph_is_another),
        cmocka_unit_test(letters_with_accents_are_others),
        cmocka_unit_test(text_is_aligned),
        cmocka_unit_test(colours_are_found_and_kept_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
