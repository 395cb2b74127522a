/* SPDX-License-Identifier: GPL-3.0-or-later
 * The readers that are fuzzed, by name. */
#include "tests/fuzz/target.h"

#include <assert.h>
#include <string.h>

#include "charts/csv.h"
#include "charts/import.h"
#include "charts/knitout.h"
#include "charts/kp.h"
#include "charts/picture.h"
#include "lang/compile.h"
#include "lang/format/format.h"

enum { WORK = 200 * 1000 };     /* steps and stitches, so that an input takes milliseconds */

static const struct scene *compile(struct arena *arena, struct diag *diag, const struct source *source)
{
    return scene_compile(arena, diag, source, &(struct compile_options){.work = WORK});
}

/* What the formatter writes of a good script is one of the same fabric, formatted already. */
static void run_format(struct arena *arena, struct diag *diag, const struct source *source)
{
    const struct scene *before = compile(arena, diag, source), *after;
    size_t length, again;
    const char *text, *twice;

    if (!before)
        return;
    text = format_script(arena, diag, source, &(struct compile_options){.work = WORK}, &length);
    assert(text);
    after = compile(arena, diag, source_from_text(arena, "formatted", text, length));
    assert(after && grid_equal(before->grid, after->grid));
    twice = format_script(arena, diag, source_from_text(arena, "formatted", text, length), &(struct compile_options){.work = WORK}, &again);
    assert(twice && again == length && memcmp(text, twice, length) == 0);
}

static void run_script(struct arena *arena, struct diag *diag, const struct source *source)
{
    compile(arena, diag, source);
}

/* Up to the script that an import writes. */
static void import(struct arena *arena, struct pattern pattern)
{
    struct text text = {.arena = arena};

    if (pattern.grid && pattern.grid->columns <= WORK / pattern.grid->rows)
        import_script(&text, &pattern, "fuzz", "A chart");
}

static void run_kp(struct arena *arena, struct diag *diag, const struct source *source)
{
    import(arena, kp_read(arena, diag, source));
}

static void run_csv(struct arena *arena, struct diag *diag, const struct source *source)
{
    import(arena, csv_read(arena, diag, source));
}

static void run_knitout(struct arena *arena, struct diag *diag, const struct source *source)
{
    import(arena, knitout_read(arena, diag, source));
}

static void run_png(struct arena *arena, struct diag *diag, const struct source *source)
{
    import(arena, picture_read(arena, diag, source, NULL));
}

const struct target targets[] = {
    {"script", run_script}, {"format", run_format}, {"kp", run_kp}, {"csv", run_csv},
    {"knitout", run_knitout}, {"png", run_png}, {NULL, NULL},
};

void target_run(const char *name, const void *bytes, size_t size)
{
    static FILE *nowhere;
    struct arena arena = {0};
    struct diag diag;

    nowhere = nowhere ? nowhere : fopen("/dev/null", "w");
    diag_init(&diag, &arena);
    for (const struct target *target = targets; target->name; target++)
        if (strcmp(target->name, name) == 0)
            target->run(&arena, &diag, source_from_text(&arena, "fuzz", bytes, size));
    diag_print(&diag, nowhere, size % 2 ? DIAG_HUMAN : DIAG_JSON, false);
    arena_free(&arena);
}
