/* SPDX-License-Identifier: GPL-3.0-or-later
 * The items of a row in, what is worked with all its numbers known out. */
#include "lang/lower.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "lang/limits.h"
#include "lang/rows/row_fit.h"
#include "lang/vocabulary.h"

/* Worked once, of so many runs of stitches. */
static struct work *work_new(struct eval *eval, struct where where, const struct item *item, int nruns)
{
    struct work *work = arena_new(eval->arena, struct work);

    work->span = item_span(where.module->source, item);
    work->n = 1;
    if (nruns)
        work->run = arena_array(eval->arena, struct run, (size_t)nruns);
    return work;
}

/* False past the limits. */
static bool count_item(struct eval *eval, struct where where, const struct item *item)
{
    struct span span = item_span(where.module->source, item);

    if (++eval->items == LIMIT_ITEMS + 1)
        diag_error(eval->diag, CODE_LIMIT_ROWS, span, "the rows have more than %d stitches and groups to work", LIMIT_ITEMS);
    return eval_step(eval, span) && eval->items <= LIMIT_ITEMS && !diag_is_full(eval->diag, span);
}

/* `(k2, p2) repeat 3 times`, which may be worked before: the width tells; not `*k2, p2* 3 times`. */
static bool is_bracket_repeated(struct where where, const struct item *item)
{
    return item->kind == ITEM_STARS && strchr("([", where.module->source->text[item->start]);
}

static bool lower_until(struct eval *eval, struct where where, const struct item *item, struct work *work)
{
    const struct until *until = &item->more->until;
    long long n = 1;

    if (until->n && !eval_whole(eval, where, until->n, 0, LIMIT_STITCHES, "this number", &n))
        return false;
    work->n = n;
    switch (until->kind) {
    case UNTIL_ONCE:
        work->until = item->kind == ITEM_REP_FROM || item->kind == ITEM_STARS ? WORK_FIT : WORK_TIMES;
        work->bare = item->kind == ITEM_GROUP;
        return true;
    case UNTIL_TIMES:
        work->until = item->kind == ITEM_REP_FROM || is_bracket_repeated(where, item) ? WORK_EITHER : WORK_TIMES;
        return true;
    case UNTIL_LAST_OR_ALL:
        work->until = n > 1 ? WORK_LAST_OR_ALL : WORK_TIMES;
        return true;
    case UNTIL_MORE:
        work->n = n + 1;
        if (item->kind == ITEM_REP_FROM || item->kind == ITEM_STARS)
            return true;
        diag_error(eval->diag, CODE_ROW_REPEAT, until->span,
                   "a group in brackets is worked so many times in all, not more");
        return false;
    case UNTIL_LAST:
        work->until = WORK_LAST;
        return true;
    case UNTIL_MARKER:
    case UNTIL_SECOND_MARKER:
    case UNTIL_LAST_MARKER:
        work->until = WORK_MARKER;
        work->marker = until->kind == UNTIL_SECOND_MARKER ? MARKER_SECOND : until->kind == UNTIL_LAST_MARKER ? MARKER_LAST : MARKER_NEXT;
        work->n = until->n ? n : 0;
        return true;
    case UNTIL_END:
        /* `*k2, p2; rep from * to end, k1`: as far as leaves room for k1. */
        work->until = item->kind > ITEM_STITCH && item->next ? WORK_FIT : WORK_LAST;
        work->unmarked = item->kind == ITEM_REP_FROM && isalpha((unsigned char)where.module->source->text[item->start]);
        work->n = 0;
        return true;
    default:
        work->until = WORK_FIT;
        work->ending = item->kind > ITEM_STITCH;
        return true;
    }
}

/* The letters of `kkpp`, stitches that are spelled out; 0: the word is another. */
static size_t spelled_length(const struct stitch_words *words)
{
    size_t n = 0;

    while (n < words->length && strchr("kKpP", words->name[n]))
        n++;
    return n == words->length && (n > 2 || (n == 2 && words->name[0] == words->name[1])) && !words->count && !words->figures.source ? n : 0;
}

/* Adds the stitches of `kkpp` to the runs, one by one. */
static bool lower_spelled(struct eval *eval, struct where where, const struct item *item, const struct stitch_words *words, struct work *work)
{
    long long none;

    for (size_t i = 0; i < words->length; i++) {
        struct run *run = work->run + work->nruns++;

        run->length = 1;
        work->length++;
        if (!vocabulary_stitch(eval, where.module, words->name + i, 1, item->start, &run->stitch, &none))
            return false;
    }
    return true;
}

/* Adds `k2` or `k 2` to the runs, unless it is none: `k0`. *bare: no number is said. */
static bool lower_stitch(struct eval *eval, struct where where, const struct item *item, struct work *work, bool *bare)
{
    struct run *run = work->run + work->nruns;
    struct stitch_words words = item_words(where.module->source, item);
    bool apart = words.count || words.figures.source;
    long long in_name, count = 1;

    *bare = false;
    if (spelled_length(&words) && !vocabulary_has(eval, where.module, words.name, words.length))
        return lower_spelled(eval, where, item, &words, work);
    if (!vocabulary_stitch(eval, where.module, words.name, words.length, item->start, &run->stitch, &in_name))
        return false;
    if (apart && in_name >= 0) {
        diag_error(eval->diag, CODE_ROW_REPEAT, item_span(where.module->source, item), "'%.*s' has a number already",
                   (int)words.length, words.name);
        return false;
    }
    if (words.count && !eval_whole(eval, where, words.count, 0, LIMIT_STITCHES, "the number of stitches", &count))
        return false;
    if (words.figures.source)
        count = strtoll(words.figures.source->text + words.figures.start, NULL, 10);
    *bare = in_name < 0 && !apart;
    run->length = (unsigned)(in_name >= 0 ? in_name : count);
    work->length += run->length;
    work->nruns += run->length > 0;
    return true;
}

/* `k2, moss, k3`: of a fabric a number of stitches is needed. */
static bool says_how_many(struct eval *eval, struct where where, const struct item *item, const struct work *work, bool bare)
{
    if (!bare || work->run[work->nruns - 1].stitch < STITCH_REVERSE)
        return true;
    diag_error(eval->diag, CODE_ROW_REPEAT, item_span(where.module->source, item), "over how many stitches this fabric is worked is not said");
    diag_hint(eval->diag, "`moss 5`, or `moss to last 3 sts`");
    return false;
}

static int count_stitches(const struct source *source, const struct item *item)
{
    int n = 0;

    for (struct item one = {0}; item_step(source, item, &one);) {
        struct stitch_words words = item_words(source, &one);

        n += spelled_length(&words) ? (int)words.length : 1;
    }
    return n;
}

/* Plain stitches that follow each other are one piece of work. Moves to the last
 * of them. A bare `k` that is the whole row fills it. */
static bool lower_plain(struct eval *eval, struct where where, const struct item **item, bool alone, struct work **to)
{
    const struct item *first = *item, *last = first;
    struct work *work;
    bool good = true, bare = false;
    int n = count_stitches(where.module->source, first);

    for (; last->next && item_is_plain(last->next); last = last->next)
        n += count_stitches(where.module->source, last->next);
    work = work_new(eval, where, first, n);
    work->span = span_join(work->span, item_span(where.module->source, last));
    *item = last;
    for (; first != last->next; first = first->next)
        for (struct item stitch = {0}; item_step(where.module->source, first, &stitch);) {
            if (!count_item(eval, where, &stitch))
                return false;
            good &= lower_stitch(eval, where, &stitch, work, &bare) && (alone || says_how_many(eval, where, &stitch, work, bare));
        }
    if (alone && bare)
        work->until = WORK_FIT;
    *to = work->nruns ? work : NULL;
    return good;
}

/* False after an error; *to is left NULL for nothing at all: `k0`, `(p0) twice`. */
static bool lower_item(struct eval *eval, struct where where, const struct item *item, bool alone, struct work **to)
{
    struct work *work = work_new(eval, where, item, item->kind == ITEM_STITCH ? (int)strlen(item->more->name) : 0);
    bool bare;

    if (!count_item(eval, where, item) || !lower_until(eval, where, item, work))
        return false;
    if (item->kind == ITEM_STITCH && item->more->within) {
        work->within = item->more->within;
        *to = work;
        return true;
    }
    if (item_is_below(item)) {
        work->run[0] = (struct run){1, item->more->name == item_opposite ? STITCH_OTHER : STITCH_SAME};
        work->nruns = 1;
        work->length = 1;
        *to = work;
        return true;
    }
    if (item_is_marker(item)) {
        work->mark = item->more->name == item_placed ? MARK_PLACED : item->more->name == item_slipped ? MARK_SLIPPED : MARK_REMOVED;
        *to = work;
        return true;
    }
    if (item->kind == ITEM_STITCH) {
        if (!lower_stitch(eval, where, item, work, &bare))
            return false;
        if (alone && bare && item->more->until.kind == UNTIL_ONCE)
            work->until = WORK_FIT;
        *to = work->nruns ? work : NULL;
        return true;
    }
    if (!lower_items(eval, where, item->more->child, &work->child))
        return false;

    /* `*k*`: one stitch, as often as the star says. */
    if (work->child && !work->child->next && work->child->run && work->child->until == WORK_FIT && item_is_plain(item->more->child))
        work->child->until = WORK_TIMES;
    *to = work->child ? work : NULL;
    if (*to || work->until == WORK_TIMES)
        return true;
    diag_error(eval->diag, CODE_ROW_REPEAT, work->span, "there is nothing to work here");
    return false;
}

/* The first runs of a list of work, of so many stitches, as work of their own. */
static struct work *first_runs(struct eval *eval, const struct work *from, long long length)
{
    struct work *work = arena_new(eval->arena, struct work);

    *work = (struct work){.span = from->span, .n = 1, .length = length};
    for (; from && length > 0; from = from->next) {
        struct run *run = arena_array(eval->arena, struct run, (size_t)(work->nruns + from->nruns));

        if (work->nruns)
            memcpy(run, work->run, (size_t)work->nruns * sizeof *run);
        work->run = run;
        for (int i = 0; i < from->nruns && length > 0; i++) {
            run[work->nruns++] = from->run[i];
            length -= from->run[i].length;
        }
    }
    return work;
}

static long long length_of(const struct work *work)
{
    long long length = 0;

    for (; work; work = work->next)
        length += work->length * work->n;
    return length;
}

/* "ending last rep k2": the last repeat goes on up to there. */
static bool end_last_repeat(struct eval *eval, struct work *work, struct span until)
{
    int from = 0;
    long long stop;
    struct work *begin;

    if (!work->next)
        return true;
    stop = work_stop(work, &from);
    if (stop >= 0 && from == 1)
        return true;
    if (stop < 0 || work_stop(work, &from) >= 0) {
        diag_error(eval->diag, CODE_ROW_REPEAT, until, "how the last repeat ends can be read in two ways");
        diag_hint(eval->diag, "write what follows the whole repeats: `rep from * to last 2 sts, k2`");
        return false;
    }
    begin = first_runs(eval, work->child, stop - length_of(work->next));
    begin->next = work->next;
    work->next = begin;
    work->ending = false;
    return true;
}

/* Whether one item is the whole row, but for markers. */
static bool is_alone(const struct item *item)
{
    int n = 0;

    for (; item; item = item->next)
        n += !item_is_marker(item);
    return n == 1;
}

bool lower_items(struct eval *eval, struct where where, const struct item *item, struct work **first)
{
    struct work *repeat = NULL;
    struct span until = {0};
    bool alone = is_alone(item), good = true;

    *first = NULL;
    for (; item; item = item->next) {
        good &= item_is_plain(item) ? lower_plain(eval, where, &item, alone, first) : lower_item(eval, where, item, alone, first);
        if (*first && !item_is_plain(item) && item->more->until.kind == UNTIL_LAST_REPEAT) {
            repeat = *first;
            until = item->more->until.span;
        }
        if (*first)
            first = &(*first)->next;
    }
    return good && (!repeat || end_last_repeat(eval, repeat, until));
}
