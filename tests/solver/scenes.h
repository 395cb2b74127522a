/* SPDX-License-Identifier: GPL-3.0-or-later
 * Small sheets for the solver's tests, made without the language. */
#ifndef WEFT_TEST_SCENES_H
#define WEFT_TEST_SCENES_H

#include "solver/discretisation.h"
#include "solver/sheet.h"

/* A sheet of columns x rows stitches 1.4 x 1.2, h = 0.5, Y = 1, nu = 0.4, no
 * springs; purl(x, y) says where the stitch is turned over, NULL: nowhere. */
struct sheet *scene_sheet(int columns, int rows, int (*purl)(int x, int y));

int rib(int x, int y);          /* 2x2 rib */
int checker(int x, int y);      /* 2x2 checks */
int seed(int x, int y);         /* 1x1 checks */
int miura(int x, int y);        /* the motif of 12 x 23 */

/* A reproducible number in [-1, 1]. */
double scene_random(void);

/* To be freed: n such numbers times an amplitude; the flat state with these added. */
double *scene_vector(int n, double amplitude);
double *scene_state(const struct discretisation *d, double amplitude);

#endif
