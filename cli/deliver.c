/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text in, the files of -o or standard output out. */
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

enum status deliver(const struct options *options, const struct text *text)
{
    struct file_log log = {0};
    bool done = options->noutputs > 0 || write_text(&log, NULL, text);
    for (int i = 0; i < options->noutputs && done; i++)
        done = write_text(&log, options->output[i], text);
    if (log.error)
        fprintf(stderr, "weft: %s\n", log.error);
    file_log_free(&log);
    return done ? STATUS_DONE : STATUS_FILES;
}
