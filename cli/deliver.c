/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script's text in, the files of -o or standard output out. */
#include <config.h>

#include "cli/deliver.h"

#include <stdio.h>

#include "output/file.h"

static bool write_text(struct file_log *log, const char *path, const struct text *text)
{
    struct file *file = path ? file_create(log, path) : file_stdout(log);
    if (file)
        file_write(file, text->bytes, text->length);
    return file && file_commit(file);
}

static enum status read_again(const struct text *text, const char *name, const struct grid *grid)
{
    struct arena arena = {0};
    struct diag diag;
    diag_init(&diag, &arena);
    const struct source *source = source_from_text(&arena, name, text->bytes, text->length);
    const struct scene *scene = scene_compile(&arena, &diag, source, NULL);
    bool same = scene && grid_equal(scene->grid, grid);
    if (!same)
        fprintf(stderr, "weft: %s: this fabric cannot be written as a script: %s\n", source_called(name),
                diag.first ? diag.first->text : "it would be read differently");
    arena_free(&arena);
    return same ? STATUS_DONE : STATUS_SCRIPT;
}

enum status deliver_check(const struct options *options)
{
    for (int i = 0; i < options->noutputs; i++)
        if (options_names_kind(options->output[i]))
            return options_wrong(options, "what this writes has one kind, a script: '%s' names another; for a file of this name: -o ./%s",
                                 options->output[i], options->output[i]);
    return STATUS_DONE;
}

enum status deliver_script(const struct options *options, const struct text *text, const char *name,
                           const struct grid *grid)
{
    enum status status = read_again(text, name, grid);
    if (status != STATUS_DONE)
        return status;
    struct file_log log = {0};
    bool done = options->noutputs > 0 || write_text(&log, NULL, text);
    for (int i = 0; i < options->noutputs && done; i++)
        done = write_text(&log, options->output[i], text);
    if (log.error)
        fprintf(stderr, "weft: %s\n", log.error);
    file_log_free(&log);
    return done ? STATUS_DONE : STATUS_FILES;
}
