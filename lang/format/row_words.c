/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows, cast on and repeats in, their words out. */
#include "lang/format/row_words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/format/spelling.h"
#include "lang/page/words.h"

struct writer {
    struct layout *out;
    const struct row_style *style;
    const char *noun;       /* "row" or "rnd" */
    const char *stop;       /* "." or "" */
    int first;              /* the statement's first token */
};

#define PUT(...) layout_print(w->out, __VA_ARGS__)

static void put_items(struct writer *, const struct item *, bool whole_row);

/* ---- numbers ---- */

/* `{n}`: the brace stands before the expression. */
static bool is_hole(const struct writer *w, const struct expr *e)
{
    int at = tokens_find(w->style->tokens, e->span.start) - 1;

    while (at > 0 && w->style->tokens->at[at].kind == TOKEN_COMMENT)
        at--;
    return at >= 0 && w->style->tokens->at[at].kind == TOKEN_HOLE;
}

static const char *count(const struct writer *w, const struct expr *e)
{
    const char *digits = e->span.source->text + e->span.start;

    if (is_hole(w, e))
        return arena_printf(w->style->arena, "{%s}",
                            spelling_of_span(w->style->arena, w->style->tokens, e->span));
    if (isdigit((unsigned char)*digits) && words_number(digits) == e->number.value)   /* else of a step, of which it is the row */
        return arena_copy(w->style->arena, digits, strspn(digits, "0123456789"));
    return arena_printf(w->style->arena, "%.0f", e->number.value);
}

/* Whether it is written as a number, and this one. */
static bool is_number(const struct writer *w, const struct expr *e, double value)
{
    return e->kind == EXPR_NUMBER && !is_hole(w, e) && e->number.value == value;
}

static void put_times(struct writer *w, const struct expr *n, const char *more)
{
    if (is_number(w, n, 1) || is_number(w, n, 2))
        PUT(" %s%s", is_number(w, n, 1) ? "once" : "twice", more);
    else
        PUT(" %s%s times", count(w, n), more);
}

static void put_to_marker(struct writer *w, const struct until *until)
{
    const char *which = until->kind == UNTIL_SECOND_MARKER ? "second " : until->kind == UNTIL_LAST_MARKER ? "last " : "";

    if (until->n)
        PUT(" to %s sts before %smarker", count(w, until->n), which);
    else
        PUT(" to %smarker", which);
}

static void put_until(struct writer *w, const struct until *until)
{
    if (until->kind == UNTIL_TIMES || until->kind == UNTIL_LAST_OR_ALL || until->kind == UNTIL_MORE)
        put_times(w, until->n, until->kind == UNTIL_MORE ? " more" : "");
    else if (until->kind == UNTIL_LAST && is_number(w, until->n, 1))
        PUT(" to last st");
    else if (until->kind == UNTIL_LAST)
        PUT(" to last %s sts", count(w, until->n));
    else if (until->kind == UNTIL_END)
        PUT(" to end");
    else if (until->kind == UNTIL_MARKER || until->kind == UNTIL_SECOND_MARKER || until->kind == UNTIL_LAST_MARKER)
        put_to_marker(w, until);
}

/* ---- stitches ---- */

/* `K`, `knit`, `P2`, `purl`: the letter, and the digits behind the word; 0: an own stitch. */
static char plain(const char *name, const char **digits)
{
    size_t letters = strcspn(name, "0123456789");
    bool letter = letters == 1 && strchr("kpKP", *name);
    bool word = letters == 4 && (strncasecmp(name, "knit", 4) == 0 || strncasecmp(name, "purl", 4) == 0);

    *digits = name + letters;
    if ((!letter && !word) || (*digits)[strspn(*digits, "0123456789")])
        return 0;
    return (char)tolower((unsigned char)*name);
}

static const struct source *source_of(const struct writer *w)
{
    return w->style->tokens->at[0].span.source;
}

/* What a plain item says, as the others say it. */
static struct item_more more_of(const struct writer *w, const struct item *item)
{
    struct item_more more = {0};
    struct stitch_words words;

    if (!item_is_plain(item))
        return item->more[0];
    words = item_words(source_of(w), item);
    more.name = arena_copy(w->style->arena, words.name, words.length);
    if (words.figures.source) {
        more.count = arena_new(w->style->arena, struct expr);
        *more.count = (struct expr){.kind = EXPR_NUMBER, .span = words.figures};
        more.count->number.value = strtod(source_of(w)->text + words.figures.start, NULL);
    }
    return more;
}

/* An own stitch; its name may end in digits, so a number stands apart. */
static void put_own(struct writer *w, const struct item_more *item)
{
    PUT("%s", item->name);
    if (item->count)
        PUT("%s%s", is_hole(w, item->count) ? "" : " ", count(w, item->count));
    put_until(w, &item->until);
}

/* Alone a stitch fills what there is: `knit`. Elsewhere it is one: `k1`. */
static void put_stitch(struct writer *w, const struct item_more *item, bool alone, bool whole_row)
{
    enum until_kind until = item->until.kind;
    const char *digits;
    char letter = plain(item->name, &digits);

    if (!letter || !w->style->lower || (*digits && item->count)) {
        put_own(w, item);
    } else if (*digits || item->count) {
        PUT("%c%s", letter, *digits ? digits : count(w, item->count));
        put_until(w, &item->until);
    } else if (alone && whole_row && (until == UNTIL_ONCE || until == UNTIL_END)) {
        PUT(letter == 'k' ? "knit" : "purl");
    } else {
        PUT("%c%s", letter, !alone && until == UNTIL_ONCE ? "1" : "");
        put_until(w, &item->until);
    }
}

/* ---- groups ---- */

static void put_group(struct writer *w, const struct item *item)
{
    char first = source_of(w)->text[item->start], open = first == '(' || first == '[' ? first : item->kind == ITEM_GROUP ? '[' : '*';
    bool total = item->kind == ITEM_STARS && item->more->until.kind == UNTIL_TIMES;

    PUT("%c", open);
    put_items(w, item->more->child, false);
    if (open == '*' && !total)
        PUT(";\nrep from *");
    else
        PUT("%c%s", open == '(' ? ')' : open == '[' ? ']' : '*', open != '*' && item->kind == ITEM_STARS ? " rep" : "");
    put_until(w, &item->more->until);
}

/* A line that begins with a statement's word would be one. */
static bool may_begin_line(const struct item_more *item)
{
    size_t letters = item->name ? strcspn(item->name, "0123456789 ") : 0;

    for (int i = 0; i < nstatement_words && letters; i++)
        if (strncasecmp(item->name, statement_word[i], letters) == 0 && !statement_word[i][letters])
            return false;
    return true;
}

static void put_item(struct writer *w, const struct item *item, bool first, bool alone, bool whole_row)
{
    struct item_more more = more_of(w, item);

    if (!first)
        PUT(may_begin_line(&more) ? ",\n" : ", ");
    if (more.name)
        put_stitch(w, &more, alone, whole_row);
    else
        put_group(w, item);
}

static void put_items(struct writer *w, const struct item *item, bool whole_row)
{
    const struct item *first = item;

    for (; item; item = item->next) {
        struct item one = {0};

        if (!item_is_plain(item))
            put_item(w, item, item == first, !first->next, whole_row);
        else
            while (item_step(source_of(w), item, &one))
                put_item(w, &one, one.start == first->start, !first->next, whole_row);
    }
}

/* ---- heads ---- */

/* Whether the text of a span has a word of rounds. */
static bool says_round(struct span span)
{
    for (unsigned i = span.start; i + 3 <= span.end; i++)
        if (strncasecmp(span.source->text + i, "rnd", 3) == 0 || strncasecmp(span.source->text + i, "round", 5) == 0)
            return true;
    return false;
}

/* `all RS rows`, `every other row`. */
static void put_all(struct writer *w, const struct row_numbers *part, const char *every)
{
    static const char *const which[] = {[ALL_RS] = "RS", [ALL_WS] = "WS", [ALL_EVEN] = "even", [ALL_ODD] = "odd"};
    const char *noun = says_round(part->span) ? "rnd" : "row";

    if (part->all >= ALL_RS_ROW)
        PUT("%s", part->all == ALL_RS_ROW ? "RS" : "WS");
    else if (part->all == ALL_OTHER || part->all == ALL_FOLLOWING)
        PUT("every %s %s", part->all == ALL_OTHER ? "other" : "following", noun);
    else
        PUT("%s %s %ss", every, which[part->all], noun);
}

static void put_numbers(struct writer *w, const struct row_numbers *part, const char *side)
{
    for (const struct row_numbers *p = part; p; p = p->next) {
        PUT("%s", p == part ? "" : p->next ? ", " : " and ");
        if (p->all)
            put_all(w, p, "all");
        else if (p->last && (p->only == ALL_EVEN || p->only == ALL_ODD))
            PUT("%s-%s (%s)", count(w, p->first), count(w, p->last), p->only == ALL_ODD ? "odd" : "even");
        else
            PUT("%s%s%s", count(w, p->first), p->last ? "-" : "", p->last ? count(w, p->last) : "");

        /* The side stands behind the last of the numbers. */
        if (!p->all && (!p->next || p->next->all)) {
            PUT("%s", side);
            side = "";
        }
    }
}

static bool is_one(const struct row_numbers *part)
{
    return !part->last && (!part->next || part->next->all);
}

/* A page may call its rounds rows. */
static bool is_called_round(const struct row *row)
{
    return row->round && strncasecmp(row->head.source->text + row->head.start, "row", 3) != 0;
}

static void put_head(struct writer *w, const struct row *row)
{
    static const char *const sides[] = {"", " (RS)", " (WS)"};
    const char *noun = is_called_round(row) ? "Rnd" : "Row", *side = sides[row->side];

    if (row->numbers && row->numbers->all) {
        put_all(w, row->numbers, "All");
        PUT("%s", row->numbers->all == ALL_RS || row->numbers->all == ALL_WS || row->numbers->all >= ALL_RS_ROW ? "" : side);
    } else if (row->numbers) {
        PUT("%s%s ", noun, is_one(row->numbers) ? "" : "s");
        put_numbers(w, row->numbers, side);
    } else if (tolower((unsigned char)row->head.source->text[row->head.start]) == 'n') {
        PUT("Next %s%s", w->noun, side);
    } else {
        PUT("%s%s", noun, side);
    }
    PUT(": ");
}

/* ---- statements ---- */

static void put_row(struct writer *w, const struct row *row)
{
    w->noun = is_called_round(row) ? "rnd" : "row";
    put_head(w, row);
    layout_column(w->out, LAYOUT_ROW);
    if (row->body == BODY_AS_ROW)
        PUT("as %s %s", w->noun, count(w, row->reference->first));
    else if (row->body == BODY_AS_BELOW)
        PUT(row->opposite ? "purl the knits and knit the purls" : "knit the knits and purl the purls");
    else if (row->body == BODY_IN_PATTERN)
        PUT("work in pattern");
    else if (row->body == BODY_IN_RIB)
        PUT("work in rib");
    else
        put_items(w, row->item, true);
    PUT("%s", w->stop);
    if (row->check)
        PUT("\n(%s st%s)", count(w, row->check), is_number(w, row->check, 1) ? "" : "s");
}

static bool says_more(struct span span)
{
    for (unsigned i = span.start; i + 4 <= span.end; i++)
        if (strncasecmp(span.source->text + i, "more", 4) == 0)
            return true;
    return false;
}

static void put_again(struct writer *w, const struct stmt *stmt)
{
    const struct again *again = &stmt->again;
    bool one = again->last ? is_number(w, again->last, 1) : is_one(again->numbers);

    layout_column(w->out, LAYOUT_ROW);
    PUT("Repeat %s", again->last ? "the last " : "");
    if (again->last && !one)
        PUT("%s ", count(w, again->last));
    PUT("%s%s", w->noun, one ? "" : "s");
    if (again->numbers) {
        PUT(" ");
        put_numbers(w, again->numbers, "");
    }
    if (again->kind == AGAIN_TIMES)
        put_times(w, again->n, says_more(stmt->span) ? " more" : "");
    else if (again->kind == AGAIN_UNTIL_ROWS)
        PUT(" until piece has %s %ss", count(w, again->n), w->noun);
    else if (again->pattern)
        PUT(" for pattern");
    PUT("%s", w->stop);
}

static void put_multiple(struct writer *w, const struct stmt *stmt)
{
    const struct multiple *m = &stmt->multiple;

    PUT("%sultiple of %s st%s", w->first == TOKEN_CAST_ON ? "Cast on a m" : "M", count(w, m->of),
        is_number(w, m->of, 1) ? "" : "s");
    if (m->plus)
        PUT(" + %s", count(w, m->plus));
    PUT("%s", w->stop);
}

void row_words(struct layout *out, const struct row_style *style, const struct stmt *stmt, int first, bool stopped)
{
    const char *noun = says_round(stmt->span) ? "rnd" : "row";
    struct writer writer = {out, style, noun, stopped ? "." : "", first}, *w = &writer;

    if (stmt->kind == STMT_ROW)
        put_row(w, &stmt->row);
    else if (stmt->kind == STMT_AGAIN)
        put_again(w, stmt);
    else if (stmt->kind == STMT_MULTIPLE)
        put_multiple(w, stmt);
    else
        PUT("Cast on %s st%s%s", count(w, stmt->cast_on.n), is_number(w, stmt->cast_on.n, 1) ? "" : "s", w->stop);
}
