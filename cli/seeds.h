/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sheet that may have several minima in; folds from several seeds, the
 * lowest found out. */
#ifndef WEFT_SEEDS_H
#define WEFT_SEEDS_H

#include "output/report.h"
#include "solver/fold.h"

struct seeds {
    int                 nresults;       /* done so far: fewer than asked for after an interrupt */
    struct report_seed *result;         /* (nresults) in the order of the seeds */
    int                 kept;           /* the lowest minimum; where there is none, the lowest end */
    double              spread;         /* of the minima's energies, over the lowest's size */
};

/* Folds the sheet from count seeds, the first its own, and leaves it with the
 * seed to keep.  false: interrupted.  Free with seeds_free in any case. */
bool seeds_try(struct seeds *seeds, int count, struct sheet *sheet, const struct fold_options *options,
               const struct fold_observer *observer);
void seeds_free(struct seeds *seeds);

/* A line for each seed, and whether they agree. */
void seeds_print(const struct seeds *seeds);

#endif
