/* SPDX-License-Identifier: GPL-3.0-or-later
 * A picture of a folded surface: what an output asks for and a surface in, one
 * .png, .svg or .pdf out. */
#ifndef WEFT_PORTRAIT_H
#define WEFT_PORTRAIT_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

/* The surface as output->picture wants it, with a scale of colours where it is
 * coloured by a field, and its chart where that is asked for, row 1 at the
 * bottom.  In SVG and PDF the surface itself is an image, three pixels a point:
 * sheets that cross each other have no order in which their cells could be
 * drawn.  Chart, scale and letters are lines and areas.  false, with log->error
 * set, if the file could not be written. */
bool portrait_write(struct file_log *log, const struct output *output, const struct scene *scene,
                   const struct surface *surface);

#endif
