/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a page says of the stitches that its rows name `edge st`, `selvedge st`. */
#ifndef WEFT_EDGE_STITCHES_H
#define WEFT_EDGE_STITCHES_H

#include <stdbool.h>
#include <stddef.h>

enum edge_stitch {
    EDGE_GARTER,        /* knitted on every row: also where nothing is said of it */
    EDGE_STOCKINETTE,   /* knitted on RS rows, purled on WS rows */
    EDGE_REVERSE,       /* the other way round */
    EDGE_PURLED,        /* on every row */
    EDGE_SLIPPED,
    EDGE_UNCLEAR        /* something is said of one side alone */
};

/* Bytes of the sentence at a place that says how edge stitches are worked, `Edge sts: knit on RS rows, purl on WS rows`; 0: another. */
size_t edge_stitches_length(const char *text, size_t at, enum edge_stitch *kind);

/* What the last of these says. *used: rows of the text name such stitches. */
enum edge_stitch edge_stitches_read(const char *text, bool *used);

#endif
