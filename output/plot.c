/* SPDX-License-Identifier: GPL-3.0-or-later
 * Plots: numbers in; lines over axes with a legend, or a map of coloured cells
 * with its scale, as one .svg, .pdf or .png out. */
#include "output/plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "drawing/canvas.h"
#include "drawing/colours.h"
#include "drawing/lettering.h"

enum { MARKS = 4, MARKS_MOST = 60, STOPS = 32 };

static const double ink = 0.15, faint = 0.88;

/* A rectangle of the picture; x, y is its upper left corner. */
struct box { double x, y, width, height; };

/* The sheet all is drawn on. */
struct sheet_of_plot {
    cairo_t *cairo;
    double   size;      /* of letters */
    double   width, height;
};

static double letters_of(int width)
{
    return fmax(7, (width ? width : PLOT_WIDTH) / 50.);
}

/* ---- the file ---- */

static void send(void *file, const void *bytes, size_t n)
{
    file_write(file, bytes, n);
}

typedef void draw_plot(const struct sheet_of_plot *sheet, const void *plot);

static bool write_plot(struct file_log *log, const char *path, double width, double height, draw_plot *draw, const void *plot)
{
    enum canvas_format format = CANVAS_SVG;
    canvas_format_of(path, &format);
    const struct canvas_size size = {width, ceil(height), 1};
    const char *why = canvas_refusal(format, size);
    struct file *file = why ? NULL : file_create(log, path);
    if (file) {
        struct canvas *canvas = canvas_begin(format, size, send, file);
        draw(&(struct sheet_of_plot){canvas->cairo, letters_of((int)width), width, ceil(height)}, plot);
        why = canvas_end(canvas);
    }
    if (why)
        file_fail(log, "%s: %s", path, why);
    if (why && file)
        file_abandon(file);
    return file && !why && file_commit(file);
}

/* ---- pens ---- */

static void set_grey(cairo_t *cairo, double grey)
{
    cairo_set_source_rgb(cairo, grey, grey, grey);
}

static void set_rgb(cairo_t *cairo, struct rgb c)
{
    cairo_set_source_rgb(cairo, c.red, c.green, c.blue);
}

static void stroke_line(cairo_t *cairo, double x0, double y0, double x1, double y1)
{
    cairo_move_to(cairo, x0, y0);
    cairo_line_to(cairo, x1, y1);
    cairo_stroke(cairo);
}

/* A line of letters, smaller where it would be longer than its room. */
static void write_within(const struct sheet_of_plot *s, double x, double y, double room, const char *text)
{
    lettering_draw(s->cairo, x, y, fmin(s->size, room / fmax(lettering_width(text, 1), 1e-9)), LETTERING_CENTRE, text);
}

static void write_upward(const struct sheet_of_plot *s, double x, double y, double room, const char *text)
{
    cairo_save(s->cairo);
    cairo_translate(s->cairo, x, y);
    cairo_rotate(s->cairo, -M_PI / 2);
    write_within(s, 0, 0, room, text);
    cairo_restore(s->cairo);
}

/* ---- frames ---- */

/* A rectangle with an axis across and one up. */
struct frame {
    struct box  box;
    struct axis x, y;
};

static double across(const struct frame *f, double x)
{
    return f->box.x + f->box.width * axis_place(&f->x, x);
}

static double up(const struct frame *f, double y)
{
    return f->box.y + f->box.height * (1 - axis_place(&f->y, y));
}

static double ticks_width(const struct axis *axis, double size)
{
    double width = 0;
    for (int i = 0; i < axis->nticks; i++)
        width = fmax(width, lettering_width(axis->tick[i].text, size));
    return width;
}

/* Behind the data: faint lines at the ticks with texts. */
static void draw_lattice(const struct sheet_of_plot *s, const struct frame *f)
{
    set_grey(s->cairo, faint);
    cairo_set_line_width(s->cairo, s->size / 16);
    for (int i = 0; i < f->x.nticks; i++)
        if (*f->x.tick[i].text)
            stroke_line(s->cairo, across(f, f->x.tick[i].value), f->box.y, across(f, f->x.tick[i].value), f->box.y + f->box.height);
    for (int i = 0; i < f->y.nticks; i++)
        if (*f->y.tick[i].text)
            stroke_line(s->cairo, f->box.x, up(f, f->y.tick[i].value), f->box.x + f->box.width, up(f, f->y.tick[i].value));
}

/* Ticks below, with their texts; a text that would touch the one before it is left out. */
static void draw_ticks_across(const struct sheet_of_plot *s, const struct frame *f)
{
    double bottom = f->box.y + f->box.height, written = -HUGE_VAL;
    for (const struct axis_tick *t = f->x.tick; t < f->x.tick + f->x.nticks; t++) {
        double x = across(f, t->value), half = lettering_width(t->text, s->size) / 2;
        stroke_line(s->cairo, x, bottom, x, bottom + s->size * (*t->text ? 0.45 : 0.25));
        if (!*t->text || x - half < written + s->size / 2)
            continue;
        lettering_draw(s->cairo, x, bottom + 1.5 * s->size, s->size, LETTERING_CENTRE, t->text);
        written = x + half;
    }
}

/* Ticks at the left (side -1) or at the right (1) of a box. */
static void draw_ticks_up(const struct sheet_of_plot *s, const struct frame *f, int side)
{
    double edge = f->box.x + (side > 0 ? f->box.width : 0);
    for (const struct axis_tick *t = f->y.tick; t < f->y.tick + f->y.nticks; t++) {
        double y = up(f, t->value);
        stroke_line(s->cairo, edge, y, edge + side * s->size * (*t->text ? 0.45 : 0.25), y);
        lettering_draw(s->cairo, edge + side * 0.8 * s->size, y + LETTERING_CAPITAL / 2 * s->size, s->size,
                       side > 0 ? LETTERING_LEFT : LETTERING_RIGHT, t->text);
    }
}

static void draw_box(const struct sheet_of_plot *s, const struct box *b)
{
    set_grey(s->cairo, ink);
    cairo_set_line_width(s->cairo, s->size / 12);
    cairo_rectangle(s->cairo, b->x, b->y, b->width, b->height);
    cairo_stroke(s->cairo);
}

/* The axes' titles: below, and upward at the left edge of the sheet. */
static void draw_titles(const struct sheet_of_plot *s, const struct box *b, const char *x, const char *y)
{
    write_within(s, b->x + b->width / 2, b->y + b->height + 3 * s->size, s->width - 2 * s->size, x);
    write_upward(s, 1.6 * s->size, b->y + b->height / 2, b->height + s->size, y);
}

/* ---- lines ---- */

static struct rgb line_color(const struct plot_panel *panel, int i)
{
    double lightest = 0.85;     /* what is lighter is lost on white */
    if (!panel->ordered)
        return colours_line(i);
    return colours_at(COLOURS_SEQUENTIAL, panel->nlines > 1 ? lightest * i / (panel->nlines - 1) : 0);
}

/* Marks differ in shape, too. */
static void draw_mark(cairo_t *cairo, int shape, double x, double y, double r)
{
    static const struct { int corners; double turn; } form[MARKS] = {{0, 0}, {4, 0.125}, {3, 0.25}, {4, 0}};
    int n = form[shape % MARKS].corners;
    cairo_new_path(cairo);
    if (n == 0)
        cairo_arc(cairo, x, y, r, 0, 2 * M_PI);
    for (int i = 0; i < n; i++) {
        double angle = 2 * M_PI * (form[shape % MARKS].turn + (double)i / n), out = n == 3 ? 1.35 : 1.2;
        cairo_line_to(cairo, x + out * r * cos(angle), y - out * r * sin(angle));
    }
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

static bool is_shown(const struct frame *f, const struct plot_line *line, int i)
{
    return i >= 0 && i < line->n && !isnan(axis_place(&f->x, line->x[i])) && !isnan(axis_place(&f->y, line->y[i]));
}

/* Neighbours that can be shown are joined; a point without any is still a mark. */
static void draw_line(const struct sheet_of_plot *s, const struct frame *f, const struct plot_line *line, int shape)
{
    cairo_new_path(s->cairo);
    cairo_set_line_width(s->cairo, s->size / 8);
    for (int i = 0; i < line->n; i++)
        if (is_shown(f, line, i))
            (is_shown(f, line, i - 1) ? cairo_line_to : cairo_move_to)(s->cairo, across(f, line->x[i]), up(f, line->y[i]));
    cairo_stroke(s->cairo);
    for (int i = 0; i < line->n; i++)
        if (is_shown(f, line, i) && (line->n <= MARKS_MOST || (!is_shown(f, line, i - 1) && !is_shown(f, line, i + 1))))
            draw_mark(s->cairo, shape, across(f, line->x[i]), up(f, line->y[i]), s->size / 4);
}

static bool has_legend(const struct plot_panel *panel)
{
    return panel->nlines > 0 && panel->line[0].name;
}

static double legend_width(const struct plot_panel *panel, double size)
{
    double width = panel->legend ? lettering_width(panel->legend, size) : 0;
    if (!has_legend(panel))
        return 0;
    for (int i = 0; i < panel->nlines; i++)
        width = fmax(width, lettering_width(panel->line[i].name, size) + 2.8 * size);
    return width + 1.5 * size;
}

/* Right of the box, in the order in which the lines are given. */
static void draw_legend(const struct sheet_of_plot *s, const struct box *b, const struct plot_panel *panel)
{
    double x = b->x + b->width + 1.5 * s->size, y = b->y + LETTERING_CAPITAL * s->size;
    if (has_legend(panel) && panel->legend) {
        set_grey(s->cairo, ink);
        lettering_draw(s->cairo, x, y, s->size, LETTERING_LEFT, panel->legend);
        y += 1.2 * LETTERING_LINE * s->size;
    }
    for (int i = 0; has_legend(panel) && i < panel->nlines; i++, y += LETTERING_LINE * s->size) {
        double middle = y - LETTERING_CAPITAL / 2 * s->size;
        set_rgb(s->cairo, line_color(panel, i));
        cairo_set_line_width(s->cairo, s->size / 8);
        stroke_line(s->cairo, x, middle, x + 2 * s->size, middle);
        draw_mark(s->cairo, i, x + s->size, middle, s->size / 4);
        set_grey(s->cairo, ink);
        lettering_draw(s->cairo, x + 2.8 * s->size, y, s->size, LETTERING_LEFT, panel->line[i].name);
    }
}

/* ---- panels ---- */

/* What a line does not show does not widen the other axis either. */
static struct axis_range range_of(const struct plot_panel *panel, bool of_y)
{
    struct axis_range range = AXIS_NOTHING;
    for (int l = 0; l < panel->nlines; l++)
        for (int i = 0; i < panel->line[l].n; i++)
            if (isfinite(panel->line[l].x[i]) && isfinite(panel->line[l].y[i]))
                axis_see(&range, of_y ? &panel->line[l].y[i] : &panel->line[l].x[i], 1);
    return range;
}

static struct axis make_axis(const struct plot_panel *panel, bool of_y, double length, double size)
{
    const struct plot_axis *axis = of_y ? &panel->y : &panel->x;
    struct axis_range range = range_of(panel, of_y);
    int texts = (int)(length / (size * (of_y ? 3 : 5)));
    return axis_make(&range, &(struct axis_wish){axis->scale, axis->zero, axis->whole, texts > 2 ? texts : 2});
}

static double panel_height(const struct plot *plot, const struct plot_panel *panel)
{
    double size = letters_of(plot->width), part = plot->npanels > 1 ? 0.32 : 0.55;
    double legend = has_legend(panel) ? (panel->nlines + 1.5) * LETTERING_LINE * size : 0;
    return fmax(part * (plot->width ? plot->width : PLOT_WIDTH), legend);
}

static double top_of(const struct plot *plot)
{
    return (plot->title ? 3 : 1.2) * letters_of(plot->width);
}

static const double below_panel = 4.2;      /* texts and title of the axis across, in letters */

/* The first panel's box; boxes of all have the same left and right edges. */
static struct box first_box(const struct sheet_of_plot *s, const struct plot *plot)
{
    double ticks = 0, legend = s->size;
    for (const struct plot_panel *p = plot->panel; p < plot->panel + plot->npanels; p++) {
        struct axis axis = make_axis(p, true, panel_height(plot, p), s->size);
        ticks = fmax(ticks, ticks_width(&axis, s->size));
        legend = fmax(legend, legend_width(p, s->size) + s->size);
    }
    double left = ceil(ticks + 3.4 * s->size);
    return (struct box){left, top_of(plot), fmax(floor(s->width - left - legend), s->width / 4), 0};
}

static void draw_panel(const struct sheet_of_plot *s, const struct plot_panel *panel, const struct box *box)
{
    struct frame f = {*box, make_axis(panel, false, box->width, s->size), make_axis(panel, true, box->height, s->size)};
    bool empty = true;
    draw_lattice(s, &f);
    draw_box(s, box);
    draw_ticks_across(s, &f);
    draw_ticks_up(s, &f, -1);
    draw_titles(s, box, panel->x.title, panel->y.title);
    for (int l = 0; l < panel->nlines; l++) {
        set_rgb(s->cairo, line_color(panel, l));
        draw_line(s, &f, &panel->line[l], l);
        for (int i = 0; i < panel->line[l].n; i++)
            empty = empty && !is_shown(&f, &panel->line[l], i);
    }
    draw_legend(s, box, panel);
    set_grey(s->cairo, ink);
    if (empty)
        write_within(s, box->x + box->width / 2, box->y + box->height / 2, box->width, "nothing to show");
}

static void draw_lines(const struct sheet_of_plot *s, const void *plot_)
{
    const struct plot *plot = plot_;
    struct box box = first_box(s, plot);
    if (plot->title)
        write_within(s, s->width / 2, 1.8 * s->size, s->width - 2 * s->size, plot->title);
    for (int i = 0; i < plot->npanels; i++) {
        box.height = panel_height(plot, &plot->panel[i]);
        draw_panel(s, &plot->panel[i], &box);
        box.y += box.height + below_panel * s->size;
    }
}

bool plot_lines(struct file_log *log, const char *path, const struct plot *plot)
{
    double height = top_of(plot);
    for (int i = 0; i < plot->npanels; i++)
        height += panel_height(plot, &plot->panel[i]) + below_panel * letters_of(plot->width);
    return write_plot(log, path, plot->width ? plot->width : PLOT_WIDTH, height, draw_lines, plot);
}

/* ---- maps ---- */

/* The values' axis is the scale of colours. */
struct colouring {
    struct axis         axis;
    enum colours_scale scale;
};

static struct colouring color_values(const struct plot_map *map, int texts)
{
    struct axis_range range = AXIS_NOTHING;
    axis_see(&range, map->value, map->nx * map->ny);
    struct colouring c = {axis_make(&range, &(struct axis_wish){.scale = map->scale, .texts = texts}), COLOURS_SEQUENTIAL};
    if (!c.axis.log && range.low < 0 && range.high > 0) {       /* zero in the middle */
        range.high = fmax(-range.low, range.high);
        range.low = -range.high;
        c.axis = axis_make(&range, &(struct axis_wish){.scale = AXIS_LINEAR, .texts = texts});
        c.scale = COLOURS_DIVERGING;
    }
    return c;
}

/* What is not there: light grey and crossed out. */
static void draw_missing(const struct sheet_of_plot *s, const struct box *b)
{
    set_grey(s->cairo, faint);
    cairo_rectangle(s->cairo, b->x, b->y, b->width, b->height);
    cairo_fill(s->cairo);
    set_grey(s->cairo, 0.6);
    cairo_set_line_width(s->cairo, s->size / 16);
    stroke_line(s->cairo, b->x, b->y, b->x + b->width, b->y + b->height);
    stroke_line(s->cairo, b->x, b->y + b->height, b->x + b->width, b->y);
}

/* Cells reach from one whole unit to another, so that no seam shows between them. */
static struct box cell_box(const struct plot_map *map, const struct box *b, int i, int j)
{
    double left = round(b->x + b->width * i / map->nx), right = round(b->x + b->width * (i + 1) / map->nx);
    double top = round(b->y + b->height * (map->ny - 1 - j) / map->ny);
    return (struct box){left, top, right - left, round(b->y + b->height * (map->ny - j) / map->ny) - top};
}

static void draw_cells(const struct sheet_of_plot *s, const struct plot_map *map, const struct colouring *c, const struct box *b)
{
    for (int j = 0; j < map->ny; j++) {
        for (int i = 0; i < map->nx; i++) {
            struct box cell = cell_box(map, b, i, j);
            double place = axis_place(&c->axis, map->value[j * map->nx + i]);
            if (isnan(place)) {
                draw_missing(s, &cell);
                continue;
            }
            set_rgb(s->cairo, colours_at(c->scale, place));
            cairo_rectangle(s->cairo, cell.x, cell.y, cell.width, cell.height);
            cairo_fill(s->cairo);
        }
    }
}

/* The params' values at the middles of rows and columns; those without room are left out. */
static void draw_values(const struct sheet_of_plot *s, const struct plot_map *map, const struct box *b)
{
    char text[AXIS_TEXT];
    double written = -HUGE_VAL;
    for (int i = 0; i < map->nx; i++) {
        double x = b->x + b->width * (i + 0.5) / map->nx;
        axis_print(text, map->x[i], 6);
        double half = lettering_width(text, s->size) / 2;
        if (x - half < written + s->size / 2)
            continue;
        lettering_draw(s->cairo, x, b->y + b->height + 1.5 * s->size, s->size, LETTERING_CENTRE, text);
        written = x + half;
    }
    written = -HUGE_VAL;
    for (int j = 0; j < map->ny; j++) {
        double y = b->height * (j + 0.5) / map->ny;
        if (y < written + LETTERING_LINE * s->size)
            continue;
        axis_print(text, map->y[j], 6);
        lettering_draw(s->cairo, b->x - 0.7 * s->size, b->y + b->height - y + LETTERING_CAPITAL / 2 * s->size, s->size,
                       LETTERING_RIGHT, text);
        written = y;
    }
}

/* The scale of colours, its numbers and its title right of the map. */
static void draw_scale(const struct sheet_of_plot *s, const struct colouring *c, const struct box *b, const char *title)
{
    struct frame f = {.box = *b, .y = c->axis};
    cairo_pattern_t *colors = cairo_pattern_create_linear(0, b->y + b->height, 0, b->y);
    for (int i = 0; i <= STOPS; i++) {
        struct rgb color = colours_at(c->scale, (double)i / STOPS);
        cairo_pattern_add_color_stop_rgb(colors, (double)i / STOPS, color.red, color.green, color.blue);
    }
    cairo_set_source(s->cairo, colors);
    cairo_rectangle(s->cairo, b->x, b->y, b->width, b->height);
    cairo_fill(s->cairo);
    cairo_pattern_destroy(colors);
    draw_box(s, b);
    draw_ticks_up(s, &f, 1);
    write_upward(s, s->width - s->size, b->y + b->height / 2, b->height + s->size, title);
}

static double values_width(const double *value, int n, double size)
{
    double width = 0;
    for (int i = 0; i < n; i++) {
        char text[AXIS_TEXT];
        axis_print(text, value[i], 6);
        width = fmax(width, lettering_width(text, size));
    }
    return width;
}

static double map_height(int width)
{
    return floor(0.6 * width);
}

static void draw_map(const struct sheet_of_plot *s, const void *map_)
{
    const struct plot_map *map = map_;
    double height = map_height((int)s->width);
    struct colouring c = color_values(map, (int)fmax(height / (3 * s->size), 2));
    double left = ceil(values_width(map->y, map->ny, s->size) + 3.4 * s->size);
    double scale = ceil(ticks_width(&c.axis, s->size) + 6.5 * s->size);
    struct box box = {left, ceil(s->size), fmax(floor(s->width - left - scale), s->width / 4), height};
    draw_cells(s, map, &c, &box);
    draw_box(s, &box);
    draw_values(s, map, &box);
    draw_titles(s, &box, map->x_title, map->y_title);
    draw_scale(s, &c, &(struct box){box.x + box.width + 2 * s->size, box.y, 1.2 * s->size, height}, map->title);
}

bool plot_map(struct file_log *log, const char *path, const struct plot_map *map)
{
    int width = map->width ? map->width : PLOT_WIDTH;
    double size = letters_of(width);
    return write_plot(log, path, width, ceil(size) + map_height(width) + below_panel * size, draw_map, map);
}
