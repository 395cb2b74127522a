/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows already given in; out, the same worked again. */
#include <string.h>

#include "lang/limits.h"
#include "lang/rows/row_list.h"

/* A row worked without a number, where its number is plain: the rows before it are the pattern's only. */
static struct row_text *unnumbered(const struct row_list *list, int label)
{
    if (label < 2 || label > list->norder || list->order[label - 1]->label || list->order[0]->label != 1)
        return NULL;
    return list->order[label - 1];
}

bool rows_labelled(struct row_list *list, struct span span, const int *label, int n, struct row_texts *texts)
{
    *texts = (struct row_texts){.text = arena_array(list->arena, struct row_text *, (size_t)n), .n = n};
    rows_work(list);
    for (int i = 0; i < n; i++) {
        texts->text[i] = label[i] > 0 && label[i] < list->label_room ? list->label[label[i]] : NULL;
        if (!texts->text[i])
            texts->text[i] = unnumbered(list, label[i]);
        if (!texts->text[i])
            texts->text[i] = row_list_counted(list, label[i]);
        if (list->failed || texts->text[i])
            continue;
        diag_error(list->diag, CODE_ROW_REFERENCE, span, "there is no row %d to repeat", label[i]);
        if (label[i] > list->last_label && label[i] <= list->norder)
            diag_hint(list->diag, "rows that were worked again have no numbers of their own: the last is row %d", list->last_label);
        row_list_fail(list);
    }
    return !list->failed;
}

struct row_texts rows_last(struct row_list *list, int n)
{
    rows_work(list);
    return (struct row_texts){.text = list->order + list->norder - n, .n = n};
}

void rows_mark(struct row_list *list, int stars)
{
    if (list->filler && !list->npending)
        rows_work(list);
    if (list->nmarks == list->mark_room)
        list->mark = arena_larger(list->arena, list->mark, &list->mark_room, sizeof *list->mark);
    list->mark[list->nmarks++] = (struct mark){stars, list->norder + list->npending};
}

/* The place in the order of work of the last mark before the n-th; n: where it stands among them. */
static int find_mark(const struct row_list *list, int stars, int *n)
{
    while (--*n >= 0)
        if (list->mark[*n].stars == stars)
            return list->mark[*n].rows;
    return list->norder;
}

bool rows_starred(struct row_list *list, struct span span, struct starred starred, struct row_texts *texts)
{
    int at = list->nmarks, end, first;

    rows_work(list);
    end = starred.to ? find_mark(list, starred.to, &at) : list->norder;
    first = find_mark(list, starred.from, &at);
    *texts = (struct row_texts){0};
    if (first < end && end <= list->norder)
        *texts = (struct row_texts){.text = list->order + first, .n = end - first};
    if (list->failed || texts->n)
        return !list->failed;
    diag_error(list->diag, CODE_ROW_REFERENCE, span, "no row is worked between these stars");
    return false;
}

/* Those said to be the pattern where they are others than the numbered ones of this part, from first on. */
static bool told_otherwise(const struct row_list *list, int first, int n)
{
    const struct told_rows *told = &list->told;

    return told->n && !(told->n == n && memcmp(told->row, list->label + first, (size_t)n * sizeof *told->row) == 0);
}

struct row_texts rows_pattern(struct row_list *list, bool going_on)
{
    const struct told_rows *told = &list->told;
    struct row_texts texts = {0};
    struct row_text *const *row;
    int first, next;

    rows_work(list);
    first = list->first_label;
    texts.n = list->last_label ? list->last_label - first + 1 : 0;
    row = texts.n ? list->label + first : NULL;
    next = list->worked_label < first ? 0 : list->worked_label - first + 1;
    if (told_otherwise(list, first, texts.n)) {
        row = told->row;
        texts.n = told->n;
        next = told->next;
        texts.told = going_on ? 1 + next : 1;
    }
    if (!texts.n)
        return texts;
    texts.text = arena_array(list->arena, struct row_text *, (size_t)texts.n);
    for (int i = 0; i < texts.n; i++)
        texts.text[i] = row[(i + (going_on ? next : 0)) % texts.n];
    return texts;
}

void rows_tell(struct row_list *list, struct span span, struct told told)
{
    int above;

    if (list->filler)
        rows_work(list);
    above = list->norder + list->npending;
    if (above && told.n > above + (list->npending > 0)) {   /* `all WS rows` may give one more */
        diag_warning(list->diag, CODE_ROWS_ABOVE, span, "%d rows are said to be the pattern, but %d %s above", told.n, above,
                     above == 1 ? "is" : "are");
        diag_hint(list->diag, "a row may be missing above, or be read as text");
    }
    if (told.n > above)
        return;

    /* Rows between may be told below: `all WS rows: purl`. */
    if (list->ngiven < list->npending)
        return;
    rows_work(list);
    if (told.n && told.n <= list->norder)
        list->told = (struct told_rows){list->order + list->norder - told.n, told.n, 0};
    else if (told.first >= list->first_label && told.last <= list->last_label)
        list->told = (struct told_rows){list->label + told.first, told.last - told.first + 1, 0};
}

void row_list_keep_part(struct row_list *list)
{
    struct part *part = arena_new(list->arena, struct part);

    *part = (struct part){list->label, list->label_room, list->last_label, list->first_label, list->worked_label, list->part};
    list->part = part;
}

static bool begins_at(struct row_text *const *label, int room, unsigned first)
{
    return room > 1 && label[1] && label[1]->head.start == first;
}

const struct row_text *rows_find_of(struct row_list *list, unsigned first, int label)
{
    for (const struct part *part = begins_at(list->label, list->label_room, first) ? NULL : list->part; part; part = part->next)
        if (begins_at(part->label, part->label_room, first))
            return label < part->label_room ? part->label[label] : NULL;
    return rows_find(list, label);
}

struct row_texts rows_of_name(struct row_list *list, unsigned first)
{
    const struct part *part = list->part;

    rows_work(list);
    if (begins_at(list->label, list->label_room, first))
        return (struct row_texts){.text = list->label + list->first_label, .n = list->last_label - list->first_label + 1};
    while (part && !begins_at(part->label, part->label_room, first))
        part = part->next;
    return part ? (struct row_texts){.text = part->label + part->first_label, .n = part->last_label - part->first_label + 1} : (struct row_texts){0};
}

void rows_tell_texts(struct row_list *list, struct row_texts texts, int next)
{
    list->told = (struct told_rows){texts.text, texts.n, next};
}

/* Takes a part out of those kept; NULL: there is none. */
static struct part *take_part(struct row_list *list, unsigned first)
{
    for (struct part **part = &list->part; *part; part = &(*part)->next)
        if (begins_at((*part)->label, (*part)->label_room, first)) {
            struct part *found = *part;

            *part = found->next;
            return found;
        }
    return NULL;
}

bool rows_choose(struct row_list *list, struct span span, unsigned first)
{
    struct part *part;

    rows_work(list);
    list->to_choose = false;
    list->told.n = 0;
    if (begins_at(list->label, list->label_room, first))
        return true;
    part = take_part(list, first);
    if (!part)
        return false;
    row_list_keep_part(list);
    list->label = part->label;
    list->label_room = part->label_room;
    list->last_label = part->last_label;
    list->first_label = part->first_label;
    list->first = part->last_label + 1;
    list->worked_label = 0;
    if (part->worked_label && part->worked_label != part->last_label) {
        diag_warning(list->diag, CODE_IN_PATTERN, span, "which row of this pattern comes first is not said: row %d", part->first_label);
        diag_hint(list->diag, "it was left behind row %d", part->worked_label);
    }
    return true;
}

void rows_describe(struct row_list *list, bool describes)
{
    list->describes = describes;
}

bool rows_to_choose(const struct row_list *list)
{
    return list->to_choose;
}

void rows_define(struct row_list *list)
{
    rows_work(list);
    list->order = NULL;
    list->norder = list->room = list->nmarks = 0;
    list->told.next = 0;
    list->start = SIDE_OPEN;
    list->worked_label = 0;
    list->loose = true;
}

/* Whether a part that was left behind was worked. */
static bool part_worked(const struct row_list *list)
{
    for (const struct part *part = list->part; part; part = part->next)
        if (part->worked_label)
            return true;
    return false;
}

bool rows_come_before(const struct row_list *list, struct row_texts texts, bool unnumbered)
{
    if (!list->norder || !texts.n)
        return false;
    return unnumbered ? !list->order[0]->label || part_worked(list) : list->last_label && list->label[list->first_label] != texts.text[0];
}

bool rows_worked(const struct row_list *list, struct row_texts texts)
{
    for (int i = 0; i < list->norder && texts.n; i++)
        if (list->order[i] == texts.text[0])
            return true;
    return list->failed || !texts.n;
}

static bool has_stitch(const struct work *work, stitch_id stitch)
{
    for (; work; work = work->next) {
        if (work->child && has_stitch(work->child, stitch))
            return true;
        for (int i = 0; !work->child && i < work->nruns; i++)
            if (work->run[i].stitch == stitch)
                return true;
    }
    return false;
}

/* The stitch at the beginning or the end of a row's text. */
static stitch_id edge_of(const struct work *work, bool last)
{
    while (last && work->next)
        work = work->next;
    if (work->child)
        return edge_of(work->child, last);
    return work->nruns ? work->run[last ? work->nruns - 1 : 0].stitch : STITCH_K;
}

bool rows_are_rib(struct row_texts texts)
{
    for (int i = 0; i < texts.n; i++) {
        const struct row_text *text = texts.text[i], *next = i + 1 < texts.n ? texts.text[i + 1] : text;

        if (text->as_below)
            continue;
        if (text->as_opposite || !text->work || !has_stitch(text->work, STITCH_K) || !has_stitch(text->work, STITCH_P))
            return false;
        if (next == text || !next->work)
            continue;

        /* Flat, the next row begins where this one ends, and shows the other face. */
        if (text->round ? edge_of(text->work, false) != edge_of(next->work, false) : edge_of(text->work, true) == edge_of(next->work, false))
            return false;
    }
    return texts.n > 0;
}

bool rows_begin_at(const struct row_list *list, long long place)
{
    return place >= 0 && place < list->norder && (place == 0 || list->order[place] != list->order[place - 1]);
}

bool rows_passed(const struct row_list *list, struct row_texts texts)
{
    for (int i = 0; i < texts.n && list->norder; i++)
        if (list->order[list->norder - 1] == texts.text[i])
            return false;
    return true;
}

bool rows_ws_first(const struct row_list *list)
{
    return !list->round && row_list_side(list, 0) == SIDE_WS;
}

enum side rows_last_side(const struct row_list *list)
{
    return list->norder && !list->round ? row_list_side(list, list->norder - 1) : SIDE_OPEN;
}

int rows_gone_on(const struct row_list *list, struct row_texts texts)
{
    int n = 0;

    while (texts.n && n < list->norder && list->order[list->norder - 1 - n] == texts.text[texts.n - 1 - n % texts.n])
        n++;
    return n;
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
    int n = texts.n, before;
    struct row_text **text = arena_array(list->arena, struct row_text *, (size_t)n + 1);

    rows_work(list);
    list->span = span;
    list->loose = true;
    if (list->failed || !n)
        return;
    if (times > LIMIT_ROWS / n || total > LIMIT_ROWS) {
        diag_error(list->diag, CODE_LIMIT_ROWS, span, "this makes more than %d rows", LIMIT_ROWS);
        row_list_fail(list);
        return;
    }

    /* The order grows, and `texts` may lie in it. */
    memcpy(text, texts.text, (size_t)n * sizeof *text);
    row_list_begin_on_side_of(list, text[0]);
    row_list_doubt_side(list, text, n);
    before = list->norder;
    for (long long pass = 0; times ? pass < times : list->norder < total; pass++)
        for (int i = 0; i < n && (times || list->norder < total); i++) {
            row_list_check_side(list, text[i], list->norder, n);
            if (list->failed || !row_list_append(list, text[i]))
                return;
        }
    remember_label(list);
    if (texts.told)
        list->told.next = (texts.told - 1 + list->norder - before) % list->told.n;
}
