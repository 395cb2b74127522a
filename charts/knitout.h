/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts as instructions for a knitting machine with two beds, in knitout 2
 * (https://textiles-lab.github.io/knitout/knitout.html).  The machine is seen
 * from the front, so is the fabric that hangs between its beds: a stitch knitted
 * on the front bed is knit, one on the back bed purl, needles count from the left. */
#ifndef WEFT_KNITOUT_H
#define WEFT_KNITOUT_H

#include <stdbool.h>

#include "charts/pattern.h"
#include "charts/text.h"
#include "lang/diag.h"

/* Does the text begin with knitout's first line? */
bool knitout_is(const struct source *);

/* Works the instructions on two beds and reads off what the front shows: a row
 * ends where the carrier turns.  What is worked before the first row over all
 * stitches is the cast-on; what closes the stitches at the end the bind-off.
 * What is not plain knit and purl is an error at its place. */
struct pattern knitout_read(struct arena *, struct diag *, const struct source *);

/* Writes a fabric of K and P: an alternating tuck cast-on, the first row from
 * right to left, transfers where a stitch differs from the one below, and the
 * stitches dropped off at the end. */
void knitout_write(struct text *, const struct grid *);

#endif
