/* SPDX-License-Identifier: GPL-3.0-or-later
 * Letters on standard input (k black, p white, r red, t transparent; the top row
 * first) in, a PNG file of the kind wanted out: paint rgb|rgba|gray|indexed|deep PATH. */
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 4096 };

static const struct {
    const char *kind;
    unsigned    format;
} kinds[] = {{"rgb", PNG_FORMAT_RGB}, {"rgba", PNG_FORMAT_RGBA}, {"gray", PNG_FORMAT_GRAY}, {"indexed", PNG_FORMAT_RGB_COLORMAP},
             {"deep", PNG_FORMAT_LINEAR_RGB}};

static const struct {
    char          letter;
    unsigned char rgba[4];
} colours[] = {{'k', {0, 0, 0, 255}}, {'p', {255, 255, 255, 255}}, {'r', {255, 0, 0, 255}}, {'t', {0, 0, 0, 0}}};
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

int main(int argc, char **argv)
{
    static char line[SIDE];
    static unsigned char pixel[8 * SIDE * 16], *to = pixel, map[NCOLOURS * 3];
    png_image image = {.version = PNG_IMAGE_VERSION, .colormap_entries = NCOLOURS - 1};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (argc == 3 && strcmp(argv[1], kinds[i].kind) == 0)
            image.format = kinds[i].format;
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
    return argc != 3 || !png_image_write_to_file(&image, argv[2], 0, pixel, 0, map);
}
