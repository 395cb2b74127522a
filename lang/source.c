/* SPDX-License-Identifier: GPL-3.0-or-later
 * Reads a whole file or standard input into memory. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/compile.h"
#include "lang/limits.h"

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

const struct source *source_read(struct arena *arena, const char *path, const char **why)
{
    const struct source *source;
    FILE *stream = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");

    if (!stream) {
        *why = strerror(errno);
        return NULL;
    }
    errno = 0;
    source = read_stream(arena, stream, path, why);
    if (stream != stdin)
        fclose(stream);
    return source;
}
