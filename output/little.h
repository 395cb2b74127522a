/* SPDX-License-Identifier: GPL-3.0-or-later
 * Numbers in, their bytes in a file out, the lowest first whatever the machine. */
#ifndef WEFT_LITTLE_H
#define WEFT_LITTLE_H

#include <stdint.h>
#include <string.h>

#include "output/file.h"

static inline void little_bytes(struct file *file, uint64_t value, size_t size)
{
    uint8_t byte[8];
    for (size_t i = 0; i < size; i++)
        byte[i] = (uint8_t)(value >> 8 * i);
    file_write(file, byte, size);
}

static inline void little_u16(struct file *file, uint16_t value) { little_bytes(file, value, 2); }
static inline void little_u32(struct file *file, uint32_t value) { little_bytes(file, value, 4); }

static inline void little_f32(struct file *file, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    little_bytes(file, bits, 4);
}

static inline void little_f64(struct file *file, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    little_bytes(file, bits, 8);
}

#endif
