/* SPDX-License-Identifier: GPL-3.0-or-later
 * Plots: numbers in; lines over axes with a legend, or a map of coloured cells
 * with its scale, as one .svg, .pdf or .png out.
 *
 * A curve of a field over a param of a sweep, one line for each value of a
 * second param:
 *
 *     struct plot_line line[] = {{"0.2", 5, x, y0}, {"0.5", 5, x, y1}};
 *     struct plot_panel panel = {.x = {"thickness (length)", AXIS_AUTO}, .y = {"energy.total", AXIS_AUTO},
 *                                .legend = "curvature", .ordered = true, .nlines = 2, .line = line};
 *     plot_lines(log, "x.svg", &(struct plot){.npanels = 1, .panel = &panel});
 *
 * A map over two, value[j * nx + i] at x[i], y[j]:
 *
 *     plot_map(log, "x.png", &(struct plot_map){.x_title = "half", .y_title = "thickness (length)",
 *              .title = "energy.total", .scale = AXIS_AUTO, .nx = 4, .ny = 3, .x = x, .y = y, .value = value});
 *
 * What is not finite (a point that failed: NAN) is a gap in a line and a crossed
 * cell in a map, as are zero and less on log scales.  The same numbers give the
 * same bytes. */
#ifndef WEFT_PLOT_H
#define WEFT_PLOT_H

#include "output/axis.h"
#include "output/file.h"

/* Of a file whose width is 0: pixels, or points in SVG and PDF. */
enum { PLOT_WIDTH = 640 };

struct plot_axis {
    const char     *title;      /* with its unit: "energy (force·length)" */
    enum axis_scale scale;
    bool            zero;       /* zero is on it (not on a log scale) */
    bool            whole;      /* whole numbers alone have ticks (not on a log scale) */
};

struct plot_line {
    const char   *name;         /* in the legend; NULL: none */
    int           n;
    const double *x, *y;        /* (n) in the order in which points are joined */
};

struct plot_panel {
    struct plot_axis        x, y;
    const char             *legend;     /* above the names, or NULL */
    bool                    ordered;    /* lines are steps of one quantity: their colours follow a scale */
    int                     nlines;
    const struct plot_line *line;       /* (nlines), later ones on top */
};

/* Panels one below the other. */
struct plot {
    const char              *title;     /* above all, or NULL */
    int                      width;
    int                      npanels;
    const struct plot_panel *panel;
};

struct plot_map {
    const char     *title;              /* of the scale of colours: what the values are */
    int             width;
    const char     *x_title, *y_title;
    enum axis_scale scale;              /* of the values; linear ones of both signs get colours that part at zero */
    int             nx, ny;             /* cells, all of one size; x and y are written below and beside them */
    const double   *x, *y;              /* (nx), (ny) from left to right, from bottom to top */
    const double   *value;              /* (ny x nx) */
};

/* The path's extension says the format.  false, with log->error set, if the file could not be written. */
bool plot_lines(struct file_log *log, const char *path, const struct plot *plot);
bool plot_map(struct file_log *log, const char *path, const struct plot_map *map);

#endif
