/* SPDX-License-Identifier: GPL-3.0-or-later
 * Files and the names in them: a parsed file in, its declarations by name out;
 * `use` brings in those of other files. */
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/eval.h"
#include "lang/limits.h"

static struct module *module_load(struct eval *, const struct source *, const char *folder, const char *key);

/* Names are interned, so their addresses will do. */
static unsigned bucket_of(const char *name)
{
    return (unsigned)((uintptr_t)name / 32 % 64);
}

struct binding *module_find(const struct module *module, const char *name)
{
    for (struct binding *b = module->bucket[bucket_of(name)]; b; b = b->next)
        if (b->name == name)
            return b;
    return NULL;
}

struct binding *binding_target(struct binding *binding)
{
    while (binding && binding->kind == BINDING_ALIAS)
        binding = binding->target;
    return binding;
}

/* "nothing is called 'x'", with the nearest of all names that can be seen. */
void module_unknown(struct eval *eval, struct where where, const char *name, struct span span)
{
    struct nearest nearest = nearest_to(name);
    const char *known;

    diag_error(eval->diag, CODE_UNKNOWN_NAME, span, "nothing here is called '%s'", name);
    if (!diag_takes_notes(eval->diag))
        return;
    known = library_other_name(eval->arena, name);
    for (const struct local *local = where.local; local; local = local->up)
        nearest_offer(&nearest, local->name);
    for (const struct binding *b = where.module->first; b; b = b->after)
        nearest_offer(&nearest, b->name);
    nearest_offer(&nearest, "K");
    nearest_offer(&nearest, "P");
    builtin_offer(&nearest);
    if (library_source(eval->arena, name) && !module_find(where.module, name))
        diag_hint(eval->diag, "the library has it: `use %s from std`", name);
    else if (known && !nearest.best)
        diag_hint(eval->diag, "the library calls it %s", known);
    else
        diag_did_you_mean(eval->diag, nearest.best);
}

static struct binding *declare(struct eval *eval, struct module *module, enum binding_kind kind,
                               const char *name, struct span span)
{
    struct binding *binding = module_find(module, name);
    unsigned bucket = bucket_of(name);

    if (binding) {
        diag_error(eval->diag, CODE_TWICE, span, "'%s' is already the name of something", name);
        diag_note(eval->diag, binding->span, "here");
        return NULL;
    }
    if (module->nnames == LIMIT_NAMES)
        diag_error(eval->diag, CODE_LIMIT_NAMES, span, "a file may give %d names", LIMIT_NAMES);
    if (module->nnames++ >= LIMIT_NAMES)
        return NULL;
    binding = arena_new(eval->arena, struct binding);
    *binding =
        (struct binding){.name = name, .kind = kind, .span = span, .module = module, .low = 1, .high = 0};
    binding->next = module->bucket[bucket];
    module->bucket[bucket] = binding;
    if (module->last)
        module->last->after = binding;
    else
        module->first = binding;
    module->last = binding;
    return binding;
}

/* ---- use ---- */

static const char *folder_of(struct arena *arena, const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? arena_copy(arena, path, (size_t)(slash - path) + 1) : "";
}

/* The file's identity: the same file by two paths is one. */
static const char *key_of(struct eval *eval, const char *path)
{
    char *real = realpath(path, NULL);
    const char *key = names_intern(eval->names, real ? real : path, strlen(real ? real : path));

    free(real);
    return key;
}

static struct module *loaded(struct eval *eval, const char *key)
{
    for (struct module *module = eval->module; module; module = module->next)
        if (module->key == key)
            return module;
    return NULL;
}

/* A file read twice counts once. */
static void note_used(struct eval *eval, const struct source *source)
{
    struct used_file *file = arena_new(eval->arena, struct used_file);

    for (const struct used_file *f = eval->used; f; f = f->next)
        if (strcmp(f->source->name, source->name) == 0)
            return;
    *file = (struct used_file){source, eval->used};
    eval->used = file;
}

/* The first of the folders that has the file; else *refused is why one that is there cannot be read, or NULL. */
static const struct source *find_file(struct eval *eval, const struct module *module, const char *name,
                                      const char **path, const char **refused)
{
    const char *why;

    for (int i = -1; i < eval->nincludes; i++) {
        const char *folder = i < 0 ? module->folder : eval->include[i];
        const char *between = i < 0 || !*folder || folder[strlen(folder) - 1] == '/' ? "" : "/";
        const struct source *source;

        if (!folder || (*name == '/' && i >= 0))
            continue;
        *path = *name == '/' ? name : arena_printf(eval->arena, "%s%s%s", folder, between, name);
        source = source_read(eval->arena, *path, &why);
        if (source) {
            note_used(eval, source);
            return source;
        }
        if (!*refused && strncmp(why, strerror(ENOENT), strlen(strerror(ENOENT))) != 0)
            *refused = why;
    }
    return NULL;
}

/* A file of nearly this name in one of the folders, named from there; or NULL. */
static const char *nearest_file(struct eval *eval, const struct module *module, const char *name)
{
    const char *found = NULL;

    for (int i = -1; i < eval->nincludes && !found; i++) {
        const char *folder = i < 0 ? module->folder : eval->include[i], *before;

        if (!folder || (*name == '/' && i >= 0))
            continue;
        before = *name == '/' || !*folder ? "" : arena_printf(eval->arena, "%s%s", folder, folder[strlen(folder) - 1] == '/' ? "" : "/");
        found = source_nearest(eval->arena, arena_printf(eval->arena, "%s%s", before, name));
        if (found && strncmp(found, before, strlen(before)) == 0)
            found += strlen(before);
    }
    return found;
}

static void not_found(struct eval *eval, const struct stmt *stmt, const struct module *module, const char *refused)
{
    if (refused) {
        diag_error(eval->diag, CODE_USE, stmt->use.file_span, "cannot read '%s': %s", stmt->use.file, refused);
        return;
    }
    diag_error(eval->diag, CODE_USE, stmt->use.file_span, "there is no file '%s'", stmt->use.file);
    if (!module->folder || !diag_takes_notes(eval->diag))
        return;
    diag_did_you_mean(eval->diag, nearest_file(eval, module, stmt->use.file));
    diag_note(eval->diag, (struct span){0}, "looked in %s%s",
              *module->folder ? module->folder : "this folder",
              eval->nincludes ? ", and in the folders of -I and WEFT_PATH" : "");
}

/* Errors in a used file point at the `use`, too. */
static struct module *load_for(struct eval *eval, struct span used, const struct source *source,
                               const char *folder, const char *key)
{
    struct context context = {used, "in a file used here", eval->diag->context};
    struct module *module;

    eval->diag->context = &context;
    module = module_load(eval, source, folder, key);
    eval->diag->context = context.up;
    return module;
}

/* `"charts/diamond.csv"` without `as`: diamond. */
static struct name_at chart_name(struct eval *eval, const struct stmt *stmt)
{
    const char *slash = strrchr(stmt->use.file, '/'), *stem = slash ? slash + 1 : stmt->use.file;
    size_t n = strspn(stem, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");

    if (stmt->use.as.name)
        return stmt->use.as;
    if (n && n <= LIMIT_NAME && stem[n] == '.' && !(*stem >= '0' && *stem <= '9'))
        return (struct name_at){names_intern(eval->names, stem, n), stmt->use.file_span, NULL};
    diag_error(eval->diag, CODE_USE, stmt->use.file_span, "the chart needs a name");
    diag_hint(eval->diag, "`use \"%s\" as NAME`", stmt->use.file);
    return (struct name_at){0};
}

/* A chart file gives one fabric. True if it was one. */
static bool use_chart(struct eval *eval, struct module *user, const struct stmt *stmt, const struct source *source)
{
    struct context context = {stmt->span, "in a chart used here", eval->diag->context};
    const struct grid *grid = NULL;
    struct binding *binding;
    struct name_at name;
    bool is_chart;

    eval->diag->context = &context;
    is_chart = eval->chart && eval->chart(eval->arena, eval->diag, source, &grid);
    eval->diag->context = context.up;
    if (!is_chart)
        return false;
    if (stmt->use.names) {
        diag_error(eval->diag, CODE_USE, stmt->use.names->span, "a chart file has no names to choose from");
        diag_hint(eval->diag, "`use \"%s\" as %s`", stmt->use.file, stmt->use.names->name);
        return true;
    }
    if (!grid || !fabric_size(eval, stmt->use.file_span, grid->columns, grid->rows))
        return true;
    name = chart_name(eval, stmt);
    binding = name.name ? declare(eval, user, BINDING_LET, name.name, name.span) : NULL;
    if (binding) {
        binding->state = DONE;
        binding->value = value_grid(grid);
    }
    return true;
}

/* The file a `use` names, parsed and with its own names declared; NULL also for a chart. */
static struct module *used_module(struct eval *eval, struct module *user, const struct stmt *stmt)
{
    const struct source *source;
    struct module *module;
    const char *path = NULL, *refused = NULL, *key;

    source = find_file(eval, user, stmt->use.file, &path, &refused);
    if (!source) {
        not_found(eval, stmt, user, refused);
        return NULL;
    }
    if (use_chart(eval, user, stmt, source))
        return NULL;
    key = key_of(eval, path);
    module = loaded(eval, key);
    if (!module)
        return load_for(eval, stmt->span, source, folder_of(eval->arena, path), key);
    if (!module->loading)
        return module;
    diag_error(eval->diag, CODE_USE_CYCLE, stmt->use.file_span,
               "'%s' is being read already: files use each other in a circle", stmt->use.file);
    return NULL;
}

/* The built-in file that has a motif. */
static struct module *library_module(struct eval *eval, const char *name, struct span used)
{
    const struct source *source = library_source(eval->arena, name);
    struct module *module;
    const char *key;

    if (!source)
        return NULL;
    key = names_intern(eval->names, source->name, strlen(source->name));
    module = loaded(eval, key);
    return module ? module : load_for(eval, used, source, NULL, key);
}

static void unknown_motif(struct eval *eval, const struct name_at *name, const struct module *module,
                          const char *file)
{
    struct nearest nearest = nearest_to(name->name);
    const char *known;

    diag_error(eval->diag, CODE_USE, name->span, "%s has no '%s'", module ? file : "the library", name->name);
    if (!diag_takes_notes(eval->diag))
        return;
    known = module ? NULL : library_other_name(eval->arena, name->name);
    if (module)
        for (const struct binding *b = module->first; b; b = b->after)
            nearest_offer(&nearest, b->name);
    else
        library_offer(&nearest);
    if (known)
        diag_hint(eval->diag, "the library calls it %s", known);
    else
        diag_did_you_mean(eval->diag, nearest.best);
}

/* Names that knitters in different countries give to different things. */
static void warn_ambiguous(struct eval *eval, const struct name_at *name)
{
    if (strcmp(name->name, "moss") != 0)
        return;
    diag_warning(
        eval->diag, CODE_AMBIGUOUS_NAME, name->span,
        "'moss' is two patterns: in Britain what others call seed, in America a pattern of four rows");
    diag_hint(eval->diag, "taken as 'seed' (British moss); the American one is 'moss_us'");
}

static void use_names(struct eval *eval, struct module *user, const struct stmt *stmt)
{
    struct module *module = stmt->use.std ? NULL : used_module(eval, user, stmt);

    if (!stmt->use.std && !module)
        return;
    for (const struct name_at *name = stmt->use.names; name; name = name->next) {
        struct module *from = stmt->use.std ? library_module(eval, name->name, stmt->span) : module;
        struct binding *target = from ? module_find(from, name->name) : NULL, *binding;

        if (!target) {
            unknown_motif(eval, name, module, stmt->use.file);
            continue;
        }
        if (stmt->use.std)
            warn_ambiguous(eval, name);
        binding = declare(eval, user, BINDING_ALIAS, name->name, name->span);
        if (binding)
            binding->target = target;
    }
}

/* All names of a file, or the file under one name. */
static void use_file(struct eval *eval, struct module *user, const struct stmt *stmt)
{
    struct module *module = used_module(eval, user, stmt);
    struct binding *binding;

    if (!module)
        return;
    if (stmt->use.as.name) {
        binding = declare(eval, user, BINDING_SPACE, stmt->use.as.name, stmt->use.as.span);
        if (binding)
            binding->module = module;
        return;
    }
    for (struct binding *b = module->first; b; b = b->after) {
        /* What it got from elsewhere, and names like _this, are its own business. */
        if (b->kind == BINDING_SPACE || b->kind == BINDING_ALIAS || *b->name == '_')
            continue;
        binding = declare(eval, user, BINDING_ALIAS, b->name, stmt->span);
        if (binding)
            binding->target = b;
    }
}

static void use(struct eval *eval, struct module *module, const struct stmt *stmt)
{
    const char *library = stmt->use.file;

    if (stmt->use.std && strcmp(library, "std") != 0) {
        diag_error(eval->diag, CODE_USE, stmt->use.file_span, "'%s' is no library; the built-in one is 'std'",
                   library);
        diag_hint(eval->diag, "a file's name stands in quotes: `from \"%s.knit\"`", library);
        return;
    }
    if (eval->include_depth >= LIMIT_INCLUDES) {
        diag_error(eval->diag, CODE_LIMIT_INCLUDES, stmt->span, "files use each other more than %d deep",
                   LIMIT_INCLUDES);
        return;
    }
    eval->include_depth++;
    if (stmt->use.names)
        use_names(eval, module, stmt);
    else
        use_file(eval, module, stmt);
    eval->include_depth--;
}

/* ---- loading ---- */

static void declare_names(struct eval *eval, struct module *module)
{
    static const struct {
        enum stmt_kind stmt;
        enum binding_kind binding;
    } kinds[] = {{STMT_LET, BINDING_LET},
                 {STMT_PARAM, BINDING_PARAM},
                 {STMT_MOTIF, BINDING_MOTIF},
                 {STMT_STITCH, BINDING_STITCH}};

    for (const struct stmt *stmt = module->file; stmt; stmt = stmt->next) {
        if (stmt->kind == STMT_USE)
            use(eval, module, stmt);
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
            const struct name_at *name = stmt->kind == STMT_MOTIF    ? &stmt->motif.name
                                         : stmt->kind == STMT_STITCH ? &stmt->stitch.name
                                         : stmt->kind == STMT_PARAM  ? &stmt->param.name
                                                                     : &stmt->let.name;
            struct binding *binding;

            if (stmt->kind != kinds[i].stmt)
                continue;
            binding = declare(eval, module, kinds[i].binding, name->name, name->span);
            if (binding)
                binding->stmt = stmt;
        }
    }
}

static struct module *module_load(struct eval *eval, const struct source *source, const char *folder,
                                  const char *key)
{
    struct module *module = arena_new(eval->arena, struct module);
    struct parse parse = parse_read(eval->arena, eval->diag, eval->names, source);

    *module = (struct module){
        .source = source, .folder = folder, .key = key, .loading = true, .next = eval->module};
    eval->module = module;
    if (!eval->main)
        eval->main = module;
    module->file = parse_statements(&parse);
    module->facts = parse.facts;
    declare_names(eval, module);
    stitches_declare(eval, module);
    module->loading = false;
    return module;
}

/* The file that is compiled: the first, and nobody's use. */
struct module *module_main(struct eval *eval, const struct source *source, const char *folder)
{
    return module_load(eval, source, folder, key_of(eval, source->name));
}
