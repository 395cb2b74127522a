/* SPDX-License-Identifier: GPL-3.0-or-later
 * Region memory: sizes in, zeroed blocks out, all freed at once. */
#include "lang/arena.h"

#include <stdalign.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK = 64 * 1024 };

struct arena_chunk {
    struct arena_chunk *older;
    size_t size, used;
    alignas(max_align_t) unsigned char memory[];
};

/* The one place where running out of memory ends. */
static _Noreturn void out_of_memory(size_t size)
{
    fprintf(stderr, "weft: out of memory (wanted %zu bytes more)\n", size);
    exit(1);
}

static struct arena_chunk *chunk_new(size_t size, struct arena_chunk *older)
{
    struct arena_chunk *chunk = size > SIZE_MAX - sizeof *chunk ? NULL : calloc(1, sizeof *chunk + size);

    if (!chunk)
        out_of_memory(size);
    chunk->older = older;
    chunk->size = size;
    return chunk;
}

void *arena_alloc(struct arena *arena, size_t size)
{
    size_t align = alignof(max_align_t);
    struct arena_chunk *chunk = arena->chunk;
    void *block;

    if (size > SIZE_MAX - align)
        out_of_memory(size);
    size = (size + align - 1) / align * align;
    arena->bytes += size;

    /* Something large gets a chunk of its own behind the current one. */
    if (size > CHUNK / 4 && chunk) {
        chunk->older = chunk_new(size, chunk->older);
        chunk->older->used = size;
        return chunk->older->memory;
    }
    if (!chunk || chunk->size - chunk->used < size)
        chunk = arena->chunk = chunk_new(size > CHUNK ? size : CHUNK, chunk);
    block = chunk->memory + chunk->used;
    chunk->used += size;
    return block;
}

void *arena_calloc(struct arena *arena, size_t count, size_t size)
{
    if (size && count > SIZE_MAX / size)
        out_of_memory(SIZE_MAX);
    return arena_alloc(arena, count * size);
}

char *arena_copy(struct arena *arena, const char *text, size_t length)
{
    char *copy = arena_alloc(arena, length + 1);

    memcpy(copy, text, length);
    return copy;
}

char *arena_vprintf(struct arena *arena, const char *format, va_list arguments)
{
    va_list again;
    char *text;
    int length;

    va_copy(again, arguments);
    length = vsnprintf(NULL, 0, format, again);
    va_end(again);
    if (length < 0)
        length = 0;
    text = arena_alloc(arena, (size_t)length + 1);
    vsnprintf(text, (size_t)length + 1, format, arguments);
    return text;
}

/* A block in a chunk of its own is given back; any other stays until the end. */
static void give_back(struct arena *arena, const void *block)
{
    struct arena_chunk **at = &arena->chunk, *chunk;

    while (*at && (const void *)(*at)->memory != block)
        at = &(*at)->older;
    chunk = *at;
    if (!chunk || at == &arena->chunk)
        return;
    *at = chunk->older;
    arena->bytes -= chunk->size;
    free(chunk);
}

void *arena_larger(struct arena *arena, const void *array, int *room, size_t size)
{
    int more = *room ? 2 * *room : 16;
    void *larger = arena_calloc(arena, (size_t)more, size);

    if (*room)
        memcpy(larger, array, (size_t)*room * size);
    if (*room * size > CHUNK)
        give_back(arena, array);
    *room = more;
    return larger;
}

char *arena_printf(struct arena *arena, const char *format, ...)
{
    va_list arguments;
    char *text;

    va_start(arguments, format);
    text = arena_vprintf(arena, format, arguments);
    va_end(arguments);
    return text;
}

char *arena_number(struct arena *arena, double number)
{
    char text[32];

    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, number);
        if (strtod(text, NULL) == number)
            break;
    }
    return arena_copy(arena, text, strlen(text));
}

void arena_free(struct arena *arena)
{
    while (arena->chunk) {
        struct arena_chunk *older = arena->chunk->older;

        free(arena->chunk);
        arena->chunk = older;
    }
    arena->bytes = 0;
}
