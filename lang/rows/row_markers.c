/* SPDX-License-Identifier: GPL-3.0-or-later
 * Where markers hang and a row in, how far the row is worked and where they hang behind it out. */
#include "lang/rows/row_markers.h"

#include <string.h>

#include "lang/limits.h"
#include "lang/names.h"
#include "lang/rows/row_fit.h"

bool work_has_marker(const struct work *work)
{
    for (; work; work = work->next)
        if (work->mark || work->until == WORK_MARKER || (work->child && work_has_marker(work->child)))
            return true;
    return false;
}

/* ---- how far a row is worked ---- */

/* The i-th marker as the row comes to it: stitches from its beginning. */
static long long place_of(const struct markers *markers, struct marked_row row, int i)
{
    return row.side == SIDE_WS ? row.width - markers->at[markers->n - 1 - i] : markers->at[i];
}

/* The marker ahead, the row's second or its last; -1: there is none. */
static long long marker_ahead(const struct markers *markers, struct marked_row row, long long here, enum marker which)
{
    int i = which == MARKER_LAST ? markers->n - 1 : which == MARKER_SECOND ? 1 : 0;

    while (i >= 0 && i < markers->n && place_of(markers, row, i) <= here)
        i++;
    if (i >= 0 && i < markers->n)
        return place_of(markers, row, i);
    return row.round && here < row.width ? row.width : -1;
}

/* Of `to 2 sts before marker` at a place of the row, the stitches left behind it; -1, with a message, where it does not come out. */
static long long left_behind(struct diag *diag, const struct work *work, const struct markers *markers, struct marked_row row, long long here)
{
    long long to = marker_ahead(markers, row, here, work->marker), repeated = to - work->n - here;

    if (to < 0) {
        diag_error(diag, CODE_ELSEWHERE, work->span, "no marker hangs ahead of this place");
        diag_hint(diag, "place it in a row before, `k3, pm, ..`, or say the stitches: `k to last 4 sts`");
        return -1;
    }
    if (repeated < 0) {
        diag_error(diag, CODE_ROW_COUNT, work->span, "the marker is %lld %s ahead, not %lld", to - here, names_count(to - here, "stitch", "stitches"), work->n);
        return -1;
    }
    if (work->length && repeated % work->length) {
        diag_error(diag, CODE_ROW_FIT, work->span, "a repeat of %lld cannot fill the %lld stitches up to the marker", work->length, repeated);
        return -1;
    }
    return row.width - to + work->n;
}

/* How far the row is behind a part of it that ends at no marker; -1: that is open. */
static long long place_behind(const struct work *work, struct marked_row row, long long here)
{
    long long behind;

    if (work->until == WORK_LAST)
        return row.width - work->n;
    if (work->until != WORK_FIT)
        return here + work->length * work->n;
    behind = work_length(work->next);
    return behind < 0 ? -1 : row.width - behind;
}

struct work *markers_reached(struct diag *diag, const struct markers *markers, struct marked_row row)
{
    struct work *first = NULL, **to = &first;
    long long here = 0;

    for (const struct work *work = row.text->work; work; work = work->next, to = &(*to)->next) {
        *to = arena_new(diag->arena, struct work);
        **to = *work;
        if (work->until == WORK_MARKER && here < 0) {
            diag_error(diag, CODE_ROW_REPEAT, work->span, "how far the repeat before this goes is open");
            diag_hint(diag, "say where it ends: `rep from * to last 2 sts`");
            return NULL;
        }
        if (work->until == WORK_MARKER) {
            (*to)->until = WORK_LAST;
            (*to)->n = left_behind(diag, work, markers, row, here);
            if ((*to)->n < 0)
                return NULL;
        }
        here = place_behind(*to, row, here);
    }
    return first;
}

/* ---- what a row does with them ---- */

/* False where too many hang. */
static bool place(struct markers *markers, int at)
{
    int i = markers->n;

    while (i && markers->at[i - 1] > at)
        i--;
    if (i && markers->at[i - 1] == at)
        return true;
    if (markers->n == LIMIT_MARKERS)
        return false;
    memmove(markers->at + i + 1, markers->at + i, (size_t)(markers->n++ - i) * sizeof *markers->at);
    markers->at[i] = at;
    return true;
}

static void take_away(struct markers *markers, int at)
{
    for (int i = 0; i < markers->n; i++)
        if (markers->at[i] == at) {
            memmove(markers->at + i, markers->at + i + 1, (size_t)(--markers->n - i) * sizeof *markers->at);
            return;
        }
}

/* One pass of a list of work from a place of the row on; returns the place behind it, -1 where too many markers hang. */
static long long pass(struct markers *markers, struct marked_row row, const struct work *work, long long here)
{
    for (; work; work = work->next) {
        int at = (int)(row.side == SIDE_WS ? row.width - here : here);

        if (work->mark == MARK_PLACED && !place(markers, at))
            return -1;
        if (work->mark == MARK_REMOVED)
            take_away(markers, at);
        if (work->child && work_has_marker(work->child))
            for (long long i = 0; i < (work->length ? work->n : 1) && here >= 0; i++)
                here = pass(markers, row, work->child, here);
        else
            here += work->length * work->n;
        if (here < 0)
            return -1;
    }
    return here;
}

bool markers_worked(struct diag *diag, struct markers *markers, struct marked_row row)
{
    if (pass(markers, row, row.text->work, 0) >= 0)
        return true;
    diag_error(diag, CODE_LIMIT_ROWS, row.text->span, "more than %d markers hang in this row", LIMIT_MARKERS);
    return false;
}
