/* SPDX-License-Identifier: GPL-3.0-or-later
 * The built-in library: a motif's name in, the source that has it out. */
#include "lang/library.h"

#include <assert.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/eval.h"

static const struct source *source_of(struct arena *arena, const struct library_file *file)
{
    size_t size = 0, at = 0;
    char *text;
    struct source *source = arena_new(arena, struct source);

    for (int i = 0; file->line[i]; i++)
        size += strlen(file->line[i]) + 1;
    text = arena_alloc(arena, size + 1);
    for (int i = 0; file->line[i]; i++) {
        size_t length = strlen(file->line[i]);

        memcpy(text + at, file->line[i], length);
        text[at + length] = '\n';
        at += length + 1;
    }
    *source = (struct source){.name = file->name, .text = text, .size = size};
    return source;
}

static const struct library_name *name_find(const char *name)
{
    for (int i = 0; i < library_nnames; i++)
        if (strcmp(library_names[i].name, name) == 0)
            return &library_names[i];
    return NULL;
}

const struct source *library_source(struct arena *arena, const char *motif)
{
    const struct library_name *name = name_find(motif);

    return name ? source_of(arena, &library_files[name->file]) : NULL;
}

void library_offer(struct nearest *nearest)
{
    for (int i = 0; i < library_nnames; i++)
        nearest_offer(nearest, library_names[i].name);
}

/* ---- other names ---- */

/* Whether text begins with the name and ends there; a blank is as good as _, "stitch" behind it says nothing. */
static bool is_called(const char *text, const char *name)
{
    while (*name && (tolower((unsigned char)*text) == tolower((unsigned char)*name) || (*text == ' ' && *name == '_'))) {
        text++;
        name++;
    }
    if (strcasecmp(name, "_stitch") == 0 || strcasecmp(name, " stitch") == 0)
        name += strlen(name);
    return !*name && (!*text || strchr(",;.\n", *text));
}

/* Names stand behind a colon, with commas between: `also: spot`, `in Britain: moss`. */
static bool goes_by(const char *about, const char *name)
{
    for (const char *list = strchr(about, ':'); list; list = strchr(list + 1, ':'))
        for (const char *at = list + 1; *at == ' '; at += *at == ',') {
            if (is_called(at + 1, name))
                return true;
            at += strcspn(at, ",;.\n");
        }
    return false;
}

const char *library_other_name(struct arena *arena, const char *name)
{
    const char *all = NULL;

    for (const struct library_name *n = library_names; n < library_names + library_nnames; n++)
        if (is_called(n->name, name) || goes_by(n->about, name))
            all = all ? arena_printf(arena, "%s or %s", all, n->name) : n->name;
    return all;
}

/* ---- all motifs ---- */

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct library_motif *)a)->name, ((const struct library_motif *)b)->name);
}

/* One motif with its default arguments. */
static void describe(struct eval *eval, const struct library_name *name, struct library_motif *motif)
{
    const struct source *source = source_of(eval->arena, &library_files[name->file]);
    struct module *module = module_main(eval, source, NULL);
    struct binding *binding = module_find(module, names_intern(eval->names, name->name, strlen(name->name)));
    struct value value = eval_binding(eval, binding, (struct span){0});

    *motif = (struct library_motif){
        .name = name->name,
        .arguments = name->arguments,
        .about = name->about,
        .file = library_files[name->file].name,
        .grid = fabric_of(eval, value, (struct span){0}),
    };
    assert(motif->grid && !eval->diag->nerrors);
    motif->multiple = value.kind == VALUE_MOTIF ? (int)value.motif->multiple : motif->grid->columns;
    motif->plus = value.kind == VALUE_MOTIF ? (int)value.motif->plus : 0;
    motif->rows = motif->grid->rows;
}

const struct library_motif *library_list(struct arena *arena, int *count)
{
    struct library_motif *motif = arena_array(arena, struct library_motif, (size_t)library_nnames);
    struct eval *eval = arena_new(arena, struct eval);
    struct diag *diag = arena_new(arena, struct diag);

    diag_init(diag, arena);
    for (int i = 0; i < library_nnames; i++) {
        eval_init(eval, arena, diag);
        describe(eval, &library_names[i], &motif[i]);
    }
    qsort(motif, (size_t)library_nnames, sizeof *motif, by_name);
    *count = library_nnames;
    return motif;
}
