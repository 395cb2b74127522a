/* SPDX-License-Identifier: GPL-3.0-or-later
 * Region memory: everything the front end makes lives in one arena and goes
 * with it.  A zero-initialised struct arena is an empty one. */
#ifndef WEFT_ARENA_H
#define WEFT_ARENA_H

#include <stdarg.h>
#include <stddef.h>

struct arena_chunk;

struct arena {
    struct arena_chunk *chunk;      /* the newest; older ones hang behind it */
    size_t              bytes;      /* handed out */
};

/* Zeroed memory, aligned for any type.  Never NULL: out of memory ends the
 * program with a sentence. */
void *arena_alloc(struct arena *, size_t size);
void *arena_calloc(struct arena *, size_t count, size_t size);

#define arena_new(arena, type) ((type *)arena_alloc((arena), sizeof(type)))
#define arena_array(arena, type, count) ((type *)arena_calloc((arena), (count), sizeof(type)))

/* An array of `room` elements, in place of it with room for more, which `room` is then. */
void *arena_larger(struct arena *, const void *array, int *room, size_t size);

/* NUL-terminated copies. */
char *arena_copy(struct arena *, const char *text, size_t length);
char *arena_printf(struct arena *, const char *format, ...) __attribute__((format(printf, 2, 3)));
char *arena_vprintf(struct arena *, const char *format, va_list) __attribute__((format(printf, 2, 0)));

/* A finite number, six digits or as many more as make it read back exactly. */
char *arena_number(struct arena *, double number);

/* Gives everything back; the arena is empty and usable again. */
void arena_free(struct arena *);

#endif
