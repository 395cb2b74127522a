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

/* The rows of samples a cell may touch. */
struct reach { int64_t first, last; };

/* Some rows of samples. */
struct band {
    double    shade;            /* as in struct render */
    int       samples;          /* likewise */
    int       width;            /* samples */
    int64_t   first, end;       /* rows of samples */
    float    *depth;            /* ((end - first) x width) of the nearest so far */
    uint32_t *color;            /* 0xFFRRGGBB, or 0 where there is nothing */
};

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

/* Of each cell; NULL: out of memory. */
static struct reach *find_reach(const struct surface *s, const struct corner *corner)
{
    struct reach *reach = malloc((size_t)s->nx * (size_t)s->ny * sizeof *reach), *next = reach;
    for (int j = 0; reach && j < s->ny; j++)
        for (int i = 0; i < s->nx; i++, next++) {
            const struct corner *a = corner + (size_t)j * (size_t)(s->nx + 1) + i, *b = a + 1, *d = a + s->nx + 1, *c = d + 1;
            next->first = sample_from(least(least(a->y, b->y), least(c->y, d->y)));
            next->last = sample_from(most(most(a->y, b->y), most(c->y, d->y)));
        }
    return reach;
}

/* Three corners of a cell, clockwise on the screen; which of the sides 01, 12, 20 get a line (bits 0, 1, 2). */
struct triangle {
    const struct corner *corner[3];
    unsigned             lines;
    double               line[3];       /* of those: what turn() makes of the line's edge and the side */
    double               depth[3];      /* what turn() of side k is worth: times it, summed, a sample's depth */
    double               lit[3];        /* likewise, of the side seen */
    double               color[3];      /* that side's in full light, 0..255 */
};

/* Is a sample, given by what turn() makes of it and each side, on a line? */
static bool on_line(const struct triangle *t, const int64_t inside[3])
{
    for (int k = 0; k < 3; k++)
        if ((t->lines >> k & 1) && (double)inside[k] < t->line[k])
            return true;
    return false;
}

/* Full brightness is reached before the light falls straight on. */
static uint32_t shaded(const struct triangle *t, double shade, double lit, bool line)
{
    double light = lit > 0 ? shade + 1.2 * (1 - shade) * lit : shade;
    light = (light < 1 ? light : 1) * (line ? line_dark : 1);
    uint32_t red = (uint32_t)(light * t->color[0] + 0.5);
    uint32_t green = (uint32_t)(light * t->color[1] + 0.5);
    uint32_t blue = (uint32_t)(light * t->color[2] + 0.5);
    return 0xFF000000 | red << 16 | green << 8 | blue;
}

/* One sample inside a triangle. */
static void draw_sample(struct band *band, const struct triangle *t, const int64_t inside[3], size_t at)
{
    const double i[3] = {(double)inside[0], (double)inside[1], (double)inside[2]};
    float depth = (float)(i[0] * t->depth[0] + i[1] * t->depth[1] + i[2] * t->depth[2]);
    if (depth <= band->depth[at])
        return;
    double lit = i[0] * t->lit[0] + i[1] * t->lit[1] + i[2] * t->lit[2];
    band->depth[at] = depth;
    band->color[at] = shaded(t, band->shade, lit, t->lines && on_line(t, inside));
}

/* The samples of a triangle that are in the band.  What turn() makes of a sample and a side grows evenly along and
 * down the rows, and is not negative inside; over the area it is the weight of the corner opposite. */
static void fill_triangle(struct band *band, struct triangle *t)
{
    const struct corner *a = t->corner[0], *b = t->corner[1], *c = t->corner[2];
    int64_t top = most(sample_from(least(a->y, least(b->y, c->y))), band->first);
    int64_t bottom = least(sample_from(most(a->y, most(b->y, c->y)) + 1), band->end);
    int64_t left = most(sample_from(least(a->x, least(b->x, c->x))), 0);
    int64_t right = least(sample_from(most(a->x, most(b->x, c->x)) + 1), band->width);
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
            if ((inside[0] | inside[1] | inside[2]) >= 0)
                draw_sample(band, t, inside, (size_t)((j - band->first) * band->width + i));
            for (int k = 0; k < 3; k++)
                inside[k] += along[k];
        }
        for (int k = 0; k < 3; k++)
            start[k] += down[k];
    }
}

/* Half a cell, whichever of its sides is seen: color is the right side's and the wrong side's. */
static void draw_triangle(struct band *band, const struct corner *a, const struct corner *b, const struct corner *c,
                          unsigned lines, const struct rgb *const color[2])
{
    int64_t area = turn(a, b, c->x, c->y);
    bool front = area < 0;
    if (area == 0)
        return;
    struct triangle t = {.corner = {a, b, c}, .lines = lines};
    if (front)          /* the other way round: sides 10, 02, 21 */
        t = (struct triangle){.corner = {b, a, c}, .lines = (lines & 1) | (lines >> 1 & 2) | (lines << 1 & 4)};
    for (int k = 0; k < 3; k++) {
        const struct corner *opposite = t.corner[(k + 2) % 3];
        t.depth[k] = opposite->depth / (double)llabs(area);
        t.lit[k] = (front ? opposite->lit : -opposite->lit) / (double)llabs(area);
    }
    double full = 255 * (front ? 1 : behind);
    const struct rgb *seen = color[!front];
    t.color[0] = full * seen->red, t.color[1] = full * seen->green, t.color[2] = full * seen->blue;
    fill_triangle(band, &t);
}

/* A cell as two triangles; lines where stitches meet. */
static void draw_cell(struct band *band, const struct render *r, const struct corner *corner, int i, int j)
{
    const struct surface *s = r->surface;
    const struct corner *a = corner + (size_t)j * (size_t)(s->nx + 1) + i, *b = a + 1, *d = a + s->nx + 1, *c = d + 1;
    int n = s->per_stitch;
    unsigned bottom = j % n == 0, right = (i + 1) % n == 0, top = (j + 1) % n == 0, left = i % n == 0;
    size_t cell = (size_t)j * (size_t)s->nx + (size_t)i;
    const struct rgb *const color[2] = {&r->color[0][cell], &r->color[1][cell]};
    draw_triangle(band, a, b, c, r->edges ? bottom | right << 1 : 0, color);
    draw_triangle(band, a, c, d, r->edges ? top << 1 | left << 2 : 0, color);
}

/* The mean of a pixel's samples, what is empty counting as nothing; two of the four bytes at a time. */
static uint32_t pixel_of(const struct band *band, int x, int y)
{
    uint32_t n = (uint32_t)(band->samples * band->samples), even = 0, odd = 0;
    for (int j = 0; j < band->samples; j++) {
        const uint32_t *row = band->color + (size_t)(y * band->samples + j) * (size_t)band->width + (size_t)(x * band->samples);
        for (int i = 0; i < band->samples; i++) {
            even += row[i] & 0x00FF00FF;
            odd += row[i] >> 8 & 0x00FF00FF;
        }
    }
    if (odd == 0)
        return 0;
    uint32_t half = n / 2;
    return ((odd >> 16) + half) / n << 24 | ((even >> 16) + half) / n << 16 |
           ((odd & 0xFFFF) + half) / n << 8 | ((even & 0xFFFF) + half) / n;
}

static void clear_band(struct band *band)
{
    size_t n = (size_t)(band->end - band->first) * (size_t)band->width;
    for (size_t i = 0; i < n; i++) {
        band->depth[i] = -INFINITY;
        band->color[i] = 0;
    }
}

/* All cells onto a band, and its pixels into the picture. */
static void draw_band(struct band *band, const struct render *r, const struct corner *corner, const struct reach *reach,
                      uint32_t *pixels)
{
    const struct surface *s = r->surface;
    clear_band(band);
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++, reach++)
            if (reach->first < band->end && reach->last >= band->first)
                draw_cell(band, r, corner, i, j);
    for (int64_t y = 0; y < (band->end - band->first) / band->samples; y++)
        for (int x = 0; x < r->width; x++)
            pixels[y * r->width + x] = pixel_of(band, x, (int)y);
}

bool render_pixels(const struct render *r, uint32_t *pixels)
{
    size_t samples = (size_t)r->width * BAND * (size_t)(r->samples * r->samples);
    struct corner *corner = place_corners(r);
    struct reach *reach = corner ? find_reach(r->surface, corner) : NULL;
    struct band band = {.shade = r->shade, .samples = r->samples, .width = r->width * r->samples,
                        .depth = malloc(samples * sizeof *band.depth),
                        .color = malloc(samples * sizeof *band.color)};
    bool done = reach && band.depth && band.color;
    for (int first = 0; done && first < r->height; first += BAND) {
        int end = first + BAND < r->height ? first + BAND : r->height;
        band.first = (int64_t)first * r->samples;
        band.end = (int64_t)end * r->samples;
        draw_band(&band, r, corner, reach, pixels + (size_t)first * (size_t)r->width);
    }
    free(band.depth);
    free(band.color);
    free(reach);
    free(corner);
    return done;
}
