/* SPDX-License-Identifier: GPL-3.0-or-later
 * PLY, as Blender, MeshLab and scan tools read it: a surface in, one binary
 * .ply of quads with all the fields of its cells out. */
#ifndef WEFT_PLY_H
#define WEFT_PLY_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

/* Little endian whatever the machine.
 *   vertex  x y z, nx ny nz (doubles), red green blue (0..255, the mean of the cells around it)
 *   face    vertex_indices (4, counter-clockwise seen from the right side), stitch_id (from 0), row, column (from
 *           1), knit_sign, kx, ky, mean_curvature, gaussian_curvature, stretching_density, bending_density,
 *           red green blue (the stitch's)
 * Lost, and said so in the header: displacements, growth steps.  false: see log->error. */
bool ply_write(struct file_log *log, const char *path, const struct scene *scene, const struct surface *surface);

#endif
