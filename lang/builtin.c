/* SPDX-License-Identifier: GPL-3.0-or-later
 * The language's functions: arguments in, a value out.  One table names them,
 * their arguments and what they do. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "lang/eval.h"
#include "lang/limits.h"

enum { ARGUMENTS = 6 };

struct call {
    struct eval *eval;
    const struct builtin *function;
    struct span span;
    int n;               /* values; for named ones the number of formals */
    struct value *value; /* VALUE_BAD: not given */
    struct span *at;
};

struct builtin {
    const char *name;
    struct value (*run)(struct call *);
    const char *formal[ARGUMENTS]; /* the first `required` must be given */
    int required;
    bool many;                /* takes any number, by position */
    double (*number)(double); /* of one number */
};

static const struct value bad = {.kind = VALUE_BAD};

/* ---- reading arguments ---- */

static const struct grid *fabric(struct call *call, int i)
{
    return fabric_of(call->eval, call->value[i], call->at[i]);
}

static bool whole(struct call *call, int i, long long low, long long high, long long otherwise,
                  long long *number)
{
    struct diag *diag = call->eval->diag;
    struct value value = call->value[i];
    const char *name = call->function->formal[i];

    *number = otherwise;
    if (value.kind == VALUE_BAD)
        return true;
    if (value.kind != VALUE_NUMBER || value.dimension) {
        diag_error(diag, CODE_TYPE, call->at[i], "'%s' of %s is a plain number, not %s", name,
                   call->function->name, value.kind == VALUE_NUMBER ? "a length" : value_type(value));
        return false;
    }
    if (value.number != floor(value.number)) {
        diag_error(diag, CODE_WHOLE, call->at[i], "'%s' of %s must be a whole number, not %g", name,
                   call->function->name, value.number);
        return false;
    }
    if (value.number < (double)low || value.number > (double)high) {
        diag_error(diag, CODE_RANGE, call->at[i], "'%s' of %s is %.15g; it must lie in %lld..%lld", name,
                   call->function->name, value.number, low, high);
        return false;
    }
    *number = (long long)value.number;
    return true;
}

static bool number(struct call *call, int i, double *to)
{
    if (call->value[i].kind == VALUE_NUMBER) {
        *to = call->value[i].number;
        return true;
    }
    if (call->value[i].kind != VALUE_BAD)
        diag_error(call->eval->diag, CODE_TYPE, call->at[i], "%s needs a number, this is %s",
                   call->function->name, value_type(call->value[i]));
    return false;
}

static struct value if_finite(struct call *call, double result, int dimension)
{
    if (isfinite(result))
        return value_number(result, dimension);
    diag_error(call->eval->diag, CODE_NOT_FINITE, call->span, "%s has no finite result here",
               call->function->name);
    return bad;
}

/* ---- numbers ---- */

static struct value run_number(struct call *call)
{
    double x;

    return number(call, 0, &x) ? if_finite(call, call->function->number(x), call->value[0].dimension) : bad;
}

/* Of a plain number only: powers and angles. */
static bool plain(struct call *call, int i, double *to)
{
    if (!number(call, i, to))
        return false;
    if (call->value[i].dimension)
        diag_error(call->eval->diag, CODE_UNIT, call->at[i], "%s of a length", call->function->name);
    return !call->value[i].dimension;
}

static struct value run_plain(struct call *call)
{
    double x;

    return plain(call, 0, &x) ? if_finite(call, call->function->number(x), 0) : bad;
}

static struct value extreme(struct call *call, double sign)
{
    double best = 0, x;

    for (int i = 0; i < call->n; i++) {
        if (!number(call, i, &x))
            return bad;
        if (call->value[i].dimension != call->value[0].dimension) {
            diag_error(call->eval->diag, CODE_UNIT, call->at[i], "%s of a length and something that is none", call->function->name);
            return bad;
        }
        if (i == 0 || sign * x > sign * best)
            best = x;
    }
    return value_number(best, call->value[0].dimension);
}

static struct value run_min(struct call *call)
{
    return extreme(call, -1);
}

static struct value run_max(struct call *call)
{
    return extreme(call, 1);
}

static struct value run_pow(struct call *call)
{
    double x, y;

    return plain(call, 0, &x) && plain(call, 1, &y) ? if_finite(call, pow(x, y), 0) : bad;
}

static struct value run_gcd(struct call *call)
{
    long long a, b;

    if (!whole(call, 0, 0, 1LL << 52, 0, &a) || !whole(call, 1, 0, 1LL << 52, 0, &b))
        return bad;
    while (b) {
        long long r = a % b;

        a = b;
        b = r;
    }
    return value_number((double)a, 0);
}

/* ---- asking a fabric ---- */

static struct value run_width(struct call *call)
{
    const struct grid *g = fabric(call, 0);

    return g ? value_number(g->columns, 0) : bad;
}

static struct value run_height(struct call *call)
{
    const struct grid *g = fabric(call, 0);

    return g ? value_number(g->rows, 0) : bad;
}

static struct value run_count(struct call *call)
{
    const struct grid *g = fabric(call, 0);
    struct value stitch = call->value[1];

    if (!g)
        return bad;
    if (stitch.kind == VALUE_BAD)
        return value_number((double)g->columns * g->rows, 0);
    if (stitch.kind != VALUE_STITCH) {
        diag_error(call->eval->diag, CODE_TYPE, call->at[1], "count counts a stitch, this is %s",
                   value_type(stitch));
        return bad;
    }
    return value_number((double)grid_count(g, stitch.stitch), 0);
}

/* The stitch at a place; the fabric goes on without end. */
static struct value run_at(struct call *call)
{
    const struct grid *g = fabric(call, 0);
    long long x, y;

    if (!g || !whole(call, 1, INT_MIN, INT_MAX, 0, &x) || !whole(call, 2, INT_MIN, INT_MAX, 0, &y))
        return bad;
    x = (x % g->columns + g->columns) % g->columns;
    y = (y % g->rows + g->rows) % g->rows;
    return (struct value){.kind = VALUE_STITCH, .stitch = grid_at(g, (int)x, (int)y)};
}

/* ---- covering an area ---- */

/* Rows of one fixed width are worked on upwards; sideways they are copied. */
static const struct grid *column_of(struct call *call, int i, long long height, long long copies)
{
    struct motif *m = call->value[i].kind == VALUE_MOTIF ? call->value[i].motif : NULL;

    if (!m || m->multiple)
        return fabric(call, i);
    return motif_grid(call->eval, m, m->plus, height ? height : copies * motif_rows(m), call->at[i]);
}

/* The motif behind a value, or NULL where its width is fixed. */
static struct motif *motif_behind(struct call *call, int i)
{
    return call->value[i].kind == VALUE_MOTIF && call->value[i].motif->multiple ? call->value[i].motif : NULL;
}

static struct value run_tile(struct call *call)
{
    struct eval *eval = call->eval;
    struct motif *m = motif_behind(call, 0);
    const struct grid *g;
    long long columns, rows;

    if (!whole(call, 1, 1, LIMIT_STITCHES, 1, &columns) || !whole(call, 2, 1, LIMIT_STITCHES, 1, &rows))
        return bad;
    if (m)
        return value_grid(
            motif_grid(eval, m, m->multiple * columns + m->plus, motif_rows(m) * rows, call->span));
    g = column_of(call, 0, 0, rows);
    if (g && call->value[0].kind == VALUE_MOTIF)
        rows = 1;
    if (!g || !fabric_size(eval, call->span, g->columns * columns, g->rows * rows))
        return bad;
    return value_grid(grid_tile(eval->arena, g, (int)columns, (int)rows));
}

static void misfit(struct call *call, long long width, long long multiple, long long plus)
{
    struct diag *diag = call->eval->diag;
    long long n = (width - plus) / multiple, below;

    diag_error(diag, CODE_FIT, call->at[1], "%lld is not a multiple of %s", width,
               names_multiple(call->eval->arena, multiple, plus));
    if (width - plus < multiple)
        n = 0;
    below = multiple * n + plus;
    if (n)
        diag_hint(diag, "the nearest widths are %lld and %lld", below, below + multiple);
    else
        diag_hint(diag, "the smallest width is %lld", multiple + plus);
}

static struct value run_fill(struct call *call)
{
    struct eval *eval = call->eval;
    struct motif *m = motif_behind(call, 0);
    const struct grid *g = NULL;
    long long width, height, multiple, plus;

    if (!whole(call, 1, 1, LIMIT_STITCHES, 1, &width) || !whole(call, 2, 1, LIMIT_STITCHES, 1, &height) ||
        (!m && !(g = column_of(call, 0, height, 0))))
        return bad;
    multiple = m ? m->multiple : g->columns;
    plus = m ? m->plus : 0;
    if (width < multiple + plus || (width - plus) % multiple) {
        misfit(call, width, multiple, plus);
        return bad;
    }
    if (m)
        return value_grid(motif_grid(eval, m, width, height, call->span));
    if (!fabric_size(eval, call->span, width, height))
        return bad;
    return value_grid(grid_window(eval->arena, g, 0, 0, (int)width, (int)height));
}

/* ---- putting together ---- */

/* All arguments as fabrics that agree in one size, and the other sizes' sum. */
static const struct grid **parts(struct call *call, bool beside, long long *sum)
{
    const struct grid **part = arena_array(call->eval->arena, const struct grid *, (size_t)call->n);

    *sum = 0;
    for (int i = 0; i < call->n; i++) {
        part[i] = fabric(call, i);
        if (!part[i])
            return NULL;
        *sum += beside ? part[i]->columns : part[i]->rows;
        if (beside ? part[i]->rows == part[0]->rows : part[i]->columns == part[0]->columns)
            continue;
        diag_error(call->eval->diag, CODE_SIZES, call->at[i], "the %s is %d here, but %d in the first",
                   beside ? "height" : "width", beside ? part[i]->rows : part[i]->columns,
                   beside ? part[0]->rows : part[0]->columns);
        diag_hint(call->eval->diag, "fill(motif, width, height) brings one to the size of the other");
        return NULL;
    }
    return part;
}

static struct value run_beside(struct call *call)
{
    long long columns;
    const struct grid **part = parts(call, true, &columns);

    if (!part || !fabric_size(call->eval, call->span, columns, part[0]->rows))
        return bad;
    return value_grid(grid_beside(call->eval->arena, part, call->n));
}

static struct value run_above(struct call *call)
{
    long long rows;
    const struct grid **part = parts(call, false, &rows);

    if (!part || !fabric_size(call->eval, call->span, part[0]->columns, rows))
        return bad;
    return value_grid(grid_above(call->eval->arena, part, call->n));
}

static bool lies_inside(struct call *call, const struct grid *whole_, long long x, long long y,
                        long long columns, long long rows)
{
    if (x + columns <= whole_->columns && y + rows <= whole_->rows)
        return true;
    diag_error(call->eval->diag, CODE_OUTSIDE, call->span,
               "%lld x %lld stitches at (%lld, %lld) do not lie inside %d x %d", columns, rows, x, y,
               whole_->columns, whole_->rows);
    return false;
}

static struct value run_crop(struct call *call)
{
    const struct grid *g = fabric(call, 0);
    long long x, y, columns, rows;

    if (!g || !whole(call, 1, 0, LIMIT_STITCHES, 0, &x) || !whole(call, 2, 0, LIMIT_STITCHES, 0, &y) ||
        !whole(call, 3, 1, LIMIT_STITCHES, 1, &columns) || !whole(call, 4, 1, LIMIT_STITCHES, 1, &rows) ||
        !lies_inside(call, g, x, y, columns, rows) || !fabric_size(call->eval, call->span, columns, rows))
        return bad;
    return value_grid(grid_window(call->eval->arena, g, x, y, (int)columns, (int)rows));
}

static struct value run_inset(struct call *call)
{
    const struct grid *part = fabric(call, 0), *ground = part ? fabric(call, 1) : NULL;
    long long x, y;

    if (!ground || !whole(call, 2, 0, LIMIT_STITCHES, 0, &x) || !whole(call, 3, 0, LIMIT_STITCHES, 0, &y) ||
        !lies_inside(call, ground, x, y, part->columns, part->rows) ||
        !fabric_size(call->eval, call->span, ground->columns, ground->rows))
        return bad;
    return value_grid(grid_inset(call->eval->arena, part, ground, (int)x, (int)y));
}

/* The frame's motif is repeated from the lower left corner of the whole. */
static struct value run_border(struct call *call)
{
    struct eval *eval = call->eval;
    const struct grid *g = fabric(call, 0), *frame;
    long long sts, rows;

    if (!g || !whole(call, 1, 0, LIMIT_STITCHES, 0, &sts) || !whole(call, 2, 0, LIMIT_STITCHES, 0, &rows) ||
        !(frame = fabric(call, 3)) ||
        !fabric_size(eval, call->span, g->columns + 2 * sts, g->rows + 2 * rows))
        return bad;
    if (motif_behind(call, 3) && call->value[3].motif->plus)
        frame = grid_window(eval->arena, frame, 0, 0, (int)call->value[3].motif->multiple, frame->rows);
    frame = grid_window(eval->arena, frame, 0, 0, g->columns + 2 * (int)sts, g->rows + 2 * (int)rows);
    return value_grid(grid_inset(eval->arena, g, frame, (int)sts, (int)rows));
}

static struct value run_shift(struct call *call)
{
    const struct grid *g = fabric(call, 0);
    long long dx, dy;

    if (!g || !whole(call, 1, INT_MIN, INT_MAX, 0, &dx) || !whole(call, 2, INT_MIN, INT_MAX, 0, &dy) ||
        !fabric_size(call->eval, call->span, g->columns, g->rows))
        return bad;
    return value_grid(grid_shift(call->eval->arena, g, dx, dy));
}

/* ---- turning ---- */

static const struct grid *to_turn(struct call *call)
{
    const struct grid *g = fabric(call, 0);

    return g && fabric_size(call->eval, call->span, g->columns, g->rows) ? g : NULL;
}

static struct value run_mirror(struct call *call)
{
    const struct grid *g = to_turn(call);

    return g ? value_grid(grid_mirror(call->eval->arena, g)) : bad;
}

static struct value run_flip(struct call *call)
{
    const struct grid *g = to_turn(call);

    return g ? value_grid(grid_flip(call->eval->arena, g)) : bad;
}

static struct value run_invert(struct call *call)
{
    const struct grid *g = to_turn(call);

    return g ? value_grid(grid_invert(call->eval->arena, g, call->eval->ws)) : bad;
}

static struct value run_turn(struct call *call)
{
    const struct grid *g = to_turn(call);

    return g ? value_grid(grid_turn(call->eval->arena, g, call->eval->ws)) : bad;
}

static struct value run_rotate(struct call *call)
{
    const struct grid *g = to_turn(call);

    return g ? value_grid(grid_rotate(call->eval->arena, g)) : bad;
}

/* ---- the table ---- */

static const struct builtin builtins[] = {
    {"tile", run_tile, {"motif", "columns", "rows"}, 3, false, NULL},
    {"fill", run_fill, {"motif", "width", "height"}, 3, false, NULL},
    {"beside", run_beside, {NULL}, 1, true, NULL},
    {"above", run_above, {NULL}, 1, true, NULL},
    {"mirror", run_mirror, {"motif"}, 1, false, NULL},
    {"flip", run_flip, {"motif"}, 1, false, NULL},
    {"invert", run_invert, {"motif"}, 1, false, NULL},
    {"turn", run_turn, {"motif"}, 1, false, NULL},
    {"rotate", run_rotate, {"motif"}, 1, false, NULL},
    {"shift", run_shift, {"motif", "dx", "dy"}, 1, false, NULL},
    {"crop", run_crop, {"motif", "x", "y", "width", "height"}, 5, false, NULL},
    {"inset", run_inset, {"motif", "into", "x", "y"}, 4, false, NULL},
    {"border", run_border, {"motif", "sts", "rows", "with"}, 4, false, NULL},
    {"width", run_width, {"motif"}, 1, false, NULL},
    {"height", run_height, {"motif"}, 1, false, NULL},
    {"count", run_count, {"motif", "stitch"}, 1, false, NULL},
    {"at", run_at, {"motif", "x", "y"}, 3, false, NULL},
    {"min", run_min, {NULL}, 1, true, NULL},
    {"max", run_max, {NULL}, 1, true, NULL},
    {"abs", run_number, {"x"}, 1, false, fabs},
    {"floor", run_number, {"x"}, 1, false, floor},
    {"ceil", run_number, {"x"}, 1, false, ceil},
    {"round", run_number, {"x"}, 1, false, round},
    {"sqrt", run_plain, {"x"}, 1, false, sqrt},
    {"sin", run_plain, {"x"}, 1, false, sin},
    {"cos", run_plain, {"x"}, 1, false, cos},
    {"tan", run_plain, {"x"}, 1, false, tan},
    {"exp", run_plain, {"x"}, 1, false, exp},
    {"log", run_plain, {"x"}, 1, false, log},
    {"pow", run_pow, {"x", "y"}, 2, false, NULL},
    {"gcd", run_gcd, {"a", "b"}, 2, false, NULL},
};
static const int nbuiltins = sizeof builtins / sizeof *builtins;

void builtin_init(struct eval *eval)
{
    eval->function = arena_array(eval->arena, const char *, (size_t)nbuiltins);
    for (int i = 0; i < nbuiltins; i++)
        eval->function[i] = names_intern(eval->names, builtins[i].name, strlen(builtins[i].name));
}

const struct builtin *builtin_find(const struct eval *eval, const char *name)
{
    for (int i = 0; i < nbuiltins; i++)
        if (eval->function[i] == name)
            return &builtins[i];
    return NULL;
}

void builtin_offer(struct nearest *nearest)
{
    for (int i = 0; i < nbuiltins; i++)
        nearest_offer(nearest, builtins[i].name);
}

/* ---- calling ---- */

static int nformals(const struct builtin *function)
{
    int n = 0;

    while (n < ARGUMENTS && function->formal[n])
        n++;
    return n;
}

/* "tile(motif, columns, rows)" */
static const char *signature(struct arena *arena, const struct builtin *function)
{
    const char *text = arena_printf(arena, "%s(", function->name);

    if (function->many)
        return arena_printf(arena, "%sa, b, ..)", text);
    for (int i = 0; i < nformals(function); i++)
        text = arena_printf(arena, "%s%s%s", text, i ? ", " : "", function->formal[i]);
    return arena_printf(arena, "%s)", text);
}

static struct value wrong_arguments(struct eval *eval, const struct builtin *function, struct span span,
                                    const char *what)
{
    diag_error(eval->diag, CODE_ARGUMENTS, span, "%s", what);
    diag_hint(eval->diag, "%s", signature(eval->arena, function));
    return bad;
}

/* The place of an argument among the formals; -1 after an error. */
static int place_of(struct eval *eval, const struct builtin *function, const struct argument *a, int position)
{
    int n = nformals(function);

    if (function->many && !a->name)
        return position;
    if (!a->name && position < n)
        return position;
    for (int i = 0; a->name && i < n; i++)
        if (strcmp(function->formal[i], a->name) == 0)
            return i;
    wrong_arguments(
        eval, function, a->span,
        a->name ? arena_printf(eval->arena, "%s has no argument '%s'", function->name, a->name)
                : arena_printf(eval->arena, "%s takes %d argument%s", function->name, n, n == 1 ? "" : "s"));
    return -1;
}

struct value builtin_call(struct eval *eval, struct where where, const struct builtin *function,
                          const struct expr *e)
{
    int n = function->many ? e->call.n : nformals(function), position = 0;
    struct value few[ARGUMENTS] = {{0}};
    struct span few_at[ARGUMENTS] = {{0}};
    struct call call = {eval, function, e->span, n, few, few_at};

    if (n > ARGUMENTS) {
        call.value = arena_array(eval->arena, struct value, (size_t)n);
        call.at = arena_array(eval->arena, struct span, (size_t)n);
        eval->steps += 10 * n;
    }
    for (const struct argument *a = e->call.first; a; a = a->next) {
        int i = place_of(eval, function, a, position);

        position += !a->name;
        if (i < 0)
            return bad;
        if (call.at[i].source)
            return wrong_arguments(eval, function, a->span,
                                   arena_printf(eval->arena, "'%s' is given twice", function->formal[i]));
        call.at[i] = a->value->span;
        call.value[i] = eval_expr(eval, where, a->value);
        if (call.value[i].kind == VALUE_BAD)
            return bad;
    }
    for (int i = 0; i < function->required; i++)
        if (i >= n || !call.at[i].source)
            return wrong_arguments(
                eval, function, e->span,
                function->many
                    ? arena_printf(eval->arena, "%s needs an argument", function->name)
                    : arena_printf(eval->arena, "%s needs '%s'", function->name, function->formal[i]));
    return function->run(&call);
}
