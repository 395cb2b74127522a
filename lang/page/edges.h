/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sentence of a page in, the edges it asks to be kept out: `Keep 3 sts at each edge in garter st throughout`. */
#ifndef WEFT_EDGES_H
#define WEFT_EDGES_H

#include <stddef.h>

#include "lang/ast.h"

/* The bytes of such a sentence, or of its part before `, work 4 rows`, that a text begins with, and where its fabric
 * stands; 0: it is none, or says more. */
size_t edges_length(const char *text, struct kept_edges *, const char **fabric);

static inline bool edges_is(const char *text)
{
    struct kept_edges edges;
    const char *fabric;

    return edges_length(text, &edges, &fabric) > 0;
}

/* The bytes of `Note: the first and last 4 sts of every row are knit` from a place on, and what says it as a sentence that
 * keeps edges does; 0: none stands there. */
size_t edges_said(const char *text, size_t start, char *plain, size_t room);

#endif
