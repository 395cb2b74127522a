/* SPDX-License-Identifier: GPL-3.0-or-later
 * Compiles a script and prints what became of it: the messages, or the grid
 * as lines of stitch symbols, the first line being the bottom row.
 *
 *     knit_dump [--settings] [--json] [--size] [-D name=value] [-S key=value] [-I dir] [-o out] [-W] FILE
 *
 * Exit status 0, 3 for a script with errors, 4 for a file that cannot be read. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/compile.h"

enum { MANY = 50 };

struct wishes {
    struct compile_override define[MANY], set[MANY];
    const char *include[MANY], *output[MANY];
    struct compile_options options;
    bool settings, json, size;
    const char *file;
};

static struct compile_override split(char *text)
{
    char *equals = strchr(text, '=');

    if (!equals)
        exit(2);
    *equals = '\0';
    return (struct compile_override){text, equals + 1};
}

static void read_option(struct wishes *w, const char *option, char *value)
{
    if (strcmp(option, "-D") == 0)
        w->define[w->options.ndefines++] = split(value);
    else if (strcmp(option, "-S") == 0)
        w->set[w->options.nsets++] = split(value);
    else if (strcmp(option, "-I") == 0)
        w->include[w->options.nincludes++] = value;
    else if (strcmp(option, "-o") == 0)
        w->output[w->options.noutputs++] = value;
    else
        exit(2);
}

static void read_arguments(struct wishes *w, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--settings") == 0)
            w->settings = true;
        else if (strcmp(argv[i], "--json") == 0)
            w->json = true;
        else if (strcmp(argv[i], "--size") == 0)
            w->size = true;
        else if (strcmp(argv[i], "-W") == 0)
            w->options.warnings_are_errors = true;
        else if (argv[i][0] == '-' && argv[i][1] && i + 1 < argc)
            read_option(w, argv[i], argv[i + 1]), i++;
        else
            w->file = argv[i];
    }
    if (!w->file)
        exit(2);
    w->options.define = w->define;
    w->options.set = w->set;
    w->options.include = w->include;
    w->options.output = w->output;
}

static void print_output(const struct output *o)
{
    const struct picture *p = &o->picture;

    printf("output %s %s per_stitch=%d line=%d\n", output_kind_name(o->kind), o->path, o->per_stitch, o->line);
    if (o->kind == OUTPUT_PICTURE)
        printf("    view %g %g, light %g %g, width %d, color %d, palette %d%s%s%s\n", p->view[0], p->view[1],
               p->light[0], p->light[1], p->width, (int)p->color, (int)p->palette, p->edges ? ", edges" : "",
               p->transparent ? ", transparent" : "", p->chart ? ", chart" : "");
    if (o->kind == OUTPUT_CHART)
        printf("    symbols %d, color %d, palette %d\n", (int)o->chart.symbols, o->chart.color, (int)o->chart.palette);
}

static void print_settings(const struct scene *scene)
{
    static const char *const from[] = {"default", "file", "command line"};

    for (int i = 0; i < scene->nsettings; i++) {
        const struct setting *s = &scene->setting[i];

        printf("%s = ", s->name);
        if (s->text)
            printf("%s", s->text);
        else
            printf("%.15g", s->number);
        printf(" [%s] %s%s", s->unit, from[s->from], s->is_param ? ", param" : "");
        if (s->low <= s->high)
            printf(" in %g..%g", s->low, s->high);
        printf(s->about ? " \"%s\"\n" : "\n", s->about);
    }
    for (int i = 0; i < scene->noutputs; i++)
        print_output(&scene->output[i]);
    for (int i = 0; i < scene->naxes; i++) {
        printf("sweep %s:", scene->axis[i].param);
        for (int j = 0; j < scene->axis[i].npoints; j++)
            printf(" %.15g", scene->axis[i].point[j]);
        printf("\n");
    }
}

static void print_grid(const struct scene *scene)
{
    const struct grid *g = scene->grid;

    for (int y = 0; y < g->rows; y++) {
        for (int x = 0; x < g->columns; x++) {
            int id = grid_at(g, x, y);

            fputs(id == STITCH_K ? "K" : id == STITCH_P ? "P" : scene->stitch[id].symbol, stdout);
        }
        putchar('\n');
    }
}

int main(int argc, char **argv)
{
    struct arena arena = {0};
    struct diag diag;
    struct wishes w = {0};
    const struct source *source;
    const struct scene *scene;
    const char *why;

    read_arguments(&w, argc, argv);
    diag_init(&diag, &arena);
    source = source_read(&arena, w.file, &why);
    if (!source) {
        fprintf(stderr, "%s: %s\n", w.file, why);
        return 4;
    }
    scene = scene_compile(&arena, &diag, source, &w.options);
    diag_print(&diag, stdout, w.json ? DIAG_JSON : DIAG_HUMAN, false);
    if (scene && w.settings)
        print_settings(scene);
    else if (scene && w.size)
        printf("%d x %d\n", scene->grid->columns, scene->grid->rows);
    else if (scene)
        print_grid(scene);
    arena_free(&arena);
    return scene ? 0 : 3;
}
