/* SPDX-License-Identifier: GPL-3.0-or-later
 * A statement that works rows again in, the rows worked out. */
#include "lang/eval.h"
#include "lang/page/lengths.h"
#include "lang/page/words.h"
#include "lang/limits.h"
#include "lang/rows/row_labels.h"
#include "lang/rows/rows.h"

static bool find_rows(struct eval *eval, struct where where, const struct stmt *stmt, const struct again *again, struct body *body,
                      struct row_texts *texts)
{
    struct row_labels labels = {0};
    long long last;

    switch (again->which) {
    case AGAIN_LAST:
        rows_pattern(body->rows, false);    /* `RS: ..` and `WS: ..` are worked by now */
        last = rows_count(body->rows);
        if (!again->last && !last) {
            diag_error(eval->diag, CODE_ROW_REFERENCE, stmt->span, "there are no rows above");
            return false;
        }
        if (again->last && !eval_whole(eval, where, again->last, 1, last, "the number of rows", &last))
            return false;
        *texts = rows_last(body->rows, (int)last);
        return true;
    case AGAIN_THEM:
    case AGAIN_GO_ON:
        *texts = rows_pattern(body->rows, again->which == AGAIN_GO_ON);
        if (texts->n || again->rib)
            return true;
        diag_error(eval->diag, CODE_ROW_REFERENCE, stmt->span, "there are no numbered rows to go on with");
        diag_hint(eval->diag, rows_count(body->rows) ? "`These 4 rows form the pattern`, behind them, says which rows without numbers are meant"
                                                     : "what is worked: `Work 28 rows in garter st`, or rows with numbers before it: `Row 1: k2, p2`");
        return false;
    case AGAIN_STARRED:
        return rows_starred(body->rows, stmt->span, again->starred, texts);
    default:
        return row_labels_evaluate(eval, where, again->numbers, &labels) &&
               (!again->onwards || row_labels_go_on(eval, &labels, rows_last_number(body->rows), stmt->span)) &&
               rows_labelled(body->rows, stmt->span, labels.label, labels.n, texts);
    }
}

/* How many rows of one text, `Rows 1 and 2`, come before the one of this number; -1: it is another row, or none. */
static int place_among(struct body *body, const struct again *again, const struct row_text *text, int number)
{
    int before = -1;

    for (; number > 0 && rows_find_of(body->rows, again->from, number) == text; number--)
        before++;
    return before;
}

/* So many rows, or the fewest more up to the row of a number; 0: it is not among them.
 * Rows of one text are told apart by their numbers, which are their places, or by how many are before them. */
static long long rows_to_row(struct body *body, const struct again *again, struct row_texts texts, long long n, int stop)
{
    const struct row_text *last = stop > 0 ? rows_find_of(body->rows, again->from, stop) : NULL;
    int at = last ? stop - texts.text[0]->label : 0, others = last ? place_among(body, again, last, stop) : 0, before = -1;
    bool by_place = last && again->which != AGAIN_STARRED && at >= 0 && at < texts.n && texts.text[at] == last;

    for (int place = (int)((n - 1) % texts.n); last && place >= 0 && texts.text[place] == last; place--)
        before++;
    for (long long end = n; last && end < n + texts.n; end++) {
        int place = (int)((end - 1) % texts.n);

        before = texts.text[place] != last ? -1 : end == n ? before : place ? before + 1 : 0;
        if (by_place ? place == at : before >= 0 && before == others)
            return end;
    }
    return 0;
}

/* The same to the row that a length ends with, or to the first that comes of two; 0: none is named. */
static long long rows_to_stop(struct body *body, const struct again *again, struct row_texts texts, long long n)
{
    long long stop = rows_to_row(body, again, texts, n, again->stop), other = rows_to_row(body, again, texts, n, again->other_stop);

    return !stop || (other && other < stop) ? other : stop;
}

/* How many rows of the last repeat there are up to the one a length ends with; 0: it is whole, or none is named. */
static int last_part(struct body *body, const struct again *again, struct row_texts texts)
{
    return texts.n ? (int)(rows_to_stop(body, again, texts, texts.n) % texts.n) : 0;
}

static bool work_follows(const struct stmt *stmt)
{
    return stmt->next && (stmt->next->kind == STMT_ROW || stmt->next->kind == STMT_AGAIN);
}

/* Whether rows up to a length that is not known end within a repeat, and something is worked on that side of it. */
static bool ends_within(const struct stmt *stmt, const struct again *again, struct body *body, struct row_texts texts)
{
    return again->kind == AGAIN_PATTERN && work_follows(stmt) && last_part(body, again, texts);
}

/* `until it measures 8 in, ending with a RS row`: one row more, where the last one is of the other side; of a length
 * that is not known where more is worked behind it. */
static void end_on_side(const struct stmt *stmt, const struct again *again, struct body *body, struct row_texts texts, long long n)
{
    enum side side = again->stop == ENDING_RS ? SIDE_RS : SIDE_WS, last = rows_last_side(body->rows);
    struct row_texts next = texts;
    bool known = again->kind == AGAIN_LENGTH || again->kind == AGAIN_PART_LENGTH;

    if (again->stop >= 0 || !texts.n || !last || last == side || !(known || work_follows(stmt)))
        return;
    next.text = texts.text + (again->kind == AGAIN_PATTERN ? 0 : n % texts.n);
    next.n = 1;
    rows_again(body->rows, stmt->span, next, 1, 0);
}

/* The whole repeats nearest to n rows, or the rows up to one of those that end it; the later, where two are as near. */
static long long rows_nearest(struct body *body, const struct again *again, struct row_texts texts, long long n)
{
    long long after = rows_to_stop(body, again, texts, n), before = 0, next;

    if (!after)
        return (n + texts.n / 2) / texts.n * texts.n;
    for (long long from = n > texts.n ? n - texts.n : 1; (next = rows_to_stop(body, again, texts, from)) < after; from = next + 1)
        before = next;
    return before && n - before < after - n ? before : after;
}

/* Rows up to a length of n: whole repeats, the last up to the row that ends it; row by row, where the pattern goes on so
 * or the length ends on a side. */
static long long rows_to_length(const struct again *again, struct body *body, struct row_texts texts, long long n)
{
    long long part = last_part(body, again, texts), nearest;
    bool among = again->bracketed || rows_just_worked(body->rows, texts);

    if (again->kind == AGAIN_LENGTH)
        n -= rows_count(body->rows);
    else if (again->which != AGAIN_GO_ON && among)
        n -= texts.n;
    if (n <= part)
        return part;
    if (again->stop < 0 || (again->which == AGAIN_GO_ON && !rows_to_stop(body, again, texts, n)))
        return n;
    nearest = rows_nearest(body, again, texts, n);
    return nearest || among ? nearest : texts.n;
}

/* The pattern whose name is mentioned; false, with a message, where it cannot be told. */
static bool choose_rows(struct eval *eval, const struct stmt *stmt, const struct again *again, struct body *body)
{
    const char *what = again->which == AGAIN_STARRED                     ? NULL
                       : again->several                                  ? "rows of two names in one sentence"
                       : again->from && again->which == AGAIN_LAST       ? "the last rows, and a pattern by its name"
                       : again->from                                     ? "the rows of this name are not among these"
                       : again->which != AGAIN_LAST && rows_to_choose(body->rows) ? "several patterns are above: which is meant is not said"
                                                                         : NULL;

    if (again->from && again->which == AGAIN_GO_ON && body_works_between(body, again->from))
        return true;
    if (!what || (!again->several && again->from && again->which != AGAIN_LAST && rows_choose(body->rows, stmt->span, again->from)))
        return true;
    diag_error(eval->diag, CODE_ROW_REFERENCE, stmt->span, "%s", what);
    diag_hint(eval->diag, "a sentence for each, with its name: `Work in Box Stitch for 8 rows`");
    return false;
}

/* `Work 4 rows in rib`: which rib that is must stand in the rows above. */
static bool check_rib(struct eval *eval, const struct stmt *stmt, const struct body *body, struct row_texts texts)
{
    if (!rows_are_rib(texts)) {
        diag_error(eval->diag, CODE_ELSEWHERE, stmt->span, "which rib this is is not said, and the rows above are none");
        diag_hint(eval->diag, "`Work 4 rows in k2, p2 rib`");
        return false;
    }
    if (rows_passed(body->rows, texts)) {
        diag_warning(eval->diag, CODE_IN_PATTERN, stmt->span, "which rib this is is not said: that of the rows above");
        diag_hint(eval->diag, "`Work 4 rows in k2, p2 rib` says it");
    }
    return true;
}

/* `until 20 rows have been worked`, `for a total of 20 rows`: whether others, worked before, are among these is not said;
 * `until 20 rows of the pattern ..` says it. */
static void warn_since_when(struct eval *eval, const struct stmt *stmt, const struct again *again, const struct body *body,
                            struct row_texts texts, long long n)
{
    bool total = again->kind == AGAIN_TOTAL_ROWS;

    if ((total && again->which == AGAIN_GO_ON) || !(total || (again->kind == AGAIN_UNTIL_ROWS && again->worked)) || !rows_come_before(body->rows, texts, !total))
        return;
    diag_warning(eval->diag, CODE_ASSUMED_TOTAL, stmt->span, "whether the rows before these are among the %lld is not said: they are%s", n, total ? " not" : "");
    diag_hint(eval->diag, total ? "`until piece has %lld rows` counts all" : "`for a total of %lld rows` counts these alone", n);
}

/* Whether one of the words stands in a statement as it was written. */
static bool has_word(const struct stmt *stmt, const char *list)
{
    return words_any_of(list, stmt->span.source->text, stmt->span.start, stmt->span.end);
}

/* `Work 4 rows in Box Stitch` right behind the 2 rows of this name: these are what the name means, and the first of the four. */
static bool counts_named(struct eval *eval, const struct stmt *stmt, const struct again *again, const struct body *body, struct row_texts texts, long long n)
{
    if (!again->from || again->which != AGAIN_GO_ON || again->kind != AGAIN_ROWS || n <= texts.n || !has_word(stmt, "work") || has_word(stmt, "more|further|another|continue|cont") ||
        !rows_just_worked(body->rows, texts))
        return false;
    diag_warning(eval->diag, CODE_ASSUMED_TOTAL, stmt->span, "whether the rows above are among the %lld is not said: they are", n);
    diag_hint(eval->diag, "`Continue in .. for %lld rows` counts those that follow; a pattern's rows before the cast-on are not worked there", n);
    return true;
}

/* What is repeated `in this way` behind rows without numbers are these, not the pattern before them. */
static bool check_manner(struct eval *eval, const struct stmt *stmt, const struct again *again, const struct body *body, struct row_texts texts)
{
    if (again->which != AGAIN_GO_ON || again->from || texts.told || !rows_passed(body->rows, texts) || !has_word(stmt, "way|manner|fashion|like this"))
        return true;
    diag_error(eval->diag, CODE_ROW_REFERENCE, stmt->span, "which rows are meant is not said: rows without numbers stand behind those that have them");
    diag_hint(eval->diag, "`Repeat the last 2 rows 3 more times`; or `Continue in pattern for 6 rows`, by the rows with numbers");
    return false;
}

/* `Repeat these 2 rows for 12 rows`, right behind them: whether they are among the 12 is not said. */
static void warn_more_rows(struct eval *eval, const struct stmt *stmt, const struct again *again, const struct body *body, struct row_texts texts, long long n)
{
    if (again->kind != AGAIN_ROWS || again->more || again->which == AGAIN_GO_ON || again->which == AGAIN_STARRED || !rows_just_worked(body->rows, texts))
        return;
    diag_warning(eval->diag, CODE_ASSUMED_TOTAL, stmt->span, "whether the rows above are among the %lld is not said: they are not", n);
    diag_hint(eval->diag, "`for %lld more rows` says it; `for a total of %lld rows` counts those above", n, n);
}

/* `until piece measures 10 cm`; not `until long enough`. */
static bool says_length(struct eval *eval, struct span span)
{
    return lengths_said(arena_copy(eval->arena, span.source->text + span.start, span.end - span.start));
}

/* What is open: how often the rows are worked, and whether those above are the first time. */
static void warn_open(struct eval *eval, const struct stmt *stmt, const struct again *again, struct body *body,
                      struct row_texts texts, bool once)
{
    if (again->kind == AGAIN_PATTERN && !again->pattern && body->top) {
        diag_warning(eval->diag, CODE_REPEAT_NO_COUNT, stmt->span, "how often these rows are %s", once ? "worked is not said: once"
                                                             : ends_within(stmt, again, body, texts) ? "repeated is not said: once more as far as they end"
                                                             : again->stop < 0 && work_follows(stmt) ? "repeated is not said: not once more but to end on that side"
                                                                                                     : "repeated is not said: not once more");
        diag_hint(eval->diag, again->open ? (says_length(eval, stmt->span) ? "`until piece has 60 rows`; or a line with a gauge in words, `Gauge: 28 rows = 10 cm`, says how many rows a length is"
                                                                  : "`until piece has 60 rows`")
                                          : "`repeat rows 1-4 5 times` works them five times more");
    }
    if (again->assumed && rows_just_worked(body->rows, texts)) {
        diag_warning(eval->diag, CODE_ASSUMED_TOTAL, stmt->span, "whether the rows above are the first time is not said: they are");
        diag_hint(eval->diag, "`repeat rows 1-4 3 more times` says it");
    }
}

static bool is_single(const struct row *row)
{
    const struct row_numbers *numbers = row->numbers;

    return !row->count && !row->times && (!numbers || (!numbers->next && !numbers->last && !numbers->all));
}

enum { NO_PLACE = -LIMIT_ROWS - 1 };

/* Where the next `Repeat the last 16 rows` begins; the rows of each `Repeat last row for 8 rows` from this statement to there are those
 * with the row above, or (`more`) others behind it. NO_PLACE: nothing says so. */
static long long block_place(struct eval *eval, struct where where, const struct stmt *stmt, const struct body *body, bool more)
{
    enum { FARTHEST = 50 };
    long long end = rows_count(body->rows), last, n;

    for (int i = 0; stmt && i < FARTHEST; i++, stmt = stmt->next) {
        if (stmt->kind == STMT_PROSE || (stmt->kind == STMT_ROW && is_single(&stmt->row))) {
            end += stmt->kind == STMT_ROW;
            continue;
        }
        if (stmt->kind != STMT_AGAIN || stmt->again.which != AGAIN_LAST || !stmt->again.last || !eval_whole(eval, where, stmt->again.last, 1, LIMIT_ROWS, "the number of rows", &last))
            return NO_PLACE;
        if (last > 1)
            return end - last;
        if (stmt->again.kind != AGAIN_ROWS || !eval_whole(eval, where, stmt->again.n, 0, LIMIT_ROWS, "this number", &n))
            return NO_PLACE;
        end += n - !(more || stmt->again.more);
    }
    return NO_PLACE;
}

/* `Repeat last row for 8 rows` twice, then `the last 16 rows`: the row above is one of the 8 where these begin with a row so alone.
 * *said: such a sum stands below. */
static bool counts_above(struct eval *eval, struct where where, const struct stmt *stmt, const struct again *again, const struct body *body, int n, bool *said)
{
    bool one = n == 1 && again->which == AGAIN_LAST && again->kind == AGAIN_ROWS && !again->more;
    long long among = one ? block_place(eval, where, stmt, body, false) : NO_PLACE;

    *said = among > NO_PLACE;
    return *said && rows_begin_at(body->rows, among) && !rows_begin_at(body->rows, block_place(eval, where, stmt, body, true));
}

/* What is left to work of n times or n rows in all, where the rows above are among them. */
static long long left_to_work(const struct again *again, struct body *body, struct row_texts texts, long long n, bool described)
{
    bool among = again->bracketed || rows_just_worked(body->rows, texts);
    int above = 0;

    switch (again->kind) {
    case AGAIN_TOTAL:
        return n && among ? n - 1 : n;
    case AGAIN_ROWS:
    case AGAIN_TOTAL_ROWS:
        if (again->kind == AGAIN_TOTAL_ROWS && again->which == AGAIN_GO_ON)
            above = rows_gone_on(body->rows, texts);
        else if (again->kind == AGAIN_ROWS ? described : among)
            above = texts.n;
        return n > above ? n - above : 0;
    case AGAIN_LENGTH:
    case AGAIN_PART_LENGTH:
        return rows_to_length(again, body, texts, n);
    default:
        return n;
    }
}

/* `3 times, ending with row 2`: so many rows must end there; of times it is open whether one of them stops there, or one more. */
static bool check_ending(struct eval *eval, const struct stmt *stmt, const struct again *again, const struct body *body, struct row_texts texts)
{
    bool counted = again->kind == AGAIN_UNTIL_ROWS || again->kind >= AGAIN_ROWS;
    const struct row_text *last = !again->ending || !rows_count(body->rows) ? NULL : counted ? rows_last(body->rows, 1).text[0] : texts.text[texts.n - 1];

    if (!last || rows_find(body->rows, again->ending) == last)
        return true;
    if (counted)
        diag_error(eval->diag, CODE_ROW_REPEAT, stmt->span, "these rows do not end with row %d, but with row %d", again->ending, last->label);
    else {
        diag_error(eval->diag, CODE_ROW_REPEAT, stmt->span, "this can be read in two ways: row %d ends the last of these times, or one more", again->ending);
        diag_hint(eval->diag, "`.., then rows 1-%d once`, behind the times the rows are worked as a whole", again->ending);
    }
    return false;
}

/* Whether what follows counts these rows as worked once more: row 5 behind `Repeat rows 1 and 2`, `these 8 rows` behind 6. */
static bool next_counts_on(struct eval *eval, struct where where, const struct stmt *stmt, const struct body *body, struct row_texts texts)
{
    const struct stmt *next = stmt->next;
    struct row_labels labels = {0};
    long long rows = rows_count(body->rows) + texts.n, last;

    while (next && next->kind == STMT_PROSE)
        next = next->next;
    if (!next || !texts.n)
        return false;
    if (next->kind == STMT_ROW && next->row.numbers && !next->row.numbers->all)
        return row_labels_evaluate(eval, where, next->row.numbers, &labels) && labels.label[0] == rows_last_number(body->rows) + texts.n + 1;
    if (next->kind == STMT_AGAIN && next->again.last)
        return eval_whole(eval, where, next->again.last, 1, LIMIT_ROWS, "the number of rows", &last) && last == rows;
    return next->kind == STMT_PATTERN && next->told.n == rows;
}

/* `Repeat from ** to **`, and `Repeat rows 1 and 2` before row 5: once more. */
static bool is_once(struct eval *eval, struct where where, const struct stmt *stmt, const struct again *again, const struct body *body,
                    struct row_texts texts)
{
    return again->kind == AGAIN_PATTERN && !again->open &&
           ((again->which == AGAIN_STARRED && !again->pattern) || next_counts_on(eval, where, stmt, body, texts));
}

/* Whether so many times, or as many less the rows above, make the sum that is said. */
struct sums { bool more, all; };

static struct sums compare_sum(const struct again *again, long long n, long long sum, long long above, long long piece, int period)
{
    long long rows = n * period;
    bool of_rows = again->sum_of == SUM_ROWS;

    if (again->sum_of == SUM_TIMES)
        return (struct sums){sum == n + (above > 0) || (sum == n && again->more), sum == n};
    return (struct sums){sum == rows + piece || (of_rows && (sum == rows + above || (sum == rows && again->more))),
                         sum == rows - above + piece || (of_rows && sum == rows)};
}

static void refuse_sum(struct eval *eval, const struct stmt *stmt, const struct again *again, long long n, long long above, long long sum)
{
    const char *of = again->sum_of == SUM_TIMES ? "times" : "rows";

    diag_error(eval->diag, CODE_ROW_REPEAT, stmt->span, "these are %lld %s, with %s above %lld: not %lld", n, of, again->sum_of == SUM_PIECE ? "all" : "those", n + above, sum);
    if (again->sum_of == SUM_TIMES)
        diag_hint(eval->diag, "`%lld more times` counts those behind the rows above", n);
    else
        diag_hint(eval->diag, "`.. until piece has %lld rows` counts all of the piece", sum);
}

/* `3 times, 6 rows in all`, `3 times (4 times in all)`: the rows above are the first time where it comes out so. */
static bool read_sum(struct eval *eval, struct where where, const struct stmt *stmt, const struct again *again, struct body *body,
                     struct row_texts texts, long long *n)
{
    long long above = rows_just_worked(body->rows, texts) ? texts.n : 0, piece = rows_count(body->rows), sum;
    struct sums sums;

    if (!again->sum || again->kind != AGAIN_TIMES || !texts.n)
        return true;
    if (!eval_whole(eval, where, again->sum, 0, LIMIT_ROWS, "the number of rows", &sum))
        return false;
    sums = compare_sum(again, *n, sum, above, piece, texts.n);
    if (sums.more && sums.all && above && !again->more) {
        diag_warning(eval->diag, CODE_ASSUMED_TOTAL, stmt->span, "whether the %lld rows are all of the piece is not said: they are these and those above", sum);
        diag_hint(eval->diag, "`until piece has %lld rows` counts all", sum);
    }
    if (sums.more)
        return true;
    if (sums.all && above && !again->more) {
        *n -= 1;
        return true;
    }
    if (again->sum_of == SUM_TIMES)
        refuse_sum(eval, stmt, again, *n, above > 0, sum);
    else
        refuse_sum(eval, stmt, again, *n * texts.n, again->sum_of == SUM_PIECE ? piece : above, sum);
    return false;
}

/* Rows above a sentence that keeps edges have them, or those between them, where they are only a pattern yet; of rows that
 * were worked without it is open. */
static bool check_edges(struct eval *eval, const struct stmt *stmt, const struct body *body, struct row_texts texts)
{
    const struct row_edges *kept = body->edges, *edges = texts.n ? texts.text[0]->edges : NULL;

    if (!kept || !texts.n || texts.text[0]->flanked || (edges && edges->n == kept->n && edges->stitch == kept->stitch))
        return true;
    if (!edges && !rows_worked(body->rows, texts)) {
        for (int i = 0; i < texts.n; i++)
            texts.text[i]->edges = body->edges;
        return true;
    }
    diag_error(eval->diag, CODE_STATEMENT, stmt->span, "whether these rows have the edges that are kept is not said");
    diag_note(eval->diag, kept->span, "which are these");
    diag_hint(eval->diag, "write these stitches in each row, at both ends: `K3, .. to last 3 sts, k3`");
    return false;
}

bool body_again(struct eval *eval, struct where where, const struct stmt *stmt, const struct again *again, struct body *body)
{
    struct row_texts texts;
    long long n = 0;
    bool described = rows_described(body->rows), once, said;

    rows_work(body->rows);
    if (again->n && !eval_whole(eval, where, again->n, 0, LIMIT_ROWS, "this number", &n))
        return false;
    if (again->numbered)
        n = rows_up_to(body->rows, (int)n);
    if (!choose_rows(eval, stmt, again, body))
        return false;
    if (again->which == AGAIN_GO_ON && !again->rib && again->kind == AGAIN_PATTERN && !rows_pattern(body->rows, true).n) {
        diag_warning(eval->diag, CODE_REPEAT_NO_COUNT, stmt->span, "how long the pattern goes on is not said: no row more");
        return true;
    }
    if (!find_rows(eval, where, stmt, again, body, &texts) || (again->rib && !check_rib(eval, stmt, body, texts)))
        return false;
    if (!check_edges(eval, stmt, body, texts))
        return false;
    if (!read_sum(eval, where, stmt, again, body, texts, &n))
        return false;
    if (!check_manner(eval, stmt, again, body, texts))
        return false;
    rows_both_sides(body->rows, texts);
    warn_since_when(eval, stmt, again, body, texts, n);
    described |= counts_named(eval, stmt, again, body, texts, n);
    described |= counts_above(eval, where, stmt, again, body, texts.n, &said);
    if (!described && !said && !again->then)
        warn_more_rows(eval, stmt, again, body, texts, n);
    once = is_once(eval, where, stmt, again, body, texts);
    if (once || (again->kind == AGAIN_PATTERN && (!rows_worked(body->rows, texts) || (!again->pattern && !again->open && rows_passed(body->rows, texts)))))
        n = 1;
    if (!once)
        warn_open(eval, stmt, again, body, texts, n > 0);
    n = left_to_work(again, body, texts, n, described);
    if (again->kind == AGAIN_UNTIL_ROWS)
        rows_again(body->rows, stmt->span, texts, 0, n);
    else if (again->kind >= AGAIN_ROWS && n)
        rows_again(body->rows, stmt->span, texts, 0, rows_count(body->rows) + n);
    else if (n)
        rows_again(body->rows, stmt->span, texts, n, 0);
    if (ends_within(stmt, again, body, texts))
        rows_again(body->rows, stmt->span, texts, 0, rows_count(body->rows) + last_part(body, again, texts));
    end_on_side(stmt, again, body, texts, n);
    if (!check_ending(eval, stmt, again, body, texts))
        return false;
    return !again->then || body_again(eval, where, stmt, again->then, body);
}
