/* SPDX-License-Identifier: GPL-3.0-or-later
 * The arithmetic of one row: its text in, the widths it fits and its stitches
 * in working order out. */
#include "lang/row_fit.h"

#include <stdio.h>
#include <string.h>

#include "lang/limits.h"

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

static const char *stitches(struct arena *arena, long long n)
{
    return arena_printf(arena, n == 1 ? "%lld stitch" : "%lld stitches", n);
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

/* The stitches that follow an open repeat; -1 where that is open, too. */
static long long length_behind(const struct work *work)
{
    long long length = 0;

    for (work = work->next; work; work = work->next) {
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
            return before + length_behind(repeat);
        }
        before += run->length;
    }
    return -1;
}

/* A repeat whose last time stops short, where that makes the width; NULL: none. *stop: its stitches then. */
static struct work *stops_short(const struct row_text *row, long long width, long long *stop)
{
    struct work *work = row->work;
    int from = 0;

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
    if (!one || fit->multiple || width <= fit->plus || (width - fit->plus) % one->length)
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
    *left = work->until == WORK_FIT ? length_behind(work) : work->n;
    if (*left >= 0)
        return true;
    diag_error(diag, CODE_ROW_REPEAT, work->span, "how far this repeat goes is open, and so is what follows");
    diag_hint(diag, "say where it ends: `rep from * to last 2 sts`");
    return false;
}

static void two_readings(struct diag *diag, const struct row_text *row, const struct work *work)
{
    long long fixed = 0;

    for (const struct work *w = row->work; w; w = w->next)
        fixed += w == work ? 0 : fixed_length(w);
    diag_error(diag, CODE_ROW_REPEAT, work->span, "`rep from * %lld times` can be read in two ways", work->n);
    diag_note(diag, (struct span){0}, "%lld times in all makes %lld stitches, %lld times more makes %lld",
              work->n, fixed + times(work->length, work->n), work->n,
              fixed + times(work->length, work->n + 1));
    diag_hint(diag, "write `rep from * %lld more times`, or `[..] %lld times`, or say how many are cast on",
              work->n, work->n);
}

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

bool row_fit(struct diag *diag, const struct row_text *row, struct fit *fit)
{
    struct progress progress = {0};

    *fit = (struct fit){1, 0, 0};
    for (const struct work *work = row->work; work; work = work->next) {
        long long length = fixed_length(work);

        if (work->until == WORK_EITHER) {
            two_readings(diag, row, work);
            return false;
        }
        if (length < 0) {
            if (!fit_open(diag, work, &progress, fit))
                return false;
        } else if (!progress.from_end) {
            progress.at = least(many, progress.at + length);
        } else if ((progress.left -= length) < 0) {
            diag_error(diag, CODE_ROW_COUNT, work->span, "this works %s more than the repeat leaves",
                       stitches(diag->arena, -progress.left));
            return false;
        }
    }
    return fit_end(diag, row, &progress, fit);
}

/* ---- messages about widths ---- */

/* "a multiple of 4 + 1", "24 stitches" */
static const char *fit_text(struct arena *arena, const struct fit *fit)
{
    if (!fit->multiple)
        return stitches(arena, fit->plus);
    if (fit->multiple == 1)
        return arena_printf(arena, "%s or more", stitches(arena, fit->least));
    return arena_printf(arena, "a multiple of %lld + %lld", fit->multiple, fit->plus % fit->multiple);
}

/* "row 3"; rows before row 1 have no number. */
static const char *name_of(struct arena *arena, const struct row_text *row, const char *unnumbered)
{
    return row->label ? arena_printf(arena, "row %d", row->label) : unnumbered;
}

static const char *who_left(struct arena *arena, enum width_from from, const struct row_text *before,
                            long long width)
{
    if (before)
        return arena_printf(arena, "%s left %lld", name_of(arena, before, "the row before"), width);
    switch (from) {
    case WIDTH_CAST_ON:
        return arena_printf(arena, "%lld are cast on", width);
    case WIDTH_MULTIPLE:
        return arena_printf(arena, "the motif's multiple makes %lld", width);
    case WIDTH_ASKED:
        return arena_printf(arena, "a width of %lld was asked for", width);
    default:
        return arena_printf(arena, "there are %lld", width);
    }
}

static void note_fit(struct diag *diag, const struct fit *fit, long long width)
{
    long long below, above;

    if (fit->multiple > 1)
        diag_note(diag, (struct span){0}, "this row fits %s; %lld is %lld x %lld + %lld",
                  fit_text(diag->arena, fit), width, fit->multiple, width / fit->multiple,
                  width % fit->multiple);
    if (fit->multiple < 2 || width < fit->least)
        return;
    below = width - ((width - fit->plus) % fit->multiple + fit->multiple) % fit->multiple;
    above = below + fit->multiple;
    if (below >= fit->least && below > 0)
        diag_hint(diag, "the nearest widths that fit are %lld and %lld", below, above);
    else
        diag_hint(diag, "the nearest width that fits is %lld", above);
}

void row_does_not_fit(struct diag *diag, const struct row_text *row, const struct row_text *before,
                      const struct fit *others)
{
    struct fit fit;

    if (!row_fit(diag, row, &fit))
        return;
    if (!fit.multiple && !others->multiple && before)
        diag_error(diag, CODE_ROW_COUNT, row->span, "%s works %s, but %s left %lld",
                   name_of(diag->arena, row, "this row"), stitches(diag->arena, fit.plus), name_of(diag->arena, before, "the row before"), others->plus);
    else
        diag_error(diag, CODE_ROW_WIDTH, row->span, "%s fits %s, but the rows before it fit %s",
                   name_of(diag->arena, row, "this row"), fit_text(diag->arena, &fit), fit_text(diag->arena, others));
    if (before)
        diag_note(diag, before->span, "%s", name_of(diag->arena, before, "the row before"));
}

/* Reports that a row does not come out on the width there is. */
static void misfit(struct diag *diag, const struct row_text *row, const struct fit *fit, long long width,
                   const char *left)
{
    if (fit->multiple == 0) {
        diag_error(diag, CODE_ROW_COUNT, row->span, "%s works %s, but %s", name_of(diag->arena, row, "this row"),
                   stitches(diag->arena, fit->plus), left);
        if (fit->plus > 0 && width > fit->plus && width % fit->plus == 0)
            diag_hint(diag, "to fill the row, repeat it: `*..; rep from * to end`");
        return;
    }
    if (width < fit->least)
        diag_error(diag, CODE_ROW_COUNT, row->span, "%s needs %s at least, but %s", name_of(diag->arena, row, "this row"),
                   stitches(diag->arena, fit->least), left);
    else
        diag_error(diag, CODE_ROW_FIT, row->span, "%s does not come out even: its repeat fits %s, but %s",
                   name_of(diag->arena, row, "this row"), fit_text(diag->arena, fit), left);
    note_fit(diag, fit, width);
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

/* Of the two readings the one that fits the width; -1: neither. */
static long long reading_that_fits(const struct row_text *row, const struct work *work, long long width)
{
    long long fixed = 0;

    for (const struct work *w = row->work; w; w = w->next)
        if (w != work && fixed_length(w) >= 0)
            fixed += fixed_length(w);
    if (fixed + times(work->length, work->n) == width)
        return work->n;
    return fixed + times(work->length, work->n + 1) == width ? work->n + 1 : -1;
}

/* The work again and again, cut off where the row ends: behind a whole pass or
 * behind its first stitches. */
static bool work_cut(struct diag *diag, const struct row_text *row, long long width, const char *left, stitch_id *to)
{
    long long period = row->work->length + row->work->next->length, rest = width % period;

    if (rest && rest != row->work->length) {
        diag_error(diag, CODE_ROW_FIT, row->span,
                   "%s does not come out even: this rib is worked over a multiple of %lld, or %lld more, but %s",
                   name_of(diag->arena, row, "this row"), period, row->work->length, left);
        return false;
    }
    for (long long i = 0; i < width; i++)
        to[i] = i % period < row->work->length ? row->work->run->stitch : row->work->next->run->stitch;
    return true;
}

bool row_work(struct diag *diag, const struct row_text *row, int width, enum width_from from,
              const struct row_text *before, stitch_id *worked)
{
    const char *left = who_left(diag->arena, from, before, width);
    stitch_id *to = worked, *end = worked + width;
    bool either = false;
    struct work *short_one = NULL, *filling = NULL;
    long long stop, often = 1;
    struct fit fit;

    if (row->cut)
        return work_cut(diag, row, width, left, worked);
    for (const struct work *work = row->work; work; work = work->next)
        if (work->until == WORK_EITHER) {
            either = true;
            if (reading_that_fits(row, work, width) < 0) {
                two_readings(diag, row, work);
                diag_note(diag, (struct span){0}, "neither fits: %s", left);
                return false;
            }
        }
    if (!either) {
        if (!row_fit(diag, row, &fit))
            return false;
        if (!fit_has(&fit, width)) {
            short_one = stops_short(row, width, &stop);
            filling = fills_row(row, &fit, width, &often);
            if (!short_one && !filling) {
                misfit(diag, row, &fit, width, left);
                return false;
            }
            if (short_one)
                warn_stop(diag, short_one, stop);
            else
                warn_fills(diag, filling);
        }
    }
    if (row->check >= 0 && row->check != width) {
        diag_error(diag, CODE_ROW_ASSERT, row->check_span, "%s ends with %s, not %lld", name_of(diag->arena, row, "this row"),
                   stitches(diag->arena, width), row->check);
        return false;
    }

    /* It fits: every repeat now has a number of times. */
    for (const struct work *work = row->work; work; work = work->next) {
        long long n = work->n;

        if (work == short_one)
            n = (end - to) / work->length + 1;
        else if (work == filling)
            n = often;
        else if (work->until == WORK_EITHER)
            n = reading_that_fits(row, work, width);
        else if (work->until == WORK_LAST)
            n = (end - to - work->n) / work->length;
        else if (work->until == WORK_FIT)
            n = (end - to - length_behind(work)) / work->length;
        to = work_times(work, n, to, end);
    }
    return to == end;
}
