/* SPDX-License-Identifier: GPL-3.0-or-later
 * VTK PolyData: a surface in, one .vtp file out, as ParaView, VTK and PyVista
 * read it.  Nothing of the surface is lost. */
#ifndef WEFT_VTP_H
#define WEFT_VTP_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

/* Writes the surface of the scene's swatch as quads seen from the right side.
 *   point data  normal (unit), displacement (length, from the flat sheet); the positions are the Points
 *   cell data   stitch_id (row * columns + column, from 0), row (from 1, the bottom), column (from 1, the left
 *               edge), knit_sign (1 knit, -1 purl, 0 another stitch), kx, ky (natural curvature, 1/length),
 *               mean_curvature, gaussian_curvature, stretching_density, bending_density (energy/area)
 * Binary arrays are raw, appended after the XML, in the machine's byte order (the header says which); numbers as
 * text read back exactly.  The arrays go out one after the other: no copy of the mesh is made.
 * false, with log->error set, if the file could not be written. */
bool vtp_write(struct file_log *log, const char *path, const struct scene *scene, const struct surface *surface,
               enum output_format format);

#endif
