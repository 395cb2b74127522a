/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft write`: a script in, written instructions for its swatch out. */
#include <config.h>

#include <stdio.h>

#include "charts/written.h"
#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/script.h"

enum status command_write(const struct options *options)
{
    /* The outputs are the text's, not the script's. */
    struct options only_script = *options;
    only_script.noutputs = 0;
    struct script script;
    enum status status = script_load(&script, options->operand[0], &only_script);
    const struct scene *scene = script.scene;
    struct text text = {.arena = &script.arena};
    if (status == STATUS_DONE)
        status = script_knit_and_purl(scene);
    if (status == STATUS_DONE) {
        written_pattern(&text, scene->grid, options->round || scene->round);
        status = deliver_script(options, &text, scene->file, scene->grid);
    }
    script_free(&script);
    return status;
}
