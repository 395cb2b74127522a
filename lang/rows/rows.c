/* SPDX-License-Identifier: GPL-3.0-or-later
 * Row texts with their numbers in, a list of them out that knows which are still to be worked. */
#include <ctype.h>
#include <string.h>

#include "lang/limits.h"
#include "lang/page/page_facts.h"
#include "lang/rows/row_list.h"

struct row_list *rows_new(struct arena *arena, struct diag *diag)
{
    struct row_list *list = arena_new(arena, struct row_list);

    list->arena = arena;
    list->diag = diag;
    list->first = list->first_label = 1;
    return list;
}

void rows_of_page(struct row_list *list, const struct page_facts *facts)
{
    list->row_1 = facts->first;
    list->begins = facts->begins;
    list->bound_off = facts->bound_off;
    list->front = facts->pegs;
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

int rows_last_number(const struct row_list *list)
{
    return list->npending ? list->first + list->npending - 1 : list->last_label;
}

/* An array of row pointers with room for n. */
struct row_text **row_list_grown(struct row_list *list, struct row_text **array, int *room, int n)
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

const struct row_text *row_list_numbered(const struct row_list *list, int label)
{
    if (label >= list->first && label < list->first + list->npending && list->pending[label - list->first])
        return list->pending[label - list->first];
    return label > 0 && label < list->label_room ? list->label[label] : NULL;
}

/* Whether an empty line, or one of other text, lies between two places; what is behind the first on its line is its own. */
static bool stand_apart(struct span before, struct span head)
{
    int breaks = 0;

    for (unsigned at = before.end; before.source == head.source && at < head.start; at++) {
        char c = before.source->text[at];

        if (breaks && isalnum((unsigned char)c))
            return true;
        breaks += c == '\n' || (c == '\r' && before.source->text[at + 1] != '\n');
    }
    return breaks > 1;
}

/* Row 1 again is where a second part begins; right behind a single row 1 it is a slip. */
static void begin_again(struct row_list *list, const struct row_text *text)
{
    if (list->ngiven < list->npending && !list->filler)
        return;
    if (!list->loose && rows_last_number(list) < 2 && !stand_apart(row_list_numbered(list, 1)->span, text->head))
        return;
    if (!list->loose && !list->describes) {
        diag_warning(list->diag, CODE_SECOND_PART, text->head,
                     "the rows begin again at 1: taken as a second part, worked on top of the first");
        diag_hint(list->diag, "a row that is only numbered wrong: `Row %d`", rows_last_number(list) + 1);
    }
    list->to_choose = list->describes;
    if (list->describes)
        rows_define(list);
    rows_work(list);
    row_list_keep_part(list);
    list->label = NULL;
    list->first = list->first_label = 1;
    list->label_room = list->last_label = 0;
}

/* Rows worked before row 1: set-up rows, those without a number. */
static int rows_before_first(const struct row_list *list)
{
    int n = 0;

    while (n < list->norder && !list->order[n]->label)
        n++;
    return n < list->norder ? n : 0;
}

int rows_place(const struct row_list *list, long number)
{
    int before = rows_before_first(list), labels = list->last_label;
    long place = before + number - list->first_label;

    if (list->first_label != 1 || number < 1 || number > LIMIT_ROWS || labels < 1)
        return -1;
    if (number > labels && place >= list->norder)
        place = labels % 2 && !list->round ? -1 : before + (number - 1) % labels;
    if (place < 0 || place >= list->norder || (number <= labels && list->order[place] != list->label[number]))
        return -1;
    return (int)place;
}

/* After a repeat the count may go on with the number of rows worked so far, without those before row 1: those that were
 * worked again have the numbers between. */
static void count_on(struct row_list *list, int label)
{
    int before = rows_before_first(list);

    if (!list->last_label)
        list->first_label = label;
    list->label = row_list_grown(list, list->label, &list->label_room, label);
    for (int between = list->last_label + 1; list->last_label && between < label; between++)
        list->label[between] = list->order[before + between - list->first_label];
    list->counts_on |= list->last_label && label > list->last_label + 1;
    list->first = label;
}

int rows_up_to(const struct row_list *list, int number)
{
    return rows_before_first(list) + number - (list->last_label ? list->first_label : 1) + 1;
}

struct row_text *row_list_counted(const struct row_list *list, int label)
{
    int place = rows_before_first(list) + label - list->first_label;

    return list->counts_on && label > list->last_label && place < list->norder ? list->order[place] : NULL;
}

static void add_at(struct row_list *list, struct row_text *text, int label)
{
    int at;

    if (!list->npending && label > list->first && label == list->norder - rows_before_first(list) + (list->last_label ? list->first_label : 1))
        count_on(list, label);
    if (label == 1 && row_list_numbered(list, 1))
        begin_again(list, text);
    list->loose = false;
    at = label - list->first;
    if (at < 0 || (at < list->npending && list->pending[at])) {
        const struct row_text *other = row_list_numbered(list, label);

        diag_error(list->diag, CODE_ROW_NUMBER, text->head, "row %d is written twice", label);
        if (other)
            diag_note(list->diag, other->head, "the first time");
        if (other && label == 1)
            diag_hint(list->diag, "a second part stands apart, by an empty line or a heading; else `Row %d`", rows_last_number(list) + 1);
        row_list_fail(list);
        return;
    }
    list->pending = row_list_grown(list, list->pending, &list->pending_room, at + 1);
    list->pending[at] = text;
    list->ngiven++;
    list->told.n = 0;
    if (at >= list->npending)
        list->npending = at + 1;
    list->label = row_list_grown(list, list->label, &list->label_room, label + 1);
    list->label[label] = text;
    if (!text->label)
        text->label = label;
}

/* False for rows among rounds. */
bool row_list_mix(struct row_list *list, const struct row_text *text)
{
    if (text->round ? list->flat : list->round) {
        diag_error(list->diag, CODE_ROW_ROUND, text->head, "rows and rounds cannot be mixed in one fabric");
        diag_hint(list->diag, "rows are worked back and forth, rounds always from the right side");
        row_list_fail(list);
        return false;
    }
    list->round |= text->round;
    list->flat |= !text->round;
    list->span = text->head;
    return true;
}

void rows_add(struct row_list *list, struct row_text *text, int label)
{
    if (row_list_mix(list, text) && !list->failed)
        add_at(list, text, label);
}

/* The side that all rows of a kind are of. */
static enum side side_of(enum all_kind all)
{
    return all == ALL_RS || all == ALL_RS_ROW ? SIDE_RS : all == ALL_WS || all == ALL_WS_ROW ? SIDE_WS : SIDE_OPEN;
}

/* `RS: ..`, which may be a single row. */
static bool may_be_one(enum all_kind all)
{
    return all == ALL_RS_ROW || all == ALL_WS_ROW;
}

static void fill(struct row_list *list, struct row_text *text, enum all_kind all, int first, int last)
{
    struct filler *filler = arena_new(list->arena, struct filler), **end = &list->filler;

    for (const struct filler *f = list->filler; f && side_of(all); f = f->next)
        if (side_of(f->all) == side_of(all) && !list->failed) {
            diag_error(list->diag, CODE_ROW_NUMBER, text->head, "the %s rows are given twice", side_of(all) == SIDE_RS ? "RS" : "WS");
            diag_note(list->diag, f->text->head, "here already");
            diag_hint(list->diag, "number rows that follow each other: `Row 1 (RS): ...`, `Row 2 (WS): ...`");
            row_list_fail(list);
        }
    *filler = (struct filler){.all = all, .first = first, .last = last, .text = text};
    while (*end)
        end = &(*end)->next;
    *end = filler;
    list->fresh = true;
    list->round |= text->round;
    list->flat |= !text->round;
    list->span = text->head;
}

/* ---- rows named by their sides ---- */

/* Whether a side comes again of `RS: ..`, `WS: ..`, and nothing else stands for several rows. */
static bool comes_again(const struct row_list *list, enum all_kind all)
{
    bool again = false;

    for (const struct filler *f = list->filler; f; f = f->next) {
        if (!may_be_one(f->all))
            return false;
        again |= f->all == all;
    }
    return again && !list->npending;
}

/* One behind a repeat begins a part of its own. */
static void add_in_turn(struct row_list *list, struct row_text *text, enum all_kind all)
{
    text->side = side_of(all);
    rows_add(list, text, list->loose ? 1 : rows_last_number(list) + 1);
}

/* `RS: ..`, `WS: ..`, `RS: ..`: rows that follow each other, also those before that are not worked yet. */
static void take_turns(struct row_list *list)
{
    const struct filler *filler = list->filler;

    list->in_turn = true;
    list->filler = NULL;
    for (; filler && list->fresh; filler = filler->next)
        add_in_turn(list, filler->text, filler->all);
    list->fresh = false;
}

void rows_fill(struct row_list *list, struct row_text *text, enum all_kind all, int first, int last)
{
    if (may_be_one(all) && !list->in_turn && comes_again(list, all))
        take_turns(list);
    if (may_be_one(all) && list->in_turn)
        add_in_turn(list, text, all);
    else
        fill(list, text, all, first, last);
}
