/* SPDX-License-Identifier: GPL-3.0-or-later
 * Params: declarations and -D options in, checked values out. */
#include "lang/params.h"

#include <stdio.h>
#include <string.h>

#include "lang/limits.h"

/* ---- the command line ---- */

const struct option_value *option_parse(struct eval *eval, const struct compile_override *given)
{
    struct option_value *option = arena_new(eval->arena, struct option_value);
    size_t length = strlen(given->name);
    const char *text = arena_printf(eval->arena, "%s=%s", given->name, given->value);

    option->source = (struct source){"command line", text, strlen(text), true};
    option->name = (struct span){&option->source, 0, (unsigned)length};
    option->value =
        parse_expression(eval->arena, eval->diag, eval->names, &option->source, (unsigned)length + 1);
    return option;
}

static struct binding *find_param(const struct eval *eval, const char *name)
{
    for (struct binding *b = eval->main->first; b; b = b->after)
        if (b->kind == BINDING_PARAM && strcmp(b->name, name) == 0)
            return b;
    return NULL;
}

static void unknown_param(struct eval *eval, struct span span, const char *name)
{
    struct nearest nearest = nearest_to(name);
    const char *list = NULL;

    for (const struct binding *b = eval->main->first; b; b = b->after)
        if (b->kind == BINDING_PARAM) {
            nearest_offer(&nearest, b->name);
            list = list ? arena_printf(eval->arena, "%s, %s", list, b->name) : b->name;
        }
    diag_error(eval->diag, CODE_DEFINE, span, "the script has no param '%s'", name);
    if (nearest.best)
        diag_did_you_mean(eval->diag, nearest.best);
    else if (list)
        diag_hint(eval->diag, "its params: %s", list);
    else
        diag_hint(eval->diag, "it has none at all; `param %s = ..` makes one", name);
}

void params_define(struct eval *eval, const struct compile_override *given)
{
    const struct option_value *option = option_parse(eval, given);
    struct binding *binding = find_param(eval, given->name);
    const struct expr *e = option->value;
    struct where where = {eval->main, NULL};

    if (!binding) {
        unknown_param(eval, option->name, given->name);
        return;
    }

    /* A bare word is a text where nothing has that name. */
    if (e->kind == EXPR_NAME && !module_find(eval->main, e->text))
        binding->value = (struct value){.kind = VALUE_STRING, .text = e->text};
    else
        binding->value = eval_expr(eval, where, e);
    binding->given = e->span;
    binding->from = FROM_COMMAND_LINE;
    binding->state = DONE;
}

/* ---- values and ranges ---- */

static void check_range(struct eval *eval, struct binding *b)
{
    const struct range *range = &b->stmt->param.range;
    struct where where = {b->module, NULL};
    struct span span = b->from == FROM_COMMAND_LINE ? b->given : b->stmt->param.value->span;
    struct value value = b->value;

    if (!range->high || value.kind == VALUE_BAD)
        return;
    if (value.kind != VALUE_NUMBER) {
        diag_error(eval->diag, CODE_TYPE, range->span, "only a number has a range, '%s' is %s", b->name,
                   value_type(value));
        return;
    }
    if (!eval_number(eval, where, range->low, value.dimension, &b->low) ||
        !eval_number(eval, where, range->high, value.dimension, &b->high))
        return;
    if (b->low > b->high) {
        diag_error(eval->diag, CODE_RANGE, range->span, "this range is empty: %g is more than %g", b->low,
                   b->high);
        return;
    }
    if (value.number >= b->low && value.number <= b->high)
        return;
    diag_error(eval->diag, CODE_RANGE, span, "%s = %.15g is out of range: from %g to %g", b->name,
               value.number, b->low, b->high);
    if (b->from == FROM_COMMAND_LINE)
        diag_note(eval->diag, range->span, "the range of '%s'", b->name);
}

/* A param is a number or a text, and -D does not change which. */
static void check_type(struct eval *eval, struct binding *b)
{
    struct value value = b->value, otherwise;

    if (value.kind == VALUE_BAD)
        return;
    if (value.kind != VALUE_NUMBER && value.kind != VALUE_STRING) {
        diag_error(eval->diag, CODE_TYPE,
                   b->from == FROM_COMMAND_LINE ? b->given : b->stmt->param.value->span,
                   "a param is a number or a text, not %s", value_type(value));
        b->value.kind = VALUE_BAD;
        return;
    }
    if (b->from != FROM_COMMAND_LINE)
        return;
    otherwise = eval_expr(eval, (struct where){b->module, NULL}, b->stmt->param.value);
    if (otherwise.kind == VALUE_BAD || otherwise.kind == value.kind)
        return;
    diag_error(eval->diag, CODE_TYPE, b->given, "'%s' is %s, not %s", b->name, value_type(otherwise),
               value_type(value));
    b->value.kind = VALUE_BAD;
}

void params_evaluate(struct eval *eval)
{
    for (struct module *module = eval->module; module; module = module->next)
        for (struct binding *b = module->first; b; b = b->after)
            if (b->kind == BINDING_PARAM) {
                eval_binding(eval, b, b->span);
                check_type(eval, b);
                check_range(eval, b);
            }
}

int params_count(const struct eval *eval)
{
    int n = 0;

    for (const struct binding *b = eval->main->first; b; b = b->after)
        n += b->kind == BINDING_PARAM;
    return n;
}

int params_settings(struct eval *eval, struct setting *setting)
{
    int n = 0;

    for (const struct binding *b = eval->main->first; b; b = b->after) {
        if (b->kind != BINDING_PARAM)
            continue;
        setting[n++] = (struct setting){
            .name = b->name,
            .unit = b->value.kind == VALUE_NUMBER && b->value.dimension == 1 ? "length" : "",
            .text = b->value.kind == VALUE_STRING ? b->value.text : NULL,
            .number = b->value.kind == VALUE_NUMBER ? b->value.number : 0,
            .from = b->from == FROM_COMMAND_LINE ? FROM_COMMAND_LINE : FROM_DEFAULT,
            .is_param = true,
            .low = b->low,
            .high = b->high,
            .about = b->stmt->param.about,
        };
    }
    return n;
}

/* ---- sweeps ---- */

static bool read_axis(struct eval *eval, const struct axis *axis, struct sweep_axis *to)
{
    struct binding *b = find_param(eval, axis->param.name);
    double *point;

    if (!b) {
        unknown_param(eval, axis->param.span, axis->param.name);
        return false;
    }
    if (b->value.kind != VALUE_NUMBER) {
        if (b->value.kind != VALUE_BAD)
            diag_error(eval->diag, CODE_SWEEP, axis->param.span, "only a number can be swept, '%s' is %s",
                       b->name, value_type(b->value));
        return false;
    }
    if (!eval_range(eval, (struct where){eval->main, NULL}, &axis->range, &point, &to->npoints))
        return false;
    if (!to->npoints) {
        diag_error(eval->diag, CODE_SWEEP, axis->range.span, "this sweep has no point");
        return false;
    }
    for (int i = 0; i < to->npoints && b->low <= b->high; i++)
        if (point[i] < b->low || point[i] > b->high) {
            diag_error(eval->diag, CODE_RANGE, axis->range.span,
                       "the sweep takes '%s' to %g, out of its range %g..%g", b->name, point[i], b->low,
                       b->high);
            diag_note(eval->diag, b->span, "its range is given here");
            return false;
        }
    to->param = b->name;
    to->point = point;
    return true;
}

const struct sweep_axis *params_sweep(struct eval *eval, const struct stmt *stmt, int *naxes)
{
    struct sweep_axis *axes;
    long long points = 1;
    int n = 0;

    for (const struct axis *axis = stmt->sweep.axis; axis; axis = axis->next)
        n++;
    axes = arena_array(eval->arena, struct sweep_axis, (size_t)n);
    *naxes = 0;
    for (const struct axis *axis = stmt->sweep.axis; axis; axis = axis->next) {
        if (!read_axis(eval, axis, &axes[*naxes]))
            return NULL;
        for (int i = 0; i < *naxes; i++)
            if (strcmp(axes[i].param, axis->param.name) == 0) {
                diag_error(eval->diag, CODE_TWICE, axis->param.span, "'%s' is swept twice", axis->param.name);
                return NULL;
            }
        points *= axes[*naxes].npoints;
        if (points > LIMIT_POINTS) {
            diag_error(eval->diag, CODE_LIMIT_LIST, stmt->span, "a sweep may have %d points", LIMIT_POINTS);
            return NULL;
        }
        ++*naxes;
    }
    return axes;
}
