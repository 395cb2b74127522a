/* SPDX-License-Identifier: GPL-3.0-or-later
 * Allocation that does not return when memory is out. */
#ifndef WEFT_MEMORY_H
#define WEFT_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

/* count zeroed elements of the given size; ends the program with a message and
 * exit status 1 when there is no memory.  Never NULL; aligned for lanes. */
void *memory_array(size_t count, size_t size);

/* The same array with room for count elements. */
void *memory_grow(void *array, size_t count, size_t size);

/* Whether a limit of address space (ulimit -v) leaves room to fold on so many threads; says so where not.
 * OpenBLAS takes a buffer for each and, refused, asks for ever. */
bool memory_suffices(int threads);

#define MEMORY_ARRAY(type, count) ((type *)memory_array((size_t)(count), sizeof(type)))

#endif
