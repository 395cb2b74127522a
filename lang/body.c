/* SPDX-License-Identifier: GPL-3.0-or-later
 * Bodies of motifs and the rows of a file: statements in, row texts with known
 * numbers (or a chart's grid) out. */
#include <limits.h>
#include <string.h>

#include "lang/chart.h"
#include "lang/eval.h"
#include "lang/limits.h"
#include "lang/lower.h"
#include "lang/page/lengths.h"
#include "lang/rows/row_fit.h"
#include "lang/rows/row_labels.h"
#include "lang/rows/row_markers.h"

/* ---- rows ---- */

static bool lower_check(struct eval *eval, struct where where, const struct row *row, struct row_text *text)
{
    text->check = -1;
    text->check_span = row->check_span;
    return !row->check ||
           eval_whole(eval, where, row->check, 0, LIMIT_STITCHES, "the number of stitches", &text->check);
}

/* `as row 7 but end k4`: as many of its last stitches are others. */
static bool lower_end(struct eval *eval, struct where where, const struct row *row, struct row_text *text)
{
    if (text->as_below || text->as_opposite || text->cut || text->on_ws) {
        diag_error(eval->diag, CODE_ROW_REFERENCE, row->body_span, "the row named here has no stitches of its own that could end otherwise");
        return false;
    }
    if (!lower_items(eval, where, row->item, &text->end) || !work_measure(eval->diag, text->end, &text->end_length))
        return false;
    for (const struct work *work = text->end; work; work = work->next)
        if (work->until != WORK_TIMES) {
            diag_error(eval->diag, CODE_ROW_REPEAT, work->span, "how many stitches this end has must be given");
            return false;
        }
    return true;
}

/* The text of a row given before, under another number. */
static bool lower_as_row(struct eval *eval, struct where where, const struct row *row, const struct body *body, int label,
                         struct row_text *text)
{
    const struct row_text *other = rows_find(body->rows, label);

    if (!other) {
        diag_error(eval->diag, CODE_ROW_REFERENCE, row->reference ? row->reference->span : row->body_span,
                   "there is no row %d before this one", label);
        return false;
    }
    text->work = other->work;
    text->marked = other->marked;
    text->on_ws = other->on_ws;
    text->cut = other->cut;
    text->failed = other->failed;
    text->as_below = other->as_below;
    text->rib = other->rib;
    text->as_opposite = other->as_opposite;
    text->end = other->end;
    text->end_length = other->end_length;
    text->check = text->check < 0 ? other->check : text->check;
    return row->body != BODY_AS_ROW || !row->item || lower_end(eval, where, row, text);
}

/* ---- fabrics with a name ---- */

/* n stitches of a kind; 0: as many as there are. */
static struct work *run_of(struct eval *eval, stitch_id stitch, int n, struct span span)
{
    struct work *work = arena_new(eval->arena, struct work);
    struct run *run = arena_new(eval->arena, struct run);

    *run = (struct run){(unsigned)(n ? n : 1), stitch};
    *work = (struct work){.span = span, .run = run, .nruns = 1, .length = run->length, .until = n ? WORK_TIMES : WORK_FIT, .n = 1};
    return work;
}

/* Seed and rib have a first row and go on from what is below; garter in the
 * round takes turns. */
static int fabric_variant(const struct row *row, int i)
{
    switch (row->fabric.kind) {
    case FABRIC_GARTER:
        return row->round ? i % 2 : 0;
    case FABRIC_SEED:
    case FABRIC_RIB:
        return i > 0;
    default:
        return 0;
    }
}

static void lower_fabric(struct eval *eval, const struct row *row, int variant, struct row_text *text)
{
    struct fabric fabric = row->fabric;
    bool below = variant && fabric.kind != FABRIC_GARTER;
    stitch_id first = fabric.kind == FABRIC_REVERSE || (fabric.kind == FABRIC_GARTER && variant) ? STITCH_P : STITCH_K;

    if (below) {
        text->as_opposite = fabric.kind == FABRIC_SEED;
        text->as_below = fabric.kind == FABRIC_RIB;
        return;
    }
    text->cut = fabric.kind == FABRIC_SEED || fabric.kind == FABRIC_RIB;
    text->work = run_of(eval, first, text->cut ? fabric.knit : 0, row->body_span);
    if (text->cut)
        text->work->next = run_of(eval, STITCH_P, fabric.purl, row->body_span);
    else if (fabric.kind != FABRIC_GARTER)
        text->on_ws = run_of(eval, first == STITCH_K ? STITCH_P : STITCH_K, 0, row->body_span);
}

/* ---- rows in pattern ---- */

/* `Row 5: work in pattern` behind rows 1-4: row 1 once more. Behind row 1 alone: as it shows from the other side, 0.
 * -1: which row's turn it is is open. */
static int row_in_pattern(const struct row *row, struct body *body, int label)
{
    if (!body->in_pattern || label != body->in_pattern + 1)
        body->period = label - 1;
    body->in_pattern = label;
    if (body->period == 1 && !row->round)
        return 0;
    return body->period < 1 || (body->period % 2 && !row->round) ? -1 : (label - 1) % body->period + 1;
}

static bool pattern_is_open(struct eval *eval, const struct row *row, const struct body *body)
{
    diag_error(eval->diag, CODE_ELSEWHERE, row->body_span, "the turn of which row it is 'in pattern' is open: %s",
               body->period < 1 ? "no row is above" : "an odd number of rows is above");
    diag_hint(eval->diag, "`as row 1`, or the row's stitches");
    return false;
}

static void warn_in_pattern(struct eval *eval, const struct row *row, int which)
{
    if (which < 0)
        return;
    diag_warning(eval->diag, CODE_IN_PATTERN, row->body_span, "what 'in pattern' is here is not said: %s",
                 which ? arena_printf(eval->arena, "as row %d", which) : "the knits are knitted, the purls purled");
    diag_hint(eval->diag, "`%s` says it", which ? arena_printf(eval->arena, "as row %d", which) : "knit the knits and purl the purls");
}

/* ---- bodies ---- */

/* `from`: the row whose text it is (`as rows 1-4`), or which of a fabric's. */
static bool lower_body(struct eval *eval, struct where where, const struct row *row, struct body *body, int from,
                       struct row_text *text)
{
    long long length;

    switch (row->body) {
    case BODY_AS_BELOW:
        text->as_below = !row->opposite;
        text->as_opposite = row->opposite;
        return true;
    case BODY_IN_RIB:
        text->as_below = text->rib = true;
        return true;
    case BODY_AS_ROW:
        return lower_as_row(eval, where, row, body, from, text);
    case BODY_FABRIC:
        lower_fabric(eval, row, from, text);
        return true;
    case BODY_IN_PATTERN:
        text->as_below = !from;
        return from < 0 ? pattern_is_open(eval, row, body) : !from || lower_as_row(eval, where, row, body, from, text);
    default:
        if (!lower_items(eval, where, row->item, &text->work) || !work_measure(eval->diag, text->work, &length))
            return false;
        text->marked = work_has_marker(text->work);
        return true;
    }
}

static bool too_many_rows(struct eval *eval, struct span span)
{
    if (eval->written_rows++ < LIMIT_WRITTEN_ROWS)
        return false;
    diag_error(eval->diag, CODE_LIMIT_ROWS, span, "a pattern may have %d written rows", LIMIT_WRITTEN_ROWS);
    return true;
}

/* The rows before that are among those of `Cont in st st until 4 rows have been worked`; none are where these begin anew,
 * `Beg with a k row, ..`, or where there are so many already. */
static long long count_from(struct eval *eval, const struct row *row, long long before, long long n)
{
    bool begins = row->starting || n <= before;

    diag_warning(eval->diag, CODE_ASSUMED_TOTAL, row->head, "whether the rows before these are among the %lld is not said: they are%s", n, begins ? " not" : "");
    diag_hint(eval->diag, begins ? "`until piece has %lld rows` counts all" : "`for %lld rows` counts these alone", n);
    return begins ? 0 : before;
}

/* The next so many rows; n = 1 where no number is said. */
static bool count_rows(struct eval *eval, struct where where, const struct row *row, const struct body *body, long long *n)
{
    long long before = 0;

    if (row->total) {
        rows_work(body->rows);
        before = rows_count(body->rows);
    }
    *n = 1;
    if (!row->count)
        return true;
    if (!eval_whole(eval, where, row->count, 1, LIMIT_WRITTEN_ROWS, "the number of rows", n))
        return false;
    if (row->worked && before)
        before = count_from(eval, row, before, *n);
    *n -= before;
    if (row->measured && *n < 0)
        *n = 0;
    if (*n > 0 || row->measured)
        return true;
    diag_error(eval->diag, CODE_ROW_NUMBER, row->head, "there %s already", before == 1 ? "is 1 row" : arena_printf(eval->arena, "are %lld rows", before));
    return false;
}

/* `Rows 5-12: as rows 1-4`: whole turns, as many as are said. */
static bool check_references(struct eval *eval, struct where where, const struct row *row, const struct row_labels *labels,
                             int nrows)
{
    long long times;

    if (row->times && !eval_whole(eval, where, row->times, 1, LIMIT_ROWS, "this number", &times))
        return false;
    if (row->times && labels->n && times * labels->n != nrows) {
        diag_error(eval->diag, CODE_ROW_REFERENCE, row->reference->span, "%d row%s worked %lld times are %lld rows, not %d",
                   labels->n, labels->n == 1 ? "" : "s", times, times * labels->n, nrows);
        diag_hint(eval->diag, "without a head of its own: `Repeat rows 1-2 3 times`, or `Repeat row 1 for a total of 12 rows`");
        return false;
    }
    if (!labels->n || nrows % labels->n == 0)
        return labels->n > 0;
    diag_error(eval->diag, CODE_ROW_REFERENCE, row->reference->span, "%d rows cannot be worked as %d rows", nrows,
               labels->n);
    if (nrows == 1)
        diag_hint(eval->diag, "rows worked again are no row of their own: `Repeat rows 1-2 once more`, without a number before it");
    return false;
}

/* One row's text; it counts even with an error: those after it keep their places. */
static struct row_text *make_text(struct eval *eval, struct where where, const struct row *row, struct body *body,
                                  int from)
{
    struct row_text *text = arena_new(eval->arena, struct row_text);

    *text = (struct row_text){.edges = body->edges, .side = row->side, .round = row->as_others ? body->round : row->round, .span = row->body_span, .head = row->head};
    if (!lower_check(eval, where, row, text))
        return NULL;
    if (!lower_body(eval, where, row, body, from, text))
        text->failed = true;
    text->shaped = text->failed && eval->refused.source == row->head.source && eval->refused.end > row->head.start && eval->refused.start < row->body_span.end;
    return text;
}

/* The i-th row of a statement; rows of one text share it. */
struct row_run {
    const struct row *row;
    struct row_labels labels, from;
    struct row_text *text;
    int which;          /* whose text it is: a row's number, or a variant of a fabric */
};

/* A knit row is of the right side, but in reverse stockinette. */
static enum side starting_side(const struct row *row)
{
    bool reverse = row->body == BODY_FABRIC && row->fabric.kind == FABRIC_REVERSE;

    if (row->starting == SIDE_OF_KNIT || row->starting == SIDE_OF_PURL)
        return (row->starting == SIDE_OF_KNIT) != reverse ? SIDE_RS : SIDE_WS;
    return row->starting;
}

static bool next_text(struct eval *eval, struct where where, struct row_run *run, struct body *body, int i)
{
    const struct row *row = run->row;
    int which = row->body == BODY_AS_ROW       ? run->from.label[i % run->from.n]
                : row->body == BODY_FABRIC     ? fabric_variant(row, i)
                : row->body == BODY_IN_PATTERN ? row_in_pattern(row, body, run->labels.label[i])
                                               : 0;
    bool starting = row->starting && i < 2;

    if (row->body == BODY_OF_PATTERN)
        return (run->text = body_of_pattern(eval, where, row, body)) != NULL;
    if (row->body == BODY_IN_PATTERN && i == 0)
        warn_in_pattern(eval, row, which);

    if (i > 0 && which == run->which && !starting)
        return true;
    run->which = which;
    run->text = make_text(eval, where, row, body, which);
    if (run->text && starting && i == 0)
        run->text->side = starting_side(row);
    return run->text != NULL;
}

/* Whether a row is among those named. */
static bool stands_for(const struct row_numbers *part, int label)
{
    for (; part; part = part->next) {
        int first = part->all || part->first->kind != EXPR_NUMBER ? 0 : (int)part->first->number.value,
            last = first && part->last && part->last->kind == EXPR_NUMBER ? (int)part->last->number.value : first;

        if (part->all || (first <= label && label <= last))
            return true;
    }
    return false;
}

/* Whether the row behind the first of `Rows 2-6 (WS)` is written by itself, above or near below. */
static bool is_between_written(const struct stmt *stmt, const struct body *body)
{
    enum { NEAR = 100 };
    int label = (int)stmt->row.numbers->first->number.value + 1;

    if (rows_find(body->rows, label))
        return true;
    stmt = stmt->next;
    for (int i = 0; stmt && i < NEAR; i++, stmt = stmt->next)
        if (stmt->kind == STMT_ROW && stands_for(stmt->row.numbers, label))
            return true;
    return false;
}

/* `Rows 2-6 (WS): as row 1` where these are all the rows: the mark is that of the first. */
static const struct row *begun_on(struct eval *eval, const struct stmt *stmt, const struct body *body)
{
    const struct row_numbers *numbers = stmt->row.numbers;
    struct row *row;

    if (!numbers || numbers->next || !numbers->last || numbers->all || !stmt->row.side || stmt->row.round || stmt->row.starting || stmt->row.setup ||
        numbers->side == SIDE_OPEN || numbers->first->kind != EXPR_NUMBER || numbers->last->kind != EXPR_NUMBER ||
        numbers->first->number.value >= numbers->last->number.value || is_between_written(stmt, body))
        return &stmt->row;
    row = arena_new(eval->arena, struct row);
    *row = stmt->row;
    row->numbers = arena_new(eval->arena, struct row_numbers);
    *row->numbers = *numbers;
    row->numbers->only = ALL_NONE;
    row->starting = row->side;
    row->side = SIDE_OPEN;
    return row;
}

static bool run_row(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    const struct row *row = begun_on(eval, stmt, body);
    struct row_run run = {.row = row};
    bool all = false;
    long long n;

    if (too_many_rows(eval, row->head) || !row_labels_evaluate(eval, where, row->numbers, &run.labels) ||
        !count_rows(eval, where, row, body, &n) || !row_labels_evaluate(eval, where, row->reference, &run.from))
        return false;
    if (run.labels.n)
        n = run.labels.n;
    if (row->body == BODY_AS_ROW && !check_references(eval, where, row, &run.from, (int)n))
        return false;
    for (const struct row_numbers *part = row->numbers; part; part = part->next)
        all |= part->all != ALL_NONE;
    for (int i = 0; i < n; i++) {
        if (!next_text(eval, where, &run, body, i))
            return false;
        if (run.labels.n && row->setup)
            rows_add_setup(body->rows, run.text, run.labels.label[i]);
        else if (run.labels.n)
            rows_add(body->rows, run.text, run.labels.label[i]);
        else if (!all)
            rows_add_next(body->rows, run.text);
    }
    for (const struct row_numbers *part = row->numbers; part; part = part->next) {
        long long last = 0;

        if (part->all && part->last && !eval_whole(eval, where, part->last, 1, LIMIT_WRITTEN_ROWS, "a row number", &last))
            return false;
        if (part->all)
            rows_fill(body->rows, run.text, part->all, run.labels.n ? run.labels.label[0] : 1, (int)last);
    }
    if (row->body == BODY_OF_PATTERN)
        body_tell_pattern(body);
    return true;
}

/* ---- the cast-on ---- */

/* Whether a statement works rows above the cast-on by their name, or between other stitches. */
static bool is_by_name(const struct stmt *stmt, const struct stmt *cast_on)
{
    return (stmt->kind == STMT_AGAIN && stmt->again.from && stmt->again.from < cast_on->span.start) || (stmt->kind == STMT_ROW && stmt->row.body == BODY_OF_PATTERN);
}

/* What a cast-on behind rows makes of them: they are the piece, where nothing follows it; or a pattern that
 * is worked from there on, `Cast on 24 sts. Knit 2 rows. Work rows 1-4 3 times`; or one that is written out again
 * below, edges and all; or it is misplaced. */
enum rows_before { ROWS_PIECE, ROWS_PATTERN, ROWS_MISPLACED, ROWS_DESCRIBED };

static bool begins_at_1(const struct row_numbers *numbers)
{
    return !numbers->all && numbers->first->kind == EXPR_NUMBER && numbers->first->number.value == 1;
}

static enum rows_before rows_before(const struct stmt *cast_on, const struct row_list *rows)
{
    bool follow = false, used = false, numbered = false, again = false;

    for (const struct stmt *stmt = cast_on->next; rows_any(rows) && stmt; stmt = stmt->next) {
        if (is_by_name(stmt, cast_on))
            return ROWS_PATTERN;
        again |= !numbered && stmt->kind == STMT_ROW && stmt->row.numbers && begins_at_1(stmt->row.numbers);
        numbered |= stmt->kind == STMT_ROW && stmt->row.numbers;
        follow |= stmt->kind == STMT_ROW;
        used |= stmt->kind == STMT_AGAIN && stmt->again.which != AGAIN_LAST;
    }
    return again ? ROWS_DESCRIBED : numbered ? ROWS_MISPLACED : used ? ROWS_PATTERN : follow ? ROWS_MISPLACED : ROWS_PIECE;
}

bool body_describes(const struct stmt *stmt)
{
    const struct stmt *cast_on = NULL;

    for (; stmt; stmt = stmt->next) {
        if (cast_on && is_by_name(stmt, cast_on))
            return true;
        cast_on = cast_on || stmt->kind != STMT_CAST_ON ? cast_on : stmt;
    }
    return false;
}

/* Whether it only says again what is cast on: `Number of sts: 43`, and below it `Cast on 43 sts`. */
static bool says_again(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    long long n;

    return body->top && body->cast_on && !rows_any(body->rows) &&
           eval_whole(eval, where, stmt->cast_on.n, 1, LIMIT_STITCHES, "the number of stitches", &n) && n == body->cast_on;
}

static bool run_cast_on(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    if (says_again(eval, where, stmt, body))
        return true;

    enum rows_before before = body->misplaced ? ROWS_MISPLACED : body->cast_on ? ROWS_PIECE : rows_before(stmt, body->rows);

    body->misplaced = before == ROWS_MISPLACED;
    if (!body->top || body->cast_on || before == ROWS_MISPLACED) {
        diag_error(eval->diag, CODE_CAST_ON, stmt->span,
                   !body->top      ? "a motif is not cast on; its width is its multiple's"
                   : body->cast_on ? "the stitches are cast on already"
                                   : "the cast-on comes before the first row");
        if (body->cast_on) {
            diag_note(eval->diag, body->cast_on_span, "here");
            diag_hint(eval->diag, "another piece begins here: put it into a file of its own");
        } else if (body->top)
            diag_hint(eval->diag, "write the cast-on above all rows, and below it the rows in the order they are worked");
        return false;
    }
    if (before == ROWS_DESCRIBED) {
        diag_warning(eval->diag, CODE_PROSE, stmt->span, "the rows above the cast-on are read as text: they begin again at row 1 below it");
        diag_hint(eval->diag, "to work them write them below the cast-on");
        body->rows = rows_new(eval->arena, eval->diag);
        rows_of_page(body->rows, &eval->main->facts);
    }
    if (before == ROWS_PATTERN)
        rows_define(body->rows);
    rows_describe(body->rows, false);
    body->cast_on_span = stmt->span;
    return eval_whole(eval, where, stmt->cast_on.n, 1, LIMIT_STITCHES, "the number of stitches",
                      &body->cast_on);
}

/* ---- statements ---- */

static bool run_chart(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    if (body->chart || rows_any(body->rows)) {
        diag_error(eval->diag, CODE_MIXED_MOTIF, stmt->span, "a motif is one chart, or rows");
        diag_hint(eval->diag, "give each its name and put them together: above(a, b), beside(a, b)");
        return false;
    }
    body->chart = chart_read(eval, where.module, stmt, &body->box, &body->box_width);
    return body->chart != NULL;
}

static bool run_for(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    double *point;
    int n;

    if (!eval_range(eval, where, &stmt->loop.range, &point, &n))
        return false;
    for (int i = 0; i < n && !body->failed; i++) {
        struct local local = {stmt->loop.name.name, value_number(point[i], 0), where.local};

        if (!eval_step(eval, stmt->span))
            return false;
        body_run(eval, (struct where){where.module, &local}, stmt->loop.body, body);
    }
    return true;
}

static bool run_if(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    double holds;

    if (!eval_number(eval, where, stmt->choice.condition, 0, &holds))
        return false;
    body_run(eval, where, holds != 0 ? stmt->choice.then : stmt->choice.otherwise, body);
    return true;
}

static bool misplaced(struct eval *eval, const struct stmt *stmt, const struct body *body)
{
    diag_error(eval->diag, CODE_PLACE, stmt->span,
               body->top ? "this cannot stand inside a loop or an `if`" : "this cannot stand inside a motif");
    diag_hint(eval->diag, "inside stand rows, charts, `repeat rows`, `let`, `for` and `if`");
    return false;
}

static struct row_edges *edges_new(struct eval *eval, struct kept_edges kept, struct span span)
{
    struct row_edges *edges = arena_new(eval->arena, struct row_edges);

    *edges = (struct row_edges){.n = kept.n, .stitch = kept.fabric == FABRIC_GARTER ? STITCH_GARTER : STITCH_SEED, .span = span};
    return edges;
}

/* From here on. */
static bool keep_edges(struct eval *eval, const struct stmt *stmt, struct body *body)
{
    struct row_edges *above = body->edges;

    if (!body->top)
        return misplaced(eval, stmt, body);
    body->edges = edges_new(eval, stmt->edges, stmt->span);
    body->edges->above = above;
    rows_work(body->rows);
    return true;
}

/* Warns where so many rows are said to end on the other side than they do; until a length they end there. */
static void check_end(struct eval *eval, const struct stmt *stmt, const struct body *body)
{
    const char *text = stmt->span.source->text;
    unsigned end = stmt->span.end;
    enum side last = rows_last_side(body->rows);
    int ending, other;
    bool counted = stmt->kind == STMT_ROW ? stmt->row.count && !stmt->row.measured
                                          : stmt->again.kind != AGAIN_PATTERN && stmt->again.kind != AGAIN_LENGTH && stmt->again.kind != AGAIN_PART_LENGTH;

    if (!body->top || !counted || !last)
        return;
    end += (unsigned)strcspn(text + end, ".;\r\n");
    ending = lengths_ending(arena_copy(eval->arena, text + stmt->span.start, end - stmt->span.start), &other);
    if (ending != (last == SIDE_RS ? ENDING_WS : ENDING_RS))
        return;
    diag_warning(eval->diag, CODE_END_SIDE, stmt->span, "the last of these rows is a %s row, not a %s row as is said", last == SIDE_RS ? "RS" : "WS", last == SIDE_RS ? "WS" : "RS");
    diag_hint(eval->diag, "the number of rows counts: one more, or one less, ends on the other side");
}

/* Rows, or rows again; edges are kept in these alone, where they say so. */
static bool run_rows(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    struct row_edges *edges = body->edges;
    bool row = stmt->kind == STMT_ROW, good;
    struct kept_edges kept = row ? stmt->row.edges : stmt->again.edges;

    if (kept.n && !body->top)
        return misplaced(eval, stmt, body);
    if (kept.n)
        body->edges = edges_new(eval, kept, row ? stmt->row.edges_span : stmt->again.edges_span);
    good = row ? run_row(eval, where, stmt, body) : body_again(eval, where, stmt, &stmt->again, body);
    body->edges = edges;
    if (good)
        check_end(eval, stmt, body);
    return good;
}

static bool run(struct eval *eval, struct where *where, const struct stmt *stmt, struct body *body)
{
    struct local *local;

    switch (stmt->kind) {
    case STMT_ROW:
    case STMT_AGAIN:
        if (body->chart) {
            diag_error(eval->diag, CODE_MIXED_MOTIF, stmt->span, "a motif is one chart, or rows");
            return false;
        }
        return run_rows(eval, *where, stmt, body);
    case STMT_CHART:
        return run_chart(eval, *where, stmt, body);
    case STMT_FOR:
        return run_for(eval, *where, stmt, body);
    case STMT_IF:
        return run_if(eval, *where, stmt, body);
    case STMT_CAST_ON:
        return run_cast_on(eval, *where, stmt, body);
    case STMT_PATTERN:
        if (body_works_between(body, 0))
            body_tell_pattern(body);
        else
            rows_tell(body->rows, stmt->span, stmt->told);
        return true;
    case STMT_EDGES:
        return keep_edges(eval, stmt, body);
    case STMT_STARS:
        rows_mark(body->rows, stmt->stars);
        return true;
    case STMT_PROSE:
        return true;
    case STMT_LET:
        local = arena_new(eval->arena, struct local);
        *local = (struct local){stmt->let.name.name, eval_expr(eval, *where, stmt->let.value), where->local};
        where->local = local;
        return local->value.kind != VALUE_BAD;
    default:
        return misplaced(eval, stmt, body);
    }
}

void body_statement(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    if (stmt->kind == STMT_MULTIPLE)
        body->multiple = stmt->multiple;
    else if (!run(eval, &where, stmt, body))
        body->failed = true;
}

bool body_in_rounds(const struct stmt *stmt)
{
    for (; stmt; stmt = stmt->next)
        if (stmt->kind == STMT_ROW && !stmt->row.as_others)
            return stmt->row.round;
    return false;
}

void body_run(struct eval *eval, struct where where, const struct stmt *stmt, struct body *body)
{
    for (; stmt && !eval->exhausted; stmt = stmt->next)
        if (!run(eval, &where, stmt, body))
            body->failed = true;
    if (eval->exhausted)
        body->failed = true;
}
