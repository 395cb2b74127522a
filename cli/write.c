/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft write`: a script in, written instructions for its swatch out. */
#include <config.h>

#include <stdio.h>

#include "charts/dictionary.h"
#include "charts/written.h"
#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/script.h"

/* Is there more in it than knit, and purl that is knit on the other side, as they are unless a script says so? */
static bool has_own_stitches(const struct scene *scene)
{
    long long plain = grid_count(scene->grid, STITCH_K) + grid_count(scene->grid, STITCH_P);
    return plain < (long long)scene->grid->columns * scene->grid->rows || dictionary_defines(scene->stitch, STITCH_K) ||
           dictionary_defines(scene->stitch, STITCH_P);
}

static enum status write_pattern(struct text *text, const struct scene *scene, bool round)
{
    bool own = has_own_stitches(scene);
    struct dictionary words = own ? dictionary_of(scene->stitch, scene->nstitches) : dictionary_plain;
    int unshown = round ? -1 : dictionary_unshown(&words, scene->grid);
    if (unshown >= 0) {
        fprintf(stderr, "weft: %s: no stitch worked on the wrong side shows the stitch %s (`ws = %s` in another says which; --round writes rounds)\n",
                source_called(scene->file), scene->stitch[unshown].name, scene->stitch[unshown].name);
        return STATUS_SCRIPT;
    }
    if (own)
        dictionary_define(text, scene->stitch, scene->nstitches);
    written_pattern(text, scene->grid, &(struct written_style){.words = &words, .round = round, .ws_first = scene->ws_first, .indent = ""});
    return STATUS_DONE;
}

enum status command_write(const struct options *options)
{
    enum status status = deliver_check(options);
    if (status != STATUS_DONE)
        return status;

    /* The outputs are the text's, not the script's. */
    struct options only_script = *options;
    only_script.noutputs = 0;
    struct script script;
    status = script_load(&script, options->operand[0], &only_script);
    const struct scene *scene = script.scene;
    struct text text = {.arena = &script.arena};
    if (status == STATUS_DONE)
        status = write_pattern(&text, scene, options->round || scene->round);
    if (status == STATUS_DONE)
        status = deliver_script(options, &text, scene->file, scene->grid);
    script_free(&script);
    return status;
}
