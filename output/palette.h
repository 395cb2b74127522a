/* SPDX-License-Identifier: GPL-3.0-or-later
 * A stitch in, the colour meshes show it in out. */
#ifndef WEFT_PALETTE_H
#define WEFT_PALETTE_H

#include <stdint.h>

/* sRGB, each in 0..1. */
struct colour { double red, green, blue; };

/* Knit red and purl blue as in the paper's figures; own stitches take turns with the rest. */
struct colour palette_stitch(int id);

/* The same in 0..255. */
void palette_bytes(int id, uint8_t rgb[3]);

#endif
