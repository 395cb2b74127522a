/* SPDX-License-Identifier: GPL-3.0-or-later
 * A stitch in, the colour meshes show it in out. */
#include "output/palette.h"

#include <math.h>

static const struct colour palette[] = {
    {0.80, 0.25, 0.20}, {0.20, 0.35, 0.75}, {0.90, 0.65, 0.15}, {0.25, 0.60, 0.45}, {0.55, 0.35, 0.65}, {0.45, 0.45, 0.45},
};
enum { NCOLOURS = sizeof palette / sizeof palette[0] };

struct colour palette_stitch(int id)
{
    return palette[id < 2 ? id : 2 + (id - 2) % (NCOLOURS - 2)];
}

void palette_bytes(int id, uint8_t rgb[3])
{
    const struct colour c = palette_stitch(id);
    rgb[0] = (uint8_t)lround(255 * c.red);
    rgb[1] = (uint8_t)lround(255 * c.green);
    rgb[2] = (uint8_t)lround(255 * c.blue);
}
