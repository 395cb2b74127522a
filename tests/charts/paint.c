/* SPDX-License-Identifier: GPL-3.0-or-later
 * Letters on standard input (k black, p white, r red, g gray, h half transparent,
 * t transparent; the top row first) in, a PNG file of the kind wanted out:
 * paint rgb|rgba|gray|indexed|deep|deep_srgb|interlaced|deep_interlaced|linear PATH. */
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 4096 };

/* Those with a depth are written step by step. */
static const struct {
    const char *kind;
    unsigned    format;
    int         depth, interlace;
    double      gamma;
} kinds[] = {{"rgb", PNG_FORMAT_RGB, 0, 0, 0},
             {"rgba", PNG_FORMAT_RGBA, 0, 0, 0},
             {"gray", PNG_FORMAT_GRAY, 0, 0, 0},
             {"indexed", PNG_FORMAT_RGB_COLORMAP, 0, 0, 0},
             {"deep", PNG_FORMAT_LINEAR_RGB, 0, 0, 0},
             {"deep_srgb", PNG_FORMAT_RGB, 16, PNG_INTERLACE_NONE, 0},
             {"interlaced", PNG_FORMAT_RGB, 8, PNG_INTERLACE_ADAM7, 0},
             {"deep_interlaced", PNG_FORMAT_RGB, 16, PNG_INTERLACE_ADAM7, 0},
             {"linear", PNG_FORMAT_RGB, 8, PNG_INTERLACE_NONE, 1}};
enum { NKINDS = sizeof kinds / sizeof *kinds };

static const struct {
    char          letter;
    unsigned char rgba[4];
} colours[] = {{'k', {0, 0, 0, 255}}, {'p', {255, 255, 255, 255}}, {'r', {255, 0, 0, 255}},
               {'g', {128, 128, 128, 255}}, {'h', {0, 0, 0, 128}}, {'t', {0, 0, 0, 0}}};
enum { NCOLOURS = sizeof colours / sizeof *colours };

static int colour_of(char letter)
{
    int i = 0;
    while (i < NCOLOURS - 1 && colours[i].letter != letter)
        i++;
    return i;
}

/* One pixel of the kind at the end of the picture. */
static unsigned char *put(unsigned char *to, unsigned format, int colour)
{
    const unsigned char *rgba = colours[colour].rgba;
    int n = (int)PNG_IMAGE_PIXEL_CHANNELS(format);
    if (format & PNG_FORMAT_FLAG_COLORMAP) {
        *to = (unsigned char)colour;
        return to + 1;
    }
    for (int i = 0; i < n; i++)
        if (format & PNG_FORMAT_FLAG_LINEAR)
            memcpy(to + 2 * i, &(unsigned short){(unsigned short)(257 * rgba[i])}, 2);
        else
            to[i] = rgba[i];
    return to + n * (format & PNG_FORMAT_FLAG_LINEAR ? 2 : 1);
}

/* Red, green and blue of each pixel in so many bits, without a word on the colour space but a gamma; 0: done. */
static int write_steps(const char *path, const png_image *image, const unsigned char *pixel, int depth, int interlace,
                       double gamma)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    FILE *file = fopen(path, "wb");
    size_t n = (size_t)image->width * 3, bytes = (size_t)depth / 8;
    unsigned char **row = malloc(image->height * sizeof *row);
    if (!png || !info || !file || !row || setjmp(png_jmpbuf(png)))
        return 1;
    png_init_io(png, file);
    png_set_IHDR(png, info, image->width, image->height, depth, PNG_COLOR_TYPE_RGB, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (gamma > 0)
        png_set_gAMA(png, info, gamma);
    for (unsigned y = 0; y < image->height; y++) {
        row[y] = malloc(n * bytes);
        for (size_t i = 0; i < n * bytes; i++)
            row[y][i] = pixel[y * n + i / bytes];
    }
    png_set_rows(png, info, row);
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, NULL);
    png_destroy_write_struct(&png, &info);
    for (unsigned y = 0; y < image->height; y++)
        free(row[y]);
    free(row);
    return fclose(file);
}

int main(int argc, char **argv)
{
    static char line[SIDE];
    static unsigned char pixel[8 * SIDE * 16], *to = pixel, map[NCOLOURS * 3];
    png_image image = {.version = PNG_IMAGE_VERSION, .colormap_entries = NCOLOURS - 1};
    int kind = 0;
    while (argc == 3 && kind < NKINDS - 1 && strcmp(argv[1], kinds[kind].kind) != 0)
        kind++;
    image.format = kinds[kind].format;
    for (int i = 0; i < NCOLOURS; i++)
        memcpy(map + 3 * i, colours[i].rgba, 3);
    while (fgets(line, sizeof line, stdin)) {
        size_t n = strcspn(line, "\n");
        if (to + 8 * n > pixel + sizeof pixel)
            return 1;
        for (size_t i = 0; i < n; i++)
            to = put(to, image.format, colour_of(line[i]));
        image.width = (unsigned)n;
        image.height++;
    }
    if (argc == 3 && kinds[kind].depth)
        return write_steps(argv[2], &image, pixel, kinds[kind].depth, kinds[kind].interlace, kinds[kind].gamma);
    return argc != 3 || !png_image_write_to_file(&image, argv[2], 0, pixel, 0, map);
}
