/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sheet of paper: a format and a size in, strokes and fills by cairo, the
 * bytes of an SVG, PDF or PNG file out. */
#include "drawing/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>

bool canvas_format_of(const char *path, enum canvas_format *format)
{
    static const char *const extension[] = {[CANVAS_SVG] = ".svg", [CANVAS_PDF] = ".pdf", [CANVAS_PNG] = ".png"};
    size_t length = strlen(path);
    for (int i = 0; i < 3; i++)
        if (length > 4 && strcasecmp(path + length - 4, extension[i]) == 0) {
            *format = (enum canvas_format)i;
            return true;
        }
    return false;
}

const char *canvas_refusal(enum canvas_format format, struct canvas_size size)
{
    double width = ceil(size.width * size.scale), height = ceil(size.height * size.scale);
    if (format != CANVAS_PNG)
        return NULL;
    if (width > CANVAS_SIDE_MAX || height > CANVAS_SIDE_MAX)
        return "a PNG has at most 30000 pixels on a side; .svg and .pdf have no limit";
    if (width * height > CANVAS_PIXELS_MAX)
        return "a PNG has at most 100 million pixels; .svg and .pdf have no limit";
    return NULL;
}

/* ---- SVG: names that do not depend on what else the program drew ---- */

/* cairo numbers surfaces and images through the whole run; here they are
 * numbered anew, in the order in which a file names them. */
struct name { const char *text; size_t length; };

/* Length of a name with a number at its end that begins here; *letters: up to the number. */
static size_t name_length(const char *text, size_t *letters)
{
    *letters = strspn(text, "abcdefghijklmnopqrstuvwxyz-");
    size_t digits = strspn(text + *letters, "0123456789");
    return *letters && digits ? *letters + digits : 0;
}

/* The number of a name, new where it was not seen before. */
static int name_number(struct name **seen, int *nseen, struct name name)
{
    for (int i = 0; i < *nseen; i++)
        if ((*seen)[i].length == name.length && memcmp((*seen)[i].text, name.text, name.length) == 0)
            return i + 1;
    struct name *more = realloc(*seen, ((size_t)*nseen + 1) * sizeof **seen);
    if (!more)
        return 0;
    *seen = more;
    more[(*nseen)++] = name;
    return *nseen;
}

/* Sends the text of an SVG, which ends in NUL, with its names numbered anew. */
static void send_renamed(const struct canvas *canvas)
{
    struct name *seen = NULL;
    int nseen = 0;
    const char *sent = canvas->bytes, *at = sent;
    while ((at = strpbrk(at, "#\"")) != NULL) {
        size_t letters;
        bool named = *at == '#' || (at - sent >= 4 && memcmp(at - 4, " id=", 4) == 0);
        size_t length = named ? name_length(at + 1, &letters) : 0;
        at++;
        if (length == 0)
            continue;
        char number[16];
        snprintf(number, sizeof number, "%d", name_number(&seen, &nseen, (struct name){at, length}));
        canvas->sink(canvas->self, sent, (size_t)(at + letters - sent));
        canvas->sink(canvas->self, number, strlen(number));
        sent = at += length;
    }
    canvas->sink(canvas->self, sent, strlen(sent));
    free(seen);
}

/* ---- the stream ---- */

static cairo_status_t keep(void *self, const unsigned char *bytes, unsigned n)
{
    struct canvas *canvas = self;
    if (canvas->room - canvas->nbytes <= n) {
        size_t room = 2 * canvas->room + n + 4096;
        char *more = realloc(canvas->bytes, room);
        if (!more)
            return CAIRO_STATUS_NO_MEMORY;
        canvas->bytes = more;
        canvas->room = room;
    }
    memcpy(canvas->bytes + canvas->nbytes, bytes, n);
    canvas->nbytes += n;
    canvas->bytes[canvas->nbytes] = 0;
    return CAIRO_STATUS_SUCCESS;
}

static cairo_status_t pass_on(void *self, const unsigned char *bytes, unsigned n)
{
    struct canvas *canvas = self;
    canvas->sink(canvas->self, bytes, n);
    return CAIRO_STATUS_SUCCESS;
}

/* ---- the sheet ---- */

/* The date in a PDF: that of SOURCE_DATE_EPOCH, or none. */
static void set_date(cairo_surface_t *surface)
{
    const char *epoch = getenv("SOURCE_DATE_EPOCH");
    char text[32] = "";
    time_t seconds = epoch ? (time_t)strtoll(epoch, NULL, 10) : 0;
    struct tm date;
    if (epoch && gmtime_r(&seconds, &date))
        strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &date);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, text);
}

static cairo_surface_t *make_surface(struct canvas *canvas)
{
    const struct canvas_size *size = &canvas->size;
    cairo_surface_t *surface;
    switch (canvas->format) {
    case CANVAS_SVG:
        surface = cairo_svg_surface_create_for_stream(keep, canvas, size->width, size->height);
        cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PT);
        return surface;
    case CANVAS_PDF:
        surface = cairo_pdf_surface_create_for_stream(pass_on, canvas, size->width, size->height);
        set_date(surface);
        return surface;
    default:
        return cairo_image_surface_create(canvas->clear ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
                                          (int)ceil(size->width * size->scale), (int)ceil(size->height * size->scale));
    }
}

static struct canvas *begin(enum canvas_format format, struct canvas_size size, canvas_sink *sink, void *self, bool clear)
{
    struct canvas *canvas = calloc(1, sizeof *canvas);
    if (!canvas)
        abort();
    *canvas = (struct canvas){.size = size, .format = format, .sink = sink, .self = self, .clear = clear};
    canvas->surface = make_surface(canvas);
    canvas->cairo = cairo_create(canvas->surface);
    if (format == CANVAS_PNG)
        cairo_scale(canvas->cairo, size.scale, size.scale);
    cairo_set_source_rgb(canvas->cairo, 1, 1, 1);
    if (!clear)
        cairo_paint(canvas->cairo);
    cairo_set_source_rgb(canvas->cairo, 0, 0, 0);
    cairo_set_line_cap(canvas->cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(canvas->cairo, CAIRO_LINE_JOIN_ROUND);
    return canvas;
}

struct canvas *canvas_begin(enum canvas_format format, struct canvas_size size, canvas_sink *sink, void *self)
{
    return begin(format, size, sink, self, false);
}

struct canvas *canvas_begin_clear(enum canvas_format format, struct canvas_size size, canvas_sink *sink, void *self)
{
    return begin(format, size, sink, self, true);
}

const char *canvas_end(struct canvas *canvas)
{
    cairo_status_t status = cairo_status(canvas->cairo);
    cairo_destroy(canvas->cairo);
    if (status == CAIRO_STATUS_SUCCESS && canvas->format == CANVAS_PNG)
        status = cairo_surface_write_to_png_stream(canvas->surface, pass_on, canvas);
    cairo_surface_finish(canvas->surface);
    if (status == CAIRO_STATUS_SUCCESS && canvas->format != CANVAS_PNG)
        status = cairo_surface_status(canvas->surface);
    if (status == CAIRO_STATUS_SURFACE_FINISHED)
        status = CAIRO_STATUS_SUCCESS;
    cairo_surface_destroy(canvas->surface);
    if (status == CAIRO_STATUS_SUCCESS && canvas->format == CANVAS_SVG)
        send_renamed(canvas);
    free(canvas->bytes);
    free(canvas);
    return status == CAIRO_STATUS_SUCCESS ? NULL : cairo_status_to_string(status);
}
