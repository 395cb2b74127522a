/* SPDX-License-Identifier: GPL-3.0-or-later
 * The arithmetic of one row: its text in, the widths it fits and its stitches
 * in working order out. */
#include "lang/rows/row_fit.h"

#include <string.h>

#include "lang/limits.h"
#include "lang/names.h"
#include "lang/rows/row_misfit.h"

static const long long many = 1LL << 40; /* lengths stop growing here */

static long long least(long long a, long long b)
{
    return a < b ? a : b;
}

static long long times(long long a, long long b)
{
    return a && b > many / a ? many : a * b;
}

/* The length of something worked a definite number of times, or -1. */
static long long fixed_length(const struct work *work)
{
    return work->until == WORK_TIMES ? times(work->length, work->n) : -1;
}

bool work_measure(struct diag *diag, struct work *work, long long *length)
{
    *length = 0;
    for (; work; work = work->next) {
        if (work->child && !work_measure(diag, work->child, &work->length))
            return false;
        for (const struct work *part = work->child; part; part = part->next)
            if (part->until != WORK_TIMES) {
                diag_error(diag, CODE_ROW_REPEAT, part->span,
                           "inside a repeat the number of times must be given");
                return false;
            }
        if (work->length < 1 && work->until != WORK_TIMES) {
            diag_error(diag, CODE_ROW_REPEAT, work->span, "there is nothing to work here");
            return false;
        }
        if (fixed_length(work) > 0)
            *length = least(many, *length + fixed_length(work));
    }
    return true;
}

bool work_is_same(const struct work *a, const struct work *b)
{
    for (; a && b; a = a->next, b = b->next) {
        if (a->nruns != b->nruns || a->until != b->until || a->n != b->n || !work_is_same(a->child, b->child))
            return false;
        for (int i = 0; i < a->nruns; i++)
            if (a->run[i].length != b->run[i].length || a->run[i].stitch != b->run[i].stitch)
                return false;
    }
    return a == b;
}

/* ---- which widths fit ---- */

static long long gcd(long long a, long long b)
{
    while (b) {
        long long r = a % b;

        a = b;
        b = r;
    }
    return a;
}

bool fit_has(const struct fit *fit, long long width)
{
    if (!fit->multiple)
        return width == fit->plus;
    return width >= fit->least && (width - fit->plus) % fit->multiple == 0;
}

/* The Chinese remainders, by steps: moduli are small, and the limit bounds the search. */
bool fit_join(const struct fit *a, const struct fit *b, struct fit *both)
{
    long long low = a->least > b->least ? a->least : b->least, period, width;

    if (!a->multiple || !b->multiple) {
        *both = a->multiple ? *b : *a;
        return fit_has(a, both->plus) && fit_has(b, both->plus);
    }
    if (a->multiple < b->multiple) {
        const struct fit *swap = a;

        a = b;
        b = swap;
    }
    if ((a->plus - b->plus) % gcd(a->multiple, b->multiple))
        return false;
    period = times(a->multiple / gcd(a->multiple, b->multiple), b->multiple);
    for (width = a->plus % a->multiple; (width - b->plus) % b->multiple; width += a->multiple)
        if (width > LIMIT_STITCHES)
            return false;
    *both = (struct fit){period, width % period, low};
    return period <= LIMIT_STITCHES;
}

/* What is left of the row after some work: `at` stitches from its start, or
 * (once a repeat has reached for the end) `left` stitches before its end. */
struct progress {
    bool from_end;
    long long at, left;
};

long long work_length(const struct work *work)
{
    long long length = 0;

    for (; work; work = work->next) {
        if (fixed_length(work) < 0)
            return -1;
        length = least(many, length + fixed_length(work));
    }
    return length;
}

/* The runs of a list of work one by one; NULL at anything else, and at the end. */
struct run_at {
    const struct work *work;
    int i;
};

static const struct run *next_run(struct run_at *at)
{
    while (at->work && at->work->run && at->i == at->work->nruns)
        *at = (struct run_at){at->work->next, 0};
    return at->work && at->work->run && fixed_length(at->work) == at->work->length ? &at->work->run[at->i++] : NULL;
}

/* Whether `end` is how a repeat goes on from a place; its last run may be cut. */
static bool goes_on_as(struct run_at repeat, struct run_at end)
{
    const struct run *a = next_run(&repeat), *b = next_run(&end), *next;

    for (; a && b && a->stitch == b->stitch; a = next_run(&repeat), b = next) {
        next = next_run(&end);
        if (!next)
            return !end.work && b->length <= a->length;
        if (a->length != b->length)
            return false;
    }
    return false;
}

long long work_stop(const struct work *repeat, int *from)
{
    struct run_at at = {repeat->child, 0}, here = at;
    const struct run *run;
    long long before = 0;

    for (int i = 0; (run = next_run(&at)); i++, here = at) {
        if (i >= *from && goes_on_as(here, (struct run_at){repeat->next, 0})) {
            *from = i + 1;
            return before + work_length(repeat->next);
        }
        before += run->length;
    }
    return -1;
}

/* Whether `k1, p1 across` is the whole row, and its last time ends behind k1. */
static bool stops_unmarked(const struct work *repeat, long long stop)
{
    struct run_at at = {repeat->child, 0};
    const struct run *run;

    if (!repeat->unmarked || repeat->next)
        return false;
    while (stop > 0 && (run = next_run(&at)))
        stop -= run->length;
    return stop == 0;
}

/* A repeat whose last time stops short, where that makes the width; NULL: none. *stop: its stitches then. */
static struct work *stops_short(const struct row_text *row, long long width, long long *stop)
{
    struct work *work = row->work;
    int from = 0;

    *stop = work && work->unmarked ? width % work->length : 0;
    if (*stop && width > work->length && stops_unmarked(work, *stop))
        return work;
    for (; work && fixed_length(work) >= 0; work = work->next)
        width -= fixed_length(work);
    if (!work || !work->ending)
        return NULL;
    while ((*stop = work_stop(work, &from)) >= 0)
        if (width >= *stop && (width - *stop) % work->length == 0)
            return work;
    return NULL;
}

static void warn_stop(struct diag *diag, struct work *work, long long stop)
{
    if (work->told)
        return;
    work->told = true;
    diag_warning(diag, CODE_LAST_REPEAT, work->span, "this comes out where the last repeat stops short, after %lld of its %lld stitches", stop,
                 work->length);
    diag_hint(diag, "`ending last rep ..` says it");
}

/* The one group of a row without a number of times, where it fills the width when repeated; NULL: none. */
static struct work *fills_row(const struct row_text *row, const struct fit *fit, long long width, long long *n)
{
    struct work *one = NULL;

    for (struct work *work = row->work; work; work = work->next)
        if (work->bare) {
            if (one)
                return NULL;
            one = work;
        }
    if (!one || !one->length || fit->multiple || width <= fit->plus || (width - fit->plus) % one->length)
        return NULL;
    *n = 1 + (width - fit->plus) / one->length;
    return one;
}

static void warn_fills(struct diag *diag, struct work *work)
{
    if (work->told)
        return;
    work->told = true;
    diag_warning(diag, CODE_ASSUMED_REPEAT, work->span, "how often this is worked is not said: as often as fills the row");
    diag_hint(diag, "`[..] 3 times`, or `*..; rep from * to end`");
}

static bool open_end(struct diag *diag, const struct work *work, long long *left)
{
    *left = work->until == WORK_FIT ? work_length(work->next) : work->n;
    if (*left >= 0)
        return true;
    diag_error(diag, CODE_ROW_REPEAT, work->span, "how far this repeat goes is open, and so is what follows");
    diag_hint(diag, "say where it ends: `rep from * to last 2 sts`");
    return false;
}

/* ---- what can be read in two ways ---- */

static bool has_readings(const struct work *work)
{
    return work->until == WORK_EITHER || work->until == WORK_LAST_OR_ALL;
}

/* The stitches right before a part of a row, worked once; NULL: there are none. */
static const struct work *runs_before(const struct row_text *row, const struct work *work)
{
    const struct work *before = row->work == work ? NULL : row->work;

    while (before && before->next != work)
        before = before->next;
    return before && before->run && before->until == WORK_TIMES && before->n == 1 ? before : NULL;
}

int row_readings(const struct row_text *row, const struct work *work)
{
    const struct work *before = runs_before(row, work);

    return work->until == WORK_EITHER ? 2 : before ? before->nruns + 1 : 1;
}

long long row_reading(const struct row_text *row, const struct work *work, int reading)
{
    const struct work *before = runs_before(row, work);
    long long length = times(work->length, work->n + (work->until == WORK_EITHER ? reading : 0));

    for (const struct work *w = row->work; w; w = w->next)
        if (w != work && fixed_length(w) >= 0)
            length += fixed_length(w);
    for (int i = 0; work->until == WORK_LAST_OR_ALL && i < reading; i++)
        length += times(before->run[before->nruns - 1 - i].length, work->n - 1);
    return length;
}

/* `k2, k1, p1 4 times` with so many of the runs before in the group: the rest of them, and the group. */
static struct work *work_grouped(struct arena *arena, const struct work *runs, const struct work *last, int nruns)
{
    struct work *before = arena_new(arena, struct work), *group = arena_new(arena, struct work), *inner = arena_new(arena, struct work),
                *end = arena_new(arena, struct work);

    *before = *inner = *runs;
    *end = *last;
    *group = *last;
    before->nruns -= nruns;
    inner->run += before->nruns;
    inner->nruns = nruns;
    inner->length = 0;
    for (int i = 0; i < nruns; i++)
        inner->length += inner->run[i].length;
    before->length -= inner->length;
    group->until = WORK_TIMES;
    if (!nruns) {
        before->next = group;
        return before;
    }
    end->n = 1;
    end->until = WORK_TIMES;
    end->next = NULL;
    inner->next = end;
    group->run = NULL;
    group->nruns = 0;
    group->child = inner;
    group->length = inner->length + end->length;
    before->next = group;
    return before->nruns ? before : group;
}

/* The row's work, with this reading of a part of it, `before` being the stitches right before. */
static struct work *work_read(struct arena *arena, struct work *from, const struct work *work, const struct work *before, int reading)
{
    struct work *copy = arena_new(arena, struct work);

    if (from == before && work->until == WORK_LAST_OR_ALL)
        return work_grouped(arena, from, work, reading);
    *copy = *from;
    if (from == work) {
        copy->until = WORK_TIMES;
        copy->n += work->until == WORK_EITHER ? reading : 0;
    } else {
        copy->next = work_read(arena, from->next, work, before, reading);
    }
    return copy;
}

/* Whether a row without parts of two readings has a width. */
static bool comes_out(const struct work *work, long long width)
{
    long long at = 0, left;

    for (; work; work = work->next) {
        if (fixed_length(work) >= 0) {
            at += fixed_length(work);
            continue;
        }
        left = work->until == WORK_FIT ? work_length(work->next) : work->n;
        if (left < 0 || width - left < at || (width - left - at) % work->length)
            return false;
        at = width - left;
    }
    return at == width;
}

/* Whether another part of the row reaches as far as it likes. */
static bool row_is_open(const struct row_text *row, const struct work *but)
{
    for (const struct work *work = row->work; work; work = work->next)
        if (work != but && fixed_length(work) < 0)
            return true;
    return false;
}

/* Of the readings of the part that can be read in two ways takes the one that makes the width; false, with a message, without
 * one, or with several. */
static bool read_at_width(struct diag *diag, struct row_text *row, long long width, const char *left)
{
    struct work *read = NULL;
    const struct work *work = row->work;
    int n = 0;

    while (work && !has_readings(work))
        work = work->next;
    if (!work)
        return true;
    for (int reading = 0; reading < row_readings(row, work); reading++) {
        struct work *one = work_read(diag->arena, row->work, work, runs_before(row, work), reading);

        if (comes_out(one, width)) {
            read = one;
            n++;
        }
    }
    if (n != 1) {
        misfit_readings(diag, row, work, row_is_open(row, work) ? NULL : left);
        return false;
    }
    row->work = read;
    for (work = read; work && !has_readings(work);)
        work = work->next;
    if (work)
        misfit_readings(diag, row, work, NULL);
    return !work;
}

/* ---- the widths of one row ---- */

/* Moves over work that reaches to `left` stitches before the end. */
static bool fit_open(struct diag *diag, const struct work *work, struct progress *progress, struct fit *fit)
{
    long long left;
    struct fit here, both;

    if (!open_end(diag, work, &left))
        return false;
    if (progress->from_end) {
        if (progress->left < left || (progress->left - left) % work->length) {
            diag_error(diag, CODE_ROW_FIT, work->span,
                       "a repeat of %lld cannot fill the %lld stitches left here", work->length,
                       progress->left - left);
            return false;
        }
        progress->left = left;
        return true;
    }
    here = (struct fit){work->length, (progress->at + left) % work->length, progress->at + left};
    if (!fit_join(fit, &here, &both)) {
        diag_error(diag, CODE_ROW_FIT, work->span, "no width fits this row");
        return false;
    }
    *fit = both;
    *progress = (struct progress){true, 0, left};
    return true;
}

static bool fit_end(struct diag *diag, const struct row_text *row, const struct progress *progress,
                    struct fit *fit)
{
    if (!progress->from_end) {
        *fit = (struct fit){0, progress->at, progress->at};
        return true;
    }
    if (progress->left == 0)
        return true;
    diag_error(diag, CODE_ROW_COUNT, row->span,
               "the repeat leaves stitches unworked: %lld more must follow it", progress->left);
    return false;
}

/* Whether one reading of a part makes the stitches that `to last 8 sts` leaves to it. */
static bool fit_reading(const struct row_text *row, const struct work *work, struct progress *progress)
{
    long long rest = work_length(work->next), first = row_reading(row, work, 0);

    if (!progress->from_end || rest < 0)
        return false;
    for (int reading = 0; reading < row_readings(row, work); reading++)
        if (times(work->length, work->n) + row_reading(row, work, reading) - first == progress->left - rest) {
            progress->left = rest;
            return true;
        }
    return false;
}

bool row_fit(struct diag *diag, const struct row_text *row, struct fit *fit)
{
    struct progress progress = {0};

    *fit = (struct fit){1, 0, 0};
    for (const struct work *work = row->work; work; work = work->next)
        if (work->until == WORK_MARKER)
            return true;
    for (const struct work *work = row->work; work; work = work->next) {
        long long length = fixed_length(work);

        if (has_readings(work)) {
            if (!fit_reading(row, work, &progress)) {
                misfit_readings(diag, row, work, NULL);
                return false;
            }
        } else if (length < 0) {
            if (!fit_open(diag, work, &progress, fit))
                return false;
        } else if (!progress.from_end) {
            progress.at = least(many, progress.at + length);
        } else if ((progress.left -= length) < 0) {
            diag_error(diag, CODE_ROW_COUNT, work->span, "this works %lld %s more than the repeat leaves", -progress.left,
                       names_count(-progress.left, "stitch", "stitches"));
            return false;
        }
    }
    return fit_end(diag, row, &progress, fit);
}

/* ---- working it ---- */

/* Writes one pass of a list of work and returns the place behind it. */
static stitch_id *work_once(const struct work *work, stitch_id *to, const stitch_id *end);

static stitch_id *work_runs(const struct work *work, stitch_id *to, const stitch_id *end)
{
    for (const struct run *run = work->run; run < work->run + work->nruns; run++) {
        long long length = least(run->length, end - to);

        memset(to, run->stitch, (size_t)length);
        to += length;
    }
    return to;
}

static stitch_id *work_times(const struct work *work, long long n, stitch_id *to, const stitch_id *end)
{
    stitch_id *first = to;
    long long length = least(times(work->length, n), end - to);

    if (n <= 0)
        return to;
    if (work->nruns == 1) {
        memset(to, work->run->stitch, (size_t)length);
        return to + length;
    }

    /* One pass, then copies of it. */
    to = work->child ? work_once(work->child, to, end) : work_runs(work, to, end);
    while (to - first < length) {
        long long more = least(to - first, length - (to - first));

        memcpy(to, first, (size_t)more);
        to += more;
    }
    return to;
}

static stitch_id *work_once(const struct work *work, stitch_id *to, const stitch_id *end)
{
    for (; work; work = work->next)
        to = work_times(work, work->n, to, end);
    return to;
}

/* The work again and again, cut off where the row ends: behind a whole pass or
 * behind its first stitches. */
static bool work_cut(struct diag *diag, const struct row_text *row, long long width, const char *left, stitch_id *to)
{
    long long period = row->work->length + row->work->next->length, rest = width % period;

    if (rest && rest != row->work->length) {
        diag_error(diag, CODE_ROW_FIT, row->span,
                   "%s does not come out even: this rib is worked over a multiple of %lld, or %lld more, but %s",
                   misfit_name(diag->arena, row, "this row"), period, row->work->length, left);
        return false;
    }
    for (long long i = 0; i < width; i++)
        to[i] = i % period < row->work->length ? row->work->run->stitch : row->work->next->run->stitch;
    return true;
}

/* `k4, [p4, k4] 5 times (40 sts)`: the count is that of the group before it. */
static bool counts_group(const struct row_text *row)
{
    const struct work *last = row->work;

    while (last && last->next)
        last = last->next;
    return last && last->child && last->until == WORK_TIMES && times(last->length, last->n) == row->check;
}

/* How often a part of a row is worked from a place on that is so many stitches from the end. */
static long long times_at(const struct work *work, long long rest)
{
    if (work->until == WORK_LAST)
        return (rest - work->n) / work->length;
    return work->until == WORK_FIT ? (rest - work_length(work->next)) / work->length : work->n;
}

/* The row's work, each part with a number of times: `often` that which fills it. */
static struct work *settled(struct arena *arena, const struct work *work, int width, const struct work *short_one, const struct work *filling, long long often)
{
    struct work *first = NULL, **to = &first;
    long long rest = width;

    for (; work; work = work->next, to = &(*to)->next) {
        *to = arena_new(arena, struct work);
        **to = *work;
        (*to)->n = work == short_one ? rest / work->length + 1 : work == filling ? often : times_at(work, rest);
        (*to)->until = WORK_TIMES;
        rest -= times(work->length, (*to)->n);
    }
    return first;
}

bool row_work(struct diag *diag, struct row_text *row, int width, enum width_from from, const struct row_text *before, stitch_id *worked)
{
    const char *left = misfit_left(diag->arena, from, before, width);
    stitch_id *to = worked, *end = worked + width;
    struct work *short_one = NULL, *filling = NULL;
    long long stop, often = 1;
    struct fit fit;

    if (row->cut)
        return work_cut(diag, row, width, left, worked);
    if (!read_at_width(diag, row, width, left) || !row_fit(diag, row, &fit))
        return false;
    if (!fit_has(&fit, width)) {
        short_one = stops_short(row, width, &stop);
        filling = fills_row(row, &fit, width, &often);
        if (!short_one && !filling) {
            misfit_width(diag, row, &fit, width, left);
            if (!before && from == WIDTH_CAST_ON)
                misfit_hint_edges(diag, &fit, width);
            return false;
        }
        if (short_one)
            warn_stop(diag, short_one, stop);
        else
            warn_fills(diag, filling);
    }
    if (row->check >= 0 && row->check != width && !counts_group(row)) {
        diag_error(diag, CODE_ROW_ASSERT, row->check_span, "%s ends with %d %s, not %lld", misfit_name(diag->arena, row, "this row"),
                   width, names_count(width, "stitch", "stitches"), row->check);
        return false;
    }

    row->work = settled(diag->arena, row->work, width, short_one, filling, often);
    for (const struct work *work = row->work; work; work = work->next)
        to = work_times(work, work->n, to, end);
    return to == end;
}
