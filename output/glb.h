/* SPDX-License-Identifier: GPL-3.0-or-later
 * glTF 2.0, one binary .glb as viewers, Blender and web pages read it: growth
 * steps in as they are reached, the folded surface with the growth as an
 * animation of morph targets out. */
#ifndef WEFT_GLB_H
#define WEFT_GLB_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

enum { GLB_STEPS = 50 };        /* kept at most: of more, every second, third, ... */

/* A step as it is kept. */
struct glb_step {
    double growth;
    float *position, *normal;   /* length, unit (points x 3) owned */
};

struct glb {
    const struct scene *scene;
    int                 every;  /* every so-manieth step is kept */
    int                 nseen;  /* steps so far */
    int                 nsteps;
    struct glb_step    *step;   /* (nsteps) owned */
    struct surface      size;   /* of the steps: a surface without its arrays */
};

struct glb glb_begin(const struct scene *scene);
void       glb_end(struct glb *glb);

/* Is the next step one to keep?  A state that is not sampled costs nothing. */
bool glb_wants(const struct glb *glb, double growth);

/* Counts a step and keeps it, where glb_wants it (surface may be NULL where it
 * does not).  false: out of memory. */
bool glb_step(struct glb *glb, double growth, const struct surface *surface);

/* Writes the folded surface, sampled as the steps were: triangles, seen from
 * the right side, 32-bit floats.  Each kind of stitch has vertices of its own,
 * so that colours (COLOR_0, linear, of the right side) do not run into each
 * other.  The steps are morph targets, called "growth 0.1", and the animation
 * "growth" goes through them to the folded surface in SECONDS; without it the
 * folded surface shows.  surface NULL: the run was stopped, its last step (there
 * must be one) takes that place.  Lost, and said so in the asset's extras: rows,
 * columns, curvatures, energies, digits beyond the seventh.  false: see log->error. */
bool glb_write(const struct glb *glb, struct file_log *log, const char *path, const struct surface *surface);

#endif
