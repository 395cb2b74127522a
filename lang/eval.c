/* SPDX-License-Identifier: GPL-3.0-or-later
 * Expressions in, values out. */
#include "lang/eval.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/limits.h"

static const struct value bad = {.kind = VALUE_BAD};

const char *value_type(struct value value)
{
    static const char *const type[] = {"nothing", "a number", "a text",  "a stitch",
                                       "a list",  "a fabric", "a motif", "a motif that wants arguments"};

    return type[value.kind];
}

/* Counts the work done; past the limit everything is bad and says so once. */
bool eval_step(struct eval *eval, struct span span)
{
    if (eval->exhausted)
        return false;
    if (++eval->steps <= LIMIT_STEPS)
        return true;
    diag_error(eval->diag, CODE_LIMIT_STEPS, span, "this takes more than %d million steps to work out",
               LIMIT_STEPS / 1000000);
    eval->exhausted = true;
    return false;
}

/* ---- names ---- */

static struct value binding_value(struct eval *eval, struct binding *binding, struct span used)
{
    const struct stmt *stmt = binding->stmt;
    struct where where = {binding->module, NULL};

    switch (binding->kind) {
    case BINDING_LET:
        return eval_expr(eval, where, stmt->let.value);
    case BINDING_PARAM:
        return eval_expr(eval, where, stmt->param.value);
    case BINDING_MOTIF:
        for (const struct formal *formal = stmt->motif.formal; formal; formal = formal->next)
            if (!formal->value)
                return (struct value){.kind = VALUE_MAKER, .maker = binding};
        return motif_make(eval, binding, where, NULL, used);
    default:
        return bad;
    }
}

struct value eval_binding(struct eval *eval, struct binding *binding, struct span used)
{
    binding = binding_target(binding);
    if (!binding)
        return bad;
    if (binding->kind == BINDING_SPACE) {
        diag_error(eval->diag, CODE_TYPE, used, "'%s' is a file; its motifs are written '%s.NAME'",
                   binding->name, binding->name);
        return bad;
    }
    if (binding->state == DOING) {
        diag_error(eval->diag, CODE_CYCLE, binding->span, "'%s' needs itself to be worked out",
                   binding->name);
        return bad;
    }
    if (binding->state == TO_DO) {
        if (eval->calls >= LIMIT_CALLS) {
            diag_error(eval->diag, CODE_LIMIT_CALLS, used, "definitions use each other more than %d deep",
                       LIMIT_CALLS);
            return bad;
        }
        binding->state = DOING;
        eval->calls++;
        binding->value = binding_value(eval, binding, used);
        eval->calls--;
        binding->state = DONE;
    }
    return binding->value;
}

static struct value name_value(struct eval *eval, struct where where, const struct expr *e)
{
    const char *name = e->text;
    struct binding *binding;

    for (const struct local *local = where.local; local; local = local->up)
        if (local->name == name)
            return local->value;
    binding = module_find(where.module, name);
    if (binding)
        return eval_binding(eval, binding, e->span);
    if (name == eval->word_K || name == eval->word_P)
        return (struct value){.kind = VALUE_STITCH, .stitch = name == eval->word_K ? STITCH_K : STITCH_P};
    if (name == eval->word_pi)
        return value_number(3.14159265358979323846, 0);
    module_unknown(eval, where, name, e->span);
    return bad;
}

static struct value member_value(struct eval *eval, struct where where, const struct expr *e)
{
    const char *name = e->member.space;
    struct binding *space = module_find(where.module, name), *member;

    if (!space || space->kind != BINDING_SPACE) {
        if (space || name == eval->word_K || name == eval->word_P || name == eval->word_pi)
            diag_error(eval->diag, CODE_TYPE, e->span, "'%s' is no file; only `use \"..\" as NAME` makes one",
                       name);
        else
            module_unknown(eval, where, name, e->span);
        return bad;
    }
    member = module_find(space->module, e->member.name);
    if (member)
        return eval_binding(eval, member, e->span);
    module_unknown(eval, (struct where){space->module, NULL}, e->member.name, e->span);
    return bad;
}

/* ---- arithmetic ---- */

static const char *const operator_text[] = {
    "+", "-", "*", "/", "mod", "<", ">", "<=", ">=", "==", "!=", "&&", "||", "-", "!"};

static bool want_number(struct eval *eval, struct value value, struct span span, const char *what)
{
    if (value.kind == VALUE_NUMBER)
        return true;
    if (value.kind != VALUE_BAD)
        diag_error(eval->diag, CODE_TYPE, span, "%s needs a number, this is %s", what, value_type(value));
    return false;
}

static struct value if_finite(struct eval *eval, const struct expr *e, double number, int dimension)
{
    if (isfinite(number))
        return value_number(number, dimension);
    diag_error(eval->diag, CODE_NOT_FINITE, e->span, "this has no finite result");
    return bad;
}

/* Both operands carry the same unit, or one of them none. */
static bool same_dimension(struct eval *eval, const struct expr *e, struct value a, struct value b)
{
    if (a.dimension == b.dimension || (a.number == 0 && !a.dimension) || (b.number == 0 && !b.dimension))
        return true;
    diag_error(eval->diag, CODE_UNIT, e->span, "'%s' of a length and something that is none",
               operator_text[e->operation.op]);
    return false;
}

static double floor_mod(double a, double b)
{
    double r = fmod(a, b);

    return r && (r < 0) != (b < 0) ? r + b : r;
}

static struct value divide(struct eval *eval, const struct expr *e, struct value a, struct value b)
{
    if (b.number == 0) {
        diag_error(eval->diag, CODE_NOT_FINITE, e->operation.b->span, "division by zero");
        return bad;
    }
    if (e->operation.op == OP_DIVIDE)
        return if_finite(eval, e, a.number / b.number, a.dimension - b.dimension);
    return same_dimension(eval, e, a, b) ? if_finite(eval, e, floor_mod(a.number, b.number), a.dimension)
                                         : bad;
}

static struct value arithmetic(struct eval *eval, const struct expr *e, struct value a, struct value b)
{
    int dimension = a.dimension ? a.dimension : b.dimension;

    switch (e->operation.op) {
    case OP_MULTIPLY:
        return if_finite(eval, e, a.number * b.number, a.dimension + b.dimension);
    case OP_DIVIDE:
    case OP_MOD:
        return divide(eval, e, a, b);
    default:
        break;
    }
    if (!same_dimension(eval, e, a, b))
        return bad;
    switch (e->operation.op) {
    case OP_ADD:
        return if_finite(eval, e, a.number + b.number, dimension);
    case OP_SUBTRACT:
        return if_finite(eval, e, a.number - b.number, dimension);
    case OP_LESS:
        return value_number(a.number < b.number, 0);
    case OP_GREATER:
        return value_number(a.number > b.number, 0);
    case OP_AT_MOST:
        return value_number(a.number <= b.number, 0);
    default:
        return value_number(a.number >= b.number, 0);
    }
}

static struct value equality(struct eval *eval, const struct expr *e, struct value a, struct value b)
{
    bool equal;

    if (a.kind == VALUE_BAD || b.kind == VALUE_BAD)
        return bad;
    if (a.kind == VALUE_NUMBER && b.kind == VALUE_NUMBER) {
        equal = a.number == b.number;
    } else if (a.kind == VALUE_STRING && b.kind == VALUE_STRING) {
        equal = strcmp(a.text, b.text) == 0;
    } else if (a.kind == VALUE_STITCH && b.kind == VALUE_STITCH) {
        equal = a.stitch == b.stitch;
    } else {
        diag_error(eval->diag, CODE_TYPE, e->span, "%s cannot be compared with %s", value_type(a),
                   value_type(b));
        return bad;
    }
    return value_number(equal == (e->operation.op == OP_EQUAL), 0);
}

/* 1 or 0; -1 after an error. */
static int truth(struct eval *eval, struct where where, const struct expr *e)
{
    struct value value = eval_expr(eval, where, e);

    if (!want_number(eval, value, e->span, "a condition"))
        return -1;
    return value.number != 0;
}

static struct value logic(struct eval *eval, struct where where, const struct expr *e)
{
    int a = truth(eval, where, e->operation.a);

    if (a < 0)
        return bad;
    if (a == (e->operation.op == OP_OR))
        return value_number(a, 0);
    a = truth(eval, where, e->operation.b);
    return a < 0 ? bad : value_number(a, 0);
}

static struct value binary(struct eval *eval, struct where where, const struct expr *e)
{
    struct value a, b;
    const char *sign = operator_text[e->operation.op];

    if (e->operation.op == OP_AND || e->operation.op == OP_OR)
        return logic(eval, where, e);
    a = eval_expr(eval, where, e->operation.a);
    b = eval_expr(eval, where, e->operation.b);
    if (e->operation.op == OP_EQUAL || e->operation.op == OP_UNEQUAL)
        return equality(eval, e, a, b);
    if (a.kind == VALUE_NUMBER && b.kind == VALUE_NUMBER)
        return arithmetic(eval, e, a, b);
    if (want_number(eval, a, e->operation.a->span, arena_printf(eval->arena, "'%s'", sign)))
        want_number(eval, b, e->operation.b->span, arena_printf(eval->arena, "'%s'", sign));
    return bad;
}

static struct value unary(struct eval *eval, struct where where, const struct expr *e)
{
    struct value a;
    int holds;

    if (e->operation.op == OP_NOT) {
        holds = truth(eval, where, e->operation.a);
        return holds < 0 ? bad : value_number(!holds, 0);
    }
    a = eval_expr(eval, where, e->operation.a);
    return want_number(eval, a, e->operation.a->span, "'-'") ? value_number(-a.number, a.dimension) : bad;
}

/* ---- lists, calls, formulas ---- */

static struct value list_value(struct eval *eval, struct where where, const struct expr *e)
{
    struct list *list = arena_new(eval->arena, struct list);
    bool good = true;

    if (e->list.n > LIMIT_LIST) {
        diag_error(eval->diag, CODE_LIMIT_LIST, e->span, "a list may have %d values", LIMIT_LIST);
        return bad;
    }
    eval->steps += 10 * e->list.n;
    list->item = arena_array(eval->arena, struct value, (size_t)e->list.n + 1);
    for (const struct expr *item = e->list.first; item; item = item->next) {
        list->item[list->n] = eval_expr(eval, where, item);
        good &= list->item[list->n++].kind != VALUE_BAD;
    }
    return good ? (struct value){.kind = VALUE_LIST, .list = list} : bad;
}

static struct value index_value(struct eval *eval, struct where where, const struct expr *e)
{
    const struct expr *a = e->operation.a, *item;
    struct value list;
    long long i;

    /* Of a list written on the spot only the one value is worked out. */
    if (a->kind == EXPR_LIST) {
        if (!eval_whole(eval, where, e->operation.b, 0, a->list.n - 1, "the place in this list", &i))
            return bad;
        for (item = a->list.first; i > 0; i--)
            item = item->next;
        return eval_expr(eval, where, item);
    }
    list = eval_expr(eval, where, a);
    if (list.kind == VALUE_BAD)
        return bad;
    if (list.kind != VALUE_LIST) {
        diag_error(eval->diag, CODE_TYPE, a->span, "only a list has places, this is %s", value_type(list));
        return bad;
    }
    if (!eval_whole(eval, where, e->operation.b, 0, list.list->n - 1, "the place in this list", &i))
        return bad;
    return list.list->item[i];
}

static struct value call_value(struct eval *eval, struct where where, const struct expr *e)
{
    const struct expr *function = e->call.function;
    const struct builtin *builtin;
    struct binding *binding = NULL;
    struct value value;

    /* A motif of this file or a used one; then the language's own functions. */
    if (function->kind == EXPR_NAME) {
        binding = module_find(where.module, function->text);
        builtin = binding ? NULL : builtin_find(eval, function->text);
        if (builtin)
            return builtin_call(eval, where, builtin, e);
    } else if (function->kind == EXPR_MEMBER) {
        struct binding *space = module_find(where.module, function->member.space);

        if (space && space->kind == BINDING_SPACE)
            binding = module_find(space->module, function->member.name);
    }
    if (binding && (binding = binding_target(binding)) && binding->kind == BINDING_MOTIF)
        return motif_make(eval, binding, where, e, e->span);
    value = eval_expr(eval, where, function);
    if (value.kind != VALUE_BAD)
        diag_error(eval->diag, CODE_TYPE, function->span, "this is %s, nothing to call", value_type(value));
    return bad;
}

static bool cell_value(struct eval *eval, struct where where, const struct expr *e, stitch_id *cell)
{
    struct value value = eval_expr(eval, where, e);

    if (value.kind == VALUE_STITCH) {
        *cell = value.stitch;
        return true;
    }
    if (value.kind != VALUE_BAD)
        diag_error(eval->diag, CODE_TYPE, e->span,
                   "a formula gives a stitch (K, P or one of yours), this is %s", value_type(value));
    return false;
}

static struct value each_value(struct eval *eval, struct where where, const struct expr *e)
{
    long long columns, rows;
    stitch_id *cell;
    struct grid *grid;
    struct local y = {e->each.y, value_number(0, 0), where.local};
    struct local x = {e->each.x, value_number(0, 0), &y};
    bool good = true;

    if (!eval_whole(eval, where, e->each.columns, 1, LIMIT_STITCHES, "the width", &columns) ||
        !eval_whole(eval, where, e->each.rows, 1, LIMIT_STITCHES, "the height", &rows) ||
        !fabric_size(eval, e->span, columns, rows))
        return bad;
    grid = grid_new(eval->arena, (int)columns, (int)rows, &cell);
    where.local = &x;
    for (long long v = 0; v < rows && good; v++)
        for (long long u = 0; u < columns && good; u++) {
            y.value.number = (double)v;
            x.value.number = (double)u;
            good = cell_value(eval, where, e->each.cell, cell++);
        }
    return good ? value_grid(grid) : bad;
}

static struct value choice(struct eval *eval, struct where where, const struct expr *e)
{
    int holds = truth(eval, where, e->operation.a);

    return holds < 0 ? bad : eval_expr(eval, where, holds ? e->operation.b : e->operation.c);
}

static struct value value_of(struct eval *eval, struct where where, const struct expr *e)
{
    switch (e->kind) {
    case EXPR_NUMBER:
        return value_number(e->number.value, e->number.dimension);
    case EXPR_STRING:
        return (struct value){.kind = VALUE_STRING, .text = e->text};
    case EXPR_NAME:
        return name_value(eval, where, e);
    case EXPR_MEMBER:
        return member_value(eval, where, e);
    case EXPR_LIST:
        return list_value(eval, where, e);
    case EXPR_UNARY:
        return unary(eval, where, e);
    case EXPR_BINARY:
        return binary(eval, where, e);
    case EXPR_CHOICE:
        return choice(eval, where, e);
    case EXPR_INDEX:
        return index_value(eval, where, e);
    case EXPR_CALL:
        return call_value(eval, where, e);
    case EXPR_EACH:
        return each_value(eval, where, e);
    default:
        return bad;
    }
}

struct value eval_expr(struct eval *eval, struct where where, const struct expr *e)
{
    struct value value = bad;

    if (!eval_step(eval, e->span))
        return bad;
    if (eval->depth >= LIMIT_EVALUATION) {
        diag_error(eval->diag, CODE_LIMIT_CALLS, e->span,
                   "expressions and definitions use each other too deep");
        return bad;
    }
    eval->depth++;
    value = value_of(eval, where, e);
    eval->depth--;
    return value;
}

/* ---- numbers that something needs ---- */

bool eval_number(struct eval *eval, struct where where, const struct expr *e, int dimension, double *number)
{
    struct value value = eval_expr(eval, where, e);

    if (!want_number(eval, value, e->span, "this place"))
        return false;
    if (value.dimension && value.dimension != dimension) {
        diag_error(eval->diag, CODE_UNIT, e->span,
                   dimension ? "this has the wrong unit" : "this number takes no unit");
        return false;
    }
    *number = value.number;
    return true;
}

bool eval_whole(struct eval *eval, struct where where, const struct expr *e, long long low, long long high,
                const char *what, long long *number)
{
    double value;

    if (!eval_number(eval, where, e, 0, &value))
        return false;
    if (value != floor(value)) {
        diag_error(eval->diag, CODE_WHOLE, e->span, "%s must be a whole number, not %g", what, value);
        return false;
    }
    if (value < (double)low || value > (double)high) {
        diag_error(eval->diag, CODE_RANGE, e->span, "%s is %.15g; it must lie in %lld..%lld", what, value,
                   low, high);
        return false;
    }
    *number = (long long)value;
    return true;
}

/* The numbers of a list. */
static bool list_points(struct eval *eval, struct where where, const struct expr *e, double **point, int *n)
{
    struct value value = eval_expr(eval, where, e);

    if (value.kind == VALUE_BAD)
        return false;
    if (value.kind != VALUE_LIST) {
        diag_error(eval->diag, CODE_TYPE, e->span,
                   "this must be a range (1..4) or a list ([1, 2, 4]), not %s", value_type(value));
        return false;
    }
    *n = value.list->n;
    *point = arena_array(eval->arena, double, (size_t)*n + 1);
    for (int i = 0; i < *n; i++) {
        if (!want_number(eval, value.list->item[i], e->span, "every place of this list"))
            return false;
        (*point)[i] = value.list->item[i].number;
    }
    return true;
}

/* 0.7 for 0.4 + 3 * 0.1, which a computer takes for 0.7000000000000001. */
static double near_decimal(double value, double step)
{
    char text[40];

    snprintf(text, sizeof text, "%.12g", value);
    return fabs(strtod(text, NULL) - value) < fabs(step) * 1e-9 ? strtod(text, NULL) : value;
}

bool eval_range(struct eval *eval, struct where where, const struct range *range, double **point, int *n)
{
    double low, high, step = 1, count;

    if (!range->high)
        return list_points(eval, where, range->low, point, n);
    if (!eval_number(eval, where, range->low, 0, &low) || !eval_number(eval, where, range->high, 0, &high) ||
        (range->step && !eval_number(eval, where, range->step, 0, &step)))
        return false;
    if (step == 0) {
        diag_error(eval->diag, CODE_RANGE, range->step->span, "a step of 0 leads nowhere");
        return false;
    }

    /* A step that misses the end by rounding still reaches it. */
    count = floor((high - low) / step + 1e-9) + 1;
    if (!(count <= LIMIT_LIST)) {
        diag_error(eval->diag, CODE_LIMIT_LIST, range->span, "a range may have %d values", LIMIT_LIST);
        return false;
    }
    *n = count > 0 ? (int)count : 0;
    *point = arena_array(eval->arena, double, (size_t)*n + 1);
    for (int i = 0; i < *n; i++)
        (*point)[i] = i == *n - 1 && fabs(low + i * step - high) < fabs(step) * 1e-6
                          ? high
                          : near_decimal(low + i * step, step);
    return true;
}
