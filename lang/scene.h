/* SPDX-License-Identifier: GPL-3.0-or-later
 * THE CONTRACT between the language and everything after it: one fabric with
 * all that is needed to fold it and to write the result.  A scene is complete
 * and valid: every number is finite and within the range its key allows, every
 * key has a value (its default where the file gives none).  Lengths are in the
 * gauge's unit; the scene and all it points to live in one arena. */
#ifndef WEFT_SCENE_H
#define WEFT_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "lang/grid.h"

/* A kind of stitch: its natural curvatures seen from the right side (z to the
 * viewer, x right, y up): b0 = [[kx, twist], [twist, ky]] against the normal
 * r_x x r_y.  A knit swatch (kx < 0 < ky) curls backward at its sides and
 * forward at top and bottom. */
struct stitch {
    const char *name;       /* "K", "P" or the file's own name */
    const char *symbol;     /* what a text chart prints, one character or more */
    double      kx;         /* 1/length, along a course */
    double      ky;         /* 1/length, along a wale */
    double      twist;      /* 1/length */
    stitch_id   ws;         /* the stitch the right side shows when this one is worked on the wrong side */
};

enum discretisation_kind { DISCRETISATION_PATCH, DISCRETISATION_TRIANGLE };
enum diagonals           { DIAGONALS_UNIFORM, DIAGONALS_ALTERNATING, DIAGONALS_CRISSCROSS };
enum method              { METHOD_AUTO, METHOD_NEWTON, METHOD_PLBFGS, METHOD_LBFGS };
enum edge                { EDGE_LEFT = 1, EDGE_RIGHT = 2, EDGE_TOP = 4, EDGE_BOTTOM = 8, EDGE_ALL = 15 };

struct gauge    { double width, height; };                      /* one stitch, length > 0 */
struct material { double thickness, young, poisson; };          /* length > 0; force/length^2 > 0; (-1, 0.5] */
struct springs  { double stiffness; unsigned edges; };          /* force/length^2 >= 0; set of enum edge */

struct mesh {
    enum discretisation_kind discretisation;
    int                      per_stitch;    /* cells along a stitch's side; 0 = auto */
    enum diagonals           diagonals;     /* triangle only */
};

struct solve {
    double      accuracy;       /* wanted relative error of the energy, > 0 */
    int         steps;          /* growth steps, >= 1 */
    double      noise;          /* amplitude of the starting noise, in thicknesses, >= 0 */
    uint64_t    seed;
    enum method method;
    double      tolerance;      /* largest gradient component, in young * thickness^2, > 0 */
    int         max_iterations; /* in all, >= 1 */
};

/* One value the scene was made with, echoed in the report with where it came from. */
enum origin { FROM_DEFAULT, FROM_FILE, FROM_COMMAND_LINE };

struct setting {
    const char *name;       /* "thickness", "stitch K kx", or a param's own name */
    const char *unit;       /* "length", "1/length", "young*length", ... or "" */
    const char *text;       /* the value, where it is a word or a list; else NULL */
    double      number;     /* the value, where text is NULL */
    enum origin from;
    bool        is_param;
    double      low, high;  /* a param's range; low > high where it has none */
    const char *about;      /* a param's text, or NULL */
};

enum output_kind { OUTPUT_REPORT, OUTPUT_CHART, OUTPUT_PIXELS, OUTPUT_PICTURE, OUTPUT_PLOT, OUTPUT_TABLE,
                   OUTPUT_PVD, OUTPUT_VTP, OUTPUT_OBJ, OUTPUT_PLY, OUTPUT_STL, OUTPUT_GLB,
                   OUTPUT_HTML, OUTPUT_STATE, OUTPUT_KINDS };

enum output_format { FORMAT_BINARY, FORMAT_ASCII };
enum coloring { COLOR_STITCH, COLOR_HEIGHT, COLOR_MEAN, COLOR_GAUSS, COLOR_BENDING, COLOR_STRETCHING };
enum dyes     { DYES_PAPER, DYES_SAFE };

/* How a surface is shown.  Angles in degrees: azimuth about z, from the side of
 * the first row (0) towards the right edge (90); elevation above the fabric's
 * plane, 90 looks at the right side, -90 at the wrong side. */
struct picture {
    double        view[2];      /* azimuth, elevation of the eye */
    double        light[2];     /* of the light as the eye sees it: to the right, upward; (0, 0) is behind the eye */
    int           width;        /* pixels, or points in SVG and PDF */
    enum coloring color;
    enum dyes     palette;      /* of knit and purl */
    bool          edges;        /* lines around the stitches */
    bool          transparent;  /* else white */
    bool          chart;        /* the stitch chart beside the surface */
};

enum graph_show  { GRAPH_ENERGY, GRAPH_CONVERGENCE };
enum graph_form  { GRAPH_FORM_AUTO, GRAPH_CURVES, GRAPH_MAP };
enum graph_scale { GRAPH_AUTO, GRAPH_LINEAR, GRAPH_LOG };

/* What a plot shows. */
struct graph {
    enum graph_show  show;      /* of a run */
    enum graph_form  form;      /* of a sweep; auto: a map of two params, else curves */
    const char      *field;     /* of a sweep: a number by its place in the report, "energy.total" */
    enum graph_scale scale;     /* of the energies or the gradient; auto: linear energies, logarithmic gradients */
    int              width;     /* pixels, or points in SVG and PDF */
};

/* How a chart is drawn, where it is a .svg, .pdf or .png. */
enum purls { PURLS_DOT, PURLS_DASH };

struct chart_look {
    enum purls symbols;         /* of purl stitches */
    bool       color;           /* cells in the palette's colours, else black on white */
    enum dyes  palette;
};

/* One file to write.  Keys of its block that a kind does not know are errors at compile time. */
struct output {
    enum output_kind kind;
    const char      *path;          /* {name} of a param already replaced; as written, relative to the working folder */
    int              per_stitch;    /* samples along a stitch's side, 0 = the kind's default */
    int              format;        /* pvd, vtp: enum output_format */
    struct picture   picture;       /* of the kinds that show the surface */
    struct graph     graph;         /* of plots */
    struct chart_look chart;        /* of drawn charts */
    int              line;          /* of the script, 0 = command line */
};

/* A file the scene was made from. */
struct scene_source {
    const char *path;               /* as opened, "-" for standard input */
    const char *text;
    size_t      size;               /* bytes */
};

struct sweep_axis {
    const char   *param;
    int           npoints;
    const double *point;            /* (npoints) */
};

struct scene {
    const char              *file;          /* as given, "-" for standard input */
    const char              *title;         /* the motif that makes up the swatch, or NULL */
    const struct grid       *grid;
    bool                     round;         /* the script's own rows are rounds: worked from the right side alone */
    bool                     ws_first;      /* the first of them is worked from the wrong side */
    int                      nstitches;
    const struct stitch     *stitch;        /* (nstitches), K and P first */
    struct gauge             gauge;
    struct material          material;
    struct springs           springs;
    struct mesh              mesh;
    struct solve             solve;
    int                      noutputs;
    const struct output     *output;        /* (noutputs), in the order written */
    int                      nsettings;
    const struct setting    *setting;       /* (nsettings), blocks' keys then params */
    int                      naxes;
    const struct sweep_axis *axis;          /* (naxes), the first varies slowest */
    int                      nsources;
    const struct scene_source *source;      /* (nsources), the script first, then the files it uses; none built in */
};

/* Whether a row of the grid, counted from 1, is worked from the right side. */
static inline bool scene_right_side(const struct scene *scene, int row)
{
    return scene->round || (row % 2 == 1) != scene->ws_first;
}

#endif
