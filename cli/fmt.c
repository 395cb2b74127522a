/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft fmt`: scripts in, the same scripts evenly laid out in their place. */
#include <config.h>

#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "lang/format/format.h"
#include "output/file.h"

/* To the file it came from; what came from standard input goes to standard output. */
static enum status deliver(const struct source *source, const char *text, size_t length)
{
    struct file_log log = {0};
    struct file *file = strcmp(source->name, "-") == 0 ? file_stdout(&log) : file_create(&log, source->name);
    if (file)
        file_write(file, text, length);
    bool done = file && file_commit(file);
    if (log.error)
        fprintf(stderr, "weft: %s\n", log.error);
    file_log_free(&log);
    return done ? STATUS_DONE : STATUS_FILES;
}

static enum status format_source(const struct options *options, struct arena *arena, const struct source *source)
{
    struct diag diag;
    size_t length;
    diag_init(&diag, arena);
    struct compile_options compile = options_compile(options);
    const char *text = format_script(arena, &diag, source, &compile, &length);
    if (!text) {
        diag_print(&diag, stderr, strcmp(options->diagnostics, "json") == 0 ? DIAG_JSON : DIAG_HUMAN,
                   options_colored(options));
        return STATUS_SCRIPT;
    }
    if (text == source->text && !options->quiet)
        fprintf(stderr, "weft: '%s' is left as it is: laid out anew, it would read otherwise\n", source->name);
    bool same = length == source->size && memcmp(text, source->text, length) == 0;
    if (options->check) {
        if (!same && !options->quiet)
            printf("%s\n", source->name);
        return same ? STATUS_DONE : STATUS_FAILED;
    }
    return same && strcmp(source->name, "-") != 0 ? STATUS_DONE : deliver(source, text, length);
}

enum status command_fmt(const struct options *options)
{
    enum status worst = STATUS_DONE;
    for (int i = 0; i < options->noperands; i++) {
        struct arena arena = {0};
        const char *why = "";
        const struct source *source = source_read(&arena, options->operand[i], &why);
        enum status status = STATUS_FILES;
        if (source)
            status = format_source(options, &arena, source);
        else
            fprintf(stderr, "weft: cannot read '%s': %s\n", options->operand[i], why);
        worst = status > worst ? status : worst;
        arena_free(&arena);
    }
    return worst;
}
