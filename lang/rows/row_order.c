/* SPDX-License-Identifier: GPL-3.0-or-later
 * A list of rows in, the order they are worked in and the side of each out. */
#include "lang/limits.h"
#include "lang/rows/row_fit.h"
#include "lang/rows/row_list.h"

static enum side other_side(enum side side)
{
    return side == SIDE_RS ? SIDE_WS : SIDE_RS;
}

/* The side the i-th row worked (from 0) is worked on. */
enum side row_list_side(const struct row_list *list, int i)
{
    enum side start = list->start ? list->start : SIDE_RS;

    return list->round || i % 2 == 0 ? start : other_side(start);
}

/* The first marked row decides on which side the work begins; else what is said of the rows. */
static void find_start(struct row_list *list)
{
    for (int i = 0; i < list->npending && !list->start; i++) {
        const struct row_text *text = list->pending[i];

        if (text && text->side)
            list->start = (list->norder + i) % 2 == 0 || list->round ? text->side : other_side(text->side);
    }
    if (!list->start && !list->npending && list->filler && list->filler->all == ALL_WS_ROW && !list->round)
        list->start = list->norder % 2 ? SIDE_RS : SIDE_WS;     /* `WS: ..` above `RS: ..`: the one is worked first */
    if (!list->start && list->row_1 && !list->round)
        list->start = list->begins || (list->norder + list->first) % 2 ? list->row_1 : other_side(list->row_1);
    if (list->round && list->start == SIDE_WS) {
        diag_error(list->diag, CODE_ROW_SIDE, list->span, "a round is always worked from the right side");
        row_list_fail(list);
    }
}

/* The same by the row worked next. */
void row_list_begin_on_side_of(struct row_list *list, const struct row_text *text)
{
    if (!list->start && text->side)
        list->start = list->norder % 2 == 0 || list->round ? text->side : other_side(text->side);
}

static bool fills(const struct filler *f, int label, enum side side)
{
    if (f->last && label > f->last)
        return false;
    return ((f->all == ALL_RS || f->all == ALL_RS_ROW) && side == SIDE_RS) || ((f->all == ALL_WS || f->all == ALL_WS_ROW) && side == SIDE_WS) ||
           (f->all == ALL_EVEN && label % 2 == 0) || (f->all == ALL_ODD && label % 2 == 1) ||
           f->all == ALL_EVERY || (f->all == ALL_FOLLOWING && label >= f->first) || (f->all == ALL_OTHER && label >= f->first && (label - f->first) % 2 == 0);
}

static struct row_text *filler_for(const struct row_list *list, int label, enum side side)
{
    for (const struct filler *f = list->filler; f; f = f->next)
        if (fills(f, label, side))
            return f->text;
    return NULL;
}

const struct row_text *rows_find(struct row_list *list, int label)
{
    const struct row_text *text = row_list_numbered(list, label);

    if (text || label < list->first)
        return text;
    find_start(list);
    return filler_for(list, label, row_list_side(list, list->norder + label - list->first));
}

/* Appends a row to the order of work; false past the limit. */
bool row_list_append(struct row_list *list, struct row_text *text)
{
    if (list->norder >= LIMIT_ROWS) {
        diag_error(list->diag, CODE_LIMIT_ROWS, list->span, "this makes more than %d rows", LIMIT_ROWS);
        row_list_fail(list);
        return false;
    }
    if (text->rib && !(list->norder && rows_are_rib((struct row_texts){list->order + list->norder - 1, 1, 0}))) {
        diag_error(list->diag, CODE_ELSEWHERE, text->span, "which rib this is is not said, and the row before it is none");
        diag_hint(list->diag, "the row's stitches, `*k2, p2; rep from * to end`, or `Work 4 rows in k2, p2 rib`");
        row_list_fail(list);
        return false;
    }
    list->order = row_list_grown(list, list->order, &list->room, list->norder + 1);
    list->order[list->norder++] = text;
    text->worked = true;
    return true;
}

/* `repeated`: so many rows are, which brings it there; 0: none. */
void row_list_check_side(struct row_list *list, const struct row_text *text, int i, int repeated)
{
    enum side side = row_list_side(list, i);
    const char *mark = text->side == SIDE_RS ? "RS" : "WS";

    if (!text->side || text->side == side)
        return;
    diag_error(list->diag, CODE_ROW_SIDE, text->head, "row %d is marked %s, but it is worked on the %s",
               text->label ? text->label : i + 1, mark, side == SIDE_RS ? "right side" : "wrong side");
    if (repeated) {
        diag_note(list->diag, list->span, "repeated here: %s", repeated == 1
                      ? "the same words on both sides, or a row between that is not named"
                      : "an odd number of rows turns the sides around");
        diag_hint(list->diag, "for the same words on both sides leave out %s; else repeat as many RS rows as WS rows", mark);
    } else {
        diag_hint(list->diag, !text->label             ? "write the row between, which is not named: `Next row: ...`"
                              : i + 1 == text->label ? "RS and WS rows take turns"
                                                   : "repeating an odd number of rows turns the sides around");
    }
    row_list_fail(list);
}

bool rows_described(const struct row_list *list)
{
    return list->fresh && !list->npending && filler_for(list, list->first, row_list_side(list, list->norder)) && filler_for(list, list->first + 1, row_list_side(list, list->norder + 1));
}

/* The first row written behind the place of one that is not. */
static struct span behind_gap(const struct row_list *list, int i)
{
    while (i < list->npending && !list->pending[i])
        i++;
    return i < list->npending ? list->pending[i]->head : list->span;
}

/* Whether it is knit alone. */
static bool is_all_knit(const struct row_text *text)
{
    const struct work *work = text->work;

    return work && !text->on_ws && !work->next && !work->child && work->nruns == 1 && work->run->stitch == STITCH_K;
}

/* Rows of one text, or all knit, show the same whichever side is in front. */
static bool are_alike(struct row_text *const *text, int n)
{
    for (int i = 1; i < n; i++)
        if (!text[i] || (text[i] != text[0] && !(is_all_knit(text[i]) && is_all_knit(text[0]))))
            return false;
    return true;
}

/* Whether a text was worked, or any that has a number. */
static bool has_worked(const struct row_list *list, const struct row_text *text, bool *numbered)
{
    *numbered = false;
    for (int i = 0; i < list->norder; i++) {
        if (list->order[i] == text)
            return true;
        *numbered |= list->order[i]->label > 0;
    }
    return false;
}

/* Row 1 is a right-side row: where an odd number of rows stands before it, these begin on the wrong side, unless they have
 * numbers, the first of them being row 1. */
void row_list_doubt_side(struct row_list *list, struct row_text *const *text, int n)
{
    const char *s = list->norder == 1 ? "" : "s";
    bool numbered;

    if (list->start || list->round || list->front || list->failed || list->norder % 2 == 0 || !n || !text[0] || text[0]->label != 1 || are_alike(text, n) ||
        has_worked(list, text[0], &numbered))
        return;
    if (!numbered) {
        list->start = SIDE_WS;
        diag_warning(list->diag, CODE_WRONG_SIDE, text[0]->head, "row 1 is taken for a right-side row: the row%s before it begin%s on the wrong side", s, *s ? "" : "s");
        diag_hint(list->diag, "`Row 1 (RS)` says so; `Row 1 (WS)` if the first row of all is of the right side");
    } else if (!list->filler) {
        diag_warning(list->diag, CODE_WRONG_SIDE, text[0]->head, "row 1 is worked on the wrong side: %d row%s before it", list->norder, *s ? "s stand" : " stands");
        diag_hint(list->diag, "`Row 1 (RS)` if it is meant for the right side");
    }
}

/* Rows of one text for all WS rows end with a WS row, or with the one before `Row 58: bind off`; not where the last of
 * these are written out: `Rows 56-61: garter`. */
static bool ends_filled(const struct row_list *list, int n)
{
    int before = list->start == SIDE_WS ? list->norder + list->norder % 2 : list->norder, next = list->first + n;
    bool filled = false;

    if (!n || !filler_for(list, next, row_list_side(list, list->norder + n)))
        return false;
    if (list->bound_off == next || list->bound_off == next + 1)
        return list->bound_off > next;
    if ((before + n) % 2 == 0)
        return false;
    for (int i = 0; i < n; i++)
        filled |= !list->pending[i];
    return !filled || !list->pending[n - 2];
}

/* The pending rows once, gaps filled by `all .. rows`. */
void rows_work(struct row_list *list)
{
    int n = list->npending;

    if (!n && !list->filler)
        return;
    find_start(list);
    row_list_doubt_side(list, list->pending, list->npending);
    if (!n && (!list->norder || rows_described(list)))
        n = filler_for(list, list->first, row_list_side(list, list->norder)) == filler_for(list, list->first + 1, row_list_side(list, list->norder + 1)) ? 1 : 2;
    else
        n += ends_filled(list, n);
    for (int i = 0; i < n && !list->failed; i++) {
        int label = list->first + i;
        struct row_text *text = i < list->npending ? list->pending[i] : NULL;

        if (!text)
            text = filler_for(list, label, row_list_side(list, list->norder));
        if (!text) {
            diag_error(list->diag, CODE_ROW_NUMBER, behind_gap(list, i), "row %d is missing", label);
            if (list->norder >= label)
                diag_note(list->diag, behind_gap(list, i), "%d row%s above it, with those that have no number", list->norder, list->norder == 1 ? " is" : "s are");
            diag_hint(list->diag, label == 1 ? "number the first row 1, also where the cast-on has been called row 1" :
                      "rows are numbered 1, 2, 3 ..; `all WS rows: purl` can stand for every second one");
            row_list_fail(list);
            return;
        }
        list->label = row_list_grown(list, list->label, &list->label_room, label + 1);
        list->label[label] = text;
        if (!text->label)
            text->label = label;
        row_list_check_side(list, text, list->norder, 0);
        if (!row_list_append(list, text))
            return;
        list->last_label = list->worked_label = label;
    }
    for (int i = 0; i < list->npending; i++)
        list->pending[i] = NULL;
    list->first = list->last_label + 1;
    list->npending = list->ngiven = 0;
    list->fresh = false;
}

void rows_add_setup(struct row_list *list, struct row_text *text, int label)
{
    if (label == list->nsetup + 1) {
        list->nsetup++;
        rows_add_next(list, text);
        return;
    }
    diag_error(list->diag, CODE_ROW_NUMBER, text->head, "set-up row %d comes behind %d of them", label, list->nsetup);
    diag_hint(list->diag, "set-up rows are numbered 1, 2, 3 .. and worked in this order");
    row_list_fail(list);
}

void rows_add_next(struct row_list *list, struct row_text *text)
{
    if (!row_list_mix(list, text))
        return;
    rows_work(list);
    row_list_begin_on_side_of(list, text);
    list->loose = true;
    if (!list->failed) {
        row_list_check_side(list, text, list->norder, 0);
        row_list_append(list, text);
    }
}

/* The first row worked that has a number and is of the kind a text stands for; or NULL. */
static const struct row_text *first_of_kind(const struct row_list *list, const struct filler *filler)
{
    for (int i = 0; i < list->norder; i++)
        if (list->order[i]->label && fills(filler, list->order[i]->label, row_list_side(list, i)))
            return list->order[i];
    return NULL;
}

/* Warns of a text for all WS rows, say, that none was left to, where the first of these is another. */
static void doubt_filler(struct row_list *list)
{
    const struct filler *filler = list->filler;
    const struct row_text *given;

    while (filler && filler->text->worked)
        filler = filler->next;
    given = filler ? first_of_kind(list, filler) : NULL;
    if (!given || work_is_same(given->work, filler->text->work))
        return;
    diag_warning(list->diag, CODE_ALL_GIVEN, filler->text->head, "no row is left for this text: each of its kind is given");
    diag_note(list->diag, given->head, "this is the first of them");
    diag_hint(list->diag, "a row that comes before them is a set-up row: `Set-up row (WS): knit`");
}

bool rows_finish(struct row_list *list)
{
    rows_work(list);
    if (!list->failed)
        doubt_filler(list);
    if (!list->start && list->begins && !list->round)
        list->start = list->row_1;
    return !list->failed;
}
