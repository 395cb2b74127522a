/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts drawn in a script. */
#ifndef WEFT_CHART_H
#define WEFT_CHART_H

#include "lang/eval.h"

/* The grid of a chart; *box and *box_width say where | .. | stands around the
 * repeat (width 0: nowhere). NULL after an error. */
const struct grid *chart_read(struct eval *, struct module *, const struct stmt *, int *box, int *box_width);

#endif
