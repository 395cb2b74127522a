/* SPDX-License-Identifier: GPL-3.0-or-later
 * A surface with a colour for each cell in, the picture of it as pixels out: a
 * depth buffer, so that sheets may cross each other, with several samples a
 * pixel, made a band of rows at a time. */
#include "output/render.h"

#include <math.h>
#include <stdlib.h>

enum {
    STEPS = 256,    /* places along a sample's side: what corners are rounded to, so that no gap opens between cells */
    BAND = 16,      /* rows of pixels at a time */
};

/* Brightness of the wrong side beside the right one. */
static const double behind = 0.8;
/* Lines around stitches: half their width in pixels, and their brightness. */
static const double line_half = 0.4, line_dark = 0.45;

/* A point of the surface in the picture. */
struct corner {
    int64_t x, y;       /* 1/STEPS of a sample, y downward */
    double  depth;      /* length, towards the eye */
    double  lit;        /* cosine between the right side's normal and the light */
};

/* Some rows of samples. */
struct band {
    double    shade;            /* as in struct render */
    int       samples;          /* likewise */
    int       width;            /* samples */
    int64_t   first, end;       /* rows of samples */
    float    *depth;            /* ((end - first) x width) of the nearest so far */
    uint32_t *color;            /* 0x00RRGGBB, or NOTHING */
};
static const uint32_t NOTHING = UINT32_MAX;

static struct corner *place_corners(const struct render *r)
{
    const struct surface *s = r->surface;
    size_t points = (size_t)(s->nx + 1) * (size_t)(s->ny + 1);
    double unit = r->scale * r->samples * STEPS;
    struct corner *corner = malloc(points * sizeof *corner);
    for (size_t i = 0; corner && i < points; i++) {
        const double *n = s->normal + 3 * i;
        double seen[3];
        view_project(&r->view, s->position + 3 * i, seen);
        corner[i] = (struct corner){
            .x = llround((seen[0] - r->centre[0]) * unit + 0.5 * r->width * r->samples * STEPS),
            .y = llround((r->centre[1] - seen[1]) * unit + 0.5 * r->height * r->samples * STEPS),
            .depth = seen[2],
            .lit = n[0] * r->light[0] + n[1] * r->light[1] + n[2] * r->light[2],
        };
    }
    return corner;
}

/* Twice the area of a triangle; positive where a, b, c turn clockwise on the screen. */
static int64_t turn(const struct corner *a, const struct corner *b, int64_t x, int64_t y)
{
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

static int64_t least(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static int64_t most(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

/* The first sample whose middle is at or right of (below) a place. */
static int64_t sample_from(int64_t place)
{
    return (place + STEPS / 2 - 1) >> 8;
}

/* Full brightness is reached before the light falls straight on. */
static uint32_t shaded(const struct rgb *color, double shade, double lit, double brightness)
{
    double light = brightness * fmin(shade + 1.2 * (1 - shade) * fmax(lit, 0), 1);
    const double part[3] = {color->red, color->green, color->blue};
    uint32_t rgb = 0;
    for (int c = 0; c < 3; c++)
        rgb = rgb << 8 | (uint32_t)(255 * light * part[c] + 0.5);
    return rgb;
}

/* Three corners of a cell, the colours of its two sides, and which of the sides 01, 12, 20 get a line (bits 0, 1, 2). */
struct triangle {
    const struct corner *corner[3];
    const struct rgb    *color[2];
    unsigned             lines;
    double               line[3];       /* of those: what turn() makes of the line's edge and the side */
};

/* Is a sample, given by what turn() makes of it and each side, on a line? */
static bool on_line(const struct triangle *t, const int64_t inside[3])
{
    for (int k = 0; k < 3; k++)
        if ((t->lines >> k & 1) && (double)llabs(inside[k]) < t->line[k])
            return true;
    return false;
}

/* One sample inside a triangle; inside[k] over area is the weight of the corner opposite to side k. */
static void draw_sample(struct band *band, const struct triangle *t, const int64_t inside[3], int64_t area, size_t at)
{
    double weight[3], depth = 0, lit = 0;
    for (int k = 0; k < 3; k++) {
        weight[k] = (double)inside[k] / (double)area;
        depth += weight[k] * t->corner[(k + 2) % 3]->depth;
    }
    if ((float)depth <= band->depth[at])
        return;
    for (int k = 0; k < 3; k++)
        lit += weight[k] * t->corner[(k + 2) % 3]->lit;
    band->depth[at] = (float)depth;
    bool front = area < 0;
    double brightness = (front ? 1 : behind) * (t->lines && on_line(t, inside) ? line_dark : 1);
    band->color[at] = shaded(t->color[!front], band->shade, front ? lit : -lit, brightness);
}

static void draw_triangle(struct band *band, struct triangle *t)
{
    const struct corner *a = t->corner[0], *b = t->corner[1], *c = t->corner[2];
    int64_t area = turn(a, b, c->x, c->y), sign = area < 0 ? -1 : 1;
    int64_t top = most(sample_from(least(a->y, least(b->y, c->y))), band->first);
    int64_t bottom = least(sample_from(most(a->y, most(b->y, c->y)) + 1), band->end);
    int64_t left = most(sample_from(least(a->x, least(b->x, c->x))), 0);
    int64_t right = least(sample_from(most(a->x, most(b->x, c->x)) + 1), band->width);
    if (area == 0 || left >= right)
        return;
    /* What turn() makes of the first sample of a row, and how that grows from one sample to the next. */
    const struct corner *from[3] = {a, b, c}, *to[3] = {b, c, a};
    int64_t start[3], along[3], down[3];
    for (int k = 0; k < 3; k++) {
        start[k] = turn(from[k], to[k], left * STEPS + STEPS / 2, top * STEPS + STEPS / 2);
        along[k] = (from[k]->y - to[k]->y) * STEPS;
        down[k] = (to[k]->x - from[k]->x) * STEPS;
        if (t->lines >> k & 1)
            t->line[k] = line_half * band->samples * hypot((double)along[k], (double)down[k]);
    }
    for (int64_t j = top; j < bottom; j++) {
        int64_t inside[3] = {start[0], start[1], start[2]};
        for (int64_t i = left; i < right; i++) {
            if (sign * inside[0] >= 0 && sign * inside[1] >= 0 && sign * inside[2] >= 0)
                draw_sample(band, t, inside, area, (size_t)((j - band->first) * band->width + i));
            for (int k = 0; k < 3; k++)
                inside[k] += along[k];
        }
        for (int k = 0; k < 3; k++)
            start[k] += down[k];
    }
}

/* A cell as two triangles; lines where stitches meet. */
static void draw_cell(struct band *band, const struct render *r, const struct corner *corner, int i, int j)
{
    const struct surface *s = r->surface;
    const struct corner *a = corner + (size_t)j * (size_t)(s->nx + 1) + i, *b = a + 1, *d = a + s->nx + 1, *c = d + 1;
    int n = s->per_stitch;
    unsigned bottom = j % n == 0, right = (i + 1) % n == 0, top = (j + 1) % n == 0, left = i % n == 0;
    if (most(most(a->y, b->y), most(c->y, d->y)) < band->first * STEPS ||
        least(least(a->y, b->y), least(c->y, d->y)) > band->end * STEPS)
        return;
    size_t cell = (size_t)j * (size_t)s->nx + (size_t)i;
    const struct rgb *right_side = &r->color[0][cell], *wrong_side = &r->color[1][cell];
    draw_triangle(band, &(struct triangle){{a, b, c}, {right_side, wrong_side}, r->edges ? bottom | right << 1 : 0, {0}});
    draw_triangle(band, &(struct triangle){{a, c, d}, {right_side, wrong_side}, r->edges ? top << 1 | left << 2 : 0, {0}});
}

/* The mean of a pixel's samples, what is empty counting as nothing. */
static uint32_t pixel_of(const struct band *band, int x, int y)
{
    unsigned sum[4] = {0}, n = (unsigned)(band->samples * band->samples);
    for (int j = 0; j < band->samples; j++) {
        const uint32_t *row = band->color + (size_t)(y * band->samples + j) * (size_t)band->width + (size_t)(x * band->samples);
        for (int i = 0; i < band->samples; i++) {
            if (row[i] == NOTHING)
                continue;
            sum[0] += 255;
            for (int c = 1; c < 4; c++)
                sum[c] += row[i] >> (24 - 8 * c) & 255;
        }
    }
    uint32_t pixel = 0;
    for (int c = 0; c < 4; c++)
        pixel = pixel << 8 | (sum[c] + n / 2) / n;
    return pixel;
}

static void clear_band(struct band *band)
{
    size_t n = (size_t)(band->end - band->first) * (size_t)band->width;
    for (size_t i = 0; i < n; i++) {
        band->depth[i] = -INFINITY;
        band->color[i] = NOTHING;
    }
}

/* All cells onto a band, and its pixels into the picture. */
static void draw_band(struct band *band, const struct render *r, const struct corner *corner, uint32_t *pixels)
{
    const struct surface *s = r->surface;
    clear_band(band);
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++)
            draw_cell(band, r, corner, i, j);
    for (int64_t y = 0; y < (band->end - band->first) / band->samples; y++)
        for (int x = 0; x < r->width; x++)
            pixels[y * r->width + x] = pixel_of(band, x, (int)y);
}

bool render_pixels(const struct render *r, uint32_t *pixels)
{
    size_t samples = (size_t)r->width * BAND * (size_t)(r->samples * r->samples);
    struct corner *corner = place_corners(r);
    struct band band = {.shade = r->shade, .samples = r->samples, .width = r->width * r->samples,
                        .depth = malloc(samples * sizeof *band.depth),
                        .color = malloc(samples * sizeof *band.color)};
    bool done = corner && band.depth && band.color;
    for (int first = 0; done && first < r->height; first += BAND) {
        int end = first + BAND < r->height ? first + BAND : r->height;
        band.first = (int64_t)first * r->samples;
        band.end = (int64_t)end * r->samples;
        draw_band(&band, r, corner, pixels + (size_t)first * (size_t)r->width);
    }
    free(band.depth);
    free(band.color);
    free(corner);
    return done;
}
