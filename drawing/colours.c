/* SPDX-License-Identifier: GPL-3.0-or-later
 * Colours by name: pairs for knit and purl, and scales for numbers. */
#include "drawing/colours.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* ---- stitches ---- */

#define RGB(hex) {(0x##hex >> 16) / 255., (0x##hex >> 8 & 255) / 255., (0x##hex & 255) / 255.}

static const struct palette palettes[] = {
    {"paper", RGB(C8352B), RGB(2F5FA8),
     {RGB(E0A526), RGB(3E9B5C), RGB(8A4FA3), RGB(6B6B6B), RGB(48B0B5), RGB(C77BA0)}},
    {"safe", RGB(F0B43C), RGB(1F4E8C),
     {RGB(2E9E83), RGB(C8572A), RGB(7FC4EA), RGB(BF7FB0), RGB(6B6B6B), RGB(EFE36A)}},
};

const struct palette *colours_palette(const char *name)
{
    for (size_t i = 0; i < sizeof palettes / sizeof *palettes; i++)
        if (strcmp(palettes[i].name, name) == 0)
            return &palettes[i];
    return NULL;
}

void colours_bytes(struct rgb c, unsigned char bytes[3])
{
    const double value[3] = {c.red, c.green, c.blue};
    for (int k = 0; k < 3; k++)
        bytes[k] = (unsigned char)lround(255 * value[k]);
}

struct rgb colours_stitch(const struct palette *palette, int stitch)
{
    return stitch == 0 ? palette->knit : stitch == 1 ? palette->purl : palette->other[(stitch - 2) % PALETTE_OTHERS];
}

/* ---- lines ---- */

/* Dark enough for thin lines on white, neighbours apart in lightness. */
struct rgb colours_line(int i)
{
    static const struct rgb lines[] = {RGB(1F4E8C), RGB(C8572A), RGB(2A8F77), RGB(8A4FA3), RGB(6B6B6B), RGB(B8860B)};
    return lines[i % (int)(sizeof lines / sizeof *lines)];
}

/* ---- scales ---- */

/* Lightness, chroma and hue in degrees of the points a scale runs through. */
struct anchor { double lightness, chroma, hue; };
struct oklab { double l, a, b; };

enum { ANCHORS_MAX = 6 };

static const struct {
    int           n;
    struct anchor anchor[ANCHORS_MAX];
} scales[] = {
    [COLOURS_SEQUENTIAL] = {6, {{0.22, 0.075, 290}, {0.36, 0.115, 275}, {0.50, 0.095, 230},
                                {0.64, 0.105, 175}, {0.79, 0.140, 130}, {0.93, 0.120, 100}}},
    [COLOURS_DIVERGING] = {5, {{0.42, 0.130, 258}, {0.68, 0.090, 248}, {0.95, 0.005, 100},
                               {0.68, 0.110, 35}, {0.42, 0.150, 27}}},
};

static struct oklab oklab_of(struct anchor anchor)
{
    double hue = anchor.hue * M_PI / 180;
    return (struct oklab){anchor.lightness, anchor.chroma * cos(hue), anchor.chroma * sin(hue)};
}

static double distance(struct oklab p, struct oklab q)
{
    return hypot(p.l - q.l, hypot(p.a - q.a, p.b - q.b));
}

/* The curve of sRGB from linear light, cut off at its ends. */
static double gamma_of(double linear)
{
    double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
    return fmin(fmax(value, 0), 1);
}

/* Oklab to sRGB: Ottosson's two matrices, with the cube between them. */
static struct rgb rgb_of(struct oklab c)
{
    double l = pow(c.l + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
    double m = pow(c.l - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
    double s = pow(c.l - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
    return (struct rgb){gamma_of(+4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                        gamma_of(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                        gamma_of(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

struct rgb colours_at(enum colours_scale scale, double t)
{
    struct oklab point[ANCHORS_MAX];
    double length = 0;
    int n = scales[scale].n;
    for (int i = 0; i < n; i++) {
        point[i] = oklab_of(scales[scale].anchor[i]);
        length += i > 0 ? distance(point[i - 1], point[i]) : 0;
    }

    /* The piece in which t's length ends, and how far along it. */
    double rest = fmin(fmax(t, 0), 1) * length;
    int i = 0;
    while (i + 2 < n && rest > distance(point[i], point[i + 1])) {
        rest -= distance(point[i], point[i + 1]);
        i++;
    }
    struct oklab p = point[i], q = point[i + 1];
    double w = fmin(rest / distance(p, q), 1);
    return rgb_of((struct oklab){p.l + w * (q.l - p.l), p.a + w * (q.a - p.a), p.b + w * (q.b - p.b)});
}
