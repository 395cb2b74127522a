/* SPDX-License-Identifier: GPL-3.0-or-later
 * The two needle beds of a knitting machine: operations in, the rows of a plain
 * fabric out, or the first operation that makes something else. */
#ifndef WEFT_BEDS_H
#define WEFT_BEDS_H

#include <stdbool.h>

#include "charts/raster.h"

enum { NEEDLE_MOST = 1000 * 1000 };

enum bed { BED_FRONT, BED_BACK };

struct needle {
    enum bed    bed;
    int         number;     /* -NEEDLE_MOST .. NEEDLE_MOST, to the right */
    struct span span;
};

struct beds;
struct beds *beds_new(struct arena *, struct diag *);

/* How far the front bed stands to the left: back needle n faces front needle n + rack. */
void beds_rack(struct beds *, double rack);

/* A loop more; a loop drawn through those there, in a direction (-1, 1); the
 * same, those there going to another needle; loops to another needle; loops off. */
void beds_tuck(struct beds *, struct needle, struct span operation);
void beds_knit(struct beds *, int direction, struct needle, struct span operation);
void beds_split(struct beds *, struct needle, struct needle to, struct span operation);
void beds_transfer(struct beds *, struct needle, struct needle to, struct span operation);
void beds_drop(struct beds *, struct needle, struct span operation);

/* The fabric's right side, or NULL after an error; and what was taken for what. */
const struct grid *beds_fabric(struct beds *, const struct source *, const char **remark);

#endif
