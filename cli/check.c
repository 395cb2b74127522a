/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft check`: scripts in, their errors and a line about each swatch out. */
#include <config.h>

#include <stdio.h>

#include "cli/command.h"
#include "cli/script.h"
#include "lang/names.h"

static void print_swatch(const char *path, const struct scene *scene)
{
    const struct grid *g = scene->grid;
    printf("%s: %d %s x %d %s, %lld knit, %lld purl", source_called(path), g->columns, names_count(g->columns, "stitch", "stitches"),
           g->rows, names_count(g->rows, "row", "rows"), grid_count(g, STITCH_K), grid_count(g, STITCH_P));
    for (int id = STITCH_P + 1; id < scene->nstitches; id++)
        if (grid_count(g, (stitch_id)id) > 0)
            printf(", %lld %s", grid_count(g, (stitch_id)id), scene->stitch[id].name);
    printf("\n");
}

enum status command_check(const struct options *options)
{
    enum status worst = STATUS_DONE;
    for (int i = 0; i < options->noperands; i++) {
        struct script script;
        enum status status = script_load(&script, options->operand[i], options);
        if (status == STATUS_DONE && !options->quiet)
            print_swatch(options->operand[i], script.scene);
        worst = status > worst ? status : worst;
        script_free(&script);
    }
    return worst;
}
