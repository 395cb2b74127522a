/* SPDX-License-Identifier: GPL-3.0-or-later
 * Motifs: a definition and its arguments in, fabrics of any width it fits out. */
#include <limits.h>

#include "lang/eval.h"
#include "lang/limits.h"

bool fabric_size(struct eval *eval, struct span span, long long columns, long long rows)
{
    if (rows > LIMIT_ROWS) {
        diag_error(eval->diag, CODE_LIMIT_ROWS, span, "this makes %lld rows; the limit is %d", rows,
                   LIMIT_ROWS);
        return false;
    }
    if (columns > LIMIT_STITCHES / rows) {
        diag_error(eval->diag, CODE_LIMIT_STITCHES, span,
                   "this makes %lld x %lld stitches; the limit is %d in all", columns, rows, LIMIT_STITCHES);
        return false;
    }
    eval->cells += columns * rows;
    if (eval->cells <= LIMIT_ALL_STITCHES)
        return true;
    diag_error(eval->diag, CODE_LIMIT_STITCHES, span,
               "all fabrics on the way here have more than %d stitches", LIMIT_ALL_STITCHES);
    return false;
}

/* ---- arguments ---- */

static struct local *bind(struct eval *eval, struct local *up, const char *name, struct value value)
{
    struct local *local = arena_new(eval->arena, struct local);

    *local = (struct local){name, value, up};
    return local;
}

/* The argument for a formal: by its name, or the i-th of those without one. */
static const struct argument *argument_for(const struct expr *call, const char *name, int i)
{
    for (const struct argument *a = call ? call->call.first : NULL; a; a = a->next)
        if (a->name ? a->name == name : i-- == 0)
            return a;
    return NULL;
}

static bool check_arguments(struct eval *eval, const struct binding *binding, const struct expr *call)
{
    int nformals = 0, position = 0;

    for (const struct formal *f = binding->stmt->motif.formal; f; f = f->next)
        nformals++;
    for (const struct argument *a = call ? call->call.first : NULL; a; a = a->next) {
        struct nearest nearest = nearest_to(a->name ? a->name : "");
        bool known = !a->name && position++ < nformals;
        int i = 0;

        for (const struct formal *f = binding->stmt->motif.formal; f && a->name; f = f->next, i++) {
            known |= f->name == a->name;
            nearest_offer(&nearest, f->name);
        }
        for (const struct argument *b = call->call.first; b != a; b = b->next)
            if (a->name && b->name == a->name) {
                diag_error(eval->diag, CODE_ARGUMENTS, a->span, "'%s' is given twice", a->name);
                return false;
            }
        if (known)
            continue;
        if (a->name)
            diag_error(eval->diag, CODE_ARGUMENTS, a->span, "'%s' has no argument '%s'", binding->name,
                       a->name);
        else
            diag_error(eval->diag, CODE_ARGUMENTS, a->span, "'%s' takes %d argument%s", binding->name,
                       nformals, nformals == 1 ? "" : "s");
        if (a->name)
            diag_did_you_mean(eval->diag, nearest.best);
        diag_note(eval->diag, binding->span, "it is defined here");
        return false;
    }
    return true;
}

/* Values of the call, else defaults, which may use the arguments before them. */
static bool bind_arguments(struct eval *eval, const struct binding *binding, struct where caller,
                           const struct expr *call, struct where *inside)
{
    int i = 0;

    *inside = (struct where){binding->module, NULL};
    if (!check_arguments(eval, binding, call))
        return false;
    for (const struct formal *formal = binding->stmt->motif.formal; formal; formal = formal->next) {
        const struct argument *argument = argument_for(call, formal->name, i);
        struct value value;

        if (argument && !argument->name)
            i++;
        if (!argument && !formal->value) {
            diag_error(eval->diag, CODE_ARGUMENTS, call->span, "'%s' needs its argument '%s'", binding->name,
                       formal->name);
            diag_note(eval->diag, formal->span, "here");
            return false;
        }
        value = argument ? eval_expr(eval, caller, argument->value) : eval_expr(eval, *inside, formal->value);
        if (value.kind == VALUE_BAD)
            return false;
        inside->local = bind(eval, inside->local, formal->name, value);
    }
    return true;
}

/* ---- from the definition to what can be knitted ---- */

static bool explicit_multiple(struct eval *eval, struct motif *m)
{
    const struct multiple *multiple = &m->stmt->motif.multiple;

    m->plus = 0;
    return eval_whole(eval, m->where, multiple->of, 1, LIMIT_STITCHES, "the multiple", &m->multiple) &&
           (!multiple->plus ||
            eval_whole(eval, m->where, multiple->plus, 0, LIMIT_STITCHES, "the stitches added", &m->plus));
}

static bool prepare_rows(struct eval *eval, struct motif *m)
{
    struct fit fit;

    if (!rows_finish(m->rows))
        return false;
    if (rows_count(m->rows) == 0) {
        diag_error(eval->diag, CODE_EMPTY_MOTIF, m->span, "'%s' has no row", m->name);
        return false;
    }
    if (m->stmt->motif.multiple.of)
        return explicit_multiple(eval, m); /* what it says is checked when it is worked */
    if (!rows_fit(m->rows, &fit) || !rows_good(m->rows))
        return false;

    /* With n repeats the width is multiple * n + plus; none at all is plus. */
    m->multiple = fit.multiple;
    m->plus = fit.plus;
    if (fit.multiple)
        m->plus = fit.least + ((fit.plus - fit.least) % fit.multiple + fit.multiple) % fit.multiple;
    if (!m->multiple && !m->plus) {
        diag_error(eval->diag, CODE_EMPTY_MOTIF, m->span, "'%s' has no stitch", m->name);
        return false;
    }
    return true;
}

/* A chart that shows several repeats is cut down to one of them. */
static bool one_repeat(struct eval *eval, struct motif *m)
{
    int period = (int)m->multiple, all = m->grid->columns, keep = (int)(m->multiple + m->plus);

    for (int y = 0; y < m->grid->rows; y++)
        for (int x = m->box; x + period < all - (int)m->plus + m->box; x++)
            if (grid_at(m->grid, x, y) != grid_at(m->grid, x + period, y)) {
                diag_error(eval->diag, CODE_MULTIPLE, m->span, "'%s' does not repeat after %d stitches",
                           m->name, period);
                diag_note(eval->diag, (struct span){0},
                          "in its row %d, stitches %d and %d from the left differ", y + 1, x + 1,
                          x + period + 1);
                return false;
            }
    if (all > keep) {
        const struct grid *part[2] = {grid_window(eval->arena, m->grid, 0, 0, m->box + period, m->grid->rows),
                                      NULL};
        int behind = keep - m->box - period;

        if (behind)
            part[1] = grid_window(eval->arena, m->grid, all - behind, 0, behind, m->grid->rows);
        m->grid = behind ? grid_beside(eval->arena, part, 2) : part[0];
    }
    return true;
}

static bool prepare_grid(struct eval *eval, struct motif *m, int box_width)
{
    int columns = m->grid->columns;

    if (!m->stmt->motif.multiple.of) {
        m->multiple = box_width ? box_width : columns;
        m->plus = columns - m->multiple;
        return true;
    }
    if (!explicit_multiple(eval, m))
        return false;
    if (columns < m->multiple + m->plus || (columns - m->plus) % m->multiple) {
        diag_error(eval->diag, CODE_MULTIPLE, m->span, "'%s' is %d stitches wide, no multiple of %s",
                   m->name, columns, names_multiple(eval->arena, m->multiple, m->plus));
        return false;
    }
    if (box_width && box_width != m->multiple) {
        diag_error(eval->diag, CODE_MULTIPLE, m->span,
                   "the chart marks a repeat of %d stitches, the multiple is %lld", box_width, m->multiple);
        return false;
    }

    /* Edge stitches that differ from the repeat need its place marked. */
    for (int y = 0; y < m->grid->rows && !box_width; y++)
        for (int x = 0; x < m->plus; x++)
            if (grid_at(m->grid, x, y) != grid_at(m->grid, x + columns - (int)m->plus, y)) {
                diag_error(eval->diag, CODE_MULTIPLE, m->span,
                           "where the repeat of '%s' stands is open: its edges differ", m->name);
                diag_hint(eval->diag, "mark the repeat in the chart: `o | x x x | o`");
                return false;
            }
    return one_repeat(eval, m);
}

static bool prepare_body(struct eval *eval, struct motif *m)
{
    struct body body = {.rows = rows_new(eval->arena, eval->diag), .round = body_in_rounds(m->stmt->motif.body)};

    body_run(eval, m->where, m->stmt->motif.body, &body);
    if (body.failed)
        return false;
    m->box = body.box;
    if (body.chart) {
        m->grid = body.chart;
        return prepare_grid(eval, m, body.box_width);
    }
    m->rows = body.rows;
    return prepare_rows(eval, m);
}

/* A motif given by an expression is the fabric that has, or another motif. */
static struct value expression_motif(struct eval *eval, struct motif *m)
{
    const struct expr *e = m->stmt->motif.value;
    struct value value = eval_expr(eval, m->where, e);

    if (value.kind == VALUE_BAD || (value.kind == VALUE_MOTIF && !m->stmt->motif.multiple.of))
        return value;
    m->grid = fabric_of(eval, value, e->span);
    if (!m->grid || !prepare_grid(eval, m, 0))
        return (struct value){.kind = VALUE_BAD};
    return (struct value){.kind = VALUE_MOTIF, .motif = m};
}

struct value motif_make(struct eval *eval, struct binding *binding, struct where caller,
                        const struct expr *call, struct span used)
{
    struct value value = {.kind = VALUE_BAD};
    struct motif *m;
    struct context context = {used, NULL, eval->diag->context};

    eval->steps += 50;
    if (eval->calls >= LIMIT_CALLS) {
        diag_error(eval->diag, CODE_LIMIT_CALLS, used, "motifs use each other more than %d deep",
                   LIMIT_CALLS);
        return value;
    }
    m = arena_new(eval->arena, struct motif);
    *m = (struct motif){.name = binding->name, .span = binding->span, .used = used, .stmt = binding->stmt};
    if (!bind_arguments(eval, binding, caller, call, &m->where))
        return value;

    /* Errors inside point at the place that used it, too. */
    context.what = arena_printf(eval->arena, "in motif '%s', used here", m->name);
    if (used.source)
        eval->diag->context = &context;
    eval->calls++;
    if (m->stmt->motif.value)
        value = expression_motif(eval, m);
    else if (prepare_body(eval, m))
        value = (struct value){.kind = VALUE_MOTIF, .motif = m};
    eval->calls--;
    eval->diag->context = context.up;
    return value;
}

/* ---- fabrics ---- */

static const struct grid *grid_of_rows(struct eval *eval, struct motif *m, long long width, long long height)
{
    struct context context = {m->used, arena_printf(eval->arena, "in motif '%s', used here", m->name),
                              eval->diag->context};
    const struct grid *grid;

    if (m->used.source)
        eval->diag->context = &context;
    grid = rows_grid(m->rows, (int)width, (int)height,
                     m->stmt->motif.multiple.of ? WIDTH_MULTIPLE : WIDTH_ROWS, eval->ws);
    eval->diag->context = context.up;
    return grid;
}

const struct grid *motif_grid(struct eval *eval, struct motif *m, long long width, long long height,
                              struct span span)
{
    long long rows = height ? height : motif_rows(m);
    const struct grid *grid;

    if (!fabric_size(eval, span, width, rows))
        return NULL;
    if (m->rows)
        return grid_of_rows(eval, m, width, rows);
    grid = m->grid;
    if (width != grid->columns)
        grid =
            grid_stretch(eval->arena, grid, m->box, (int)m->multiple, (int)((width - m->plus) / m->multiple));
    return rows == grid->rows ? grid : grid_window(eval->arena, grid, 0, 0, (int)width, (int)rows);
}

int motif_rows(const struct motif *m)
{
    return m->rows ? rows_count(m->rows) : m->grid->rows;
}

const struct grid *fabric_of(struct eval *eval, struct value value, struct span span)
{
    switch (value.kind) {
    case VALUE_GRID:
        return value.grid;
    case VALUE_STITCH:
        return fabric_size(eval, span, 1, 1) ? grid_constant(eval->arena, 1, 1, value.stitch) : NULL;
    case VALUE_MOTIF:
        if (!value.motif->natural)
            value.motif->natural =
                motif_grid(eval, value.motif, value.motif->multiple + value.motif->plus, 0, span);
        return value.motif->natural;
    case VALUE_MAKER:
        diag_error(eval->diag, CODE_ARGUMENTS, span, "'%s' needs its arguments", value.maker->name);
        diag_note(eval->diag, value.maker->span, "it is defined here");
        return NULL;
    case VALUE_BAD:
        return NULL;
    default:
        diag_error(eval->diag, CODE_TYPE, span, "a fabric or a motif is needed here, this is %s",
                   value_type(value));
        return NULL;
    }
}
