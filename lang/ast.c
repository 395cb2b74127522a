/* SPDX-License-Identifier: GPL-3.0-or-later
 * Constructors of the syntax tree: the parser's pieces in, nodes out.  Depth is
 * counted here, so that whoever walks the tree may recurse. */
#include "lang/ast.h"

#include <assert.h>
#include <string.h>

#include "lang/limits.h"
#include "lang/parse.h"
#include "lang/scanner.h"
#include "lang/page/edges.h"
#include "lang/page/words.h"

#define BLANKS " \t\f\v"
#define DIGITS "0123456789"

static int deeper(int a, int b)
{
    return a > b ? a : b;
}

static int depth_of(const struct expr *e)
{
    return e ? e->depth : 0;
}

static struct expr *expr_new(struct parse *parse, enum expr_kind kind, struct span span, int depth)
{
    struct expr *e = arena_new(parse->arena, struct expr);

    e->kind = kind;
    e->span = span;
    e->depth = depth + 1;
    if (e->depth > LIMIT_DEPTH) {
        if (!parse->too_deep) {
            diag_error(parse->diag, CODE_LIMIT_DEPTH, span, "this expression is nested more than %d deep",
                       LIMIT_DEPTH);
            diag_hint(parse->diag, "give parts of it names with 'let'");
        }
        parse->too_deep = true;
        e->kind = EXPR_BAD;
        e->depth = 1;
    }
    return e;
}

struct expr *expr_bad(struct parse *parse, struct span span)
{
    return expr_new(parse, EXPR_BAD, span, 0);
}

struct expr *expr_number(struct parse *parse, struct span span, double value, int dimension)
{
    struct expr *e = expr_new(parse, EXPR_NUMBER, span, 0);

    e->number.value = value;
    e->number.dimension = dimension;
    return e;
}

struct expr *expr_text(struct parse *parse, enum expr_kind kind, struct span span, const char *text)
{
    struct expr *e = expr_new(parse, kind, span, 0);

    e->text = text;
    return e;
}

struct expr *expr_member(struct parse *parse, struct span span, const char *space, const char *name)
{
    struct expr *e = expr_new(parse, EXPR_MEMBER, span, 0);

    e->member.space = space;
    e->member.name = name;
    return e;
}

struct expr *expr_list(struct parse *parse, struct span span, struct expr *first)
{
    struct expr *e;
    int depth = 0, n = 0;

    for (struct expr *item = first; item; item = item->next, n++)
        depth = deeper(depth, item->depth);
    e = expr_new(parse, EXPR_LIST, span, depth);
    e->list.first = first;
    e->list.n = n;
    return e;
}

struct expr *expr_operation(struct parse *parse, enum expr_kind kind, struct span span, enum operator op,
                            struct expr *a, struct expr *b, struct expr *c)
{
    int depth = deeper(depth_of(a), deeper(depth_of(b), depth_of(c)));
    struct expr *e = expr_new(parse, kind, span, depth);

    e->operation.op = op;
    e->operation.a = a;
    e->operation.b = b;
    e->operation.c = c;
    return e;
}

struct expr *expr_call(struct parse *parse, struct span span, struct expr *function, struct argument *first)
{
    struct expr *e;
    int depth = function->depth, n = 0;

    for (struct argument *a = first; a; a = a->next, n++)
        depth = deeper(depth, a->value->depth);
    e = expr_new(parse, EXPR_CALL, span, depth);
    e->call.function = function;
    e->call.first = first;
    e->call.n = n;
    return e;
}

struct expr *expr_each(struct parse *parse, struct span span, struct name_at x, struct name_at y,
                       struct expr *columns, struct expr *rows, struct expr *cell)
{
    int depth = deeper(columns->depth, deeper(rows->depth, cell->depth));
    struct expr *e = expr_new(parse, EXPR_EACH, span, depth);

    e->each.x = x.name;
    e->each.y = y.name;
    e->each.columns = columns;
    e->each.rows = rows;
    e->each.cell = cell;
    return e;
}

struct argument *ast_argument(struct parse *parse, struct span span, const char *name, struct expr *value)
{
    struct argument *a = arena_new(parse->arena, struct argument);

    *a = (struct argument){.name = name, .span = span, .value = value};
    return a;
}

static struct item *item_new(struct parse *parse, enum item_kind kind, struct span span)
{
    struct item *item = arena_alloc(parse->arena, sizeof *item + (kind <= ITEM_COUNTED ? 0 : sizeof *item->more));

    item->start = span.start;
    item->length = span.end - span.start;
    item->kind = kind;
    return item;
}

static bool is_written(struct span span, const char *text)
{
    size_t length = strlen(text);

    return length == span.end - span.start && memcmp(span.source->text + span.start, text, length) == 0;
}

struct item *item_stitch(struct parse *parse, struct span span, const char *name, struct expr *count,
                         struct until until)
{
    bool plain = !count && until.kind == UNTIL_ONCE && (!name || is_written(span, name));
    struct item *item = item_new(parse, !name ? ITEM_SEVERAL : plain ? ITEM_PLAIN : ITEM_STITCH, span);

    if (!plain)
        item->more[0] = (struct item_more){.name = name, .count = count, .until = until};
    return item;
}

struct item *item_stitches(struct parse *parse, struct span span, const char *name, struct span number, double n)
{
    struct span before = {span.source, span.start, span.start + (unsigned)strlen(name)};
    bool plain = n <= LIMIT_STITCHES && number.start > before.end && is_written(before, name);

    for (unsigned at = before.end; at < number.start; at++)
        plain &= strchr(BLANKS, span.source->text[at]) != NULL;
    plain &= strspn(span.source->text + number.start, DIGITS) == number.end - number.start;
    if (plain)
        return item_new(parse, ITEM_COUNTED, span_join(before, number));
    return item_stitch(parse, span, name, expr_number(parse, number, n, 0), (struct until){.span = before});
}

/* What they are called, which is how they are written. */
const char item_placed[] = "pm", item_slipped[] = "sm", item_removed[] = "rm";
const char item_same[] = "knit the knits and purl the purls", item_opposite[] = "purl the knits and knit the purls";

struct item *item_below(struct parse *parse, struct span span, bool opposite, struct until until)
{
    struct item *item = item_new(parse, ITEM_STITCH, span);

    item->more[0] = (struct item_more){.name = opposite ? item_opposite : item_same, .until = until};
    return item;
}

bool item_is_below(const struct item *item)
{
    return item->kind == ITEM_STITCH && (item->more->name == item_same || item->more->name == item_opposite);
}

struct item *item_within(struct parse *parse, struct span span, struct within within)
{
    struct item *item = item_new(parse, ITEM_STITCH, span);
    struct within *kept = arena_new(parse->arena, struct within);

    *kept = within;
    item->more[0] = (struct item_more){.name = "work in pattern", .within = kept, .until = {.span = span}};
    return item;
}

struct item *item_marker(struct parse *parse, struct span span, const char *done)
{
    struct item *item = item_new(parse, ITEM_STITCH, span);

    item->more[0] = (struct item_more){.name = done, .until = {.span = span}};
    return item;
}

bool item_is_marker(const struct item *item)
{
    const char *name = item->kind == ITEM_STITCH ? item->more->name : NULL;

    return name && (name == item_placed || name == item_slipped || name == item_removed);
}

struct item *item_group(struct parse *parse, enum item_kind kind, struct span span, struct item *child,
                        struct until until)
{
    struct item *item = item_new(parse, kind, span);

    item->more[0] = (struct item_more){.child = child, .until = until};
    return item;
}

struct span item_span(const struct source *source, const struct item *item)
{
    return (struct span){source, item->start, item->start + item->length};
}

struct until item_until(const struct source *source, const struct item *item)
{
    return item_is_plain(item) ? (struct until){.span = item_span(source, item)} : item->more->until;
}

bool item_step(const struct source *source, const struct item *item, struct item *one)
{
    unsigned start = one->length ? one->start + one->length : item->start;
    bool several = item->kind == ITEM_SEVERAL;

    if (start == item->start + item->length)
        return false;
    start += several ? (unsigned)words_gap_length(source->text + start) : 0;
    *one = (struct item){
        .start = start,
        .kind = several ? ITEM_PLAIN : item->kind,
        .length = several ? (unsigned)words_stitch_length(source->text + start) : item->length,
    };
    assert(one->length > 0);
    return true;
}

struct stitch_words item_words(const struct source *source, const struct item *item)
{
    const char *text = source->text + item->start;
    struct span figures = item_span(source, item);
    size_t length;

    if (!item_is_plain(item))
        return (struct stitch_words){item->more->name, strlen(item->more->name), item->more->count, {0}};
    if (item->kind == ITEM_PLAIN)
        return (struct stitch_words){.name = text, .length = item->length};
    for (figures.start = figures.end; strchr(DIGITS, source->text[figures.start - 1]);)
        figures.start--;
    for (length = figures.start - item->start; strchr(BLANKS, text[length - 1]);)
        length--;
    return (struct stitch_words){text, length, NULL, figures};
}

struct row_numbers *ast_row_numbers(struct parse *parse, struct span span, struct expr *first,
                                    struct expr *last, enum all_kind all)
{
    struct row_numbers *numbers = arena_new(parse->arena, struct row_numbers);

    *numbers = (struct row_numbers){.first = first, .last = last, .all = all, .span = span};
    return numbers;
}

struct pair *ast_pair(struct parse *parse, struct span key_span, const char *key, struct expr *value)
{
    struct pair *pair = arena_new(parse->arena, struct pair);

    *pair = (struct pair){.key = key, .key_span = key_span, .value = value};
    return pair;
}

struct name_at *ast_name(struct parse *parse, struct span span, const char *name)
{
    struct name_at *at = arena_new(parse->arena, struct name_at);

    *at = (struct name_at){.name = name, .span = span};
    return at;
}

struct formal *ast_formal(struct parse *parse, struct span span, const char *name, struct expr *value)
{
    struct formal *formal = arena_new(parse->arena, struct formal);

    *formal = (struct formal){.name = name, .span = span, .value = value};
    return formal;
}

struct symbol *ast_symbol(struct parse *parse, struct span span, const char *symbol, struct name_at stitch)
{
    struct symbol *s = arena_new(parse->arena, struct symbol);

    *s = (struct symbol){.symbol = symbol, .stitch = stitch, .span = span};
    return s;
}

struct axis *ast_axis(struct parse *parse, struct name_at param, struct range range)
{
    struct axis *axis = arena_new(parse->arena, struct axis);

    *axis = (struct axis){.param = param, .range = range};
    return axis;
}

/* ---- statements ---- */

struct stmt *ast_stmt(struct parse *parse, enum stmt_kind kind, struct span span)
{
    struct stmt *stmt = arena_new(parse->arena, struct stmt);

    stmt->kind = kind;
    stmt->span = span;
    return stmt;
}

struct stmt *stmt_use(struct parse *parse, struct span span, struct name_at *names, struct name_at as,
                      struct name_at file, bool std)
{
    struct stmt *stmt = ast_stmt(parse, STMT_USE, span);

    stmt->use.names = names;
    stmt->use.as = as;
    stmt->use.file = file.name;
    stmt->use.file_span = file.span;
    stmt->use.std = std;
    return stmt;
}

struct stmt *stmt_let(struct parse *parse, struct span span, struct name_at name, struct expr *value)
{
    struct stmt *stmt = ast_stmt(parse, STMT_LET, span);

    stmt->let.name = name;
    stmt->let.value = value;
    return stmt;
}

struct stmt *stmt_param(struct parse *parse, struct span span, struct name_at name, struct expr *value,
                        struct range range, const char *about)
{
    struct stmt *stmt = ast_stmt(parse, STMT_PARAM, span);

    stmt->param.name = name;
    stmt->param.value = value;
    stmt->param.range = range;
    stmt->param.about = about;
    return stmt;
}

struct stmt *stmt_block(struct parse *parse, enum stmt_kind kind, struct span span, struct name_at name,
                        struct pair *pair)
{
    struct stmt *stmt = ast_stmt(parse, kind, span);

    if (kind == STMT_STITCH) {
        stmt->stitch.name = name;
        stmt->stitch.pair = pair;
    } else {
        stmt->block.name = name;
        stmt->block.pair = pair;
    }
    return stmt;
}

struct stmt *stmt_motif(struct parse *parse, struct span span, struct name_at name, struct formal *formal,
                        struct multiple multiple, struct stmt *body, struct expr *value)
{
    struct stmt *stmt = ast_stmt(parse, STMT_MOTIF, span);

    stmt->motif.name = name;
    stmt->motif.formal = formal;
    stmt->motif.multiple = multiple;
    stmt->motif.body = body;
    stmt->motif.value = value;
    return stmt;
}

struct stmt *stmt_expr(struct parse *parse, enum stmt_kind kind, struct span span, struct expr *value)
{
    struct stmt *stmt = ast_stmt(parse, kind, span);

    if (kind == STMT_VERSION)
        stmt->version.number = value;
    else if (kind == STMT_CAST_ON)
        stmt->cast_on.n = value;
    else
        stmt->swatch.value = value;
    return stmt;
}

struct stmt *stmt_output(struct parse *parse, struct span span, struct name_at kind, struct name_at path,
                         struct pair *pair)
{
    struct stmt *stmt = ast_stmt(parse, STMT_OUTPUT, span);

    stmt->output.kind = kind;
    stmt->output.path = path.name;
    stmt->output.path_span = path.span;
    stmt->output.pair = pair;
    return stmt;
}

struct stmt *stmt_sweep(struct parse *parse, struct span span, struct axis *axis)
{
    struct stmt *stmt = ast_stmt(parse, STMT_SWEEP, span);

    stmt->sweep.axis = axis;
    return stmt;
}

struct stmt *stmt_multiple(struct parse *parse, struct multiple multiple)
{
    struct stmt *stmt = ast_stmt(parse, STMT_MULTIPLE, multiple.span);

    stmt->multiple = multiple;
    return stmt;
}

/* How far the sentence of a statement was read: words behind it may be blank by now. */
static unsigned sentence_end(const struct parse *parse, struct span span)
{
    unsigned end = span.end;

    while (end < parse->scanner->at && !strchr("\r\n#", parse->text[end]))
        end++;
    return end;
}

/* `until 20 rows have been worked`: since when is not said. */
static const char *const worked = "worked|done|completed|knitted";

struct stmt *stmt_row(struct parse *parse, struct span span, struct row row)
{
    struct stmt *stmt = ast_stmt(parse, STMT_ROW, span);
    unsigned end = row.total || row.body == BODY_OF_PATTERN ? sentence_end(parse, span) : span.end;
    bool several;

    stmt->row = row;
    stmt->row.worked = row.total && words_any_of(worked, span.source->text, span.start, end) && !words_any_of("from|total|in all", span.source->text, span.start, end);
    if (row.body == BODY_OF_PATTERN)
        stmt->row.from = named_rows(&parse->named, span.start, end, &several);
    return stmt;
}

/* The edges that a sentence keeps in its rows, `.. until it measures 40 in, keeping 2 sts at each edge in garter st`. */
static void find_edges(const struct parse *parse, struct span span, unsigned end, struct again *again)
{
    const char *fabric;

    for (unsigned at = span.start; parse->facts.knitters && at < end; at++) {
        if (strchr(".;", parse->text[at]) && parse->text[at + 1] == ' ')
            return;
        if (at == span.start || parse->text[at - 1] != ' ')
            continue;
        again->edges_span = (struct span){span.source, at, at + (unsigned)edges_length(parse->text + at, &again->edges, &fabric)};
        if (again->edges_span.end > at)
            return;
        again->edges.n = 0;
    }
}

/* `until 60 rows of pattern are complete`: of the pattern, not of the piece. */
static const char *const of_pattern = "rows of pattern|rows of patt|rows of pat|rows of the pattern|rows in pattern|rows in patt";

struct stmt *stmt_again(struct parse *parse, struct span span, struct again again)
{
    struct stmt *stmt = ast_stmt(parse, STMT_AGAIN, span);
    unsigned end = sentence_end(parse, span);

    stmt->again = again;
    stmt->again.worked = words_any_of(worked, span.source->text, span.start, end);
    stmt->again.from = named_rows(&parse->named, span.start, end, &stmt->again.several);
    find_edges(parse, span, end, &stmt->again);
    if (stmt->again.kind == AGAIN_UNTIL_ROWS && stmt->again.which == AGAIN_GO_ON && words_any_of(of_pattern, parse->text, span.start, end))
        stmt->again.kind = AGAIN_TOTAL_ROWS;
    return stmt;
}

struct stmt *stmt_pattern(struct parse *parse, struct span span, struct told told)
{
    struct stmt *stmt = ast_stmt(parse, STMT_PATTERN, span);

    stmt->told = told;
    return stmt;
}

struct stmt *stmt_for(struct parse *parse, struct span span, struct name_at name, struct range range,
                      struct stmt *body)
{
    struct stmt *stmt = ast_stmt(parse, STMT_FOR, span);

    stmt->loop.name = name;
    stmt->loop.range = range;
    stmt->loop.body = body;
    return stmt;
}

struct stmt *stmt_if(struct parse *parse, struct span span, struct expr *condition, struct stmt *then,
                     struct stmt *otherwise)
{
    struct stmt *stmt = ast_stmt(parse, STMT_IF, span);

    stmt->choice.condition = condition;
    stmt->choice.then = then;
    stmt->choice.otherwise = otherwise;
    return stmt;
}

struct stmt *stmt_chart(struct parse *parse, struct span span, struct symbol *symbol, struct name_at *line)
{
    struct stmt *stmt = ast_stmt(parse, STMT_CHART, span);

    stmt->chart.symbol = symbol;
    stmt->chart.line = line;
    return stmt;
}
