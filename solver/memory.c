/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sizes in, memory out; the one place where the solver ends for want of it. */
#include "solver/memory.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 64 };

static void *out_of_memory(size_t count, size_t size)
{
    fprintf(stderr, "weft: out of memory (an array of %zu x %zu bytes)\n", count, size);
    exit(1);
}

void *memory_array(size_t count, size_t size)
{
    if (count > SIZE_MAX / 2 / size)
        return out_of_memory(count, size);
    size_t bytes = (count * size + ALIGNMENT) & ~(size_t)(ALIGNMENT - 1);
    void *array = aligned_alloc(ALIGNMENT, bytes);
    return array ? memset(array, 0, bytes) : out_of_memory(count, size);
}

void *memory_grow(void *array, size_t count, size_t size)
{
    void *grown = count > SIZE_MAX / size ? NULL : realloc(array, count * size);
    return grown ? grown : out_of_memory(count, size);
}
