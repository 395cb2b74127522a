/* SPDX-License-Identifier: GPL-3.0-or-later
 * A row's stitches in working order in, the shortest words a knitter would use out. */
#include "charts/row.h"

#include <string.h>

enum {
    WRAP       = 66,        /* columns of a line; what closes a row or a repeat may stand behind them, */
    WRAP_MOST  = 79,        /* to here */
    GROUP_RUNS = 8,         /* runs of one [..] group at most */
    STAR_RUNS  = 128,       /* runs of one repeat from * at most */
    COST_RUN   = 2,         /* of `k2` */
    COST_GROUP = 3,         /* of `[..] 3 times` */
    COST_STAR  = 3          /* of `*..; rep from *` */
};

/* The row and its runs: run r is the stitches start[r] .. start[r + 1] - 1. */
struct runs {
    const stitch_id *worked;        /* (n) */
    int              n, nruns;
    int             *start;         /* (nruns + 1) */
    int             *run_of;        /* (n) the run a stitch lies in */
    int              step;          /* repeats have a multiple of this many runs: knit and purl take turns */
};

static struct runs find_runs(struct arena *arena, const stitch_id *worked, int n)
{
    struct runs runs = {.worked = worked, .n = n, .step = 2};
    runs.start = arena_array(arena, int, (size_t)n + 1);
    runs.run_of = arena_array(arena, int, (size_t)n);
    for (int i = 0; i < n; i++) {
        if (i == 0 || worked[i] != worked[i - 1])
            runs.start[runs.nruns++] = i;
        runs.run_of[i] = runs.nruns - 1;
        runs.step = worked[i] > STITCH_P ? 1 : runs.step;
    }
    runs.start[runs.nruns] = n;
    return runs;
}

static int run_length(const struct runs *runs, int run)
{
    return runs->start[run + 1] - runs->start[run];
}

static bool same_stitch(const struct runs *runs, int a, int b)
{
    return runs->worked[runs->start[a]] == runs->worked[runs->start[b]];
}

/* ---- a part of a row ---- */

/* Stitches from .. to-1 as items, the first and the last run perhaps cut. */
struct part {
    const struct runs *runs;
    int                from, to;
};

static int part_runs(struct part p)
{
    return p.to > p.from ? p.runs->run_of[p.to - 1] - p.runs->run_of[p.from] + 1 : 0;
}

/* Length of the i-th run inside the part. */
static int part_length(struct part p, int i)
{
    int run = p.runs->run_of[p.from] + i;
    int from = p.runs->start[run], to = p.runs->start[run + 1];
    return (to < p.to ? to : p.to) - (from > p.from ? from : p.from);
}

/* How often the runs i .. i+u-1 follow each other from i on. */
static int group_times(struct part p, int i, int u)
{
    int nruns = part_runs(p), same = 0, first = p.runs->run_of[p.from] + i;
    while (i + u + same < nruns && part_length(p, i + same) == part_length(p, i + u + same) &&
           same_stitch(p.runs, first + same, first + u + same))
        same++;
    return same / u + 1;
}

/* The group at run i that saves most: its runs and how often; false if none does. */
static bool find_group(struct part p, int i, int *unit, int *times)
{
    int most = 0;
    for (int u = 2; u <= GROUP_RUNS && i + 2 * u <= part_runs(p); u += p.runs->step) {
        int n = group_times(p, i, u), saved = (n - 1) * u * COST_RUN - COST_GROUP;
        if (saved > most && (n > 2 || u > 2)) {
            most = saved;
            *unit = u;
            *times = n;
        }
    }
    return most > 0;
}

static int part_cost(struct part p)
{
    int cost = 0, unit, times;
    for (int i = 0; i < part_runs(p);)
        if (find_group(p, i, &unit, &times)) {
            cost += unit * COST_RUN + COST_GROUP;
            i += unit * times;
        } else {
            cost += COST_RUN;
            i++;
        }
    return cost;
}

/* ---- words ---- */

/* An item with the comma and the line break before it, and what closes a repeat or the row behind it. */
static void put(struct row_writer *w, const char *item, const char *behind)
{
    int length = (int)strlen(item), all = length + (int)strlen(behind);
    if (w->begun)
        text_print(w->text, ",");
    if (w->begun && (w->column + length + 2 > WRAP || w->column + all + 2 > WRAP_MOST)) {
        text_print(w->text, "\n%s", w->indent);
        w->column = (int)strlen(w->indent);
    } else if (w->begun) {
        text_print(w->text, " ");
        w->column += 2;
    }
    text_print(w->text, "%s%s", item, behind);
    w->column += all;
    w->begun = true;
}

static const struct entry *entry_of(const struct row_writer *w, struct part p, int i)
{
    return &w->words->entry[p.runs->worked[p.runs->start[p.runs->run_of[p.from] + i]]];
}

/* `k2` */
static const char *run_words(struct row_writer *w, struct part p, int i)
{
    const struct entry *entry = entry_of(w, p, i);
    return arena_printf(w->text->arena, "%s%s%d", entry->name, entry->apart ? " " : "", part_length(p, i));
}

/* `[k2, p2] 3 times` */
static const char *group_words(struct row_writer *w, struct part p, int i, int unit, int times)
{
    struct arena *arena = w->text->arena;
    const char *words = "[";
    for (int j = 0; j < unit; j++)
        words = arena_printf(arena, "%s%s%s", words, j ? ", " : "", run_words(w, p, i + j));
    return times == 2 ? arena_printf(arena, "%s] twice", words) : arena_printf(arena, "%s] %d times", words, times);
}

/* The part's items; `before` stands before the first, `behind` behind the last. */
static void write_part(struct row_writer *w, struct part p, const char *before, const char *behind)
{
    int nruns = part_runs(p), unit, times;
    for (int i = 0; i < nruns; before = "") {
        const char *item;
        if (find_group(p, i, &unit, &times)) {
            item = group_words(w, p, i, unit, times);
            i += unit * times;
        } else {
            item = run_words(w, p, i++);
        }
        put(w, arena_printf(w->text->arena, "%s%s", before, item), i == nruns ? behind : "");
    }
}

/* ---- the repeat from * ---- */

/* Stitches from .. from+period-1, taken `times` times. */
struct star {
    int from, period, times, cost;
};

static int star_end(const struct star *star)
{
    return star->from + star->period * star->times;
}

/* The three parts of a row that a repeat is in. */
static struct part before_star(const struct runs *runs, const struct star *star)
{
    return (struct part){runs, 0, star->from};
}

static struct part in_star(const struct runs *runs, const struct star *star)
{
    return (struct part){runs, star->from, star->from + star->period};
}

static struct part behind_star(const struct runs *runs, const struct star *star)
{
    return (struct part){runs, star_end(star), runs->n};
}

/* The cost as long as nobody looks for groups. */
static int plain_cost(const struct runs *runs, const struct star *star)
{
    return COST_STAR + COST_RUN * (part_runs(before_star(runs, star)) + part_runs(in_star(runs, star)) +
                                   part_runs(behind_star(runs, star)));
}

/* With groups, where what is outside the repeat is short. */
static int star_cost(const struct runs *runs, const struct star *star)
{
    struct part before = before_star(runs, star), behind = behind_star(runs, star);
    if (part_runs(before) + part_runs(behind) > STAR_RUNS)
        return star->cost;
    return COST_STAR + part_cost(before) + part_cost(in_star(runs, star)) + part_cost(behind);
}

/* A repeat is the most of its row; less is a group in brackets. */
static void offer_star(const struct runs *runs, struct star *best, int from, int to, int period)
{
    struct star star = {.from = from, .period = period, .times = (to - from) / period};
    if (star.times < 2 || 2 * (star_end(&star) - from) < runs->n)
        return;
    star.cost = plain_cost(runs, &star);
    if (!best->times || star.cost < best->cost ||
        (star.cost == best->cost && star_cost(runs, &star) < star_cost(runs, best)))
        *best = star;
}

/* Runs first .. last and u runs behind each repeat: stitches that repeat, the cut
 * runs at both ends with them. */
static void offer_stretch(const struct runs *runs, struct star *best, int first, int last, int u)
{
    int from = runs->start[first], to = runs->start[last + u];
    int period = runs->start[first + u] - from;
    if (first > 0 && same_stitch(runs, first - 1, first + u - 1)) {
        int left = run_length(runs, first - 1), other = run_length(runs, first + u - 1);
        from -= left < other ? left : other;
    }
    if (last + u < runs->nruns && same_stitch(runs, last, last + u)) {
        int right = run_length(runs, last + u), other = run_length(runs, last);
        to += right < other ? right : other;
    }
    if (from == 0)
        offer_star(runs, best, 0, to, period);
    for (int run = first; run <= last && runs->start[run] < from + period; run++)
        offer_star(runs, best, runs->start[run], to, period);
}

static struct star find_star(const struct runs *runs)
{
    struct star best = {0};
    for (int u = 2; u <= STAR_RUNS && u < runs->nruns; u += runs->step)
        for (int first = 0; first + u < runs->nruns;) {
            int last = first;
            while (last + u < runs->nruns && run_length(runs, last) == run_length(runs, last + u) &&
                   same_stitch(runs, last, last + u))
                last++;
            if (last > first)
                offer_stretch(runs, &best, first, last, u);
            first = last + 1;
        }
    return best;
}

static void write_star(struct row_writer *w, const struct runs *runs, const struct star *star)
{
    int left = runs->n - star_end(star);
    const char *until = left == 0   ? "; rep from * to end"
                        : left == 1 ? "; rep from * to last st"
                                    : arena_printf(w->text->arena, "; rep from * to last %d sts", left);
    if (left == 0)
        until = arena_printf(w->text->arena, "%s%s", until, w->end);
    write_part(w, before_star(runs, star), "", "");
    write_part(w, in_star(runs, star), "*", until);
    write_part(w, behind_star(runs, star), "", w->end);
}

/* ---- the row ---- */

/* The smallest period that divides the row. */
static int whole_period(const struct runs *runs)
{
    for (int period = 1; period < runs->n; period++)
        if (runs->n % period == 0 &&
            memcmp(runs->worked, runs->worked + period, (size_t)(runs->n - period)) == 0)
            return period;
    return runs->n;
}

void row_write(struct row_writer *w, const stitch_id *worked, int n)
{
    struct runs runs = find_runs(w->text->arena, worked, n);
    struct part whole = {&runs, 0, n};
    if (runs.nruns == 1) {
        put(w, w->words->entry[worked[0]].row, w->end);
        return;
    }
    struct star star = w->open ? (struct star){0, whole_period(&runs), 0, 0} : find_star(&runs);
    if (w->open)
        star.times = n / star.period;
    if (w->open || (star.times && star_cost(&runs, &star) <= part_cost(whole)))
        write_star(w, &runs, &star);
    else
        write_part(w, whole, "", w->end);
}
