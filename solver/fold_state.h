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
    const struct effort   *effort;      /* of the fold so far, while it runs */
};

#endif
