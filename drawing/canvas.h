/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sheet of paper: a format and a size in, strokes and fills by cairo, the
 * bytes of an SVG, PDF or PNG file out.  The same drawing gives the same bytes:
 * no clock, no names that depend on what was drawn before. */
#ifndef WEFT_CANVAS_H
#define WEFT_CANVAS_H

#include <stdbool.h>
#include <stddef.h>

#include <cairo.h>

enum canvas_format { CANVAS_SVG, CANVAS_PDF, CANVAS_PNG };

/* What a PNG may have; more asks for gigabytes of memory. */
enum { CANVAS_SIDE_MAX = 30000, CANVAS_PIXELS_MAX = 100000000 };

/* The size in units of the drawing: points in SVG and PDF; in PNG, `scale`
 * pixels are one unit (fractions of a pixel are rounded up). */
struct canvas_size { double width, height, scale; };

/* Takes the file's bytes, in order; keeps its errors to itself. */
typedef void canvas_sink(void *self, const void *bytes, size_t n);

struct canvas {
    cairo_t           *cairo;       /* (0, 0) is the upper left corner, y downwards; round caps and joins */
    struct canvas_size size;
    enum canvas_format format;
    bool               clear;       /* nothing behind what is drawn */
    cairo_surface_t   *surface;
    canvas_sink       *sink;
    void              *self;
    char              *bytes;       /* (nbytes), of an SVG until it is complete */
    size_t             nbytes, room;
};

/* The format of a path's extension, in any case; false: it is none of them. */
bool canvas_format_of(const char *path, enum canvas_format *format);

/* Could a canvas of this size be made?  NULL, or why not: "a PNG has at most ...". */
const char *canvas_refusal(enum canvas_format format, struct canvas_size size);

/* A white sheet of a size that is not refused; self is handed to the sink.
 * Errors (out of memory) are kept for canvas_end. */
struct canvas *canvas_begin(enum canvas_format format, struct canvas_size size, canvas_sink *sink, void *self);

/* The same without the white: what is not drawn on stays transparent. */
struct canvas *canvas_begin_clear(enum canvas_format format, struct canvas_size size, canvas_sink *sink, void *self);

/* Sends what is left to the sink and frees the canvas.  NULL, or what went
 * wrong; then the bytes are not a complete file. */
const char *canvas_end(struct canvas *canvas);

#endif
