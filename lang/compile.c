/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script in, a scene out: the order in which its parts are worked out. */
#include "lang/compile.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/eval.h"
#include "lang/limits.h"
#include "lang/outputs.h"
#include "lang/page/page_chart.h"
#include "lang/params.h"
#include "lang/settings.h"

/* What is being put together. */
struct compilation {
    struct eval eval;
    const struct compile_options *options;
    struct settings settings;
    struct outputs outputs;
    const struct grid *grid;
    bool round; /* its rows are rounds */
    bool ws_first; /* the first of them is worked on the wrong side */
    const char *title;
    const struct sweep_axis *axis;
    int naxes;
};

/* ---- before anything else ---- */

/* The folders of -I, then those of WEFT_PATH. */
static void find_folders(struct eval *eval, const struct compile_options *options)
{
    const char *path = getenv("WEFT_PATH"), *colon = path;
    int n = options->nincludes + 1;
    const char **folder;

    while (colon && (colon = strchr(colon, ':')) != NULL) {
        colon++;
        n++;
    }
    folder = arena_array(eval->arena, const char *, (size_t)n);
    n = 0;
    for (int i = 0; i < options->nincludes; i++)
        folder[n++] = options->include[i];
    for (; path && *path; path += *path == ':') {
        size_t length = strcspn(path, ":");

        if (length)
            folder[n++] = arena_copy(eval->arena, path, length);
        path += length;
    }
    eval->include = folder;
    eval->nincludes = n;
}

void eval_init(struct eval *eval, struct arena *arena, struct diag *diag)
{
    *eval = (struct eval){.arena = arena, .diag = diag, .names = arena_new(arena, struct names)};
    eval->names->arena = arena;
    eval->word_K = names_intern(eval->names, "K", 1);
    eval->word_P = names_intern(eval->names, "P", 1);
    eval->word_pi = names_intern(eval->names, "pi", 2);
    builtin_init(eval);
    eval->nstitches = 2;
    eval->stitch[STITCH_K] = (struct stitch){.name = "K", .symbol = "k", .kx = -1, .ky = 1, .ws = STITCH_P};
    eval->stitch[STITCH_P] = (struct stitch){.name = "P", .symbol = "p", .kx = 1, .ky = -1, .ws = STITCH_K};
    eval->ws[STITCH_K] = STITCH_P;
    eval->ws[STITCH_P] = STITCH_K;
}

static void check_version(struct compilation *c)
{
    struct eval *eval = &c->eval;

    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next) {
        double version;

        if (stmt->kind != STMT_VERSION)
            continue;
        if (stmt != eval->main->file)
            diag_error(eval->diag, CODE_VERSION, stmt->span,
                       "the language's version stands in the first line");
        if (eval_number(eval, (struct where){eval->main, NULL}, stmt->version.number, 0, &version) &&
            version != 1)
            diag_error(eval->diag, CODE_VERSION, stmt->span,
                       "this weft knows version 1 of the language, not %g", version);
    }
}

/* ---- what the command line and the blocks set ---- */

static void override(struct compilation *c, const struct compile_override *given, bool stitches)
{
    struct eval *eval = &c->eval;
    const struct option_value *option;
    const char *dot = strchr(given->name, '.');
    const char *stitch = dot ? arena_copy(eval->arena, given->name, (size_t)(dot - given->name)) : NULL;
    struct nearest nearest;
    bool is_stitch = false;

    for (int i = 0; stitch && i < eval->nstitches; i++)
        is_stitch |= strcmp(eval->stitch[i].name, stitch) == 0;
    if (is_stitch != stitches)
        return;
    option = option_parse(eval, given);
    if (is_stitch ? stitches_override(eval, stitch, dot + 1, option->name, option->value)
                  : settings_override(eval, &c->settings, given->name, option->value))
        return;
    nearest = nearest_to(given->name);
    settings_offer(eval->arena, &nearest);
    diag_error(eval->diag, CODE_DEFINE, option->name, "there is no key '%s'", given->name);
    diag_did_you_mean(eval->diag, nearest.best);
    if (!nearest.best)
        diag_hint(eval->diag, "keys are written with their block: solve.steps, material.thickness, K.kx");
}

static bool set_parameters(struct compilation *c)
{
    const struct compile_options *options = c->options;
    struct eval *eval = &c->eval;

    for (int i = 0; i < options->ndefines; i++)
        params_define(eval, &options->define[i]);
    params_evaluate(eval);

    /* With a param out of its range the rest would only be misread. */
    if (eval->diag->nerrors)
        return false;
    stitches_evaluate(eval);
    for (int i = 0; i < options->nsets; i++)
        override(c, &options->set[i], true);
    stitches_finish(eval);

    settings_default(&c->settings);
    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next)
        if (stmt->kind == STMT_BLOCK)
            settings_block(eval, &c->settings, stmt);
    for (int i = 0; i < options->nsets; i++)
        override(c, &options->set[i], false);
    return true;
}

/* ---- the fabric ---- */

static bool makes_rows(const struct stmt *stmt)
{
    switch (stmt->kind) {
    case STMT_CAST_ON:
    case STMT_MULTIPLE:
    case STMT_ROW:
    case STMT_AGAIN:
    case STMT_FOR:
    case STMT_IF:
    case STMT_CHART:
        return true;
    default:
        return false;
    }
}

/* `Multiple of 4 + 2` at the top of the file. */
static bool multiple_of(struct compilation *c, const struct body *body, long long *of, long long *plus)
{
    struct eval *eval = &c->eval;
    const struct multiple *multiple = &body->multiple;
    struct where where = {eval->main, NULL};

    *plus = 0;
    return eval_whole(eval, where, multiple->of, 1, LIMIT_STITCHES, "the multiple", of) &&
           (!multiple->plus ||
            eval_whole(eval, where, multiple->plus, 0, LIMIT_STITCHES, "the stitches added", plus));
}

/* The cast-on must be one. */
static bool check_multiple(struct compilation *c, const struct body *body)
{
    long long of, plus;

    if (!body->multiple.of)
        return true;
    if (!multiple_of(c, body, &of, &plus))
        return false;
    if (!body->cast_on || (body->cast_on >= of + plus && (body->cast_on - plus) % of == 0))
        return true;
    diag_error(c->eval.diag, CODE_FIT, body->cast_on_span, "%lld is not a multiple of %s", body->cast_on,
               names_multiple(c->eval.arena, of, plus));
    diag_note(c->eval.diag, body->multiple.span, "which the pattern asks for");
    return false;
}

enum { ASSUMED_REPEATS = 4, ASSUMED_STITCHES = 20 };

/* Some repeats, behind the stitches of the edges: `least` is a width without one. */
static long long some_repeats(struct diag *diag, struct span span, long long of, long long plus, long long least)
{
    long long some = (of < 4 ? ASSUMED_STITCHES / of : ASSUMED_REPEATS) * of, width = some + plus;

    if (width < least + of)
        width += (least + some - width + of - 1) / of * of;
    diag_warning(diag, CODE_ASSUMED_WIDTH, span,
                 "how many stitches are cast on is not said: %lld, a multiple of %s", width, names_multiple(diag->arena, of, plus));
    diag_hint(diag, "`Cast on %lld sts`, or another multiple", width + of);
    return width;
}

/* The count behind a row, where the rows fit it: no need of a cast-on. */
static long long said_width(const struct body *body, const struct fit *fit)
{
    long long width = rows_said_width(body->rows);

    return width >= fit->least && width >= fit->plus && (fit->multiple ? (width - fit->plus) % fit->multiple == 0 : width == fit->plus) ? width : 0;
}

/* The width of rows that no cast-on gives. */
static long long open_width(struct compilation *c, const struct body *body)
{
    struct diag *diag = c->eval.diag;
    struct fit fit;

    if (!rows_fit(body->rows, &fit) || !rows_good(body->rows))
        return 0;
    if (said_width(body, &fit) > 0)
        return said_width(body, &fit);
    if (!fit.multiple && fit.plus)
        return fit.plus;
    if (!fit.multiple) {
        diag_error(diag, CODE_EMPTY_MOTIF, body->first, "these rows have no stitch");
        return 0;
    }
    if (c->options->least_width)
        return fit.plus + fit.multiple * (fit.least > fit.plus ? (fit.least - fit.plus + fit.multiple - 1) / fit.multiple : 1);
    if (fit.multiple > 1 && rows_one_repeat(body->rows, &fit))
        return some_repeats(diag, body->first, fit.multiple, fit.plus, fit.least);
    diag_error(diag, CODE_ROW_WIDTH, body->first, "how many stitches these rows are worked over is not said");
    if (fit.multiple > 1)
        diag_hint(diag, "begin with `Cast on %lld sts`, or another multiple of %s",
                  4 * fit.multiple + fit.plus, names_multiple(diag->arena, fit.multiple, fit.plus));
    else
        diag_hint(diag, "begin with `Cast on 20 sts`");
    return 0;
}

/* A pattern from a stitch dictionary says its multiple and no more. */
static long long assumed_width(struct compilation *c, const struct body *body)
{
    long long of, plus, width;
    struct fit fit;

    if (!rows_fit(body->rows, &fit) || !rows_good(body->rows) || !multiple_of(c, body, &of, &plus))
        return 0;
    if (!fit.multiple)
        return fit.plus;
    width = said_width(body, &fit);
    return width > 0 && (width - plus) % of == 0 ? width : some_repeats(c->eval.diag, body->multiple.span, of, plus, fit.least);
}

/* What the page draws beside its rows; or NULL. */
static const struct page_chart *page_chart_of(const struct compilation *c)
{
    const struct stmt *stmt = c->eval.main->file;

    while (stmt && stmt->kind != STMT_PAGE_CHART)
        stmt = stmt->next;
    return stmt ? stmt->page_chart : NULL;
}

static const struct grid *checked_with_chart(struct compilation *c, const struct body *body, const struct grid *grid)
{
    const struct page_chart *chart = page_chart_of(c);

    return !grid || !chart || page_chart_agrees(c->eval.diag, chart, grid, body->rows) ? grid : NULL;
}

static const struct grid *grid_of_body(struct compilation *c, struct body *body)
{
    struct eval *eval = &c->eval;
    long long width = body->cast_on;

    if (body->chart)
        return body->chart;
    if (!rows_finish(body->rows))
        return NULL;
    if (!rows_count(body->rows) && page_chart_of(c))
        return page_chart_fabric(eval->diag, page_chart_of(c), body->cast_on_span, width);
    if (!rows_count(body->rows)) {
        diag_error(eval->diag, CODE_EMPTY_MOTIF, body->first, "there is no row to knit");
        return NULL;
    }
    if (!rows_keep_edges(body->rows, body->edges, (int)width) || !check_multiple(c, body))
        return NULL;
    if (!width && body->multiple.of)
        width = assumed_width(c, body);
    else if (!width)
        width = open_width(c, body);
    if (!width || !fabric_size(eval, body->first, width, rows_count(body->rows)))
        return NULL;
    return checked_with_chart(c, body, rows_grid(body->rows, (int)width, 0, body->cast_on ? WIDTH_CAST_ON : WIDTH_ROWS, eval->ws));
}

/* What only says something of rows: of those below, or of those above. */
static bool is_of_rows(const struct stmt *stmt, bool above)
{
    return stmt->kind == STMT_STARS || stmt->kind == STMT_EDGES || (stmt->kind == STMT_PATTERN && above);
}

/* Rows, loops and a cast-on at the top of the file. */
static const struct grid *own_rows(struct compilation *c, struct span *where)
{
    struct eval *eval = &c->eval;
    struct body body = {.rows = rows_new(eval->arena, eval->diag), .round = body_in_rounds(eval->main->file), .top = true};
    const struct grid *grid;

    rows_describe(body.rows, body_describes(eval->main->file));
    rows_of_page(body.rows, &eval->main->facts);
    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next) {
        if (makes_rows(stmt) && !body.first.source)
            body.first = stmt->span;
        else if (!makes_rows(stmt) && !is_of_rows(stmt, body.first.source != NULL))
            continue;
        body_statement(eval, (struct where){eval->main, NULL}, stmt, &body);
    }
    *where = body.first;
    grid = body.first.source && !body.failed ? grid_of_body(c, &body) : NULL;
    c->round = rows_round(body.rows);
    c->ws_first = grid && rows_ws_first(body.rows);
    return grid;
}

/* The name of the motif a swatch consists of: of flag, rib(3, 1), tile(std.flag, 2, 2). */
static const char *title_of(const struct module *main, const struct expr *e)
{
    while (e->kind == EXPR_CALL) {
        const struct expr *function = e->call.function;
        bool repeats = function->kind == EXPR_NAME &&
                       (strcmp(function->text, "tile") == 0 || strcmp(function->text, "fill") == 0);

        e = repeats && e->call.first ? e->call.first->value : function;
    }
    if (e->kind == EXPR_MEMBER)
        return e->member.name;
    if (e->kind == EXPR_NAME) {
        const struct binding *binding = binding_target(module_find(main, e->text));

        return binding && binding->kind == BINDING_MOTIF ? e->text : NULL;
    }
    return NULL;
}

/* `swach miura`: a line that was passed over as text, being nearly a swatch. */
static void hint_swatch(struct eval *eval)
{
    static const char *const swatch[] = {"swatch"};

    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next) {
        const char *text = stmt->span.source->text + stmt->span.start;
        size_t n = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");

        if (stmt->kind == STMT_PROSE && nearest_in(arena_copy(eval->arena, text, n < 10 ? n : 0), swatch, 1)) {
            diag_note(eval->diag, stmt->span, "this line is read as text; did you mean 'swatch'?");
            return;
        }
    }
}

static void no_fabric(struct eval *eval)
{
    unsigned end = (unsigned)eval->main->source->size;

    diag_error(eval->diag, CODE_NO_SWATCH, (struct span){eval->main->source, end, end}, "the script gives no fabric to fold");
    hint_swatch(eval);
    diag_hint(eval->diag, "`swatch tile(motif, 4, 4)`, or rows: `Cast on 20 sts`, `Row 1: *k2, p2; rep from *`");
}

static void make_fabric(struct compilation *c)
{
    struct eval *eval = &c->eval;
    const struct stmt *swatch = NULL;
    struct span rows;

    c->grid = own_rows(c, &rows);
    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next) {
        if (stmt->kind != STMT_SWATCH)
            continue;
        if (swatch || rows.source) {
            diag_error(eval->diag, CODE_TWO_SWATCHES, stmt->span, "there is a fabric to fold already");
            diag_note(eval->diag, swatch ? swatch->span : rows, "here");
            diag_hint(eval->diag, "put the two together: above(a, b), beside(a, b)");
            return;
        }
        swatch = stmt;
        c->title = title_of(eval->main, stmt->swatch.value);
        c->grid = fabric_of(eval, eval_expr(eval, (struct where){eval->main, NULL}, stmt->swatch.value),
                            stmt->swatch.value->span);
    }
    if (!swatch && !rows.source && !eval->diag->nerrors)
        no_fabric(eval);
}

/* Definitions that nothing used are checked, too. */
static void check_unused(struct eval *eval)
{
    for (struct binding *b = eval->main->first; b && !eval->exhausted; b = b->after) {
        struct value value;

        if (b->state != TO_DO || (b->kind != BINDING_LET && b->kind != BINDING_MOTIF))
            continue;
        value = eval_binding(eval, b, (struct span){0});
        if (value.kind == VALUE_MOTIF)
            fabric_of(eval, value, b->span);
    }
}

/* ---- outputs and sweeps ---- */

static void list_outputs(struct compilation *c)
{
    struct eval *eval = &c->eval;

    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next)
        c->outputs.sweep = c->outputs.sweep || stmt->kind == STMT_SWEEP;
    for (const struct stmt *stmt = eval->main->file; stmt; stmt = stmt->next)
        if (stmt->kind == STMT_OUTPUT)
            outputs_statement(eval, &c->outputs, stmt);
    for (int i = 0; i < c->options->noutputs; i++) {
        struct source *source = arena_new(eval->arena, struct source);
        const char *text = c->options->output[i];

        *source = (struct source){"command line", text, strlen(text), true};
        outputs_option(eval, &c->outputs, source);
    }
}

static void list_sweep(struct compilation *c)
{
    const struct stmt *sweep = NULL;

    for (const struct stmt *stmt = c->eval.main->file; stmt; stmt = stmt->next) {
        if (stmt->kind != STMT_SWEEP)
            continue;
        if (sweep) {
            diag_error(c->eval.diag, CODE_SWEEP, stmt->span, "there is a sweep already");
            diag_note(c->eval.diag, sweep->span, "here");
            diag_hint(c->eval.diag, "one sweep has several axes: `sweep a in 1..3, b in [2, 4]`");
            return;
        }
        sweep = stmt;
        c->axis = params_sweep(&c->eval, stmt, &c->naxes);
    }
}

/* ---- the whole ---- */

/* The files of the disk that took part, in the order they were read. */
static void list_sources(struct eval *eval, struct scene *scene)
{
    struct scene_source *source;
    int n = 1;

    for (const struct used_file *f = eval->used; f; f = f->next)
        n++;
    source = arena_array(eval->arena, struct scene_source, (size_t)n);
    scene->nsources = n;
    scene->source = source;
    for (const struct used_file *f = eval->used; f; f = f->next)
        source[--n] = (struct scene_source){f->source->name, f->source->text, f->source->size};
    source[0] = (struct scene_source){eval->main->source->name, eval->main->source->text, eval->main->source->size};
}

static const struct scene *scene_of(struct compilation *c)
{
    struct eval *eval = &c->eval;
    struct scene *scene = arena_new(eval->arena, struct scene);
    int nsettings = SETTINGS + eval->nstitches * STITCH_KEYS + params_count(eval);
    struct setting *setting = arena_array(eval->arena, struct setting, (size_t)nsettings);
    struct stitch *stitch = arena_array(eval->arena, struct stitch, (size_t)eval->nstitches);

    settings_apply(&c->settings, scene);
    nsettings = settings_list(&c->settings, setting);
    nsettings += stitches_settings(eval, setting + nsettings);
    nsettings += params_settings(eval, setting + nsettings);
    memcpy(stitch, eval->stitch, (size_t)eval->nstitches * sizeof *stitch);
    scene->file = eval->main->source->name;
    scene->grid = c->grid;
    scene->round = c->round;
    scene->ws_first = c->ws_first;
    scene->title = c->title;
    scene->nstitches = eval->nstitches;
    scene->stitch = stitch;
    scene->noutputs = c->outputs.n;
    scene->output = c->outputs.output;
    scene->nsettings = nsettings;
    scene->setting = setting;
    scene->naxes = c->naxes;
    scene->axis = c->axis;
    list_sources(eval, scene);
    return scene;
}

static const struct scene *compile(struct compilation *c, const struct source *source)
{
    struct eval *eval = &c->eval;
    const char *slash = strrchr(source->name, '/');
    const char *folder =
        slash ? arena_copy(eval->arena, source->name, (size_t)(slash - source->name) + 1) : "";

    find_folders(eval, c->options);
    eval->main = module_main(eval, source, folder);

    /* What could not be read would only be missed again and again. */
    if (eval->diag->nerrors)
        return NULL;
    check_version(c);
    if (!set_parameters(c))
        return NULL;
    make_fabric(c);
    check_unused(eval);
    list_outputs(c);
    list_sweep(c);
    return eval->diag->nerrors || !c->grid ? NULL : scene_of(c);
}

const struct scene *scene_compile(struct arena *arena, struct diag *diag, const struct source *source,
                                  const struct compile_options *options)
{
    static const struct compile_options none = {0};
    struct compilation *c = arena_new(arena, struct compilation);

    c->options = options ? options : &none;
    diag->warnings_are_errors = c->options->warnings_are_errors;
    eval_init(&c->eval, arena, diag);
    c->eval.chart = c->options->chart;
    if (c->options->work) {
        c->eval.steps = LIMIT_STEPS - c->options->work;
        c->eval.cells = LIMIT_ALL_STITCHES - c->options->work;
    }
    return compile(c, source);
}
