/* SPDX-License-Identifier: GPL-3.0-or-later
 * ParaView's collection: growth steps in as they are reached, one .pvd and one
 * .vtp a step out.  The .pvd can be opened at every moment of a run: each
 * step's .vtp is complete before the .pvd that names it replaces the last. */
#ifndef WEFT_PVD_H
#define WEFT_PVD_H

#include "output/vtp.h"

struct pvd {
    struct file_log    *log;
    const char         *path;
    const struct scene *scene;
    enum output_format  format;     /* of the steps */
    int                 digits;     /* of a step's number in its file's name */
    int                 nsteps;     /* so far */
    double             *growth;     /* (nsteps) owned, the time of each step */
};

/* Begins a collection of at most scene->solve.steps + 1 steps; writes nothing yet. */
struct pvd pvd_begin(struct file_log *log, const char *path, const struct scene *scene,
                     enum output_format format);

/* Writes step number nsteps beside the collection, named after it
 * (miura.pvd: miura_00.vtp, ...), then the collection that names it by a
 * relative path, so that the folder can be moved.  false: see log->error. */
bool pvd_step(struct pvd *pvd, double growth, const struct surface *surface);

void pvd_end(struct pvd *pvd);

#endif
