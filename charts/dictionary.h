/* SPDX-License-Identifier: GPL-3.0-or-later
 * What written rows call each kind of stitch, and the statements that define those which are
 * neither knit nor purl. */
#ifndef WEFT_DICTIONARY_H
#define WEFT_DICTIONARY_H

#include "charts/text.h"
#include "lang/scene.h"

struct dictionary {
    struct entry {
        const char *name;       /* with a number behind it: "k", "T" */
        const char *row;        /* a row of nothing else: "knit", "T" */
        bool        apart;      /* its number stands apart: `T 2` */
        int         on_ws;      /* what is worked on the wrong side to show it; -1: none does */
    } entry[STITCH_MAX];
};

/* Knit and purl alone. */
extern const struct dictionary dictionary_plain;

/* Of a scene's stitches (n). */
struct dictionary dictionary_of(const struct stitch *, int n);

/* Whether a script must define this one: all but knit and purl as they are. */
bool dictionary_defines(const struct stitch *, int id);

/* A `stitch` statement for each of those. */
void dictionary_define(struct text *, const struct stitch *, int n);

/* The first stitch of the rows worked on the wrong side that none worked there shows; -1: no such. */
int dictionary_unshown(const struct dictionary *, const struct grid *);

#endif
