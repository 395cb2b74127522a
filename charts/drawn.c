/* SPDX-License-Identifier: GPL-3.0-or-later
 * A scene in, its chart with title, numbers, repeat and key out. */
#include "charts/drawn.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/drawn_body.h"
#include "charts/repeat.h"
#include "drawing/lettering.h"

enum {
    CELL       = 16,        /* points of a cell's side where there is room, */
    CELL_LEAST = 2,         /* and at least; */
    BODY       = 720,       /* in between as many as make a page of all */
    PAGE_MOST  = 14400,     /* points of a PDF's side (PDF 1.7, annex C) */
    PIXELS     = 2,         /* of a point in PNG */
    TITLE      = 256,       /* bytes */
    NUMBERS    = 300,       /* on one side */
    HEAVY      = 10         /* cells between heavy lines */
};

/* Where things are, in points. */
struct sheet {
    const struct scene *scene;
    struct drawn_style  style;
    int                 side;                   /* pixels of a stitch's side where the body is an image, else 0 */
    struct repeat       repeat;
    char                title[TITLE];
    double              cell_width, cell_height;
    double              size;                   /* of numbers and of the key's text */
    int                 column_step, row_step;  /* what numbers are given: multiples, and the ones behind of rows */
    struct drawn_box    body;
    double              key;                    /* top of the key */
    double              width, height;
};

/* ---- what is to be drawn ---- */

/* The motif's name, else the file's without folder and extension. */
static void find_title(struct sheet *sheet)
{
    const struct scene *scene = sheet->scene;
    const char *name = scene->title ? scene->title : scene->file ? scene->file : "", *slash = strrchr(name, '/');
    size_t length = strlen(name = slash ? slash + 1 : name);
    if (!scene->title && length > 5 && strcmp(name + length - 5, ".knit") == 0)
        length -= 5;
    if (strcmp(name, "-") != 0)
        snprintf(sheet->title, sizeof sheet->title, "%.*s", (int)length, name);
    for (char *at = sheet->title; *at; at++)
        *at = *at == '_' ? ' ' : *at;
}

static bool has_repeat(const struct sheet *sheet)
{
    return sheet->repeat.columns < sheet->scene->grid->columns || sheet->repeat.rows < sheet->scene->grid->rows;
}

static bool is_used(const struct scene *scene, int stitch)
{
    return memchr(scene->grid->cell, stitch, (size_t)scene->grid->columns * (size_t)scene->grid->rows) != NULL;
}

/* What is worked on the wrong side to show a stitch; -1: nothing is. */
static int worked_as(const struct scene *scene, int stitch)
{
    for (int id = 0; id < scene->nstitches; id++)
        if (scene->stitch[id].ws == stitch)
            return id;
    return -1;
}

static const char *stitch_name(const struct scene *scene, int stitch)
{
    return stitch == STITCH_K ? "knit" : stitch == STITCH_P ? "purl" : scene->stitch[stitch].name;
}

/* The key's line of a stitch: "knit on RS, purl on WS". */
static const char *stitch_text(const struct scene *scene, int stitch, char *text, size_t size)
{
    int back = worked_as(scene, stitch);
    if (scene->round || back == stitch)
        snprintf(text, size, "%s", stitch_name(scene, stitch));
    else if (back < 0)
        snprintf(text, size, "%s on RS", stitch_name(scene, stitch));
    else
        snprintf(text, size, "%s on RS, %s on WS", stitch_name(scene, stitch), stitch_name(scene, back));
    return text;
}

static const char *repeat_text(const struct sheet *sheet, char *text, size_t size)
{
    const struct repeat *r = &sheet->repeat;
    const char *row = sheet->scene->round ? "round" : "row";
    snprintf(text, size, "repeat: %d %s × %d %s%s", r->columns, r->columns == 1 ? "st" : "sts", r->rows, row,
             r->rows == 1 ? "" : "s");
    return text;
}

/* ---- sizes ---- */

static double half_points(double length)
{
    return fmax(round(2 * length) / 2, CELL_LEAST);
}

/* Cells have the gauge's shape, within reason, and are as large as one page
 * allows; those of an image are whole pixels of a PNG. */
static void size_cells(struct sheet *sheet)
{
    const struct grid *g = sheet->scene->grid;
    double shape = sqrt(fmin(fmax(sheet->scene->gauge.width / sheet->scene->gauge.height, 0.5), 2));
    double width = CELL * shape, height = CELL / shape;
    double fit = fmin(1, BODY / fmax(g->columns * width, g->rows * height));
    sheet->cell_width = sheet->side ? sheet->side / (double)PIXELS : half_points(fit * width);
    sheet->cell_height = sheet->side ? sheet->cell_width : half_points(fit * height);
    double longest = fmax(g->columns * sheet->cell_width, g->rows * sheet->cell_height);
    sheet->size = fmin(fmax(longest / 90, fmin(0.5 * CELL, 0.6 * sheet->cell_height)), 1.5 * CELL);
}

static double number_width(const struct sheet *sheet, int number)
{
    char text[16];
    snprintf(text, sizeof text, "%d", number);
    return lettering_width(text, sheet->size);
}

/* The smallest step that leaves so much room for a number, and has not too many
 * of them.  Flat rows are named
 * on two sides: two cells each where all are, else only even steps and the row
 * behind each. */
static int step_of(int cells, double cell, double room, bool flat_rows)
{
    static const int steps[] = {1, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000};
    enum { STEPS = sizeof steps / sizeof *steps };
    if (flat_rows && 2 * cell >= room && cells <= NUMBERS)
        return 1;
    int i = flat_rows ? 2 : 0;
    while (i < STEPS - 1 && (cell * steps[i] < room || cells / steps[i] > NUMBERS))
        i++;
    return steps[i];
}

static void find_steps(struct sheet *sheet)
{
    const struct grid *g = sheet->scene->grid;
    double room = number_width(sheet, g->columns) + 0.4 * sheet->size;
    sheet->column_step = step_of(g->columns, sheet->cell_width, room, false);
    sheet->row_step = step_of(g->rows, sheet->cell_height, 0.95 * sheet->size, !sheet->scene->round);
}

/* ---- the key ---- */

static double key_line(const struct sheet *sheet)
{
    return 2.4 * sheet->size;
}

static struct drawn_box key_cell(const struct sheet *sheet, int line)
{
    double height = 1.8 * sheet->size, width = height * sheet->cell_width / sheet->cell_height;
    return (struct drawn_box){sheet->body.x, sheet->key + line * key_line(sheet), width, height};
}

/* Draws a line of the key, or only measures it; returns where it ends. */
static double key_text(cairo_t *cairo, const struct sheet *sheet, int line, const char *text)
{
    struct drawn_box cell = key_cell(sheet, line);
    double x = cell.x + cell.width + sheet->size;
    if (cairo)
        lettering_draw(cairo, x, cell.y + cell.height / 2 + LETTERING_CAPITAL / 2 * sheet->size, sheet->size,
                       LETTERING_LEFT, text);
    return x + lettering_width(text, sheet->size);
}

static void outline(cairo_t *cairo, struct drawn_box box, double pen)
{
    cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
    cairo_set_line_width(cairo, pen);
    cairo_stroke(cairo);
}

/* Red on white, black among colours. */
static void draw_repeat_box(cairo_t *cairo, const struct sheet *sheet, struct drawn_box box)
{
    cairo_set_source_rgb(cairo, sheet->style.palette ? 0 : 0.8, 0, 0);
    outline(cairo, box, 0.22 * sheet->size);
    cairo_set_source_rgb(cairo, 0, 0, 0);
}

/* In an image own stitches are known by their colours. */
static void draw_key_cell(cairo_t *cairo, const struct sheet *sheet, int stitch, struct drawn_box cell)
{
    struct drawn_style style = sheet->style;
    if (sheet->side && stitch > STITCH_P && !style.palette)
        style.palette = drawn_palette(DYES_PAPER);
    drawn_cell(cairo, sheet->scene, (stitch_id)stitch, cell, &style);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    outline(cairo, cell, 0.06 * sheet->size);
}

/* Draws the key, or only measures it: lines, and the right end of the longest. */
static int do_key(cairo_t *cairo, const struct sheet *sheet, double *right)
{
    const struct scene *scene = sheet->scene;
    char text[2 * TITLE];
    int line = 0;
    *right = 0;
    for (int stitch = 0; stitch < scene->nstitches; stitch++) {
        if (!is_used(scene, stitch))
            continue;
        if (cairo)
            draw_key_cell(cairo, sheet, stitch, key_cell(sheet, line));
        *right = fmax(*right, key_text(cairo, sheet, line++, stitch_text(scene, stitch, text, sizeof text)));
    }
    if (has_repeat(sheet)) {
        if (cairo)
            draw_repeat_box(cairo, sheet, key_cell(sheet, line));
        *right = fmax(*right, key_text(cairo, sheet, line++, repeat_text(sheet, text, sizeof text)));
    }
    return line;
}

/* ---- the sheet ---- */

static double title_size(const struct sheet *sheet)
{
    return 1.5 * sheet->size;
}

static void lay_out(struct sheet *sheet)
{
    const struct grid *g = sheet->scene->grid;
    double margin = 1.5 * sheet->size, gap = 0.7 * sheet->size, number = number_width(sheet, g->rows) + gap, right;
    double left = sheet->scene->round || (g->rows == 1 && !sheet->scene->ws_first) ? 0 : number;
    double top = *sheet->title ? LETTERING_LINE * title_size(sheet) : 0;
    sheet->body = (struct drawn_box){ceil(margin + left), ceil(margin + top), g->columns * sheet->cell_width,
                                     g->rows * sheet->cell_height};
    sheet->key = sheet->body.y + sheet->body.height + 3 * sheet->size;
    int lines = do_key(NULL, sheet, &right);
    right = fmax(right, sheet->body.x + sheet->body.width + number);
    right = fmax(right, sheet->body.x + lettering_width(sheet->title, title_size(sheet)));
    sheet->width = ceil(right + margin);
    sheet->height = ceil(sheet->key + (lines - 1) * key_line(sheet) + 1.8 * sheet->size + margin);
}

static struct sheet make_sheet(const struct scene *scene, const struct chart_look *look)
{
    struct sheet sheet = {
        .scene = scene,
        .style = {look->color ? drawn_palette(look->palette) : NULL, true, look->symbols},
        .repeat = repeat_of(scene->grid),
    };
    sheet.side = drawn_pixels(scene, &sheet.style);
    find_title(&sheet);
    size_cells(&sheet);
    find_steps(&sheet);
    lay_out(&sheet);
    return sheet;
}

/* ---- lines and numbers ---- */

/* Lines between cells, every so many from the lower right corner. */
static void draw_lines(cairo_t *cairo, const struct sheet *sheet, int columns, int rows, double gray, double pen)
{
    const struct grid *g = sheet->scene->grid;
    const struct drawn_box *body = &sheet->body;
    double right = body->x + body->width, down = body->y + body->height;
    for (int i = columns; i < g->columns; i += columns) {
        cairo_move_to(cairo, right - i * sheet->cell_width, body->y);
        cairo_line_to(cairo, right - i * sheet->cell_width, down);
    }
    for (int j = rows; j < g->rows; j += rows) {
        cairo_move_to(cairo, body->x, down - j * sheet->cell_height);
        cairo_line_to(cairo, right, down - j * sheet->cell_height);
    }
    cairo_set_source_rgb(cairo, gray, gray, gray);
    cairo_set_line_width(cairo, pen);
    cairo_stroke(cairo);
    cairo_set_source_rgb(cairo, 0, 0, 0);
}

static void draw_grid(cairo_t *cairo, const struct sheet *sheet)
{
    const struct grid *g = sheet->scene->grid;
    double cell = fmin(sheet->cell_width, sheet->cell_height), pen = fmin(0.05 * sheet->size, 0.1 * cell);
    int columns = sheet->column_step > HEAVY ? sheet->column_step : HEAVY;
    int rows = sheet->row_step > HEAVY ? sheet->row_step : HEAVY;
    if (!sheet->side)
        draw_lines(cairo, sheet, 1, 1, 0.6, pen);
    if (g->columns > 2 * HEAVY || g->rows > 2 * HEAVY)
        draw_lines(cairo, sheet, columns, rows, 0.3, 1.5 * pen);
    outline(cairo, sheet->body, fmin(0.1 * sheet->size, 0.5 * cell));
}

static void draw_number(cairo_t *cairo, const struct sheet *sheet, double x, double y, enum lettering_align align,
                        int number)
{
    char text[16];
    snprintf(text, sizeof text, "%d", number);
    lettering_draw(cairo, x, y, sheet->size, align, text);
}

static void draw_row_numbers(cairo_t *cairo, const struct sheet *sheet)
{
    const struct drawn_box *body = &sheet->body;
    int step = sheet->row_step;
    double gap = 0.7 * sheet->size, left = body->x - gap, right = body->x + body->width + gap;
    for (int row = 1; row <= sheet->scene->grid->rows; row++) {
        bool right_side = scene_right_side(sheet->scene, row);
        double y = body->y + body->height - (row - 0.5) * sheet->cell_height + LETTERING_CAPITAL / 2 * sheet->size;
        if (row % step == 0 || row == 1 || (!sheet->scene->round && row % step == 1))
            draw_number(cairo, sheet, right_side ? right : left, y, right_side ? LETTERING_LEFT : LETTERING_RIGHT, row);
    }
}

/* From the right edge, where a right-side row begins. */
static void draw_stitch_numbers(cairo_t *cairo, const struct sheet *sheet)
{
    const struct drawn_box *body = &sheet->body;
    int step = sheet->column_step;
    double y = body->y + body->height + (0.5 + LETTERING_CAPITAL) * sheet->size;
    double room = number_width(sheet, step) + 0.4 * sheet->size;
    for (int i = 1; i <= sheet->scene->grid->columns; i++)
        if (i % step == 0 || (i == 1 && (step - 1) * sheet->cell_width >= room))
            draw_number(cairo, sheet, body->x + body->width - (i - 0.5) * sheet->cell_width, y, LETTERING_CENTRE, i);
}

/* One repeat, where a right-side row begins. */
static void draw_repeat(cairo_t *cairo, const struct sheet *sheet)
{
    const struct drawn_box *body = &sheet->body;
    double width = sheet->repeat.columns * sheet->cell_width, height = sheet->repeat.rows * sheet->cell_height;
    if (has_repeat(sheet))
        draw_repeat_box(cairo, sheet, (struct drawn_box){body->x + body->width - width, body->y + body->height - height,
                                                         width, height});
}

/* ---- all ---- */

static void draw_sheet(cairo_t *cairo, const struct sheet *sheet)
{
    double right;
    lettering_draw(cairo, sheet->body.x, sheet->body.y - (LETTERING_LINE - LETTERING_CAPITAL) * title_size(sheet),
                   title_size(sheet), LETTERING_LEFT, sheet->title);
    drawn_body(cairo, sheet->scene, sheet->body, &sheet->style);
    draw_grid(cairo, sheet);
    draw_repeat(cairo, sheet);
    draw_row_numbers(cairo, sheet);
    draw_stitch_numbers(cairo, sheet);
    do_key(cairo, sheet, &right);
}

/* A PDF's page has its limit; what is longer is drawn smaller. */
static double scale_of(const struct sheet *sheet, enum canvas_format format)
{
    return format == CANVAS_PDF ? fmin(1, PAGE_MOST / fmax(sheet->width, sheet->height)) : 1;
}

static struct canvas_size size_of(const struct sheet *sheet, double scale)
{
    return (struct canvas_size){sheet->width * scale, sheet->height * scale, PIXELS};
}

const char *drawn_refusal(const struct scene *scene, const struct chart_look *look, enum canvas_format format)
{
    struct sheet sheet = make_sheet(scene, look);
    return canvas_refusal(format, size_of(&sheet, scale_of(&sheet, format)));
}

const char *drawn_chart(const struct scene *scene, const struct chart_look *look, enum canvas_format format,
                        canvas_sink *sink, void *self)
{
    struct sheet sheet = make_sheet(scene, look);
    double scale = scale_of(&sheet, format);
    struct canvas *canvas = canvas_begin(format, size_of(&sheet, scale), sink, self);
    cairo_scale(canvas->cairo, scale, scale);
    draw_sheet(canvas->cairo, &sheet);
    return canvas_end(canvas);
}
