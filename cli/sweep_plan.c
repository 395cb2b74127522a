/* SPDX-License-Identifier: GPL-3.0-or-later
 * Which folds the points of a sweep take: the folds that came to an end in; those
 * to run next, and the one each point keeps, out. */
#include <config.h>

#include "cli/sweep_plan.h"

#include <math.h>

#include "cli/sweep_table.h"

static const double AGREEMENT = 1e-8;   /* of the energy, as between seeds */
enum { WORTH_IT = 3 };                  /* points between two: for fewer, the checks take more than is saved */

/* ---- folds ---- */

/* Is it done by now, and what did it come to? */
static void read_fold(const struct sweep_plan *plan, struct sweep_fold *fold)
{
    struct arena arena = {0};
    struct sweep_point point = sweep_point(plan->sweep, fold->number, fold->from, &arena);
    enum sweep_state state = sweep_point_state(plan->sweep, &point);
    cJSON *report = state == SWEEP_DONE ? sweep_point_json(&point, SWEEP_REPORT, &arena) : NULL;
    fold->done = state == SWEEP_DONE || (state == SWEEP_ERROR && (fold->wanted || plan->looking));
    cJSON *record = fold->from > 0 ? sweep_point_json(&point, SWEEP_RECORD, &arena) : NULL;
    fold->good = sweep_table_converged(report) &&
                 (fold->from == 0 || cJSON_IsTrue(cJSON_GetObjectItemCaseSensitive(record, SWEEP_BACK)));
    fold->energy = sweep_table_number(report, "energy.total");
    cJSON_Delete(record);
    cJSON_Delete(report);
    arena_free(&arena);
}

/* The fold, which is to be run if it is not done. */
static struct sweep_fold *look(struct sweep_plan *plan, int number, int from)
{
    struct sweep_fold **at = &plan->fold[number - 1], *fold;
    while (*at && (*at)->from != from)
        at = &(*at)->other;
    if (!*at) {
        *at = arena_array(&plan->arena, struct sweep_fold, 1);
        **at = (struct sweep_fold){.number = number, .from = from};
    }
    fold = *at;
    if (!fold->done)
        read_fold(plan, fold);
    if (!fold->done && !fold->wanted) {
        fold->wanted = true;
        plan->nwanted++;
        *plan->last = fold;
        plan->last = &fold->next;
    }
    return fold;
}

static bool same_minimum(const struct sweep_fold *a, const struct sweep_fold *b)
{
    return a->good && b->good && fabs(a->energy - b->energy) <= AGREEMENT * fabs(b->energy);
}

/* ---- chains ---- */

static void look_at_each(struct sweep_plan *plan, int a, int b)
{
    for (int k = a; k <= b; k++)
        plan->from[k - 1] = look(plan, k, 0)->from;
}

/* Point a to point b of a chain. */
static void look_between(struct sweep_plan *plan, int a, int b)
{
    if (b - a - 1 < WORTH_IT) {
        look_at_each(plan, a, b);
        return;
    }
    const struct sweep_fold *at = look(plan, a, 0), *end = look(plan, b, 0);
    plan->from[a - 1] = plan->from[b - 1] = 0;
    for (int k = a + 1; k <= b && at->done && at->good; k++)
        at = look(plan, k, a);
    if (!at->done || !end->done)
        return;
    if (at->number == b && same_minimum(at, end)) {
        for (int k = a + 1; k < b; k++)
            plan->from[k - 1] = a;
        return;
    }
    look_between(plan, a, (a + b) / 2);
    look_between(plan, (a + b) / 2, b);
}

void sweep_plan_look(struct sweep_plan *plan, int number)
{
    const struct sweep *sweep = plan->sweep;
    int length = sweep_chain(sweep), first = number - (number - 1) % length;
    look_between(plan, first, first + length - 1);
}

/* ---- the whole ---- */

void sweep_plan_begin(struct sweep_plan *plan, const struct sweep *sweep, bool looking)
{
    size_t n = (size_t)sweep->npoints;
    *plan = (struct sweep_plan){.sweep = sweep, .looking = looking};
    plan->fold = arena_array(&plan->arena, struct sweep_fold *, n);
    plan->from = arena_array(&plan->arena, int, n);
    plan->last = &plan->next;
    for (size_t i = 0; i < n; i++)
        plan->from[i] = -1;
    for (int number = 1; number <= sweep->npoints; number += sweep_chain(sweep))
        sweep_plan_look(plan, number);
}

void sweep_plan_free(struct sweep_plan *plan)
{
    arena_free(&plan->arena);
}

struct sweep_fold *sweep_plan_next(struct sweep_plan *plan)
{
    struct sweep_fold *fold = plan->next;
    if (fold && !(plan->next = fold->next))
        plan->last = &plan->next;
    return fold;
}

int sweep_plan_done(const struct sweep_plan *plan)
{
    int done = 0;
    for (int i = 0; i < plan->sweep->npoints; i++)
        for (const struct sweep_fold *fold = plan->fold[i]; fold; fold = fold->other)
            done += fold->from == plan->from[i] && fold->done;
    return done;
}
