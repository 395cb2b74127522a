/* SPDX-License-Identifier: GPL-3.0-or-later
 * A surface with a colour for each cell in, the picture of it as pixels out:
 * orthographic, shaded, what is hidden is hidden. */
#ifndef WEFT_RENDER_H
#define WEFT_RENDER_H

#include <stdbool.h>
#include <stdint.h>

#include "drawing/colours.h"
#include "output/view.h"
#include "solver/surface.h"

/* How a surface lies in a picture. */
struct render {
    const struct surface *surface;
    const struct rgb     *color[2];     /* (ny x nx) of a cell's right side and its wrong side */
    struct view           view;
    double                light[3];     /* unit vector towards the light */
    double                shade;        /* brightness of what the light does not reach, 0..1 */
    bool                  edges;        /* dark lines around the stitches */
    int                   width, height;/* pixels */
    int                   samples;      /* along a pixel's side, of which the mean is taken: 1 or more */
    double                scale;        /* pixels per length */
    double                centre[2];    /* what view_project gives for the picture's middle */
};

/* Fills pixels, 0xAARRGGBB with the colours premultiplied by alpha as cairo's
 * ARGB32 has them, top row first; 0 where there is no fabric.  The right side
 * has its full colour, the wrong side its own a little darker.  false: out of memory. */
bool render_pixels(const struct render *render, uint32_t *pixels);

#endif
