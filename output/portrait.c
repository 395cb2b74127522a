/* SPDX-License-Identifier: GPL-3.0-or-later
 * A picture of a folded surface: what an output asks for and a surface in, one
 * .png, .svg or .pdf out. */
#include "output/portrait.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/drawn_body.h"
#include "drawing/canvas.h"
#include "drawing/colours.h"
#include "drawing/lettering.h"
#include "drawing/packed.h"
#include "output/field.h"
#include "output/render.h"

enum { PIXELS_PER_POINT = 3, SAMPLES = 4, SAMPLES_FINE = 2, NUMBERS = 5, NUMBER_SIZE = 16 };

/* Where things are, in the picture's unit; no scale or chart: their box is empty. */
struct layout {
    double     size;        /* of letters */
    struct drawn_box fold, chart, scale;
    double     width, height;
};

/* All that a picture is made of. */
struct show {
    const struct picture *picture;
    const struct scene   *scene;
    const struct surface *surface;
    const struct palette *palette;
    struct field          field;    /* value NULL: coloured by stitch */
    char                  number[NUMBERS][NUMBER_SIZE];     /* beside the scale, from low to high */
    struct view           view;
    double                low[2], high[2];                  /* of the projected surface, length */
    struct layout         layout;
};

/* ---- what goes where ---- */

static void find_extent(struct show *show)
{
    const struct surface *s = show->surface;
    size_t points = (size_t)(s->nx + 1) * (size_t)(s->ny + 1);
    for (int c = 0; c < 2; c++)
        show->low[c] = INFINITY, show->high[c] = -INFINITY;
    for (size_t i = 0; i < points; i++) {
        double seen[3];
        view_project(&show->view, s->position + 3 * i, seen);
        for (int c = 0; c < 2; c++) {
            show->low[c] = fmin(show->low[c], seen[c]);
            show->high[c] = fmax(show->high[c], seen[c]);
        }
    }
}

static double numbers_width(const struct show *show)
{
    double width = 0;
    for (int i = 0; i < NUMBERS; i++)
        width = fmax(width, lettering_width(show->number[i], show->layout.size));
    return width;
}

/* Fold and chart have one height; all together are as wide as asked for and at
 * most one and a half times as high.  Whole units keep edges sharp. */
static void lay_out(struct show *show)
{
    struct layout *l = &show->layout;
    const struct grid *g = show->scene->grid;
    const struct gauge *gauge = &show->scene->gauge;
    double width = show->picture->width, margin = ceil(width / 50);
    l->size = fmax(7, width / 60);
    double scale = show->field.value ? ceil(numbers_width(show) + 6 * l->size) : 0;
    double gap = show->picture->chart ? 2 * margin : 0, room = width - 2 * margin - scale - gap;
    double fold_width = fmax(show->high[0] - show->low[0], gauge->width / 100);
    double fold_height = fmax(show->high[1] - show->low[1], gauge->height / 100);
    double chart = show->picture->chart ? g->columns * gauge->width / (g->rows * gauge->height) : 0;
    double height = fmin(room / (chart + fold_width / fold_height), 1.5 * width);
    double inner = ceil(fmax(height, show->field.value ? 14 * l->size : 0));
    double left = margin + floor((room - height * (chart + fold_width / fold_height)) / 2);
    l->width = width;
    l->height = inner + 2 * margin;
    l->chart = (struct drawn_box){left, margin + floor((inner - height) / 2), chart * height, height};
    l->fold = (struct drawn_box){ceil(left + chart * height + gap), l->chart.y, height * fold_width / fold_height, height};
    l->scale = (struct drawn_box){width - margin - scale + 1.5 * l->size, margin, scale > 0 ? l->size : 0, inner};
}

/* ---- the fold ---- */

/* A purl is a knit stitch from behind: its wrong side has the colour of what it is there. */
static struct rgb color_of(const struct show *show, int i, int j, bool behind)
{
    const struct surface *s = show->surface;
    const struct field *f = &show->field;
    if (f->value) {
        double share = (f->value[(size_t)j * (size_t)s->nx + (size_t)i] - f->low) / (f->high - f->low);
        return colours_at(f->diverging ? COLOURS_DIVERGING : COLOURS_SEQUENTIAL, share);
    }
    stitch_id id = grid_at(show->scene->grid, i / s->per_stitch, j / s->per_stitch);
    return colours_stitch(show->palette, behind ? show->scene->stitch[id].ws : id);
}

/* (ny x nx) of one side; NULL: out of memory. */
static struct rgb *color_cells(const struct show *show, bool behind)
{
    const struct surface *s = show->surface;
    struct rgb *color = malloc((size_t)s->nx * (size_t)s->ny * sizeof *color);
    for (int j = 0; color && j < s->ny; j++)
        for (int i = 0; i < s->nx; i++)
            color[(size_t)j * (size_t)s->nx + (size_t)i] = color_of(show, i, j, behind);
    return color;
}

/* The fold as an image of so many pixels a unit; NULL: out of memory. */
static cairo_surface_t *render_fold(const struct show *show, int pixels)
{
    const struct drawn_box *box = &show->layout.fold;
    const struct surface *s = show->surface;
    struct rgb *right = color_cells(show, false), *wrong = color_cells(show, true);
    struct render render = {
        .surface = s, .color = {right, wrong}, .view = show->view, .edges = show->picture->edges,
        .shade = show->field.value ? 0.75 : 0.5,
        .samples = pixels > 1 ? SAMPLES_FINE : SAMPLES,
        .width = (int)ceil(box->width * pixels), .height = (int)ceil(box->height * pixels),
        .scale = box->height * pixels / fmax(show->high[1] - show->low[1], show->scene->gauge.height / 100),
        .centre = {(show->low[0] + show->high[0]) / 2, (show->low[1] + show->high[1]) / 2},
    };
    view_direction(&show->view, show->picture->light, render.light);
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, render.width, render.height);
    bool done = cairo_surface_status(image) == CAIRO_STATUS_SUCCESS && right && wrong &&
                render_pixels(&render, (uint32_t *)(void *)cairo_image_surface_get_data(image));
    free(right);
    free(wrong);
    if (done) {
        cairo_surface_mark_dirty(image);
        return image;
    }
    cairo_surface_destroy(image);
    return NULL;
}

static bool draw_fold(cairo_t *cairo, const struct show *show, enum canvas_format format)
{
    int pixels = format == CANVAS_PNG ? 1 : PIXELS_PER_POINT;
    cairo_surface_t *image = render_fold(show, pixels);
    if (!image)
        return false;
    if (format == CANVAS_SVG && !packed_attach(image, show->field.value ? PACKED_GRADUAL : PACKED_FLAT)) {
        cairo_surface_destroy(image);
        return false;
    }
    cairo_save(cairo);
    cairo_translate(cairo, show->layout.fold.x, show->layout.fold.y);
    cairo_scale(cairo, 1. / pixels, 1. / pixels);
    cairo_set_source_surface(cairo, image, 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(image);
    return true;
}

/* ---- what stands beside it ---- */

/* A line of letters that runs upward, its middle at the scale's. */
static void draw_upward(cairo_t *cairo, const struct show *show, double x, const char *text)
{
    const struct drawn_box *box = &show->layout.scale;
    double size = fmin(show->layout.size, box->height / lettering_width(text, 1));
    cairo_save(cairo);
    cairo_translate(cairo, x, box->y + box->height / 2);
    cairo_rotate(cairo, -M_PI / 2);
    lettering_draw(cairo, 0, 0, size, LETTERING_CENTRE, text);
    cairo_restore(cairo);
}

static void draw_scale(cairo_t *cairo, const struct show *show)
{
    const struct drawn_box *box = &show->layout.scale;
    double size = show->layout.size, right = box->x + box->width;
    enum { STOPS = 32 };
    cairo_pattern_t *colors = cairo_pattern_create_linear(0, box->y + box->height, 0, box->y);
    for (int i = 0; i <= STOPS; i++) {
        struct rgb c = colours_at(show->field.diverging ? COLOURS_DIVERGING : COLOURS_SEQUENTIAL, (double)i / STOPS);
        cairo_pattern_add_color_stop_rgb(colors, (double)i / STOPS, c.red, c.green, c.blue);
    }
    cairo_set_source(cairo, colors);
    cairo_rectangle(cairo, box->x, box->y, box->width, box->height);
    cairo_fill(cairo);
    cairo_pattern_destroy(colors);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    for (int i = 0; i < NUMBERS; i++) {
        double y = box->y + box->height * (1 - (double)i / (NUMBERS - 1));
        double down = i == 0 ? 0 : i == NUMBERS - 1 ? LETTERING_CAPITAL : LETTERING_CAPITAL / 2;
        lettering_draw(cairo, right + 0.5 * size, y + down * size, size, LETTERING_LEFT, show->number[i]);
    }
    double title = right + 1.9 * size + numbers_width(show);
    draw_upward(cairo, show, title, show->field.title);
    draw_upward(cairo, show, title + LETTERING_LINE * size, show->field.ends);
}

/* ---- the file ---- */

static void send(void *file, const void *bytes, size_t n)
{
    file_write(file, bytes, n);
}

static bool draw(struct file_log *log, struct file *file, const struct show *show, const char *path)
{
    enum canvas_format format = CANVAS_PNG;
    canvas_format_of(path, &format);
    const struct canvas_size size = {show->layout.width, show->layout.height, 1};
    struct canvas *canvas = (show->picture->transparent ? canvas_begin_clear : canvas_begin)(format, size, send, file);
    bool done = draw_fold(canvas->cairo, show, format);
    if (show->picture->chart)
        drawn_body(canvas->cairo, show->scene, show->layout.chart, &(struct drawn_style){.palette = show->palette});
    if (show->field.value)
        draw_scale(canvas->cairo, show);
    const char *why = canvas_end(canvas);
    if (done && !why)
        return true;
    file_fail(log, "%s: %s", path, why ? why : "out of memory");
    return false;
}

bool portrait_write(struct file_log *log, const struct output *output, const struct scene *scene,
                   const struct surface *surface)
{
    const struct picture *picture = &output->picture;
    struct show show = {.picture = picture, .scene = scene, .surface = surface,
                        .palette = drawn_palette(picture->palette), .view = view_make(picture->view)};
    if (picture->color != COLOR_STITCH) {
        show.field = field_of(surface, picture->color);
        if (!show.field.value) {
            file_fail(log, "%s: out of memory", output->path);
            return false;
        }
        for (int i = 0; i < NUMBERS; i++)
            snprintf(show.number[i], NUMBER_SIZE, "%.3g",
                     show.field.low + (show.field.high - show.field.low) * i / (NUMBERS - 1));
    }
    find_extent(&show);
    lay_out(&show);
    struct file *file = file_create(log, output->path);
    bool done = file && draw(log, file, &show, output->path);
    field_free(&show.field);
    if (file && !done)
        file_abandon(file);
    return done && file_commit(file);
}
