/* SPDX-License-Identifier: GPL-3.0-or-later
 * Reads a whole file or standard input into memory. */
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lang/compile.h"
#include "lang/limits.h"
#include "lang/names.h"

enum { ENTRIES = 10 * 1000 };       /* of a folder that are compared with a misspelt name */

const struct source *source_from_text(struct arena *arena, const char *name, const char *text, size_t size)
{
    struct source *source = arena_new(arena, struct source);

    *source = (struct source){
        .name = arena_copy(arena, name, strlen(name)),
        .text = arena_copy(arena, text, size),
        .size = size,
    };
    return source;
}

const char *source_called(const char *name)
{
    return strcmp(name, "-") == 0 ? "standard input" : name;
}

/* Reads to the end, or a little past the limit: too long is the script's error,
 * found where its other errors are. */
static const struct source *read_stream(struct arena *arena, FILE *stream, const char *path, const char **why)
{
    const struct source *source = NULL;
    size_t size = 0, room = 1 << 16, got;
    char *text = malloc(room), *more;

    while (text && (got = fread(text + size, 1, room - size, stream)) > 0) {
        size += got;
        if (size > LIMIT_FILE)
            break;
        if (size == room) {
            more = realloc(text, room *= 2);
            if (!more)
                free(text);
            text = more;
        }
    }
    if (!text || ferror(stream))
        *why = strerror(text ? errno : ENOMEM);
    else
        source = source_from_text(arena, path, text, size);
    free(text);
    return source;
}

/* ---- misspelt paths ---- */

static bool is_folder(const char *path)
{
    struct stat status;

    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

/* What a folder has that is spelt nearly like a name: a folder, or none. Of several the first by name. */
static const char *nearest_entry(struct arena *arena, const char *before, const char *name, bool folder)
{
    size_t stem = strcspn(name, ".");
    struct nearest best = {.word = name};
    DIR *list = opendir(*before ? before : ".");
    const struct dirent *entry;

    for (int n = 0; list && n < ENTRIES && (entry = readdir(list)); n++) {
        struct nearest one = {.word = name, .distance = stem < 6 ? 2 : stem < 10 ? 3 : 4};

        nearest_offer(&one, entry->d_name);
        if (!one.best || (one.best[0] == '.') != (name[0] == '.') ||
            is_folder(arena_printf(arena, "%s%s", before, one.best)) != folder)
            continue;
        if (best.best && (one.distance > best.distance || (one.distance == best.distance && strcmp(one.best, best.best) > 0)))
            continue;
        best = (struct nearest){.word = name, .best = arena_copy(arena, one.best, strlen(one.best)), .distance = one.distance};
    }
    if (list)
        closedir(list);
    return best.best;
}

const char *source_nearest(struct arena *arena, const char *path)
{
    const char *found = arena_copy(arena, "", 0), *wanted = path;

    /* Folder by folder: what is there is kept, what is not replaced. */
    for (size_t n; *path; path += n) {
        bool folder = path[n = strcspn(path, "/")] == '/';
        const char *name = arena_copy(arena, path, n), *there = arena_printf(arena, "%s%s", found, name);

        n += strspn(path + n, "/");
        if (*name && access(there, F_OK) != 0)
            name = nearest_entry(arena, found, name, folder);
        if (!name)
            return NULL;
        found = arena_printf(arena, "%s%s%s", found, name, folder ? "/" : "");
    }
    return strcmp(found, wanted) == 0 ? NULL : found;
}

const struct source *source_read(struct arena *arena, const char *path, const char **why)
{
    const struct source *source;
    FILE *stream = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");

    if (!stream) {
        const char *reason = strerror(errno), *meant = errno == ENOENT ? source_nearest(arena, path) : NULL;

        *why = meant ? arena_printf(arena, "%s; did you mean '%s'?", reason, meant) : reason;
        return NULL;
    }
    errno = 0;
    source = read_stream(arena, stream, path, why);
    if (stream != stdin)
        fclose(stream);
    return source;
}
