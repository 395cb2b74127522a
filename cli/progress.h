/* SPDX-License-Identifier: GPL-3.0-or-later
 * How far a fold is: steps and energies in; a bar on a terminal, a few lines
 * elsewhere, out. */
#ifndef WEFT_PROGRESS_H
#define WEFT_PROGRESS_H

#include <stdbool.h>

struct fold_step;

struct progress {
    enum { PROGRESS_NONE, PROGRESS_LINES, PROGRESS_BAR } style;
    int    nsteps, done;        /* growth steps, in all and completed */
    double begun, stepped, drawn;   /* the start, the last completed step, the last look; on progress_clock */
};

/* Progress of nsteps growth steps on standard error; none if quiet. */
struct progress progress_begin(int nsteps, bool quiet);

/* A step is completed (growth 0 is the flat sheet, before the first). */
void progress_step(struct progress *progress, const struct fold_step *step);

/* Within a step; draws ten times a second at most. */
void progress_iteration(struct progress *progress, double growth, int iterations, double energy);

/* Of the points of a sweep rather than growth steps: one ended, as a line says,
 * which a bar shows only where it is news; and again and again, while some run. */
void progress_point(struct progress *progress, const char *line, bool news);
void progress_points(struct progress *progress, int running);

/* Takes the bar away. */
void progress_end(struct progress *progress);

/* Seconds on a clock that only runs forward. */
double progress_clock(void);

#endif
