/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a fold will need, without folding: a sheet in; its last mesh, a guess of
 * time and memory out. */
#ifndef WEFT_FORECAST_H
#define WEFT_FORECAST_H

struct sheet;

struct forecast {
    int    per_stitch;      /* of the last level; for auto: of a sample's */
    long   unknowns;        /* on that level */
    long   elements;
    double seconds;         /* wall, two threads; within a factor 2 on the bench's scenes, docs/numerics.md */
    double bytes;           /* at the peak; likewise */
};

/* Makes the levels and analyses their factors, which takes a small part of a fold's time; for auto folds a sample of
 * the sheet, a dozen stitches a side, to see how fine its accuracy takes it. */
struct forecast forecast_fold(const struct sheet *sheet);

#endif
