/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft import`: a chart from elsewhere in, a script out. */
#include <config.h>

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "charts/csv.h"
#include "charts/import.h"
#include "charts/kp.h"
#include "cli/command.h"
#include "cli/deliver.h"
#include "lang/limits.h"

static const struct format {
    const char *extension;      /* NULL: any */
    const char *what;           /* as the script's first line names it */
    struct pattern (*read)(struct arena *, struct diag *, const struct source *);
} formats[] = {
    {".csv", "A table of k and p", csv_read},
    {NULL, "A grid of K and P", kp_read},
};

static const struct format *find_format(const char *path)
{
    const struct format *format = formats;
    size_t n = strlen(path);
    while (format->extension &&
           (n < strlen(format->extension) || strcasecmp(path + n - strlen(format->extension), format->extension) != 0))
        format++;
    return format;
}

static bool fits(struct diag *diag, const struct source *source)
{
    if (source->size > LIMIT_FILE)
        diag_error(diag, CODE_LIMIT_FILE, (struct span){source, 0, 0}, "the file is longer than %d bytes", LIMIT_FILE);
    return source->size <= LIMIT_FILE;
}

static enum status import(struct arena *arena, const struct options *options, const struct source *source)
{
    struct diag diag;
    struct pattern pattern = {0};
    const struct format *format = find_format(source->name);
    struct text text = {.arena = arena};
    diag_init(&diag, arena);
    if (fits(&diag, source))
        pattern = format->read(arena, &diag, source);
    diag_print(&diag, stderr, strcmp(options->diagnostics, "json") == 0 ? DIAG_JSON : DIAG_HUMAN,
               options_colored(options));
    if (diag.nerrors)
        return STATUS_SCRIPT;
    import_script(&text, &pattern, source->name, format->what);
    return deliver(options, &text);
}

enum status command_import(const struct options *options)
{
    struct arena arena = {0};
    const char *why = "", *path = options->operand[0];
    const struct source *source = source_read(&arena, path, &why);
    enum status status = STATUS_FILES;
    if (source)
        status = import(&arena, options, source);
    else
        fprintf(stderr, "weft: cannot read '%s': %s\n", path, why);
    arena_free(&arena);
    return status;
}
