/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a state of the sheet is made of: for the driver, and for tests that
 * judge its result by other means. */
#ifndef WEFT_FOLD_STATE_H
#define WEFT_FOLD_STATE_H

#include "solver/discretisation.h"

struct effort;

struct fold_state {
    struct discretisation *d;
    double                *x;           /* (n) */
    double                 growth;
    int                    ngrown;
    double                *grown;       /* (ngrown) x of the level the sheet grew on, at the full curvature; NULL: not there yet */
    double                 grown_energy;
    const struct effort   *effort;      /* of the fold so far, while it runs */
};

#endif
