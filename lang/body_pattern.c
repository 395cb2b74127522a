/* SPDX-License-Identifier: GPL-3.0-or-later
 * A row that works a pattern between other stitches in, `K4, work row 1 of Box Stitch to last 4 sts, k4`; out, the pattern's
 * rows between these stitches: this one, and those that follow in the same manner. */
#include "lang/eval.h"
#include "lang/limits.h"
#include "lang/lower.h"
#include "lang/rows/row_fit.h"

/* What is worked before and behind the pattern, by the side of its row. */
struct flanks {
    struct work *before, *behind;
};

struct between {
    unsigned         from;      /* where the pattern's rows begin; 0: it has no name */
    struct row_texts rows;      /* the pattern's, */
    struct row_texts made;      /* and the same between the flanks */
    struct flanks    flanks[2]; /* of odd and of even rows */
    int              next;      /* the place of the row whose turn it is */
};

static bool refuse(struct eval *eval, struct span span, const char *what)
{
    diag_error(eval->diag, CODE_ELSEWHERE, span, "%s", what);
    diag_hint(eval->diag, "write the row out, edges and all; or say it of the rows: `Keep 4 sts at each edge in garter st`");
    return false;
}

/* ---- copies ---- */

/* A list of work, to be worked by itself. `behind`: so many stitches follow it. */
static struct work *copy_work(struct eval *eval, const struct work *work, long long behind)
{
    struct work *first = NULL, **next = &first;

    for (; work; work = work->next, next = &(*next)->next) {
        *next = arena_new(eval->arena, struct work);
        **next = *work;
        (*next)->child = copy_work(eval, work->child, 0);
        (*next)->n += work->until == WORK_LAST ? behind : 0;
        (*next)->next = NULL;
    }
    return first;
}

static void append(struct work **list, struct work *more)
{
    while (*list)
        list = &(*list)->next;
    *list = more;
}

/* All stitches there are, shown as below or otherwise. */
static struct work *work_below(struct eval *eval, const struct row_text *text)
{
    struct work *work = arena_new(eval->arena, struct work);

    work->run = arena_new(eval->arena, struct run);
    *work->run = (struct run){1, text->as_below ? STITCH_SAME : STITCH_OTHER};
    *work = (struct work){.span = text->span, .run = work->run, .nruns = 1, .length = 1, .until = WORK_FIT, .n = 1};
    return work;
}

/* A row of the pattern between its flanks. */
static struct row_text *make_row(struct eval *eval, const struct row_text *text, struct flanks flanks)
{
    struct row_text *made = arena_new(eval->arena, struct row_text);
    long long behind = work_length(flanks.behind);

    *made = (struct row_text){.side = text->side, .round = text->round, .check = -1, .span = text->span, .head = text->head, .marked = text->marked, .failed = text->failed,
                              .flanked = true};
    made->work = copy_work(eval, flanks.before, 0);
    append(&made->work, text->as_below || text->as_opposite ? work_below(eval, text) : copy_work(eval, text->work, behind));
    append(&made->work, copy_work(eval, flanks.behind, 0));
    return made;
}

/* ---- the row ---- */

/* Parts the work of a row at the pattern's place; false: there is none in it, or two. */
static bool part_work(struct work *work, struct flanks *flanks, const struct within **within)
{
    struct work **end = &flanks->before;

    *flanks = (struct flanks){work, NULL};
    *within = NULL;
    while (*end && !(*end)->within)
        end = &(*end)->next;
    if (!*end)
        return false;
    *within = (*end)->within;
    flanks->behind = (*end)->next;
    *end = NULL;
    for (work = flanks->behind; work; work = work->next)
        if (work->within)
            return false;
    return true;
}

/* Whether both flanks have so many stitches, and the last are those that the pattern leaves. */
static bool check_flanks(struct eval *eval, struct span span, struct flanks flanks, const struct within *within)
{
    long long behind;

    if (!work_measure(eval->diag, flanks.before, &behind) || !work_measure(eval->diag, flanks.behind, &behind))
        return false;
    behind = work_length(flanks.behind);
    if (behind < 0 || work_length(flanks.before) < 0)
        return refuse(eval, span, "how many stitches stand beside the pattern is not said");
    if (!within->last || behind == within->last)
        return true;
    diag_error(eval->diag, CODE_ROW_COUNT, span, "the pattern leaves %d stitch%s, and %lld are worked behind it", within->last, within->last == 1 ? "" : "es", behind);
    return false;
}

/* The pattern a row names, or the one before; its rows between the flanks are made anew where these are others. */
static bool find_pattern(struct eval *eval, const struct row *row, struct body *body)
{
    struct between *between = body->between;
    struct row_texts rows;

    if (between && (!row->from || row->from == between->from))
        return true;
    rows = row->from ? rows_of_name(body->rows, row->from) : rows_any(body->rows) ? (struct row_texts){0} : rows_pattern(body->rows, false);
    if (!rows.n)
        return refuse(eval, row->body_span, "which pattern this is is not said, or its rows stand elsewhere");
    for (int i = 0; i < rows.n; i++)
        if (!rows.text[i] || rows.text[i]->cut || rows.text[i]->on_ws || rows.text[i]->end || rows.text[i]->edges)
            return refuse(eval, row->body_span, "a row of this pattern has no stitches of its own");
    body->between = between = arena_new(eval->arena, struct between);
    *between = (struct between){.from = row->from, .rows = rows};
    between->made = (struct row_texts){.text = arena_array(eval->arena, struct row_text *, (size_t)rows.n), .n = rows.n};
    return true;
}

/* The flanks of a row, and of those of the same side; where none is known of the other, of these, too. */
static bool set_flanks(struct eval *eval, const struct row *row, struct between *between, struct flanks flanks, int place)
{
    struct flanks *own = &between->flanks[place % 2], *other = &between->flanks[1 - place % 2];
    bool first = !other->before && !other->behind;

    if (work_is_same(own->before, flanks.before) && work_is_same(own->behind, flanks.behind) && between->made.text[place])
        return true;
    if ((eval->written_rows += between->rows.n) > LIMIT_WRITTEN_ROWS) {
        diag_error(eval->diag, CODE_LIMIT_ROWS, row->head, "a pattern may have %d written rows", LIMIT_WRITTEN_ROWS);
        return false;
    }
    *own = flanks;
    if (first)
        *other = flanks;
    between->made.text = arena_array(eval->arena, struct row_text *, (size_t)between->rows.n);
    for (int i = 0; i < between->rows.n; i++)
        between->made.text[i] = make_row(eval, between->rows.text[i], between->flanks[i % 2]);
    return true;
}

/* The place of the row that is worked; -1, with a message: the pattern has none of this number. */
static int place_of(struct eval *eval, const struct row *row, const struct between *between, const struct within *within)
{
    if (!within->row)
        return between->next;
    for (int i = 0; i < between->rows.n; i++)
        if (between->rows.text[i]->label == within->row)
            return i;
    diag_error(eval->diag, CODE_ROW_REFERENCE, row->body_span, "the pattern has no row %d", within->row);
    return -1;
}

struct row_text *body_of_pattern(struct eval *eval, struct where where, const struct row *row, struct body *body)
{
    struct work *work;
    struct flanks flanks;
    const struct within *within;
    struct row_text *text;
    int place;

    if (!lower_items(eval, where, row->item, &work))
        return NULL;
    if (!part_work(work, &flanks, &within)) {
        refuse(eval, row->body_span, "a pattern stands once in a row, and in no repeat");
        return NULL;
    }
    if (!check_flanks(eval, row->body_span, flanks, within) || !find_pattern(eval, row, body))
        return NULL;
    place = place_of(eval, row, body->between, within);
    if (place < 0 || !set_flanks(eval, row, body->between, flanks, place))
        return NULL;
    text = body->between->made.text[place];
    if (within->over)
        text->check = within->over + work_length(flanks.before) + work_length(flanks.behind);
    text->check_span = row->body_span;
    text->side = row->side ? row->side : text->side;
    text->head = row->head;
    text->span = row->body_span;
    body->between->next = (place + 1) % body->between->rows.n;
    return text;
}

void body_tell_pattern(struct body *body)
{
    rows_tell_texts(body->rows, body->between->made, body->between->next);
}

bool body_works_between(struct body *body, unsigned from)
{
    struct row_texts last;

    if (!body->between || (from && from != body->between->from))
        return false;
    rows_work(body->rows);
    last = rows_count(body->rows) ? rows_last(body->rows, 1) : (struct row_texts){0};
    for (int i = 0; last.n && i < body->between->made.n; i++)
        if (last.text[0] == body->between->made.text[i])
            return true;
    return false;
}
