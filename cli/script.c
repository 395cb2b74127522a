/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script's path in, its scene out; what is wrong is said on standard error. */
#include <config.h>

#include "cli/script.h"

#include <stdio.h>
#include <string.h>

#include "cli/progress.h"

/* Is every error one of the command line? */
static bool only_command_line(const struct diag *diag)
{
    for (const struct message *m = diag->first; m; m = m->next)
        if (m->severity == SEVERITY_ERROR && !(m->span.source && m->span.source->command_line))
            return false;
    return diag->nerrors > 0;
}

enum status script_load(struct script *script, const char *path, const struct options *options)
{
    double begun = progress_clock();
    const char *why = "";
    struct diag diag;
    *script = (struct script){0};
    diag_init(&diag, &script->arena);
    diag.errors_only = options->quiet;
    script->source = source_read(&script->arena, path, &why);
    if (!script->source) {
        fprintf(stderr, "weft: cannot read '%s': %s\n", path, why);
        return STATUS_FILES;
    }
    struct compile_options compile = options_compile(options);
    script->scene = scene_compile(&script->arena, &diag, script->source, &compile);
    script->compile_s = progress_clock() - begun;
    diag_print(&diag, stderr, strcmp(options->diagnostics, "json") == 0 ? DIAG_JSON : DIAG_HUMAN,
               options_colored(options));
    return script->scene ? STATUS_DONE : only_command_line(&diag) ? STATUS_USAGE : STATUS_SCRIPT;
}

enum status script_knit_and_purl(const struct scene *scene)
{
    for (int id = STITCH_P + 1; id < scene->nstitches; id++)
        if (grid_count(scene->grid, (stitch_id)id) > 0) {
            fprintf(stderr, "weft: %s: the stitch %s is neither knit nor purl, so this cannot be written\n", source_called(scene->file),
                    scene->stitch[id].name);
            return STATUS_SCRIPT;
        }
    return STATUS_DONE;
}

void script_free(struct script *script)
{
    arena_free(&script->arena);
}
