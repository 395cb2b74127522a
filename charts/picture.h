/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts as pictures: one pixel is one stitch. */
#ifndef WEFT_PICTURE_H
#define WEFT_PICTURE_H

#include <stdbool.h>

#include "charts/pattern.h"
#include "charts/text.h"
#include "lang/diag.h"

/* What the colours mean. */
struct colour {
    unsigned  rgb;              /* 0xRRGGBB */
    stitch_id stitch;
};

struct colour_key {
    int                  n;
    const struct colour *colour;    /* (n), none twice */
};

/* Reads `#000000=k,#ffffff=p` (also: black, white); NULL, and *why, if it is no key. */
const struct colour_key *picture_key(struct arena *, const char *text, const char **why);

/* Do the bytes begin like a PNG file? */
bool picture_is_png(const struct source *);

/* Reads a PNG file of any kind, its top row of pixels being the fabric's top row;
 * without a key black is knit, white is purl. Errors are in diag, a pixel's at the
 * line and column of its place, from 1; after one the result has no grid. */
struct pattern picture_read(struct arena *, struct diag *, const struct source *, const struct colour_key *);

/* Writes a fabric of K and P the same way, black for K and white for P. */
void picture_write(struct text *, const struct grid *);

#endif
