/* SPDX-License-Identifier: GPL-3.0-or-later
 * A plot of a sweep: a field of its points' reports in; curves over a param or a
 * map over two out. */
#include <config.h>

#include "cli/sweep_plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/sweep_table.h"
#include "lang/names.h"
#include "output/plot.h"

static const enum axis_scale scales[] = {
    [GRAPH_AUTO] = AXIS_AUTO, [GRAPH_LINEAR] = AXIS_LINEAR, [GRAPH_LOG] = AXIS_LOG,
};

/* A map unless it is asked for or the second param is not there. */
static bool is_map(const struct sweep *sweep, const struct graph *graph)
{
    return graph->form == GRAPH_MAP || (graph->form == GRAPH_FORM_AUTO && sweep->naxes == 2);
}

/* ---- before any work ---- */

/* Is the field one of the table, or one of those that only a report has? */
static bool is_field(const char *field, struct nearest *nearest)
{
    static const char *const others[] = {"parameters.", "time.", "memory."};
    const char *name;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strncmp(field, others[i], strlen(others[i])) == 0)
            return true;
    for (int i = 0; (name = sweep_table_field(i)) != NULL; i++) {
        if (strcmp(name, field) == 0)
            return true;
        nearest_offer(nearest, name);
    }
    return false;
}

enum status sweep_plot_check(const struct sweep *sweep, const struct output *output)
{
    const struct graph *graph = &output->graph;
    struct nearest nearest = nearest_to(graph->field);
    int least = graph->form == GRAPH_MAP ? 2 : 1;
    if (sweep->naxes >= least && sweep->naxes <= 2 && is_field(graph->field, &nearest))
        return STATUS_DONE;
    fprintf(stderr, "%s:%d: error: ", sweep->script, output->line);
    if (sweep->naxes < least || sweep->naxes > 2)
        fprintf(stderr, "a plot shows %s, and the sweep has %d\n", least == 2 ? "two params as a map" : "one param or two",
                sweep->naxes);
    else if (nearest.best)
        fprintf(stderr, "a report has no number '%s'; did you mean %s?\n", graph->field, nearest.best);
    else
        fprintf(stderr, "a report has no number '%s'; it has what heads the columns of a table\n", graph->field);
    return STATUS_SCRIPT;
}

/* ---- numbers ---- */

/* The field's value at each point, the first param varying slowest; NAN where it did not converge. */
static double *read_values(const struct sweep *sweep, const char *field, struct arena *arena)
{
    double *value = arena_array(arena, double, (size_t)sweep->npoints);
    for (int i = 0; i < sweep->npoints; i++) {
        struct arena own = {0};
        struct sweep_point point = sweep_point_kept(sweep, i + 1, &own);
        cJSON *report = sweep_table_report(sweep, &point, &own);
        value[i] = sweep_table_converged(report) ? sweep_table_number(report, field) : NAN;
        cJSON_Delete(report);
        arena_free(&own);
    }
    return value;
}

/* The param with what the script says it is. */
static const char *title(const struct sweep *sweep, int axis, struct arena *arena)
{
    const char *name = sweep->axis[axis].param;
    for (const struct setting *s = sweep->scene->setting; s < sweep->scene->setting + sweep->scene->nsettings; s++)
        if (s->is_param && s->about && strcmp(s->name, name) == 0)
            return arena_printf(arena, "%s: %s", name, s->about);
    return name;
}

/* ---- drawing ---- */

/* A line over the first param for each value of the second. */
static bool write_curves(const struct sweep *sweep, const struct output *output, struct file_log *log, struct arena *arena)
{
    const struct sweep_axis *x = &sweep->axis[0], *other = sweep->naxes > 1 ? &sweep->axis[1] : NULL;
    const double *value = read_values(sweep, output->graph.field, arena);
    int nlines = other ? other->npoints : 1;
    struct plot_line *line = arena_array(arena, struct plot_line, (size_t)nlines);
    for (int k = 0; k < nlines; k++) {
        double *y = arena_array(arena, double, (size_t)x->npoints);
        for (int i = 0; i < x->npoints; i++)
            y[i] = value[i * nlines + k];
        line[k] = (struct plot_line){other ? arena_printf(arena, "%g", other->point[k]) : NULL, x->npoints, x->point, y};
    }
    struct plot_panel panel = {
        .x = {.title = title(sweep, 0, arena), .scale = AXIS_AUTO},
        .y = {.title = output->graph.field, .scale = scales[output->graph.scale]},
        .legend = other ? other->param : NULL, .ordered = true, .nlines = nlines, .line = line,
    };
    return plot_lines(log, output->path, &(struct plot){.width = output->graph.width, .npanels = 1, .panel = &panel});
}

static bool write_map(const struct sweep *sweep, const struct output *output, struct file_log *log, struct arena *arena)
{
    const struct sweep_axis *x = &sweep->axis[0], *y = &sweep->axis[1];
    const double *value = read_values(sweep, output->graph.field, arena);
    double *cell = arena_array(arena, double, (size_t)sweep->npoints);
    for (int i = 0; i < x->npoints; i++)
        for (int j = 0; j < y->npoints; j++)
            cell[j * x->npoints + i] = value[i * y->npoints + j];
    return plot_map(log, output->path, &(struct plot_map){
        .title = output->graph.field, .width = output->graph.width, .scale = scales[output->graph.scale],
        .x_title = title(sweep, 0, arena), .y_title = title(sweep, 1, arena),
        .nx = x->npoints, .ny = y->npoints, .x = x->point, .y = y->point, .value = cell,
    });
}

bool sweep_plot_write(const struct sweep *sweep, const struct output *output, struct file_log *log)
{
    struct arena arena = {0};
    bool done = (is_map(sweep, &output->graph) ? write_map : write_curves)(sweep, output, log, &arena);
    arena_free(&arena);
    return done;
}
