/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the sentences of a page say of all its rows, wherever they stand. */
#ifndef WEFT_PAGE_FACTS_H
#define WEFT_PAGE_FACTS_H

#include "lang/ast.h"
#include "lang/page/edge_stitches.h"

struct page_facts {
    bool      page;         /* the text is as much as a page has (words.h), */
    bool      knitters;     /* rows in a knitter's words, and no statement of the language's own */
    bool      rounds;       /* the stitches are joined before the rows: what is called a row is a round */
    enum side first;        /* the side of row 1; open: nothing is said of it, or both; */
    bool begins;            /* or that of the first row worked */
    double    gauge;        /* rows per millimetre, "20 sts and 28 rows = 4 in"; 0: none is said, */
    size_t    gauge_from, gauge_to; /* and from where to where */
    size_t    loom;         /* behind its word, where rows, no rounds, are worked on a loom, perhaps; 0: no word of one */
    bool      pegs;         /* surely: its pegs are named. All rows are worked from the front */
    size_t    circle;       /* behind the word of a circular needle, where a marker is placed at the cast-on and nothing says
                             * whether the stitches are joined, or the work turned; 0: that is not open */
    size_t    machine;      /* behind the word of a knitting machine; 0: no word of one */
    size_t    sizes;        /* where the cast-on names further sizes, `20 (26, 30)`, */
    int       nsizes;       /* so many of them; 0: it names none */
    int       bound_off;    /* the number of the row that binds off; 0: it has none */
    bool      edges;        /* rows name edge stitches, `edge st`, */
    enum edge_stitch edge;  /* worked so */
};

/* Those of a text whose marks are plain. Of one longer than a page's only whether its rows are rounds. */
struct page_facts page_facts_read(const char *text, size_t size);

#endif
