/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft list`: the built-in motifs, or one of them with its chart, out. */
#include <config.h>

#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "lang/names.h"
#include "output/chart.h"

/* "8 + 1": the widths a motif fits are the multiples of the first plus the second. */
static void print_multiple(char text[32], const struct library_motif *motif)
{
    if (motif->plus)
        snprintf(text, 32, "%d + %d", motif->multiple, motif->plus);
    else
        snprintf(text, 32, "%d", motif->multiple);
}

static void print_list(const struct library_motif *motif, int count)
{
    printf("%-22s %-9s %4s  %s\n", "motif", "multiple", "rows", "");
    for (const struct library_motif *m = motif; m < motif + count; m++) {
        char name[64], multiple[32];
        snprintf(name, sizeof name, "%s%s", m->name, m->arguments);
        print_multiple(multiple, m);
        printf("%-22s %-9s %4d  %.*s\n", name, multiple, m->rows, (int)strcspn(m->about, "\n"), m->about);
    }
}

static enum status print_motif(const struct library_motif *m)
{
    static const struct stitch stitch[] = {{.name = "K", .symbol = "k"}, {.name = "P", .symbol = "p"}};
    const struct scene scene = {.grid = m->grid, .nstitches = 2, .stitch = stitch};
    struct file_log log = {0};
    struct file *file = file_stdout(&log);
    char multiple[32];
    if (!file)
        return STATUS_FILES;
    print_multiple(multiple, m);
    file_print(file, "%s%s: %s\n", m->name, m->arguments, m->about);
    file_print(file, "multiple of %s, %d %s, in %s\n\n", multiple, m->rows, names_count(m->rows, "row", "rows"), m->file);
    chart_text(file, &scene);
    bool done = file_commit(file);
    if (log.error)
        fprintf(stderr, "weft: %s\n", log.error);
    file_log_free(&log);
    return done ? STATUS_DONE : STATUS_FILES;
}

/* One motif by its name, or the nearest to it. */
static enum status list_one(const struct options *options, struct arena *arena, const struct library_motif *motif, int count)
{
    const char *name = options->operand[0];
    struct nearest nearest = nearest_to(name);
    for (const struct library_motif *m = motif; m < motif + count; m++) {
        if (strcmp(m->name, name) == 0)
            return print_motif(m);
        nearest_offer(&nearest, m->name);
    }
    const char *known = library_other_name(arena, name);
    if (known)
        return options_wrong(options, "there is no motif '%s'; the library calls it %s", name, known);
    if (nearest.best)
        return options_wrong(options, "there is no motif '%s'; did you mean %s?", name, nearest.best);
    return options_wrong(options, "there is no motif '%s'", name);
}

enum status command_list(const struct options *options)
{
    struct arena arena = {0};
    int count;
    const struct library_motif *motif = library_list(&arena, &count);
    enum status status = STATUS_DONE;
    if (options->noperands > 0)
        status = list_one(options, &arena, motif, count);
    else
        print_list(motif, count);
    arena_free(&arena);
    return status;
}
