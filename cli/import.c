/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft import`: a chart from elsewhere in, a script out. */
#include <config.h>

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "charts/csv.h"
#include "charts/import.h"
#include "charts/knitout.h"
#include "charts/kp.h"
#include "charts/legend.h"
#include "charts/picture.h"
#include "charts/words.h"
#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/import.h"
#include "lang/limits.h"

/* ---- what can be read ---- */

struct import {
    const struct options    *options;
    const struct source     *source;
    const struct colour_key *key;       /* of a picture; or NULL */
    struct arena            *arena;
    struct diag              diag;
};

typedef struct pattern read_chart(struct import *import);
static read_chart read_csv, read_png, read_kp, read_knitout, read_words, read_legend;

/* What a chart is follows from its first bytes, else from its extension. */
static const struct format {
    const char *extension;      /* NULL: any */
    bool      (*is)(const struct source *source);
    const char *what;           /* as the script's first line names it */
    read_chart *read;
} formats[] = {
    {".png", picture_is_png, "A picture", read_png},
    {".k", knitout_is, "Knitout", read_knitout},
    {".knitout", knitout_is, "Knitout", read_knitout},
    {".csv", csv_is, "A table of k and p", read_csv},
    {".tsv", NULL, "A table of k and p", read_csv},
    {".chart", legend_is, "A chart of signs", read_legend},
    {".ks", words_is, "Written rows", read_words},
    {NULL, NULL, "A grid of K and P", read_kp},
};

static const struct format *find_format(const struct source *source)
{
    const struct format *known = NULL, *format;
    size_t n = strlen(source->name);
    for (format = formats; format->extension; format++) {
        size_t m = strlen(format->extension);
        if (format->is && format->is(source))
            return format;
        if (!known && n >= m && strcasecmp(source->name + n - m, format->extension) == 0)
            known = format;
    }
    return known ? known : format;
}

static struct pattern read_knitout(struct import *import)
{
    return knitout_read(import->arena, &import->diag, import->source);
}

static struct pattern read_kp(struct import *import)
{
    return kp_read(import->arena, &import->diag, import->source);
}

static struct pattern read_words(struct import *import)
{
    return words_read(import->arena, &import->diag, import->source);
}

static struct pattern read_legend(struct import *import)
{
    return legend_read(import->arena, &import->diag, import->source);
}

static struct pattern read_csv(struct import *import)
{
    return csv_read(import->arena, &import->diag, import->source);
}

static struct pattern read_png(struct import *import)
{
    return picture_read(import->arena, &import->diag, import->source, import->key);
}

/* ---- in a script ---- */

/* Is the first line that is no comment one of K and P? */
static bool begins_with_stitches(const struct source *source)
{
    const char *text = source->text;
    while (*text == '#' || *text == '\n' || *text == '\r')
        text += *text == '#' ? strcspn(text, "\r\n") : 1;
    size_t n = strspn(text, "KPkp \t");
    return n > 0 && strpbrk(text, "KPkp") < text + n && strchr("\r\n", text[n]);
}

bool import_chart(struct arena *arena, struct diag *diag, const struct source *source, const struct grid **grid)
{
    struct import import = {.source = source, .arena = arena};
    const struct format *format = find_format(source);
    if (!format->extension && !begins_with_stitches(source))
        return false;
    int errors = diag->nerrors;
    import.diag = *diag;
    struct pattern pattern = source->size <= LIMIT_FILE ? format->read(&import) : (struct pattern){0};
    *diag = import.diag;
    *grid = NULL;
    if (source->size > LIMIT_FILE)
        diag_error(diag, CODE_LIMIT_FILE, (struct span){source, 0, 0}, "the file is longer than %d bytes", LIMIT_FILE);
    else if (pattern.grid && diag->nerrors == errors && pattern.grid->columns <= LIMIT_STITCHES / pattern.across &&
             pattern.grid->rows <= LIMIT_ROWS / pattern.up)
        *grid = grid_tile(arena, pattern.grid, pattern.across, pattern.up);
    return true;
}

/* ---- the command ---- */

/* What a file that is not known by its first bytes is instead, and what to do then; NULL: nothing known. */
static const char *other_format(const struct source *source, const struct format *format, const char **advice)
{
    const char *dot = strrchr(source->name, '.'), *other = source_other_format(source, advice);
    if (other || format->extension || !dot || strcmp(dot, ".knit") != 0 || begins_with_stitches(source))
        return other;
    *advice = "it needs no import: `weft check`, `weft chart`, `weft run` read it";
    return "a script";
}

static struct pattern read_pattern(struct import *import, const struct format *format)
{
    /* Knitout with a first line that is wrong is still meant as such. */
    bool known = (format->is && format->is(import->source)) || (format->read == read_knitout && import->source->text[0] == ';');
    const char *advice = NULL, *other = known ? NULL : other_format(import->source, format, &advice);
    if (other) {
        diag_error(&import->diag, CODE_CHART_MARK, (struct span){import->source, 0, 0}, "this is %s, not a chart", other);
        diag_hint(&import->diag, "%s", advice ? advice : "charts are read from .csv, .png with a pixel for each stitch, .k, "
                  "written rows, and lines of K and P");
        return (struct pattern){0};
    }
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
    bool json = strcmp(options->diagnostics, "json") == 0;
    diag_print(&import->diag, stderr, json ? DIAG_JSON : DIAG_HUMAN, options_colored(options));
    if (import->diag.nerrors)
        return STATUS_SCRIPT;
    if (pattern.remark && !options->quiet && !json)
        fprintf(stderr, "weft: %s: %s\n", import->source->name, pattern.remark);
    import_script(&text, &pattern, import->source->name, format->what);
    const struct grid *whole = grid_tile(import->arena, pattern.grid, pattern.across, pattern.up);
    return deliver_script(options, &text, import->source->name, whole);
}

enum status command_import(const struct options *options)
{
    struct arena arena = {0};
    struct import import = {.options = options, .arena = &arena};
    const char *why = "", *path = options->operand[0];
    enum status status = deliver_check(options);
    if (status != STATUS_DONE)
        return status;
    status = STATUS_FILES;
    diag_init(&import.diag, &arena);
    import.diag.errors_only = options->quiet;
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
