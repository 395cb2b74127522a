/* SPDX-License-Identifier: GPL-3.0-or-later
 * Row texts in, the order they are worked in and the grid they make out. */
#include "lang/rows.h"

#include <ctype.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "lang/limits.h"
#include "lang/row_draw.h"
#include "lang/row_fit.h"
#include "lang/row_misfit.h"

/* The text that stands for every row of a kind. */
struct filler {
    enum all_kind all;
    int first; /* ALL_OTHER, ALL_FOLLOWING: the row it was given for */
    struct row_text *text;
    struct filler *next;
};

struct row_list {
    struct arena *arena;
    struct diag *diag;

    /* Rows in working order. */
    struct row_text **order;
    int norder, room;

    /* The numbered rows not yet worked: labels first .. first + npending - 1. */
    struct row_text **pending;
    int first, npending, pending_room;

    /* All numbered rows, by label, for `as row 3` and repeats. */
    struct row_text **label;
    int label_room;

    struct filler *filler;
    int last_label, first_label;    /* of this part of the pattern */
    int nsetup;                     /* numbered set-up rows */
    int worked_label;               /* of the numbered row worked last */
    bool loose;                     /* what came last had no number, or was a repeat */
    enum side start; /* the side of the first row worked; open until known */
    bool round, flat, failed;
    struct span span; /* of the row added last */
};

struct row_list *rows_new(struct arena *arena, struct diag *diag)
{
    struct row_list *list = arena_new(arena, struct row_list);

    list->arena = arena;
    list->diag = diag;
    list->first = list->first_label = 1;
    return list;
}

bool rows_any(const struct row_list *list)
{
    return list->norder || list->npending || list->filler;
}

bool rows_good(const struct row_list *list)
{
    for (int i = 0; i < list->norder; i++)
        if (list->order[i]->failed)
            return false;
    return !list->failed;
}

bool rows_round(const struct row_list *list)
{
    return list->round;
}

int rows_count(const struct row_list *list)
{
    return list->norder;
}

static int last_given(const struct row_list *list)
{
    return list->npending ? list->first + list->npending - 1 : list->last_label;
}

/* An array of row pointers with room for n. */
static struct row_text **grown(struct row_list *list, struct row_text **array, int *room, int n)
{
    struct row_text **larger;
    int wanted = *room ? *room : 16;

    if (n <= *room)
        return array;
    while (wanted < n)
        wanted *= 2;
    larger = arena_array(list->arena, struct row_text *, (size_t)wanted);
    if (*room)
        memcpy(larger, array, (size_t)*room * sizeof *array);
    *room = wanted;
    return larger;
}

static void fail(struct row_list *list)
{
    list->failed = true;
}

/* ---- numbering ---- */

const struct row_text *rows_find(const struct row_list *list, int label)
{
    if (label >= list->first && label < list->first + list->npending && list->pending[label - list->first])
        return list->pending[label - list->first];
    return label > 0 && label < list->label_room ? list->label[label] : NULL;
}

static void flush(struct row_list *list);

/* Whether an empty line or other text lies between two places. */
static bool stand_apart(struct span before, struct span head)
{
    int breaks = 0;

    for (unsigned at = before.end; before.source == head.source && at < head.start; at++) {
        char c = before.source->text[at];

        if (isalnum((unsigned char)c))
            return true;
        breaks += c == '\n' || (c == '\r' && before.source->text[at + 1] != '\n');
    }
    return breaks > 1;
}

/* Row 1 again is where a second part begins; right behind a single row 1 it is a slip. */
static void begin_again(struct row_list *list, const struct row_text *text)
{
    for (int i = 0; i < list->npending; i++)
        if (!list->pending[i] && !list->filler)
            return;
    if (!list->loose && last_given(list) < 2 && !stand_apart(rows_find(list, 1)->span, text->head))
        return;
    if (!list->loose) {
        diag_warning(list->diag, CODE_SECOND_PART, text->head,
                     "the rows begin again at 1: taken as a second part, worked on top of the first");
        diag_hint(list->diag, "a row that is only numbered wrong: `Row %d`", last_given(list) + 1);
    }
    flush(list);
    list->first = list->first_label = 1;
    list->last_label = 0;
    for (int i = 0; i < list->label_room; i++)
        list->label[i] = NULL;
}

/* Rows worked before row 1: set-up rows, those without a number. */
static int rows_before_first(const struct row_list *list)
{
    int n = 0;

    while (n < list->norder && !list->order[n]->label)
        n++;
    return n < list->norder ? n : 0;
}

/* After a repeat the count may go on with the number of rows worked so far, without those before row 1: those that were
 * worked again have the numbers between. */
static void count_on(struct row_list *list, int label)
{
    int before = rows_before_first(list);

    if (!list->last_label)
        list->first_label = label;
    list->label = grown(list, list->label, &list->label_room, label);
    for (int between = list->last_label + 1; list->last_label && between < label; between++)
        list->label[between] = list->order[before + between - 1];
    list->first = label;
}

static void add_at(struct row_list *list, struct row_text *text, int label)
{
    int at;

    if (!list->npending && label > list->first && label == list->norder - rows_before_first(list) + 1)
        count_on(list, label);
    if (label == 1 && rows_find(list, 1))
        begin_again(list, text);
    list->loose = false;
    at = label - list->first;
    if (at < 0 || (at < list->npending && list->pending[at])) {
        const struct row_text *other = rows_find(list, label);

        diag_error(list->diag, CODE_ROW_NUMBER, text->head, "row %d is written twice", label);
        if (other)
            diag_note(list->diag, other->head, "the first time");
        if (other && label == 1)
            diag_hint(list->diag, "a second part stands apart, by an empty line or a heading; else `Row %d`", last_given(list) + 1);
        fail(list);
        return;
    }
    if (at >= LIMIT_WRITTEN_ROWS) {
        diag_error(list->diag, CODE_LIMIT_ROWS, text->head, "row %d: a pattern may have %d written rows",
                   label, LIMIT_WRITTEN_ROWS);
        fail(list);
        return;
    }
    list->pending = grown(list, list->pending, &list->pending_room, at + 1);
    list->pending[at] = text;
    if (at >= list->npending)
        list->npending = at + 1;
    list->label = grown(list, list->label, &list->label_room, label + 1);
    list->label[label] = text;
    if (!text->label)
        text->label = label;
}

/* False for rows among rounds. */
static bool rows_mix(struct row_list *list, const struct row_text *text)
{
    if (text->round ? list->flat : list->round) {
        diag_error(list->diag, CODE_ROW_ROUND, text->head, "rows and rounds cannot be mixed in one fabric");
        diag_hint(list->diag, "rows are worked back and forth, rounds always from the right side");
        fail(list);
        return false;
    }
    list->round |= text->round;
    list->flat |= !text->round;
    list->span = text->head;
    return true;
}

void rows_add(struct row_list *list, struct row_text *text, int label)
{
    if (rows_mix(list, text) && !list->failed)
        add_at(list, text, label);
}

void rows_fill(struct row_list *list, struct row_text *text, enum all_kind all, int first)
{
    struct filler *filler = arena_new(list->arena, struct filler), **last = &list->filler;

    *filler = (struct filler){.all = all, .first = first, .text = text};
    while (*last)
        last = &(*last)->next;
    *last = filler;
    list->round |= text->round;
    list->flat |= !text->round;
    list->span = text->head;
}

/* ---- the order of work ---- */

static enum side other_side(enum side side)
{
    return side == SIDE_RS ? SIDE_WS : SIDE_RS;
}

/* The side the i-th row worked (from 0) is worked on. */
static enum side side_of(const struct row_list *list, int i)
{
    enum side start = list->start ? list->start : SIDE_RS;

    return list->round || i % 2 == 0 ? start : other_side(start);
}

/* The first marked row decides on which side the work begins. */
static void find_start(struct row_list *list)
{
    for (int i = 0; i < list->npending && !list->start; i++) {
        const struct row_text *text = list->pending[i];

        if (text && text->side)
            list->start = (list->norder + i) % 2 == 0 || list->round ? text->side : other_side(text->side);
    }
    if (list->round && list->start == SIDE_WS) {
        diag_error(list->diag, CODE_ROW_SIDE, list->span, "a round is always worked from the right side");
        fail(list);
    }
}

/* The same by the row worked next. */
static void begin_on_side_of(struct row_list *list, const struct row_text *text)
{
    if (!list->start && text->side)
        list->start = list->norder % 2 == 0 || list->round ? text->side : other_side(text->side);
}

static struct row_text *filler_for(const struct row_list *list, int label, enum side side)
{
    for (const struct filler *f = list->filler; f; f = f->next)
        if ((f->all == ALL_RS && side == SIDE_RS) || (f->all == ALL_WS && side == SIDE_WS) ||
            (f->all == ALL_EVEN && label % 2 == 0) || (f->all == ALL_ODD && label % 2 == 1) ||
            f->all == ALL_EVERY || (f->all == ALL_FOLLOWING && label >= f->first) || (f->all == ALL_OTHER && label >= f->first && (label - f->first) % 2 == 0))
            return f->text;
    return NULL;
}

/* Appends a row to the order of work; false past the limit. */
static bool append(struct row_list *list, struct row_text *text)
{
    if (list->norder >= LIMIT_ROWS) {
        diag_error(list->diag, CODE_LIMIT_ROWS, list->span, "this makes more than %d rows", LIMIT_ROWS);
        fail(list);
        return false;
    }
    list->order = grown(list, list->order, &list->room, list->norder + 1);
    list->order[list->norder++] = text;
    return true;
}

/* `repeated`: so many rows are, which brings it there; 0: none. */
static void check_side(struct row_list *list, const struct row_text *text, int i, int repeated)
{
    enum side side = side_of(list, i);
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
    fail(list);
}

/* Works the pending rows once, gaps filled by `all .. rows`. */
static void flush(struct row_list *list)
{
    int n = list->npending;

    /* A pattern of RS rows with one text for all WS rows ends with a WS row. */
    if (!n && !list->filler)
        return;
    find_start(list);
    if (!n && !list->norder)
        n = filler_for(list, 1, side_of(list, 0)) == filler_for(list, 2, side_of(list, 1)) ? 1 : 2;
    else if (n && (list->norder + n) % 2 && filler_for(list, list->first + n, side_of(list, list->norder + n)))
        n++;
    for (int i = 0; i < n && !list->failed; i++) {
        int label = list->first + i;
        struct row_text *text = i < list->npending ? list->pending[i] : NULL;

        if (!text)
            text = filler_for(list, label, side_of(list, list->norder));
        if (!text) {
            diag_error(list->diag, CODE_ROW_NUMBER, list->span, "row %d is missing", label);
            diag_hint(list->diag, label == 1 ? "number the first row 1, also where the cast-on has been called row 1" :
                      "rows are numbered 1, 2, 3 ..; `all WS rows: purl` can stand for every second one");
            fail(list);
            return;
        }
        list->label = grown(list, list->label, &list->label_room, label + 1);
        list->label[label] = text;
        if (!text->label)
            text->label = label;
        check_side(list, text, list->norder, 0);
        if (!append(list, text))
            return;
        list->last_label = list->worked_label = label;
    }
    for (int i = 0; i < list->npending; i++)
        list->pending[i] = NULL;
    list->first = list->last_label + 1;
    list->npending = 0;
}

void rows_work(struct row_list *list)
{
    flush(list);
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
    fail(list);
}

void rows_add_next(struct row_list *list, struct row_text *text)
{
    if (!rows_mix(list, text))
        return;
    flush(list);
    begin_on_side_of(list, text);
    list->loose = true;
    if (!list->failed) {
        check_side(list, text, list->norder, 0);
        append(list, text);
    }
}

/* ---- rows worked again ---- */

/* A row worked without a number, where its number is plain: the rows before it are the pattern's only. */
static struct row_text *unnumbered(const struct row_list *list, int label)
{
    if (label < 2 || label > list->norder || list->order[label - 1]->label || list->order[0]->label != 1)
        return NULL;
    return list->order[label - 1];
}

bool rows_labelled(struct row_list *list, struct span span, const int *label, int n, struct row_texts *texts)
{
    *texts = (struct row_texts){arena_array(list->arena, struct row_text *, (size_t)n), n};
    flush(list);
    for (int i = 0; i < n; i++) {
        texts->text[i] = label[i] > 0 && label[i] < list->label_room ? list->label[label[i]] : NULL;
        if (!texts->text[i])
            texts->text[i] = unnumbered(list, label[i]);
        if (list->failed || texts->text[i])
            continue;
        diag_error(list->diag, CODE_ROW_REFERENCE, span, "there is no row %d to repeat", label[i]);
        fail(list);
    }
    return !list->failed;
}

struct row_texts rows_last(struct row_list *list, int n)
{
    flush(list);
    return (struct row_texts){list->order + list->norder - n, n};
}

struct row_texts rows_pattern(struct row_list *list, bool going_on)
{
    struct row_texts texts = {0};
    int first, n;

    flush(list);
    first = list->first_label;
    n = list->last_label - first + 1;
    if (n < 1 || !list->last_label)
        return texts;
    texts = (struct row_texts){arena_array(list->arena, struct row_text *, (size_t)n), n};
    for (int i = 0; i < n; i++)
        texts.text[i] = list->label[first + (i + (going_on ? list->worked_label - first + 1 : 0)) % n];
    return texts;
}

void rows_define(struct row_list *list)
{
    flush(list);
    list->norder = 0;
    list->start = SIDE_OPEN;
    list->worked_label = 0;
    list->loose = true;
}

bool rows_worked(const struct row_list *list, struct row_texts texts)
{
    for (int i = 0; i < list->norder && texts.n; i++)
        if (list->order[i] == texts.text[0])
            return true;
    return list->failed || !texts.n;
}

bool rows_just_worked(const struct row_list *list, struct row_texts texts)
{
    int first = list->norder - texts.n;

    if (list->failed || first < 0 || !texts.n || memcmp(list->order + first, texts.text, (size_t)texts.n * sizeof *texts.text) != 0)
        return false;
    for (int i = 0; i < first; i++)
        if (list->order[i] == texts.text[0])
            return false;
    return true;
}

void rows_both_sides(struct row_list *list, struct row_texts texts)
{
    if (texts.n == 1 && list->norder && list->order[list->norder - 1] == texts.text[0])
        texts.text[0]->side = SIDE_OPEN;
}

/* The label of the row worked last, for `continue in pattern`. */
static void remember_label(struct row_list *list)
{
    for (int label = list->first_label; label <= list->last_label; label++)
        if (list->norder && list->label[label] == list->order[list->norder - 1])
            list->worked_label = label;
}

void rows_again(struct row_list *list, struct span span, struct row_texts texts, long long times, long long total)
{
    int n = texts.n;
    struct row_text **text = arena_array(list->arena, struct row_text *, (size_t)n + 1);

    flush(list);
    list->span = span;
    list->loose = true;
    if (list->failed || !n)
        return;
    if (times > LIMIT_ROWS / n || total > LIMIT_ROWS) {
        diag_error(list->diag, CODE_LIMIT_ROWS, span, "this makes more than %d rows", LIMIT_ROWS);
        fail(list);
        return;
    }

    /* The order grows, and `texts` may lie in it. */
    memcpy(text, texts.text, (size_t)n * sizeof *text);
    begin_on_side_of(list, text[0]);
    for (long long pass = 0; times ? pass < times : list->norder < total; pass++)
        for (int i = 0; i < n && (times || list->norder < total); i++) {
            check_side(list, text[i], list->norder, n);
            if (list->failed || !append(list, text[i]))
                return;
        }
    remember_label(list);
}

bool rows_finish(struct row_list *list)
{
    flush(list);
    return !list->failed;
}

/* ---- widths ---- */

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

/* ---- drawing ---- */

static bool nothing_below(struct row_list *list, const struct row_text *text)
{
    const char *row = list->round ? "rnd" : side_of(list, 0) == SIDE_WS ? "row (RS)" : "row (WS)";

    diag_error(list->diag, CODE_ROW_REFERENCE, text->span, "there is no row below the first");
    diag_hint(list->diag, "put the row it is worked on before it, `Set-up %s: *k2, p2; rep from * to end`, or write its own stitches", row);
    return false;
}

const struct grid *rows_grid(struct row_list *list, int width, int height, enum width_from from,
                             const stitch_id *ws)
{
    stitch_id *cell, *worked = arena_array(list->arena, stitch_id, (size_t)width);
    int rows = height ? height : list->norder;
    struct grid *g = grid_new(list->arena, width, rows, &cell);
    const struct row_text *before = NULL;
    bool good = true;

    for (int i = 0; i < list->norder; i++)
        memset(list->order[i]->drawn, 0, sizeof list->order[i]->drawn);
    for (int i = 0; i < rows; i++) {
        struct row_text *text = list->order[i % list->norder];
        enum side side = side_of(list, i);
        stitch_id *to = cell + (size_t)i * (size_t)width;

        /* A text that was drawn on this side before is the same again. */
        if (i >= list->norder)
            check_side(list, text, i, 0);
        if (list->failed)
            return NULL;
        if (text->failed) {
            good = false;
            before = NULL;
            continue;
        }
        if ((text->as_below || text->as_opposite) && i == 0) {
            nothing_below(list, text);
            return NULL;
        }
        if (text->as_opposite) {
            for (int x = 0; x < width; x++)
                to[x] = ws[to[x - width]];
        } else if (text->as_below) {
            memcpy(to, to - width, (size_t)width);
        } else if (text->drawn[side]) {
            memcpy(to, cell + (size_t)(text->drawn[side] - 1) * (size_t)width, (size_t)width);
        } else {
            struct row_text here = *text;

            here.work = side == SIDE_WS && text->on_ws ? text->on_ws : text->work;
            if (!row_work(list->diag, &here, width, from, before, worked)) {
                good = false;
            } else if (i == 0 && row_draw_asks_below(worked, width)) {
                good = nothing_below(list, text);
            } else if (good) {
                text->drawn[side] = row_draw(to, worked, (struct row_place){width, side, list->round, i == 0, ws}) ? i + 1 : 0;
            }
        }
        before = text;
    }
    return good ? g : NULL;
}
