/* SPDX-License-Identifier: GPL-3.0-or-later
 * The page to look at a swatch: growth steps in as they are reached, one
 * self-contained .html out. */
#include <config.h>

#include "output/page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drawing/colours.h"
#include "output/field.h"
#include "output/json.h"
#include "output/page_pack.h"

/* The page in lines, made by the build; lines that begin with @ are filled in.
 * Without npm there are none. */
extern const char *const page_template[];

enum channel { CHANNEL_X, CHANNEL_Y, CHANNEL_Z, CHANNEL_MEAN, CHANNEL_GAUSS, CHANNEL_BENDING, CHANNEL_STRETCHING, NCHANNELS };

static const char *const channel_name[NCHANNELS] = {"x", "y", "z", "mean", "gauss", "bending", "stretching"};

/* What the fold can be coloured by besides its stitches. */
enum { COLORINGS = COLOR_STRETCHING + 1, SCALE_STOPS = 33 };

static const char *const coloring_name[COLORINGS] = {
    [COLOR_HEIGHT] = "height", [COLOR_MEAN] = "mean", [COLOR_GAUSS] = "gauss",
    [COLOR_BENDING] = "bending", [COLOR_STRETCHING] = "stretching",
};
static const char *const palette_name[] = {"paper", "safe"};
static const char *const scale_name[] = {[COLOURS_SEQUENTIAL] = "sequential", [COLOURS_DIVERGING] = "diverging"};

struct page {
    const struct scene *scene;
    int                 per_stitch;
    int                 stride, nseen;      /* of the steps seen, every stride-th is kept */
    int                 nsteps;
    struct fold_step   *step;               /* (nsteps) */
    float              *value[NCHANNELS];   /* (nsteps x points or cells) */
    struct field        range[COLORINGS];   /* of the last step, from COLOR_HEIGHT on; without values */
};

bool page_is_there(void)
{
    return page_template[0];
}

static int nkept(const struct scene *scene)
{
    return scene->solve.steps < PAGE_STEPS ? scene->solve.steps : PAGE_STEPS;
}

int page_per_stitch(const struct scene *scene)
{
    const double most_points = 2e5;         /* in all steps: about 2 MB of page */
    int n = 6;
    while (n > 1 && (n * scene->grid->columns + 1.0) * (n * scene->grid->rows + 1.0) * (nkept(scene) + 1) > most_points)
        n--;
    return n;
}

struct page *page_begin(const struct scene *scene)
{
    struct page *page = page_pack_room(NULL, sizeof *page);
    *page = (struct page){.scene = scene, .stride = (scene->solve.steps + PAGE_STEPS - 1) / PAGE_STEPS};
    return page;
}

void page_end(struct page *page)
{
    if (!page)
        return;
    for (int f = 0; f < NCHANNELS; f++)
        free(page->value[f]);
    free(page->step);
    free(page);
}

/* ---- steps ---- */

bool page_wants(struct page *page, const struct fold_step *step)
{
    return page->nseen++ % page->stride == 0 || step->growth >= 1;
}

int page_nsteps(const struct page *page)
{
    return page->nsteps;
}

static size_t width(const struct page *page, enum channel channel)
{
    return (size_t)page->scene->grid->columns * (size_t)page->per_stitch + (channel <= CHANNEL_Z);
}

static size_t height(const struct page *page, enum channel channel)
{
    return (size_t)page->scene->grid->rows * (size_t)page->per_stitch + (channel <= CHANNEL_Z);
}

static size_t layer(const struct page *page, enum channel channel)
{
    return width(page, channel) * height(page, channel);
}

/* The ranges of colours, as in pictures: of the surface as it is in the end. */
static void find_ranges(struct page *page, const struct surface *s)
{
    for (enum coloring c = COLOR_HEIGHT; c <= COLOR_STRETCHING; c++) {
        page->range[c] = field_of(s, c);
        if (!page->range[c].value)
            page_pack_no_room();
        field_free(&page->range[c]);
    }
}

void page_add(struct page *page, const struct fold_step *step, const struct surface *s)
{
    const double *const from[NCHANNELS] = {s->position, s->position + 1, s->position + 2,
                                         s->mean, s->gauss, s->bending, s->stretching};
    size_t before = (size_t)page->nsteps++;
    page->per_stitch = s->per_stitch;
    page->step = page_pack_room(page->step, (before + 1) * sizeof *page->step);
    page->step[before] = *step;
    for (enum channel f = 0; f < NCHANNELS; f++) {
        size_t n = layer(page, f), stride = f <= CHANNEL_Z ? 3 : 1;
        page->value[f] = page_pack_room(page->value[f], (before + 1) * n * sizeof *page->value[f]);
        for (size_t i = 0; i < n; i++)
            page->value[f][before * n + i] = (float)from[f][i * stride];
    }
    find_ranges(page, s);
}

/* ---- the data ---- */

static struct page_field describe(const struct page *page, enum channel f)
{
    struct page_field field = {width(page, f), height(page, f), (size_t)page->nsteps, INFINITY, -INFINITY};
    for (size_t i = 0; i < layer(page, f) * (size_t)page->nsteps; i++) {
        field.low = fmin(field.low, page->value[f][i]);
        field.high = fmax(field.high, page->value[f][i]);
    }
    return field;
}

static void add_fields(cJSON *root, struct page_pack *pack, const struct page *page)
{
    cJSON *fields = cJSON_AddArrayToObject(root, "fields");
    for (enum channel f = 0; f < NCHANNELS; f++) {
        struct page_field field = describe(page, f);
        cJSON *entry = cJSON_CreateObject();
        json_text(entry, "name", channel_name[f]);
        json_unsigned(entry, "width", field.width);
        json_unsigned(entry, "height", field.height);
        json_number(entry, "low", field.low);
        json_number(entry, "high", field.high);
        cJSON_AddItemToArray(fields, entry);
        page_pack_field(pack, &field, page->value[f]);
    }
}

static void add_stitches(cJSON *root, const struct scene *scene)
{
    cJSON *stitches = cJSON_AddArrayToObject(root, "stitches");
    for (const struct stitch *s = scene->stitch; s < scene->stitch + scene->nstitches; s++) {
        cJSON *entry = cJSON_CreateObject();
        json_text(entry, "name", s->name);
        json_text(entry, "symbol", s->symbol);
        json_integer(entry, "ws", s->ws);
        cJSON_AddItemToArray(stitches, entry);
    }
}

static void add_color(cJSON *array, struct rgb color)
{
    unsigned char byte[3];
    char text[8];
    colours_bytes(color, byte);
    snprintf(text, sizeof text, "#%02x%02x%02x", byte[0], byte[1], byte[2]);
    cJSON_AddItemToArray(array, cJSON_CreateString(text));
}

/* The very colours that pictures and meshes have. */
static void add_colors(cJSON *root, const struct scene *scene)
{
    cJSON *palettes = cJSON_AddObjectToObject(root, "palettes"), *scales = cJSON_AddObjectToObject(root, "scales");
    for (size_t p = 0; p < sizeof palette_name / sizeof *palette_name; p++) {
        cJSON *colors = cJSON_AddArrayToObject(palettes, palette_name[p]);
        for (int id = 0; id < scene->nstitches; id++)
            add_color(colors, colours_stitch(colours_palette(palette_name[p]), id));
    }
    for (enum colours_scale s = COLOURS_SEQUENTIAL; s <= COLOURS_DIVERGING; s++) {
        cJSON *colors = cJSON_AddArrayToObject(scales, scale_name[s]);
        for (int i = 0; i < SCALE_STOPS; i++)
            add_color(colors, colours_at(s, i / (SCALE_STOPS - 1.)));
    }
}

static void add_colorings(cJSON *root, const struct page *page)
{
    cJSON *colorings = cJSON_AddArrayToObject(root, "colorings");
    for (enum coloring c = COLOR_HEIGHT; c <= COLOR_STRETCHING; c++) {
        const struct field *range = &page->range[c];
        cJSON *entry = cJSON_CreateObject();
        json_text(entry, "name", coloring_name[c]);
        json_text(entry, "title", range->title);
        json_text(entry, "scale", scale_name[range->diverging ? COLOURS_DIVERGING : COLOURS_SEQUENTIAL]);
        json_number(entry, "low", range->low);
        json_number(entry, "high", range->high);
        json_text(entry, "ends", range->ends);
        cJSON_AddItemToArray(colorings, entry);
    }
}

static void add_energy(cJSON *object, const struct fold_energy *energy)
{
    json_number(object, "total", energy->total);
    json_number(object, "stretching", energy->stretching);
    json_number(object, "bending", energy->bending);
    json_number(object, "springs", energy->springs);
}

static void add_steps(cJSON *root, const struct page *page)
{
    cJSON *steps = cJSON_AddArrayToObject(root, "steps");
    for (int i = 0; i < page->nsteps; i++) {
        const struct fold_step *s = &page->step[i];
        cJSON *step = cJSON_CreateObject();
        json_number(step, "growth", s->growth);
        add_energy(step, &s->energy);
        cJSON_AddItemToArray(steps, step);
    }
}

static void add_result(cJSON *root, const struct page *page, const struct fold_record *r)
{
    /* Of a run that was stopped nothing is known but its last step. */
    const struct fold_record stopped = {.energy = page->step[page->nsteps - 1].energy, .energy_error = -1,
                                        .extent_x = NAN, .extent_y = NAN, .extent_z = NAN, .max_normal_curvature = NAN};
    cJSON *result = cJSON_AddObjectToObject(root, "result");
    json_text(result, "status", r ? fold_status_name(r->status) : "stopped");
    r = r ? r : &stopped;
    json_text(result, "remark", r->remark ? r->remark : "");
    add_energy(result, &r->energy);
    json_number(result, "error_estimate", r->energy_error < 0 ? NAN : r->energy_error);
    json_number(result, "extent_x", r->extent_x);
    json_number(result, "extent_y", r->extent_y);
    json_number(result, "extent_z", r->extent_z);
    json_number(result, "max_normal_curvature", r->max_normal_curvature);
}

static void add_parameters(cJSON *root, const struct scene *scene)
{
    static const char *const from[] = {
        [FROM_DEFAULT] = "default", [FROM_FILE] = "file", [FROM_COMMAND_LINE] = "command line",
    };
    cJSON *parameters = cJSON_AddArrayToObject(root, "parameters");
    for (const struct setting *s = scene->setting; s < scene->setting + scene->nsettings; s++) {
        cJSON *entry = cJSON_CreateObject();
        json_text(entry, "name", s->name);
        if (s->text)
            json_text(entry, "value", s->text);
        else
            json_number(entry, "value", s->number);
        json_text(entry, "unit", s->unit);
        json_text(entry, "from", from[s->from]);
        json_text(entry, "about", s->about ? s->about : "");
        cJSON_AddItemToArray(parameters, entry);
    }
}

/* The script's name without its folder. */
static const char *title_of(const struct scene *scene)
{
    const char *slash = strrchr(scene->file, '/');
    return strcmp(scene->file, "-") == 0 ? "swatch" : slash ? slash + 1 : scene->file;
}

static char *data_text(const struct page *page, const struct fold_record *record)
{
    const struct scene *scene = page->scene;
    struct page_pack pack = {0};
    cJSON *root = cJSON_CreateObject();
    json_text(root, "weft", PACKAGE_VERSION);
    json_text(root, "title", title_of(scene));
    json_integer(root, "columns", scene->grid->columns);
    json_integer(root, "rows", scene->grid->rows);
    json_integer(root, "per_stitch", page->per_stitch);
    json_integer(root, "every", page->stride);
    json_number(root, "width", scene->gauge.width);
    json_number(root, "height", scene->gauge.height);
    add_stitches(root, scene);
    add_colors(root, scene);
    add_colorings(root, page);
    add_result(root, page, record);
    add_steps(root, page);
    add_parameters(root, scene);
    page_pack_bytes(&pack, scene->grid->cell, (size_t)scene->grid->columns * (size_t)scene->grid->rows);
    add_fields(root, &pack, page);
    char *blob = page_pack_text(&pack);
    cJSON_AddStringToObject(root, "blob", blob);
    free(blob);
    char *text = cJSON_PrintUnformatted(root);
    cJSON_Delete(root);
    return text;
}

/* ---- the file ---- */

/* Text with what HTML would take for its own replaced: by entities, or within
 * JSON by escapes.  (A script element would end at "</script", JSON or not.) */
static void write_escaped(struct file *file, const char *text, bool json)
{
    for (size_t n; *text; text += n) {
        n = strcspn(text, "<&");
        file_write(file, text, n);
        if (text[n])
            file_print(file, json ? "\\u%04x" : "&#%d;", text[n++]);
    }
}

static void write_title(struct file *file, const struct page *page)
{
    cJSON *holder = cJSON_CreateObject();
    json_text(holder, "title", title_of(page->scene));      /* as valid UTF-8 */
    const char *title = cJSON_GetStringValue(cJSON_GetObjectItem(holder, "title"));
    write_escaped(file, title ? title : "", false);
    cJSON_Delete(holder);
}

bool page_write(const struct page *page, struct file_log *log, const char *path, const struct fold_record *record)
{
    char *data = data_text(page, record);
    struct file *file = data ? file_create(log, path) : NULL;
    if (!data)
        file_fail(log, "out of memory");
    for (const char *const *line = page_template; file && *line; line++) {
        if (strcmp(*line, "@title@") == 0)
            write_title(file, page);
        else if (strcmp(*line, "@data@") == 0)
            write_escaped(file, data, true);
        else
            file_write(file, *line, strlen(*line));
        file_write(file, "\n", 1);
    }
    cJSON_free(data);
    return file && file_commit(file);
}
