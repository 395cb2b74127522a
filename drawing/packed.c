/* SPDX-License-Identifier: GPL-3.0-or-later
 * An image of cairo's in, the bytes of a PNG file out. */
#include <config.h>

#include "drawing/packed.h"

#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Measured on folds: unfiltered rows repeat, where colours run into each other rows differ by little; a level less
 * costs these 2 % in size and a third less time. */
static const struct { int filter, level; } packing[] = {
    [PACKED_FLAT] = {PNG_FILTER_NONE, 6},
    [PACKED_GRADUAL] = {PNG_FILTER_UP, 5},
};

/* A row of cairo's pixels, 0xAARRGGBB multiplied by alpha, as bytes that are not: R, G, B and A if there is one. */
static void unpack_row(const uint32_t *pixel, int width, bool alpha, unsigned char *byte)
{
    for (int x = 0; x < width; x++) {
        uint32_t p = pixel[x], a = alpha ? p >> 24 : 255;
        for (int shift = 16; shift >= 0; shift -= 8) {
            uint32_t part = p >> shift & 255;
            *byte++ = (unsigned char)(a == 255 || a == 0 ? part : (part * 255 + a / 2) / a);
        }
        if (alpha)
            *byte++ = (unsigned char)a;
    }
}

/* false where libpng gave up: it does so by jumping here. */
static bool write_rows(png_struct *png, png_info *info, cairo_surface_t *image, enum packed_as as, unsigned char *row)
{
    int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
    int stride = cairo_image_surface_get_stride(image);
    bool alpha = cairo_image_surface_get_format(image) == CAIRO_FORMAT_ARGB32;
    const unsigned char *pixels = cairo_image_surface_get_data(image);
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, packing[as].filter);
    png_set_compression_level(png, packing[as].level);
    png_write_info(png, info);
    for (int y = 0; y < height; y++) {
        unpack_row((const uint32_t *)(const void *)(pixels + (size_t)y * (size_t)stride), width, alpha, row);
        png_write_row(png, row);
    }
    png_write_end(png, NULL);
    return true;
}

unsigned char *packed_png(cairo_surface_t *image, enum packed_as as, size_t *size)
{
    char *bytes = NULL;
    png_struct *png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_info *info = png ? png_create_info_struct(png) : NULL;
    unsigned char *row = malloc(4 * (size_t)cairo_image_surface_get_width(image) + 1);
    FILE *stream = open_memstream(&bytes, size);
    cairo_surface_flush(image);
    bool done = info && row && stream;
    if (done) {
        png_init_io(png, stream);
        done = write_rows(png, info, image, as, row);
    }
    png_destroy_write_struct(&png, &info);
    free(row);
    if (stream && fclose(stream) != 0)
        done = false;
    if (done)
        return (unsigned char *)bytes;
    free(bytes);
    return NULL;
}

bool packed_attach(cairo_surface_t *image, enum packed_as as)
{
    size_t size;
    unsigned char *png = packed_png(image, as, &size);
    if (png && cairo_surface_set_mime_data(image, CAIRO_MIME_TYPE_PNG, png, size, free, png) == CAIRO_STATUS_SUCCESS)
        return true;
    free(png);
    return false;
}
