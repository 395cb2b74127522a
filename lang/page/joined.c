/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with its sentences whole out: a line that stops short goes on in the next. */
#include "lang/page/joined.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "lang/page/headings.h"
#include "lang/parse.h"
#include "lang/page/prose.h"
#include "lang/syntax.h"
#include "lang/page/words.h"

enum { LONGEST = 1000 };    /* bytes of a sentence that is put together */

/* A line's last sentence, as far as it goes. */
struct piece {
    const char *text;
    size_t      length;
    bool        behind_stop;    /* another sentence is before it on its line */
};

static struct piece last_sentence(const char *line, size_t length)
{
    size_t start = 0;

    while (length > 0 && isspace((unsigned char)line[length - 1]))
        length--;
    for (size_t i = 0; i + 1 < length; i++)
        if (strchr(".!?;", line[i]) && line[i] && isspace((unsigned char)line[i + 1]))
            start = i + 1;
    while (start < length && isspace((unsigned char)line[start]))
        start++;
    return (struct piece){line + start, length - start, start > 0 && memchr(line, '.', start) != NULL};
}

static int count_words(struct piece piece)
{
    int words = 0;

    for (size_t at = 0, n; at < piece.length; at += n ? n : 1) {
        n = words_length(piece.text + at);
        words += n > 0;
    }
    return words;
}

/* Where the last word begins. */
static const char *last_word(struct piece piece)
{
    size_t at = piece.length;

    while (at > 0 && isalpha((unsigned char)piece.text[at - 1]))
        at--;
    return piece.text + at;
}

/* `Place a`, `Repeat rows 1 and 2 until the`: no sentence ends so. */
static bool needs_more(struct piece piece)
{
    static const char *const word[] = {"a", "an", "the", "and", "or", "of", "from", "in", "on", "for", "until", "till", "with", "at", "by", "every", "each",
                                       "your", "this", "these", "is", "are", "be", "not", "than", "that", "as", "to", "into", "when", "if"};

    return count_words(piece) > 1 && words_find(last_word(piece), word, sizeof word / sizeof *word) >= 0;
}

/* `(RS)`, `(WS): knit` */
static bool is_side(const char *text)
{
    return *text == '(' && (words_is(text + 1, "rs") || words_is(text + 1, "ws"));
}

/* `Row 2`, `Rnds 3 and 4`: the head of a row, whose side or colon is on the next line. */
static bool is_head(struct piece piece, const char *next)
{
    size_t at = words_length(piece.text);

    if (!words_are_rows(piece.text) || !(*next == ':' || is_side(next)))
        return false;
    at += strspn(piece.text + at, " 0123456789-,");
    return at >= piece.length;
}

static bool has_sign(const char *text, size_t length, const char *signs)
{
    for (size_t i = 0; i < length; i++)
        if (strchr(signs, text[i]))
            return true;
    return false;
}

/* Whether a part of the pattern, a label or a statement begins. */
static bool begins_part(const char *text, size_t length)
{
    static const char *const word[] = {"then", "now", "multiple", "multiples", "mult", "even", "odd", "rs", "ws", "set", "setup", "foundation", "continue", "cont", "gauge"},
                             *const of_rows[] = {"next", "for", "all", "every", "each", "first", "another", "any", "over", "on", "using", "with"};
    bool rows = words_find(text, of_rows, sizeof of_rows / sizeof *of_rows) >= 0 || words_are(words_is(text, "and") ? words_next(text) : text, WORDS_END);

    if (rows && (has_sign(text, length, "0123456789") || words_line_has(text, "rows") || words_line_has(text, "row") || words_line_has(text, "rounds") || words_line_has(text, "number") ||
                 words_line_has(text, "multiple")))
        return true;
    return words_find(text, word, sizeof word / sizeof *word) >= 0 || (!rows && words_find(text, statement_word, nstatement_words) >= 0) || words_are_rows(text) ||
           words_are_rows(words_next(text)) || !prose_reads(text, true) ||
           prose_statement_follows(text) || prose_fabric_follows(text) || prose_pattern_follows(text) || syntax_is_row(text) || has_sign(text, length, ":={}\"*[");
}

/* The stitches of a row; not `Repeat rows 1-4`. */
static bool is_row_text(const char *text)
{
    bool repeat = words_is(text, "repeat") || words_is(text, "rep");

    return syntax_is_row(text) && !is_side(text) && !(repeat && prose_repeats_rows(text + words_length(text)));
}

/* `Repeat rows 1` before `and 2 until`, `Rows 1` before `and 3: knit`, `1st and` before `3rd rows: knit`. */
static bool names_rows(struct piece piece, const char *next)
{
    static const char *const word[] = {"and", "to", "through", "thru"};
    const char *rows = piece.text;

    if (piece.length && (words_ordinal_length(rows) || words_are_rows(rows)) && words_find(last_word(piece), word, 4) >= 0)
        return isdigit((unsigned char)*next) || words_ordinal_length(next);
    if (!piece.length || !isdigit((unsigned char)piece.text[piece.length - 1]) || words_find(next, word, 4) < 0 || !isdigit((unsigned char)*words_next(next)))
        return false;
    while (words_length(rows) && !words_are_rows(rows))
        rows = words_next(rows);
    return words_are_rows(rows) && rows + words_length(rows) + strspn(rows + words_length(rows), " 0123456789-,") >= piece.text + piece.length;
}

/* `markers at both ends.`, `the work.`: small letters that begin nothing. */
static bool goes_on(const char *text, size_t length)
{
    if (words_is(text, "and") || words_is(text, "or"))
        return !begins_part(words_next(text), length - words_length(text));
    return islower((unsigned char)*text) && (words_length(text) > 1 || *text == 'a') && !begins_part(text, length);
}

/* Whether what ends a line is a sentence's beginning: words, of which the first is capital, but for the text of a row
 * and for a title or a heading. */
static bool is_begun(const char *line, struct piece piece)
{
    size_t heading;

    if (!piece.length || !isalpha((unsigned char)piece.text[piece.length - 1]) || has_sign(piece.text, piece.length, "*[]{}=\"") || is_row_text(piece.text))
        return false;
    if (!isupper((unsigned char)*piece.text) || words_length(piece.text) < 2 || headings_find(line, &heading) != HEADING_NONE)
        return false;
    return piece.behind_stop || (count_words(piece) > 1 && !memchr(piece.text, ':', piece.length));
}

/* `pattern (I worked them 5` before `more times)`: a bracket that the next line closes. */
static bool closes_bracket(const char *line, size_t length, const char *next, size_t rest)
{
    size_t open = length, close = 0;

    while (open > 0 && !strchr("()", line[open - 1]))
        open--;
    while (close < rest && !strchr("()", next[close]))
        close++;
    return open > 0 && line[open - 1] == '(' && isupper((unsigned char)*words_skip_blanks(line + open)) && close < rest && next[close] == ')' && !begins_part(next, rest);
}

/* A sentence to the reader; no row, and no statement. */
static bool is_prose(const char *line)
{
    return prose_reads(line, false) && !words_row(line) && !words_are(line, WORDS_GO_ON | WORDS_THEN) && !prose_statement_follows(line);
}

/* `sl 1, k3`, `12 k`: a row, whatever stands before it. */
static bool has_stitches(const char *text, size_t length)
{
    const char *behind = words_behind_number(text);

    for (size_t at = 0; at < length; at += words_length(text + at) + (words_length(text + at) == 0)) {
        size_t stitch = at > 0 && isalnum((unsigned char)text[at - 1]) ? 0 : words_stitch_length(text + at);

        if (stitch && !isalnum((unsigned char)text[at + stitch]))
            return true;
    }
    return syntax_is_row(text) || (isdigit((unsigned char)*text) && behind && prose_stitches_follow(behind));
}

/* Whether the sentence that a line ends with goes on in the next. `whole`: the line has one of a line before it. */
static bool is_broken(const char *line, size_t length, const char *next, size_t rest, bool whole)
{
    struct piece piece = last_sentence(line, length);

    if (!piece.length || !rest || has_sign(line, length, "#{}"))
        return false;
    if (is_head(piece, next) || names_rows(piece, next) || closes_bracket(line, length, next, rest))
        return true;
    if (needs_more(piece) && is_prose(line) && has_stitches(next, rest))
        return false;
    if (needs_more(piece) && !has_sign(piece.text, piece.length, "*[=\"") && !is_row_text(piece.text))
        return islower((unsigned char)*next) ? !words_are_rows(next) && !words_is(next, "then") && !has_sign(next, rest, "={}\"") : isdigit((unsigned char)*next) && !has_sign(next, rest, ":|)");
    return (is_begun(line, piece) || (whole && !piece.behind_stop && isalpha((unsigned char)piece.text[piece.length - 1]))) && goes_on(next, rest);
}

/* ---- over empty lines, too ---- */

/* `row 1.`, `rows 1 and 2,`: rows that are named, none that begins. */
static bool refers_to_rows(const char *text)
{
    const char *behind = words_are_rows(text) ? words_next(text) : text;

    while (isdigit((unsigned char)*behind) || strchr(" -&", *behind ? *behind : '.') || words_is(behind, "and") || words_is(behind, "to"))
        behind += words_length(behind) ? words_length(behind) : 1;
    return words_are_rows(text) && (*behind == ',' || prose_line_ends(behind));
}

/* Whether a row or a statement begins: `row 3`, `1st row`, `purl 2 rows`, `2)`; not the `row.` of `to end of`, nor its `last 2 sts`. */
static bool begins_work(const char *text)
{
    static const char *const word[] = {"next", "rs", "ws", "set", "setup", "foundation", "multiple", "multiples", "mult", "then", "now"};
    size_t digits = strspn(text, "0123456789"), ordinal = words_ordinal_length(text);

    if (digits)
        return ordinal ? words_are_rows(words_skip_blanks(text + ordinal)) : text[digits] && strchr(".:)|", text[digits]);
    if (refers_to_rows(text) || words_one_of("cast on edge|cast-on edge|cast on row|cast-on row", text))
        return false;
    return words_row(text) || words_find(text, word, sizeof word / sizeof *word) >= 0 || (!words_are_rows(text) && prose_statement_follows(text));
}

/* `Rep from * to`, `until work from`: no end of a line. */
static bool is_cut(struct piece piece)
{
    return needs_more(piece) && islower((unsigned char)*last_word(piece)) && !has_sign(piece.text, piece.length, "={}");
}

/* `Cast on 6 sts (this is the`: a bracket that the next text closes. */
static bool is_open(const char *line, size_t length, const char *next, size_t rest)
{
    size_t close = strcspn(next, "()");

    while (length > 0 && !strchr("()", line[length - 1]))
        length--;
    return length > 0 && line[length - 1] == '(' && isalpha((unsigned char)line[length]) && close < rest && next[close] == ')';
}

/* `end of row.`, `19" [48 cm]`: what goes on behind it. */
static bool ends_cut(const char *text, size_t length)
{
    return (islower((unsigned char)*text) || isdigit((unsigned char)*text)) && !begins_work(text) && !has_sign(text, length, ":={}");
}

/* `ending on a WS row.`, `until ..`, `twice.`: what begins no sentence. */
static bool is_rest(const char *text)
{
    static const char *const lone[] = {"until", "till", "twice", "thrice", "times"}, *const ending[] = {"ending", "finishing"}, *const with[] = {"with", "on", "after"};
    const char *next = words_next(text);

    if (words_find(text, ending, 2) >= 0 && words_find(next, with, 3) >= 0)     /* not `ending with 2 rows of rib` */
        return islower((unsigned char)*text) && !words_behind_number(words_next(next));
    return islower((unsigned char)*text) && words_find(text, lone, 5) >= 0;
}

/* `(beg with a K row).`, `(knit all rows)` behind `Work 5 rows St st`. */
static bool is_bracket_on_rows(const char *text)
{
    static const char *const how[] = {"beg", "begin", "beginning", "start", "starting", "end", "ending", "finishing", "knit", "k", "purl", "p"},
                             *const behind[] = {"with", "on", "after", "all", "every", "each"};
    size_t close = strcspn(text, ")\r\n"), word = close;

    while (word > 0 && isalpha((unsigned char)text[word - 1]))
        word--;
    return *text == '(' && text[close] == ')' && words_are_rows(text + word) && words_find(text + 1, how, sizeof how / sizeof *how) >= 0 &&
           words_find(words_next(text + 1), behind, 6) >= 0;
}

/* `Garter` before `st (knit all rows)`: the name of a fabric. */
static bool names_fabric(struct piece piece, const char *next)
{
    static const char *const fabric[] = {"garter", "stockinette", "stocking", "st", "seed", "moss"}, *const stitch[] = {"st", "stitch"};

    return words_find(last_word(piece), fabric, 6) >= 0 && islower((unsigned char)*next) && words_find(next, stitch, 2) >= 0;
}

/* Whether a line's sentence goes on wherever the next text stands; one to the reader only in more of it, not in stitches. */
static bool is_unfinished(const char *line, size_t length, const char *next, size_t rest)
{
    struct piece piece = last_sentence(line, length);
    char last = piece.length ? piece.text[piece.length - 1] : '.';

    if (!rest || has_sign(line, length, "#{}"))
        return false;
    if ((is_cut(piece) || is_open(line, length, next, rest)) && ends_cut(next, rest))
        return !is_prose(line) || !(has_stitches(next, rest) || words_row(next));
    return !strchr(".:;!?", last) && (is_rest(next) || is_bracket_on_rows(next) || names_fabric(piece, next));
}

/* Where the next line with a text begins; `size`: there is none. */
static size_t next_text(const char *text, size_t at, size_t size)
{
    while (at < size && isspace((unsigned char)text[at]))
        at++;
    return at;
}

const char *joined_plain(struct arena *arena, const char *text, size_t size)
{
    char *own = NULL;
    size_t begin = 0;   /* of the sentence's first line */
    int depth = 0;

    for (size_t at = 0, next; at < size; at = next) {
        size_t length = words_line_within(text + at, size - at), marks = strspn(text + at, " \t-*>"), first, rest;
        bool adjacent;

        depth = words_depth(text + at, length, depth);
        next = at + length + (text[at + length] == '\r');
        next += next < size && (text[next] == '\n' || !text[next]);
        first = next_text(text, at + length, size);
        adjacent = first == next + strspn(text + next, " \t");
        rest = words_line_within(text + first, LONGEST + 1);
        if (depth > 0 || first + rest > begin + LONGEST ||
            !(is_unfinished(text + at + marks, length - marks, text + first, rest) || (adjacent && is_broken(text + at + marks, length - marks, text + first, rest, begin < at)))) {
            begin = next;
            continue;
        }
        own = own ? own : arena_copy(arena, text, size);
        memset(own + at + length, ' ', first - at - length);
        next = first;
    }
    return own ? own : text;
}
