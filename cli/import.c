/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft import`: a chart from elsewhere in, a script out. */
#include <config.h>

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "charts/csv.h"
#include "charts/import.h"
#include "charts/kp.h"
#include "charts/picture.h"
#include "cli/command.h"
#include "cli/deliver.h"
#include "lang/limits.h"

/* ---- what can be read ---- */

struct import {
    const struct options    *options;
    const struct source     *source;
    const struct colour_key *key;       /* of a picture; NULL: black and white */
    struct arena            *arena;
    struct diag              diag;
};

typedef struct pattern read_chart(struct import *import);
static read_chart read_csv, read_png, read_kp;

static const struct format {
    const char *extension;      /* NULL: any */
    const char *what;           /* as the script's first line names it */
    read_chart *read;
} formats[] = {
    {".png", "A picture", read_png},
    {".csv", "A table of k and p", read_csv},
    {NULL, "A grid of K and P", read_kp},
};

/* By the extension; a picture also by its first bytes. */
static const struct format *find_format(const struct source *source)
{
    const struct format *format = formats;
    size_t n = strlen(source->name);
    if (picture_is_png(source))
        return format;
    for (; format->extension; format++) {
        size_t m = strlen(format->extension);
        if (n >= m && strcasecmp(source->name + n - m, format->extension) == 0)
            break;
    }
    return format;
}

static struct pattern read_kp(struct import *import)
{
    return kp_read(import->arena, &import->diag, import->source);
}

static struct pattern read_csv(struct import *import)
{
    return csv_read(import->arena, &import->diag, import->source);
}

static struct pattern read_png(struct import *import)
{
    const struct colour_key *key = import->key ? import->key : &picture_black_and_white;
    struct pattern pattern = picture_read(import->arena, &import->diag, import->source, key);
    if (pattern.grid && !import->key && !import->options->quiet)
        fprintf(stderr, "weft: %s: black is taken as knit, white as purl\n", import->source->name);
    return pattern;
}

/* ---- the command ---- */

static struct pattern read_pattern(struct import *import, const struct format *format)
{
    if (import->source->size <= LIMIT_FILE)
        return format->read(import);
    diag_error(&import->diag, CODE_LIMIT_FILE, (struct span){import->source, 0, 0}, "the file is longer than %d bytes",
               LIMIT_FILE);
    return (struct pattern){0};
}

static enum status import_source(struct import *import)
{
    const struct options *options = import->options;
    const struct format *format = find_format(import->source);
    struct text text = {.arena = import->arena};
    if (import->key && format->read != read_png)
        return options_wrong(options, "--key is for pictures; '%s' is none", import->source->name);
    struct pattern pattern = read_pattern(import, format);
    diag_print(&import->diag, stderr, strcmp(options->diagnostics, "json") == 0 ? DIAG_JSON : DIAG_HUMAN,
               options_colored(options));
    if (import->diag.nerrors)
        return STATUS_SCRIPT;
    import_script(&text, &pattern, import->source->name, format->what);
    const struct grid *whole = grid_tile(import->arena, pattern.grid, pattern.across, pattern.up);
    return deliver_script(options, &text, import->source->name, whole);
}

enum status command_import(const struct options *options)
{
    struct arena arena = {0};
    struct import import = {.options = options, .arena = &arena};
    const char *why = "", *path = options->operand[0];
    enum status status = STATUS_FILES;
    diag_init(&import.diag, &arena);
    if (options->key)
        import.key = picture_key(&arena, options->key, &why);
    if (options->key && !import.key)
        status = options_wrong(options, "--key: %s", why);
    else if ((import.source = source_read(&arena, path, &why)))
        status = import_source(&import);
    else
        fprintf(stderr, "weft: cannot read '%s': %s\n", path, why);
    arena_free(&arena);
    return status;
}
