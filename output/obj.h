/* SPDX-License-Identifier: GPL-3.0-or-later
 * Wavefront OBJ: a surface in, one .obj of quads with normals and one .mtl with
 * a colour for each kind of stitch out. */
#ifndef WEFT_OBJ_H
#define WEFT_OBJ_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

/* Faces are grouped by stitch: group and material have the stitch's name in
 * small letters, knit and purl for K and P.  What OBJ has no place for is lost
 * and said so in its first lines: curvatures, energies, displacements.  The
 * .mtl stands beside path, with its name (x.obj: x.mtl).  false, with
 * log->error set, if a file could not be written. */
bool obj_write(struct file_log *log, const char *path, const struct scene *scene, const struct surface *surface);

#endif
