/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft chart`: a script in, its stitch chart out, as text or as a file. */
#include <config.h>

#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/outputs.h"
#include "cli/script.h"
#include "output/chart.h"

static bool print_chart(struct file_log *log, const struct scene *scene, bool grid)
{
    struct file *file = file_stdout(log);
    if (file && grid)
        chart_grid(file, scene);
    else if (file)
        chart_text(file, scene);
    return file && file_commit(file);
}

/* PATH, chart:PATH or pixels:PATH. */
static struct chart_file chart_file(const char *wish)
{
    static const enum output_kind kinds[] = {OUTPUT_CHART, OUTPUT_PIXELS};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const char *name = output_kind_name(kinds[i]);
        size_t n = strlen(name);
        if (strncmp(wish, name, n) == 0 && wish[n] == ':')
            return (struct chart_file){.kind = kinds[i], .path = wish + n + 1};
    }
    return (struct chart_file){.kind = OUTPUT_CHART, .path = wish};
}

/* `foo:x.svg`: of no kind there is. */
static bool names_other_kind(const char *wish)
{
    return chart_file(wish).path == wish && options_names_kind(wish);
}

static enum status write_charts(const struct options *options, const struct scene *scene)
{
    struct file_log log = {0};
    for (int i = 0; i < options->noutputs; i++)
        if (outputs_check_chart(chart_file(options->output[i]), scene) != STATUS_DONE)
            return STATUS_SCRIPT;
    bool done = options->noutputs > 0 || print_chart(&log, scene, options->grid);
    for (int i = 0; i < options->noutputs && done; i++)
        done = outputs_write_chart(&log, chart_file(options->output[i]), scene);
    if (log.error)
        fprintf(stderr, "weft: %s\n", log.error);
    file_log_free(&log);
    return done ? STATUS_DONE : STATUS_FILES;
}

enum status command_chart(const struct options *options)
{
    for (int i = 0; i < options->noutputs; i++)
        if (names_other_kind(options->output[i]) || !outputs_has_chart(chart_file(options->output[i])))
            return options_wrong(options, "a chart is written as .svg, .pdf, .png, .txt, .csv, .k or pixels:x.png, not as '%s'",
                                 options->output[i]);

    /* The outputs of a chart are its own, not the script's. */
    struct options only_script = *options;
    only_script.noutputs = 0;
    struct script script;
    enum status status = script_load(&script, options->operand[0], &only_script);
    if (status == STATUS_DONE)
        status = write_charts(options, script.scene);
    script_free(&script);
    return status;
}
