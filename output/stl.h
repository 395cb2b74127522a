/* SPDX-License-Identifier: GPL-3.0-or-later
 * STL, as printers and slicers read it: a surface in, one binary .stl out. */
#ifndef WEFT_STL_H
#define WEFT_STL_H

#include "output/file.h"
#include "solver/surface.h"

/* Two triangles a cell, counter-clockwise seen from the right side, each with
 * its own normal, in 32-bit floats.  STL knows nothing else: points shared by
 * triangles, stitches, colours, curvatures, energies and growth steps are lost;
 * the first 80 bytes say so.  The surface has no thickness.  false: see log->error. */
bool stl_write(struct file_log *log, const char *path, const struct surface *surface);

#endif
