/* SPDX-License-Identifier: GPL-3.0-or-later
 * Parts of rows as the grammar reads them in, whole rows out: heads, repeats, what is not said and what is taken. */
#include "lang/syntax.h"

#include <string.h>
#include <strings.h>

#include "lang/scanner.h"
#include "lang/page/lengths.h"
#include "lang/page/starred.h"
#include "lang/page/words.h"

/* A row's number as it is written; 0: it is not, or too large for one. */
static int row_number(const struct expr *number)
{
    return number && number->kind == EXPR_NUMBER && number->number.value <= LIMIT_ROWS ? (int)number->number.value : 0;
}

/* The last number of a part of a list of rows. */
static int last_number(const struct row_numbers *part)
{
    return row_number(part->last ? part->last : part->first);
}

/* `Rows 1, 3 (RS) and 6`: the side that the first of them is on, as the mark is of the rows before it alone; or open. */
static enum side side_of_first(const struct row_numbers *numbers)
{
    int first = numbers ? row_number(numbers->first) : 0;

    for (const struct row_numbers *part = numbers; part && part->next && first; part = part->next)
        if (part->side && !part->next->side && last_number(part) && last_number(part->next) && (last_number(part) - last_number(part->next)) % 2)
            return (last_number(part) - first) % 2 == 0 ? part->side : part->side == SIDE_RS ? SIDE_WS : SIDE_RS;
    return SIDE_OPEN;
}

/* `Rows 2-6 (WS)`: one text on one side is that of every second row. */
static void mark_only(struct row_numbers *numbers, enum side side)
{
    for (struct row_numbers *part = numbers; part && side; part = part->next) {
        int n = last_number(part) - row_number(part->first);

        if (part->last && n > 0 && n % 2 == 0 && !part->only)
            part->only = side == SIDE_RS ? ALL_RS : ALL_WS;
    }
}

struct row syntax_head(struct parse *parse, enum side round, enum side side, struct row_numbers *numbers)
{
    struct row row = {.round = round == SIDE_RS, .side = side, .numbers = numbers};

    /* A side behind one of the numbers is the side of all, unless two disagree. */
    for (struct row_numbers *part = numbers; part; part = part->next) {
        row.round |= part->round;
        if (row.side && part->side && part->side != row.side) {
            diag_error(parse->diag, CODE_ROW_SIDE, part->span,
                       "one text cannot stand for both RS and WS rows");
            diag_hint(parse->diag, "write the two as separate rows");
        }
        row.side = part->side ? part->side : row.side;
    }
    row.starting = side || row.round ? SIDE_OPEN : side_of_first(numbers);
    if (row.starting)
        row.side = SIDE_OPEN;
    if (!row.round)
        mark_only(numbers, row.side);
    return row;
}

/* `WS rows 2-6`, `even rows 2, 4 and 6`. */
struct row syntax_head_only(struct parse *parse, struct span span, struct all all, struct row_numbers *numbers)
{
    enum side side = all.kind == ALL_RS ? SIDE_RS : all.kind == ALL_WS ? SIDE_WS : SIDE_OPEN;

    for (struct row_numbers *part = numbers; part; part = part->next) {
        part->only = all.kind == ALL_EVERY || all.kind == ALL_FOLLOWING ? ALL_NONE : all.kind;
        part->span = span_join(span, part->span);
    }
    return syntax_head(parse, all.round ? SIDE_RS : SIDE_OPEN, side, numbers);
}

struct row syntax_bare_head(struct parse *parse, struct span span, enum side round)
{
    struct expr *number = expr_number(parse, span, parse->scanner->bare - 1, 0);

    return syntax_head(parse, round, SIDE_OPEN, ast_row_numbers(parse, span, number, NULL, ALL_NONE));
}

/* Whether an item is stitches with a number: `p1`, `purl 2`. */
static bool is_counted(const struct source *source, const struct item *item)
{
    struct stitch_words words;

    if (item->kind > ITEM_STITCH)
        return false;
    words = item_words(source, item);
    return words.count || words.figures.source || isdigit((unsigned char)words.name[words.length - 1]);
}

static void warn_repeat(struct parse *parse, struct span first, struct span last, enum until_kind until, const char *begins)
{
    const char *end = until == UNTIL_LAST ? "to last .. sts" : until == UNTIL_END ? "to end" : "to marker";
    struct span span = span_join(first, last);
    const char *text = first.source->text + first.start;
    int length = (int)(last.end - first.start);

    while (length > 0 && strchr(" ,;\t", text[length - 1]))
        length--;
    diag_warning(parse->diag, CODE_ASSUMED_REPEAT, span, "where this repeat begins is not marked: %s", begins);
    diag_hint(parse->diag, "`*%.*s; rep from * %s`", length, text, end);
}

/* `k1, p1 to end`: nobody would write p1 for a purl to the end; the row is repeated, from the marker behind which that stands. */
static struct item *repeat_to_end(struct parse *parse, struct item *first)
{
    struct item *begin = first, *before = NULL, *group;

    for (struct item *item = first; item; item = item->next) {
        struct until until = item_until(parse->source, item);
        enum until_kind kind = until.kind;

        if (item_is_marker(item)) {
            before = item;
            begin = item->next;
            continue;
        }
        if (item->kind > ITEM_STITCH || (kind != UNTIL_ONCE && (item == begin || !is_counted(parse->source, item))))
            return first;
        if (kind == UNTIL_ONCE)
            continue;
        if (kind == UNTIL_TIMES || kind == UNTIL_LAST_OR_ALL)
            return first;
        warn_repeat(parse, item_span(parse->source, begin), (struct span){parse->source, item->start, until.span.start}, kind,
                    before ? "behind the marker" : "at the row's first stitch");
        group = item_group(parse, ITEM_REP_FROM, span_join(item_span(parse->source, begin), item_span(parse->source, item)), begin, until);
        group->next = item->next;
        item->next = NULL;
        item->more->until = (struct until){.span = item_span(parse->source, item)};
        if (before)
            before->next = group;
        return before ? first : group;
    }
    return first;
}

struct item *syntax_whole(struct parse *parse, struct span rep, struct item *first, struct until until, struct item *tail)
{
    struct span begin = item_span(parse->source, first);
    struct item *last = first, *group;

    while (last->next)
        last = last->next;
    warn_repeat(parse, begin, item_span(parse->source, last), UNTIL_END, "at the row's first stitch");
    group = item_group(parse, ITEM_REP_FROM, span_join(begin, rep), first, until);
    group->next = tail;
    return group;
}

struct item *syntax_open_star(struct parse *parse, struct span star, struct item *before, struct item *first)
{
    struct item *last = first, *group = first, *end = before;
    struct span span;

    while (last->next && item_until(parse->source, last).kind == UNTIL_ONCE)
        last = last->next;
    span = item_span(parse->source, last);
    if (first->kind == ITEM_STARS) {
        /* `*(k2, p2) repeat to end`: the bracket says what is repeated. */
    } else if (last->kind != ITEM_STITCH || (last->more->until.kind != UNTIL_END && last->more->until.kind != UNTIL_LAST)) {
        syntax_star_is_left(parse, star);
    } else {
        group = item_group(parse, ITEM_REP_FROM, span_join(star, span), first, last->more->until);
        group->next = last->next;
        last->next = NULL;
        last->more->until = (struct until){.span = span};
    }
    while (end && end->next)
        end = end->next;
    if (end)
        end->next = group;
    return before ? before : group;
}

struct row syntax_plain_rows(struct parse *parse, struct span all, struct span word, const char *stitch,
                             struct expr *count, enum side round)
{
    struct row row = {.round = round == SIDE_RS, .count = count, .head = all, .body_span = all};

    row.item = item_stitch(parse, word, stitch, NULL, (struct until){.span = word});
    if (!count)
        row.numbers = ast_row_numbers(parse, all, NULL, NULL, ALL_EVERY);
    return row;
}

/* `Knit 1 row, purl 1 row, three times`: a sentence that is taken apart at its commas. */
void syntax_rows_times(struct parse *parse, struct span span)
{
    diag_error(parse->diag, CODE_ROW_REPEAT, span, "which rows are worked so many times can be read in two ways: the last, or more of them");
    diag_hint(parse->diag, "`Knit 1 row. Purl 1 row. Repeat the last 2 rows twice more.`");
}

void syntax_rows_so_far(struct parse *parse, struct span span)
{
    diag_warning(parse->diag, CODE_PROSE, span, "this count of rows is read as text: how many are worked was said before");
    diag_hint(parse->diag, "it may be that of all rows so far; `Work 6 rows in St st` says those worked here");
}

struct row syntax_fabric(struct span all, struct fabric fabric, struct expr *count, enum side round, enum side starting)
{
    return (struct row){.round = round == SIDE_RS, .count = count, .head = all, .body = BODY_FABRIC, .body_span = all,
                        .fabric = fabric, .starting = starting};
}

/* `garter st 3`, `seed st to last 4 sts` within a row; what the second stitch of a rib is would be a guess. */
struct item *syntax_fabric_stitches(struct parse *parse, struct span span, struct fabric fabric, struct expr *count, struct until until)
{
    static const char *const name[] = {[FABRIC_GARTER] = "garter", [FABRIC_STOCKINETTE] = "stockinette", [FABRIC_REVERSE] = "reverse",
                                       [FABRIC_SEED] = "seed", [FABRIC_RIB] = "knit"};

    if (fabric.kind == FABRIC_RIB) {
        diag_error(parse->diag, CODE_ELSEWHERE, span, "a rib over a part of a row: version 1 needs the row's stitches themselves");
        diag_hint(parse->diag, "`[k1, p1] twice`, or `*k1, p1; rep from * to last 3 sts`");
    }
    return item_stitch(parse, span, names_intern(parse->names, name[fabric.kind], strlen(name[fabric.kind])), count, until);
}

struct row syntax_ridges(struct parse *parse, struct span all, struct expr *count, enum side starting)
{
    struct expr *two = expr_number(parse, count->span, 2, 0);
    struct expr *rows = expr_operation(parse, EXPR_BINARY, count->span, OP_MULTIPLY, count, two, NULL);

    return syntax_fabric(all, (struct fabric){.kind = FABRIC_GARTER}, rows, SIDE_OPEN, starting);
}

struct row syntax_total(struct row row)
{
    row.total = true;
    return row;
}

struct stmt *syntax_keeps(struct stmt *stmt, struct span span, struct kept_edges edges)
{
    if (stmt->kind == STMT_ROW) {
        stmt->row.edges = edges;
        stmt->row.edges_span = span;
    } else {
        stmt->again.edges = edges;
        stmt->again.edges_span = span;
    }
    return stmt;
}

struct row syntax_as_others(struct row row)
{
    row.as_others = true;
    return row;
}

/* A knitter ends with a wrong-side row, where only a length is said. */
static int whole_ridges(struct measure measure)
{
    return measure.counted ? measure.rows : measure.rows + measure.rows % 2;
}

struct expr *syntax_rows_of(struct parse *parse, struct span span, struct measure measure)
{
    struct expr *two = measure.rows ? NULL : syntax_two_rows(parse, span);

    if (two && lengths_said(arena_copy(parse->arena, span.source->text + span.start, span.end - span.start)))
        diag_hint(parse->diag, "a line with a gauge in words, `Gauge: 28 rows = 10 cm`, says how many rows a length is");
    return two ? two : expr_number(parse, span, whole_ridges(measure), 0);
}

struct row syntax_measured(struct row row, struct measure measure)
{
    row.as_others = true;
    row.total = row.measured = measure.rows && !measure.part;
    return row;
}

struct again syntax_again_until(struct parse *parse, struct span span, struct measure measure)
{
    if (!measure.rows)
        return (struct again){.kind = AGAIN_PATTERN, .open = true, .stop = measure.ending, .other_stop = measure.other};
    return (struct again){.kind = measure.part ? AGAIN_PART_LENGTH : AGAIN_LENGTH, .n = expr_number(parse, span, measure.rows, 0), .stop = measure.ending, .other_stop = measure.other};
}

struct expr *syntax_two_rows(struct parse *parse, struct span span)
{
    diag_warning(parse->diag, CODE_REPEAT_NO_COUNT, span, "how many rows these are is not said: two");
    diag_hint(parse->diag, "`Work 20 rows in garter st`, or `Knit 20 rows`");
    return expr_number(parse, span, 2, 0);
}

/* `k1, p1 3 times`: p1 alone, or both?  Where a row begins so its width may tell. */
static void check_times(struct parse *parse, struct item *first, bool row)
{
    bool open = row;    /* no part of the row before this can be read in two ways */

    for (struct item *item = first; item; item = item->next) {
        enum until_kind kind = item_until(parse->source, item).kind;

        if (item->kind > ITEM_STITCH)
            check_times(parse, item->more->child, false);
        open &= item->kind != ITEM_REP_FROM || kind != UNTIL_TIMES;
        if (item == first || item->kind != ITEM_STITCH || kind != UNTIL_TIMES || !is_counted(parse->source, item))
            continue;
        if (open) {
            item->more->until.kind = UNTIL_LAST_OR_ALL;
            open = false;
            continue;
        }
        diag_error(parse->diag, CODE_ROW_REPEAT, item_span(parse->source, item),
                   "what is worked so many times can be read in two ways: '%s' alone, or more of the row", item->more->name);
        diag_hint(parse->diag, "write `[..] 3 times` around what is repeated");
    }
}

/* `knit the knits and purl the purls`, and no more. */
static bool is_whole_below(const struct item *item)
{
    return item && !item->next && item_is_below(item) &&
           (item->more->until.kind == UNTIL_FIT || item->more->until.kind == UNTIL_END);
}

/* Whether a name is words of the list alone, and one of them the first. */
static bool has_only(const char *name, const char *const *words, int n)
{
    size_t length, at = 0;

    for (; name[at]; at += length, at += strspn(name + at, " \t")) {
        int i = 0;

        length = strcspn(name + at, " \t");
        while (i < n && (strncasecmp(words[i], name + at, length) != 0 || words[i][length]))
            i++;
        if (i == n)
            return false;
    }
    return at > 0;
}

/* Whether a row has nothing but these words, to its end. */
static bool is_of_words(struct parse *parse, const struct item *item, const char *const *words, int n)
{
    struct stitch_words name;
    enum until_kind until;

    if (!item || item->next || item->kind > ITEM_STITCH || item_is_below(item))
        return false;
    name = item_words(parse->source, item);
    until = item_until(parse->source, item).kind;
    if (name.count || name.figures.source || (until != UNTIL_ONCE && until != UNTIL_END))
        return false;
    return has_only(arena_copy(parse->arena, name.name, name.length), words, n);
}

/* `work in pattern as established`, `patt to end`, and no more; only rows with a number have a turn. */
static bool is_in_pattern(struct parse *parse, const struct row *head, const struct item *item)
{
    static const char *const words[] = {"patt", "pattern", "work", "in", "the", "est", "established", "as", "set", "even", "to", "end", "across", "row"};
    struct stitch_words name;

    if (!head->numbers || head->numbers->all || !is_of_words(parse, item, words, sizeof words / sizeof *words))
        return false;
    name = item_words(parse->source, item);
    return strcspn(name.name, "pP") < name.length;
}

/* `rib to end`, `work in rib`, and no more. */
static bool is_in_rib(struct parse *parse, const struct item *item)
{
    static const char *const words[] = {"rib", "ribbing", "work", "in", "the", "as", "before", "set", "established", "across", "all", "row"};
    struct stitch_words name;

    if (!is_of_words(parse, item, words, sizeof words / sizeof *words))
        return false;
    name = item_words(parse->source, item);
    return strcspn(name.name, "bB") < name.length;
}

struct row syntax_sided(struct parse *parse, struct row head, struct span span, enum side side)
{
    if (head.side && head.side != side)
        diag_error(parse->diag, CODE_ROW_SIDE, span, "this row was marked %s at its beginning", side == SIDE_RS ? "WS" : "RS");
    head.side = side;
    return head;
}

/* Whether a pattern is worked within these. */
static bool has_within(const struct item *item)
{
    for (; item; item = item->next)
        if (!item_is_plain(item) && (item->more->within || has_within(item->more->child)))
            return true;
    return false;
}

struct row syntax_row(struct parse *parse, struct row head, struct span head_span, struct row body, struct span body_span)
{
    check_times(parse, body.item, true);
    body.item = repeat_to_end(parse, body.item);
    if (is_whole_below(body.item)) {
        body.body = BODY_AS_BELOW;
        body.opposite = body.item->more->name == item_opposite;
    } else if (is_in_pattern(parse, &head, body.item)) {
        body.body = BODY_IN_PATTERN;
    } else if (has_within(body.item)) {
        body.body = BODY_OF_PATTERN;
    } else if (is_in_rib(parse, body.item)) {
        body.body = BODY_IN_RIB;
    }
    body.count = head.count;
    body.starting = body.starting ? body.starting : head.starting;
    body.setup = head.setup;
    body.round = head.round;
    body.side = head.side;
    body.numbers = head.numbers;
    body.head = head_span;
    body.body_span = body_span;
    return body;
}

struct again syntax_again(struct row_numbers *numbers, struct expr *last, struct again again)
{
    again.which = last ? AGAIN_LAST : AGAIN_NUMBERS;
    again.numbers = numbers;
    again.last = last;
    return again;
}

bool syntax_onwards(const struct parse *parse, struct span span, const struct row_numbers *numbers)
{
    const char *plain = parse->text + span.start, *text = span.source->text + span.start;

    return !numbers->next && !numbers->last && !numbers->all &&
           (words_is(words_next(plain), "from") || words_is(words_next(text), "from"));
}

struct again syntax_go_on(struct span span, struct expr *count)
{
    const char *text = span.source->text + span.start;
    bool total = false;

    for (size_t n = span.end - span.start; n > 5; n--, text++)
        total |= strncasecmp(text, "until", 5) == 0 || strncasecmp(text, "till ", 5) == 0 || strncasecmp(text, "total", 5) == 0;
    return (struct again){.which = AGAIN_GO_ON, .kind = total ? AGAIN_UNTIL_ROWS : AGAIN_ROWS, .n = count};
}

struct again syntax_rib(struct again again)
{
    again.rib = true;
    return again;
}

void syntax_then(struct parse *parse, struct again *all, struct span span, struct again again)
{
    struct again *then = arena_new(parse->arena, struct again), **last = &all->then;

    *then = again;
    if (then->kind == AGAIN_PATTERN && !then->n) {
        then->kind = AGAIN_TIMES;
        then->n = expr_number(parse, span, 1, 0);
    }
    while (*last)
        last = &(*last)->then;
    *last = then;
}

struct again syntax_starred(struct starred starred, struct again again)
{
    again.which = AGAIN_STARRED;
    again.starred = starred;
    return again;
}

struct row_numbers *syntax_first_rows(struct parse *parse, struct span span, struct expr *n)
{
    return ast_row_numbers(parse, span, expr_number(parse, span, 1, 0), n, ALL_NONE);
}

/* `Work rows 1-4 three times` right behind them is three times in all. */
struct again syntax_work_again(struct row_numbers *numbers, struct again again)
{
    again.numbers = numbers;
    again.assumed = (again.kind == AGAIN_TIMES || again.kind == AGAIN_ROWS) && !again.more;
    if (again.assumed)
        again.kind = again.kind == AGAIN_TIMES ? AGAIN_TOTAL : AGAIN_TOTAL_ROWS;
    return again;
}

/* `[Knit 2 rows, purl 2 rows] twice`: in all, surely. */
struct again syntax_group(struct again again)
{
    again.assumed = false;
    again.bracketed = true;
    return syntax_starred((struct starred){STARRED_GROUP, 0}, again);
}

/* ---- what is not said, and what is taken ---- */

struct multiple syntax_parity(struct parse *parse, struct span span, int of, int plus)
{
    return (struct multiple){expr_number(parse, span, of, 0), plus ? expr_number(parse, span, plus, 0) : NULL, span};
}

void syntax_first_size(struct parse *parse, struct span sizes)
{
    diag_warning(parse->diag, CODE_FIRST_SIZE, sizes, "several sizes: the first is taken, in the rows too");
    diag_hint(parse->diag, "for another, write its numbers alone");
}

struct stmt *syntax_goes_on(struct parse *parse, struct span span, struct measure measure)
{
    struct again again = syntax_again_until(parse, span, measure);

    again.which = AGAIN_GO_ON;
    return stmt_again(parse, span, again);
}
