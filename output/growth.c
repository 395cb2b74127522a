/* SPDX-License-Identifier: GPL-3.0-or-later
 * How a fabric grew: the steps of a fold's record in, a plot or a table of them out. */
#include "output/growth.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "output/number.h"
#include "output/plot.h"

/* ---- columns ---- */

enum { GROWTH, ENERGY, STRETCHING, BENDING, SPRINGS, ITERATIONS, GRADIENT_MAX, COLUMNS };

static const char *const names[COLUMNS] = {
    "growth", "energy", "stretching", "bending", "springs", "iterations", "gradient_max",
};

static double value_of(const struct fold_step *s, int column)
{
    const double value[COLUMNS] = {s->growth, s->energy.total, s->energy.stretching, s->energy.bending,
                                   s->energy.springs, s->iterations, s->gradient_max};
    return value[column];
}

/* All steps, column after column; NULL: out of memory. */
static double *gather(const struct fold_record *r)
{
    double *value = malloc(((size_t)r->nsteps * COLUMNS + 1) * sizeof *value);
    for (int c = 0; value && c < COLUMNS; c++)
        for (int i = 0; i < r->nsteps; i++)
            value[c * r->nsteps + i] = value_of(&r->step[i], c);
    return value;
}

/* ---- the plot ---- */

static const struct plot_axis growth_axis = {.title = "growth (of the natural curvatures)", .zero = true};

static struct plot_line line_of(const double *value, int nsteps, int column, const char *name)
{
    return (struct plot_line){name, nsteps, value + GROWTH * nsteps, value + column * nsteps};
}

static bool all_zero(const double *value, int n)
{
    while (n > 0 && value[n - 1] == 0)
        n--;
    return n == 0;
}

static bool plot_energies(struct file_log *log, const struct output *output, const double *value, int n)
{
    bool springs = !all_zero(value + SPRINGS * n, n);
    const struct plot_line line[] = {
        line_of(value, n, ENERGY, "total"),
        line_of(value, n, BENDING, "bending"),
        line_of(value, n, STRETCHING, "stretching"),
        line_of(value, n, SPRINGS, "springs"),
    };
    const struct plot_panel panel = {
        .x = growth_axis, .nlines = springs ? 4 : 3, .line = line,
        .y = {"energy (force·length)", output->graph.scale == GRAPH_LOG ? AXIS_LOG : AXIS_LINEAR, .zero = true},
    };
    return plot_lines(log, output->path, &(struct plot){.width = output->graph.width, .npanels = 1, .panel = &panel});
}

/* Gradients span decades; iterations do not. */
static bool plot_convergence(struct file_log *log, const struct output *output, const double *value, int n)
{
    const struct plot_line gradient = line_of(value, n, GRADIENT_MAX, NULL), iterations = line_of(value, n, ITERATIONS, NULL);
    enum axis_scale scale = output->graph.scale == GRAPH_LINEAR ? AXIS_LINEAR : AXIS_LOG;
    const struct plot_panel panel[] = {
        {.x = growth_axis, .y = {"gradient (young·thickness²)", scale, .zero = true}, .nlines = 1, .line = &gradient},
        {.x = growth_axis, .y = {"iterations", .zero = true, .whole = true}, .nlines = 1, .line = &iterations},
    };
    return plot_lines(log, output->path, &(struct plot){.width = output->graph.width, .npanels = 2, .panel = panel});
}

bool growth_plot(struct file_log *log, const struct output *output, const struct fold_record *record)
{
    double *value = gather(record);
    bool done = value && (output->graph.show == GRAPH_ENERGY ? plot_energies : plot_convergence)(log, output, value, record->nsteps);
    if (!value)
        file_fail(log, "%s: out of memory", output->path);
    free(value);
    return done;
}

/* ---- the table ---- */

bool growth_table(struct file_log *log, const char *path, const struct fold_record *record)
{
    struct file *file = file_create(log, path);
    for (int c = 0; file && c < COLUMNS; c++)
        file_print(file, "%s%s", c ? "," : "", names[c]);
    for (int i = 0; file && i < record->nsteps; i++) {
        for (int c = 0; c < COLUMNS; c++) {
            double value = value_of(&record->step[i], c);
            char text[NUMBER_TEXT] = "";
            if (isfinite(value))
                number_print(text, value);
            file_print(file, "%s%s", c ? "," : "\n", text);
        }
    }
    if (file)
        file_print(file, "\n");
    return file && file_commit(file);
}
