/* SPDX-License-Identifier: GPL-3.0-or-later
 * A row that does not come out on a width in, sentences with its arithmetic out. */
#include "lang/rows/row_misfit.h"

#include <string.h>

#include "lang/names.h"
#include "lang/rows/row_fit.h"

enum {
    TERMS = 12,     /* of a sum are shown */
    WRITTEN = 60    /* bytes of a row that a hint writes out */
};

static const char *stitches(struct arena *arena, long long n)
{
    return arena_printf(arena, n == 1 ? "%lld stitch" : "%lld stitches", n);
}

/* ---- names ---- */

/* "a multiple of 4 + 1", "24 stitches" */
static const char *fit_text(struct arena *arena, const struct fit *fit)
{
    if (!fit->multiple)
        return stitches(arena, fit->plus);
    if (fit->multiple == 1)
        return arena_printf(arena, "%s or more", stitches(arena, fit->least));
    return arena_printf(arena, "a multiple of %s", names_multiple(arena, fit->multiple, fit->plus % fit->multiple));
}

const char *misfit_name(struct arena *arena, const struct row_text *row, const char *unnumbered)
{
    return row->label ? arena_printf(arena, "row %d", row->label) : unnumbered;
}

const char *misfit_left(struct arena *arena, enum width_from from, const struct row_text *before, long long width)
{
    if (before)
        return arena_printf(arena, "%s left %lld", misfit_name(arena, before, "the row before"), width);
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

/* ---- a row of one width ---- */

/* "2 + 5 x 4": what the row works, piece by piece; NULL where that is one number, or too many. */
static const char *sum_text(struct arena *arena, const struct row_text *row)
{
    const char *sum = "", *plus = "";
    bool product = false;
    int n = 0;

    for (const struct work *work = row->work; work; work = work->next, plus = " + ") {
        product |= !work->run || work->n != 1;
        for (int i = 0; work->n == 1 && work->run && i < work->nruns && n < TERMS; i++, n++, plus = " + ")
            sum = arena_printf(arena, "%s%s%u", sum, plus, work->run[i].length);
        if (!work->run || work->n != 1)
            sum = arena_printf(arena, "%s%s%lld x %lld", sum, plus, work->n, work->length);
        if (++n > TERMS)
            return NULL;
    }
    return product || row->work->nruns > 1 || row->work->next ? sum : NULL;
}

/* The stitches of a width that a repeat leaves over. */
static long long left_over(const struct fit *fit, long long width)
{
    return ((width - fit->plus) % fit->multiple + fit->multiple) % fit->multiple;
}

static void hint_nearest(struct diag *diag, const char *what, const struct fit *fit, long long width)
{
    long long below = width - left_over(fit, width), above = below + fit->multiple;

    if (below >= fit->least && below > 0)
        diag_hint(diag, "%sthe nearest widths that fit are %lld and %lld", what, below, above);
    else
        diag_hint(diag, "%sthe nearest width that fits is %lld", what, above);
}

/* `p4, k2`: the first n stitches of a repeat; NULL where they end within a run. */
static const char *beginning(struct arena *arena, const struct work *repeat, long long n)
{
    const char *text = "";

    if (repeat->child && !repeat->child->next && repeat->child->until == WORK_TIMES && repeat->child->n == 1)
        repeat = repeat->child;
    for (int i = 0; repeat->run && i < repeat->nruns && i < TERMS && repeat->run[i].stitch <= STITCH_P; i++) {
        text = arena_printf(arena, "%s%s%c%u", text, i ? ", " : "", repeat->run[i].stitch == STITCH_P ? 'p' : 'k', repeat->run[i].length);
        n -= repeat->run[i].length;
        if (n <= 0)
            return n == 0 ? text : NULL;
    }
    return NULL;
}

/* `*p4, k4; rep from * to last 3 sts` leaves 4 stitches over: the last repeat may be meant to break off there. */
static void hint_broken_off(struct diag *diag, const struct row_text *row, const struct fit *fit, long long width)
{
    long long over = left_over(fit, width), behind = 0;
    const struct work *repeat = row->work;
    const char *text;

    while (repeat && repeat->until != WORK_FIT && repeat->until != WORK_LAST)
        repeat = repeat->next;
    text = repeat ? beginning(diag->arena, repeat, over) : NULL;
    if (!text)
        return;
    for (const struct work *work = repeat->next; work; work = work->next)
        behind += work->n * work->length;
    diag_hint(diag, "where the last repeat is to break off, write what it works: `rep from * to last %s, %s%s`",
              over + behind == 1 ? "st" : arena_printf(diag->arena, "%lld sts", over + behind), text, behind ? ", .." : "");
}

/* The line to write for `Row 1: k1, p1` where it is worked to the end. */
static void hint_repeated(struct diag *diag, const struct row_text *row)
{
    const char *text = row->span.source->text + row->span.start;
    int n = (int)(row->span.end - row->span.start);
    const char *noun = row->round ? "Rnd" : "Row", *next = row->round ? "Next rnd: " : "Next row: ";
    const char *head = row->label ? arena_printf(diag->arena, "%s %d: ", noun, row->label) : next;

    if (n > WRITTEN || memchr(text, '\n', (size_t)n) || memchr(text, '*', (size_t)n) || memchr(text, ':', (size_t)n))
        diag_hint(diag, "to fill the row, repeat it: `*..; rep from * to end`");
    else
        diag_hint(diag, "to fill the row, repeat it: `%s*%.*s; rep from * to end`", head, n, text);
}

/* The row is worked once: its sum, and what it would take. */
static void misfit_once(struct diag *diag, const struct row_text *row, long long makes, long long width, const char *left)
{
    const char *sum = row->work ? sum_text(diag->arena, row) : NULL;

    diag_error(diag, CODE_ROW_COUNT, row->span, "%s works %s, but %s", misfit_name(diag->arena, row, "this row"),
               stitches(diag->arena, makes), left);
    if (sum)
        diag_note(diag, (struct span){0}, "%s = %lld, %lld %s than %lld", sum, makes, makes > width ? makes - width : width - makes,
                  makes > width ? "more" : "less", width);
    if (makes > 0 && width > makes && width % makes == 0)
        hint_repeated(diag, row);
    else if (makes > 1 && width / 2 >= makes)
        hint_nearest(diag, arena_printf(diag->arena, "repeated to the end it fits a multiple of %lld: ", makes),
                     &(struct fit){makes, 0, makes}, width);
}

void misfit_width(struct diag *diag, const struct row_text *row, const struct fit *fit, long long width, const char *left)
{
    struct arena *arena = diag->arena;

    if (fit->multiple == 0) {
        misfit_once(diag, row, fit->plus, width, left);
        return;
    }
    if (width < fit->least)
        diag_error(diag, CODE_ROW_COUNT, row->span, "%s needs %s at least, but %s", misfit_name(arena, row, "this row"),
                   stitches(arena, fit->least), left);
    else
        diag_error(diag, CODE_ROW_FIT, row->span, "%s does not come out even: its repeat fits %s, but %s",
                   misfit_name(arena, row, "this row"), fit_text(arena, fit), left);
    if (fit->multiple > 1)
        diag_note(diag, (struct span){0}, "this row fits %s; %lld is %lld x %lld + %lld", fit_text(arena, fit), width,
                  fit->multiple, width / fit->multiple, width % fit->multiple);
    if (fit->multiple > 1 && width >= fit->least)
        hint_nearest(diag, "", fit, width);
    if (fit->multiple > 1 && width > fit->least)
        hint_broken_off(diag, row, fit, width);
}

void misfit_hint_edges(struct diag *diag, const struct fit *fit, long long width)
{
    long long over = fit->multiple > 1 && width >= fit->least ? left_over(fit, width) : 0;

    if (over)
        diag_hint(diag, "or work the %s left over as its edges, before the '*' and behind `to last ..`", stitches(diag->arena, over));
}

void misfit_rows(struct diag *diag, const struct row_text *row, const struct row_text *before, const struct fit *fit,
                 const struct fit *others)
{
    struct arena *arena = diag->arena;

    if (!fit->multiple && !others->multiple && before)
        diag_error(diag, CODE_ROW_COUNT, row->span, "%s works %s, but %s left %lld", misfit_name(arena, row, "this row"),
                   stitches(arena, fit->plus), misfit_name(arena, before, "the row before"), others->plus);
    else
        diag_error(diag, CODE_ROW_WIDTH, row->span, "%s fits %s, but the rows before it fit %s",
                   misfit_name(arena, row, "this row"), fit_text(arena, fit), fit_text(arena, others));
    if (before)
        diag_note(diag, before->span, "%s", misfit_name(arena, before, "the row before"));
}

/* ---- two readings ---- */

/* The repeat `to last 9 sts` that a part is behind, and the stitches before it; NULL: it is behind none. */
static const struct work *leaving(const struct row_text *row, const struct work *work, long long *before)
{
    const struct work *open = NULL;
    long long at = 0;

    for (const struct work *w = row->work; w && w != work; w = w->next)
        if (w->until == WORK_LAST) {
            open = w;
            *before = at;
        } else {
            at += w->n * w->length;
        }
    return open;
}

void misfit_readings(struct diag *diag, const struct row_text *row, const struct work *work, const char *left)
{
    long long before = 0, least, most, n = work->n;
    const struct work *open = leaving(row, work, &before);
    const char *otherwise;

    least = row_reading(row, work, 0) - before;
    most = row_reading(row, work, row_readings(row, work) - 1) - before;
    left = open && !left ? arena_printf(diag->arena, "the repeat before leaves %lld", open->n) : left;
    otherwise = left ? "" : ", or say how many are cast on";

    if (work->until == WORK_EITHER) {
        diag_error(diag, CODE_ROW_REPEAT, work->span, "`rep from * %lld times` can be read in two ways", n);
        diag_note(diag, (struct span){0}, "%lld times in all makes %lld stitches, %lld times more makes %lld", n, least, n, most);
    } else {
        diag_error(diag, CODE_ROW_REPEAT, work->span, "what is worked %lld times can be read in two ways", n);
        diag_note(diag, (struct span){0}, "this alone %lld times makes %lld stitches, with all before it %lld times makes %lld", n, least,
                  n, most);
    }
    if (left)
        diag_note(diag, (struct span){0}, "neither fits: %s", left);
    if (work->until == WORK_EITHER)
        diag_hint(diag, "write `rep from * %lld more times`, or `[..] %lld times`%s", n, n, otherwise);
    else
        diag_hint(diag, "write `[..] %lld times` around what is repeated%s", n, otherwise);
}
