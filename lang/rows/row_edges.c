/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows below a sentence that keeps edges in, whether they are worked between these edges out: their counts say it. */
#include <string.h>

#include "lang/rows/row_fit.h"
#include "lang/rows/row_list.h"

static int between_of(const struct row_edges *edges, int width)
{
    return width > 2 * edges->n ? width - 2 * edges->n : 0;
}

/* Whether a text fits so many stitches, and what it works then. */
static bool works(struct row_list *list, const struct row_text *text, int width, stitch_id *worked)
{
    struct row_text row = *text;
    struct diag quiet;

    diag_init(&quiet, list->arena);
    memset(worked, STITCH_SAME, (size_t)width);
    if (width < 1)
        return false;
    return text->as_below || text->as_opposite || (row_work(&quiet, &row, width, WIDTH_CAST_ON, NULL, worked) && !quiet.nwarnings);
}

/* Whether so many stitches are of the fabric: all knit, or in turns. */
static bool is_fabric(const stitch_id *worked, const struct row_edges *edges)
{
    for (int i = 0; i < edges->n; i++) {
        bool own = worked[i] == edges->stitch;

        if (worked[i] > STITCH_P && !own)
            return false;
        if (edges->stitch == STITCH_GARTER ? !own && worked[i] != STITCH_K : !own && i > 0 && worked[i] == worked[i - 1])
            return false;
    }
    return true;
}

static bool shows_edges(const struct row_text *text, const stitch_id *worked, int width)
{
    return !text->on_ws && is_fabric(worked, text->edges) && is_fabric(worked + width - text->edges->n, text->edges);
}

/* The rows of one sentence. */
static void decide(struct row_list *list, struct row_edges *edges, int width)
{
    stitch_id *worked = arena_array(list->arena, stitch_id, (size_t)width);
    bool all = true, between = true, shown = true;

    for (int i = 0; i < list->norder; i++)
        list->order[i]->seen = false;
    for (int i = 0; i < list->norder; i++) {
        struct row_text *text = list->order[i];

        /* Each text once, however often it is worked. */
        if (text->edges != edges || text->failed || text->seen)
            continue;
        if (text->marked) {
            between = false;    /* such a row has its edges: they are what is marked */
            continue;
        }
        text->seen = true;
        between &= works(list, text, between_of(edges, width), worked);
        all &= works(list, text, width, worked);
        shown &= all && width >= edges->n && shows_edges(text, worked, width);
    }
    edges->between = between && !(all && shown);
    if (edges->between) {
        diag_warning(list->diag, CODE_EDGES, edges->span, "these %d stitches at each edge are worked beside the rows below, which are those of the %d between", edges->n,
                     width - 2 * edges->n);
        diag_hint(list->diag, "rows that have them need no such line: `k%d, .. to last %d sts, k%d`", edges->n, edges->n, edges->n);
    } else if (all && !shown) {
        diag_warning(list->diag, CODE_PROSE, edges->span, "this line is read as text: the rows below work all %d stitches, the edges too", width);
        if (between_of(edges, width))
            diag_hint(list->diag, "rows of the stitches between the edges are those of %d", between_of(edges, width));
        else
            diag_hint(list->diag, "%d stitches have no others between edges of %d", width, edges->n);
    }
}

bool rows_keep_edges(struct row_list *list, const struct row_edges *last, int width)
{
    for (int i = 0; i < list->norder; i++) {
        struct row_edges *edges = list->order[i]->edges;

        if (!edges || edges->decided)
            continue;
        edges->decided = true;
        if (width && !list->round) {
            decide(list, edges, width);
            continue;
        }
        diag_error(list->diag, CODE_STATEMENT, edges->span, "edges can be kept %s", width ? "in rows, not in rounds" : "where it is said how many stitches are cast on");
        diag_hint(list->diag, "write these stitches in each row, at both ends: `K3, .. to last 3 sts, k3`");
        return false;
    }
    for (; last; last = last->above)
        if (!last->decided) {
            diag_warning(list->diag, CODE_PROSE, last->span, "this line is read as text: no row is below it");
            diag_hint(list->diag, "edges are kept in the rows below such a line; above it write them in each row");
        }
    return true;
}

bool row_edges_work(struct diag *diag, struct row_text *text, int width, enum width_from from, const struct row_text *before, stitch_id *worked)
{
    const struct row_edges *edges = text->edges;
    int inner = width - 2 * edges->n;

    memset(worked, edges->stitch, (size_t)width);
    if (!text->as_below && !text->as_opposite)
        return row_work(diag, text, inner, from, before, worked + edges->n);
    memset(worked + edges->n, text->as_below ? STITCH_SAME : STITCH_OTHER, (size_t)inner);
    return true;
}
