/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows in the order of work in; the widths they fit and the grid they make out. */
#include <string.h>

#include "lang/rows/row_draw.h"
#include "lang/rows/row_fit.h"
#include "lang/rows/row_list.h"
#include "lang/rows/row_misfit.h"

static bool is_between(const struct row_text *text)
{
    return text->edges && text->edges->between;
}

bool rows_fit(const struct row_list *list, struct fit *fit)
{
    const struct row_text *before = NULL;

    *fit = (struct fit){1, 0, 0};
    for (int i = 0; i < list->norder; i++)
        list->order[i]->seen = false;
    for (int i = 0; i < list->norder; i++) {
        struct row_text *text = list->order[i];
        struct fit row, both;

        /* Each text once, however often it is worked. */
        if (text->as_below || text->as_opposite || text->cut || text->failed || text->seen)
            continue;
        text->seen = true;
        if (!row_fit(list->diag, text, &row))
            return false;
        if (is_between(text))
            row = (struct fit){row.multiple, row.plus + 2 * text->edges->n, row.least + 2 * text->edges->n};
        if (!fit_join(fit, &row, &both)) {
            misfit_rows(list->diag, text, before, &row, fit);
            return false;
        }
        *fit = both;
        before = text;
    }
    return true;
}

bool rows_one_repeat(const struct row_list *list, const struct fit *all)
{
    struct fit row;

    for (int i = 0; i < list->norder; i++) {
        const struct row_text *text = list->order[i];

        if (text->work && !text->cut && row_fit(list->diag, text, &row) && row.multiple == all->multiple)
            return true;
    }
    return false;
}

long long rows_said_width(const struct row_list *list)
{
    for (int i = 0; i < list->norder; i++)
        if (list->order[i]->check > 0)
            return list->order[i]->check;
    return 0;
}

static bool nothing_below(struct row_list *list, const struct row_text *text)
{
    const char *row = list->round ? "rnd" : row_list_side(list, 0) == SIDE_WS ? "row (RS)" : "row (WS)";

    diag_error(list->diag, CODE_ROW_REFERENCE, text->span, "there is no row below the first");
    diag_hint(list->diag, "put the row it is worked on before it, `Set-up %s: *k2, p2; rep from * to end`, or write its own stitches", row);
    return false;
}

/* Works the end that is another than its row's: over as many stitches. */
static bool work_end(struct row_list *list, const struct row_text *text, int width, enum width_from from, stitch_id *worked)
{
    struct row_text end = *text;

    if (!text->end)
        return true;
    end.work = text->end;
    end.check = -1;
    if (text->end_length <= width)
        return row_work(list->diag, &end, (int)text->end_length, from, NULL, worked + width - text->end_length);
    diag_error(list->diag, CODE_ROW_COUNT, text->span, "this end has %lld stitches, the row %d", text->end_length, width);
    return false;
}

/* A row's stitches in working order; markers hang in it, and behind it, where it is worked to them or hangs them. */
static bool work_row(struct row_list *list, struct row_text *text, struct marked_row row, enum width_from from, const struct row_text *before, struct markers *markers, stitch_id *worked)
{
    row.text = text;
    if (text->marked)
        text->work = markers_reached(list->diag, markers, row);
    if (text->marked && !text->work)
        return false;
    if (!(is_between(text) ? row_edges_work : row_work)(list->diag, text, row.width, from, before, worked) || !work_end(list, text, row.width, from, worked))
        return false;
    return !text->marked || markers_worked(list->diag, markers, row);
}

/* Goes on with the garter of a row worked on a side, `edge st, ..`, in one that is worked as the stitches appear. */
static void keep_garter(stitch_id *to, const stitch_id *worked, int width, enum side worked_on, enum side side)
{
    for (int x = 0; x < width; x++)
        if (worked[x] == STITCH_GARTER)
            to[worked_on == SIDE_RS ? width - 1 - x : x] = side == SIDE_RS ? STITCH_K : STITCH_P;
}

const struct grid *rows_grid(struct row_list *list, int width, int height, enum width_from from,
                             const stitch_id *ws)
{
    stitch_id *cell, *worked = arena_array(list->arena, stitch_id, (size_t)width);
    int rows = height ? height : list->norder;
    struct grid *g = grid_new(list->arena, width, rows, &cell);
    struct markers markers = {0};
    const struct row_text *before = NULL;
    enum side worked_on = SIDE_RS;
    bool good = true, shaped = false, told = false;     /* told: `worked` are the stitches of the last row that was not worked as they appear */

    for (int i = 0; i < list->norder; i++)
        memset(list->order[i]->drawn, 0, sizeof list->order[i]->drawn);
    for (int i = 0; i < rows; i++) {
        struct row_text *text = list->order[i % list->norder];
        enum side side = row_list_side(list, i);
        stitch_id *to = cell + (size_t)i * (size_t)width;

        /* A text that was drawn on this side before is the same again. */
        if (i >= list->norder)
            row_list_check_side(list, text, i, 0);
        if (list->failed)
            return NULL;
        shaped |= text->shaped;
        if (text->failed || shaped) {
            good = false;
            before = NULL;
            continue;
        }
        if ((text->as_below || text->as_opposite) && i == 0) {
            nothing_below(list, text);
            return NULL;
        }
        if (text->as_opposite && !is_between(text)) {
            for (int x = 0; x < width; x++)
                to[x] = ws[to[x - width]];
        } else if (text->as_below && !is_between(text)) {
            memcpy(to, to - width, (size_t)width);
            if (told && !list->round)
                keep_garter(to, worked, width, worked_on, side);
        } else if (text->drawn[side] && !text->marked) {
            memcpy(to, cell + (size_t)(text->drawn[side] - 1) * (size_t)width, (size_t)width);
            told = false;
        } else {
            struct row_text here = *text;

            here.work = side == SIDE_WS && text->on_ws ? text->on_ws : text->work;
            if (!work_row(list, &here, (struct marked_row){text, width, side, list->round}, from, before, &markers, worked)) {
                good = false;
            } else if (i == 0 && row_draw_asks_below(worked, width)) {
                good = nothing_below(list, text);
            } else if (good) {
                told = true;
                worked_on = side;
                text->drawn[side] = row_draw(to, worked, (struct row_place){width, side, list->round, i == 0, list->front && !text->on_ws, ws}) ? i + 1 : 0;
            }
        }
        before = text;
    }
    return good ? g : NULL;
}
