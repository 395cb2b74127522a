/* SPDX-License-Identifier: GPL-3.0-or-later
 * From a state to a minimum on one level: the chosen minimiser, the inertia
 * test at its end, and the push off a saddle. */
#ifndef WEFT_DESCENT_H
#define WEFT_DESCENT_H

#include "solver/problem.h"

struct descent {
    enum outcome outcome;
    bool         minimum;           /* the exact Hessian is positive definite, rigid modes aside */
    int          pushes;            /* saddles left on the way */
};

/* Moves x (n) downhill until the problem's tolerance, by the method. */
enum outcome descent_settle(struct problem *p, enum method method, double *x);

/* The same, then leaves any saddle it ends at, to the lower side, up to a number of times. */
struct descent descent_to_minimum(struct problem *p, enum method method, double *x);

#endif
