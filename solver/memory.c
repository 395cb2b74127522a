/* SPDX-License-Identifier: GPL-3.0-or-later
 * Sizes in, memory out; the one place where the solver ends for want of it. */
#include "solver/memory.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum { ALIGNMENT = 64, BLAS_BUFFER = 128, OTHERWISE = 256 };     /* bytes, MB, MB */

static void *out_of_memory(size_t count, size_t size)
{
    fprintf(stderr, "weft: out of memory (an array of %zu x %zu bytes)\n", count, size);
    exit(1);
}

bool memory_suffices(int threads)
{
    struct rlimit limit;
    unsigned long long least = OTHERWISE + (unsigned long long)threads * BLAS_BUFFER;

    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >> 20 >= least)
        return true;
    fprintf(stderr, "weft: the address space is limited to %llu MB (ulimit -v); to fold on %d thread%s takes %llu MB\n",
            (unsigned long long)limit.rlim_cur >> 20, threads, threads == 1 ? "" : "s", least);
    return false;
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
