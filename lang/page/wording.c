/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text in, the same out with its turns of phrase put plainly: "the rest of
 * the row" becomes "to end". What is left over is blank, so no place moves. */
#include "lang/page/wording.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

#include "lang/page/casts.h"
#include "lang/page/explained.h"
#include "lang/page/fabrics.h"
#include "lang/page/groups.h"
#include "lang/page/heads.h"
#include "lang/page/page_facts.h"
#include "lang/page/phrases.h"
#include "lang/page/printed.h"
#include "lang/page/prose.h"
#include "lang/page/ribs.h"
#include "lang/page/signs.h"
#include "lang/page/turns.h"
#include "lang/page/words.h"
#include "lang/page/yarns.h"

enum { FEW = 16 };

/* Whether `k`, `knit`, `p` or `purl` stands before. */
static bool behind_stitch(const char *text, size_t at)
{
    size_t end;

    while (at > 0 && isspace((unsigned char)text[at - 1]))
        at--;
    for (end = at; at > 0 && isalnum((unsigned char)text[at - 1]);)
        at--;
    return end > at && words_one_of("knit|k|purl|p", text + at) == end - at;
}

/* Whether nothing but blanks and marks of a list stands before, on the line. */
static bool begins_line(const char *text, size_t at)
{
    return words_sign_before(text, at, " \t*-") == '\n';
}

/* Whether behind a row's name its stitches follow, or `work`. */
static bool work_follows(const char *text)
{
    text += strspn(text, " \t");
    text += strspn(text, ":,;") + strspn(text + strspn(text, ":,;"), " \t");
    return prose_stitches_follow(text) || words_one_of("knit|purl|k|p|work", text);
}

/* The same, or that a sentence ends before. */
static bool begins_sentence(const char *text, size_t at)
{
    return begins_line(text, at) || (strchr(" \t", text[at - 1]) && words_sign_before(text, at, " \t") == '.');
}

/* A text that is copied before the first change of it. */
struct wording {
    struct arena *arena;
    const char *text;
    size_t size;
    bool copied;
    const struct page_facts *facts;
    size_t label, nlabel;       /* the words before the rows of this part, `Rib row 1:`, as they were written; 0: none */
    bool labelled;              /* those of a part have such words */
    bool cast_on;               /* stitches were cast on, or rows named, above */
    size_t last_cast_on;        /* where they are for the last time; 0: that was not asked for */
    size_t heading;             /* where the line begins that was the last heading, `Middle:`; 0: none, or the first line */
    const char *written;
    size_t blank, behind_blank; /* a part of the text without a sign */
    struct phrases *phrases, *printed;
};

static char *own_text(struct wording *w)
{
    if (!w->copied)
        w->text = arena_copy(w->arena, w->text, w->size);
    w->copied = true;
    return (char *)w->text;
}

/* Whether a row begins on a line that the words of a phrase reach: `k3, p3 repeat` and below it `Row 2 K`. */
static bool reaches_row(const char *text, const struct found *found)
{
    for (int i = 1; i < found->n; i++)
        if (memchr(text + found->end[i - 1], '\n', found->start[i] - found->end[i - 1]) && words_row(text + found->start[i]) && prose_pattern_follows(text + found->start[i]))
            return true;
    return false;
}

/* Puts the phrase of a table that begins here plainly. */
static void put_phrase(struct wording *w, struct phrases *phrases, const struct phrase *table, size_t at)
{
    struct found found;

    for (int i = 0; (i = phrases_find(phrases, w->text, at, i, &found)) >= 0; i++) {
        char mark = *table[i].words;

        if ((mark == '@' && !behind_stitch(w->text, at)) || (mark == '^' && !begins_line(w->text, at)) || (strchr(">!", mark) && !begins_sentence(w->text, at)) ||
            (phrases_break(w->text, &found) && (strchr("<>", mark) || w->text[found.end[found.n - 1]] == ':')) || (mark == '>' && !work_follows(w->text + found.end[found.n - 1])))
            continue;
        if (phrases_change(w->text, &found) && !reaches_row(w->text, &found) && phrases_put(own_text(w), &found, table[i].plain))
            return;
    }
}

/* Puts blanks for so many bytes, but for line ends where nothing plain stands for them. */
static void put_blanks(struct wording *w, size_t at, size_t length, const char *plain)
{
    char *text = own_text(w) + at;

    for (size_t i = 0; i < length; i++)
        text[i] = !*plain && strchr("\r\n", text[i]) ? text[i] : ' ';
    memcpy(text, plain, strlen(plain));
}

/* How long `k2, p3, ` is before a further stitch with its figure, or before the two of `k1, p1 alternately`: no sign and no phrase begins in it. */
static size_t stitches_length(const char *text)
{
    size_t pair = 0, length = 0, at = 0;

    for (size_t n; (n = words_stitch_length(text + at)) > 0; at += words_gap_length(text + at)) {
        pair = length;
        length = at;
        at += n;
    }
    return words_one_of("alternately|alternating", text + at) ? pair : length;
}

/* Puts a book's marks, and then its words, plainly. */
static void put_printed(struct wording *w)
{
    char plain[PRINTED_PLAIN];
    const char *marked = w->text;
    struct words_line line = {0};

    for (size_t at = strcspn(marked, "_=[\""), next; at < w->size; at = next + strcspn(marked + next, "_=[\"")) {
        if (words_line_is_long(&line, marked, at)) {
            next = line.end;
            continue;
        }
        next = marked[at] == '"' ? words_skip_quoted(marked, at) : at + 1;
        if (printed_mark(marked, at))
            put_blanks(w, at, printed_mark(marked, at), "");
    }
    line = (struct words_line){0};
    for (size_t at = 0, length; at < w->size; at = w->text[at] == '"' ? words_skip_quoted(w->text, at) : at + 1) {
        if (words_line_is_long(&line, w->text, at)) {
            at = line.end;
            continue;
        }
        length = stitches_length(w->text + at);
        at += length > FEW ? length : 0;
        length = printed_length(w->text, at, plain);
        if (length)
            put_blanks(w, at, length, plain);
    }
}

static void put_sign(struct wording *w, size_t at)
{
    char plain[SIGNS_PLAIN];
    size_t length = signs_length(w->text, at, plain);

    if (length)
        put_blanks(w, at, length, plain);
}

static void put_rib(struct wording *w, size_t at, size_t length)
{
    char *text = own_text(w) + at;

    text[0] = text[length - 1] = ' ';
    for (size_t i = 0; i < length; i++)
        text[i] = text[i] == '.' ? ',' : text[i];
}

/* ---- signs ---- */

/* Whether the line above ends within an expression. */
static bool goes_on(struct wording *w, size_t line)
{
    size_t at = line;

    while (at > 0 && strchr(" \t\r\n", w->text[at - 1]))
        at = at == w->behind_blank ? w->blank : at - 1;
    w->blank = at;
    w->behind_blank = at < line ? line : 0;
    return at > 0 && strchr(",[(=", w->text[at - 1]);
}

/* Puts blanks for what stands before a part of the pattern, at a line's beginning. */
static void put_head(struct wording *w, size_t at, bool inside)
{
    bool stop;
    size_t length = explained_fabric(w->text + at, w->cast_on) ? 0 : heads_length(w->text + at, inside, &stop), digits = strspn(w->text + at, "0123456789"), cast = heads_cast_on(w->text + at);

    if (cast) {
        memset(own_text(w) + at, ' ', cast);
        if (words_behind_number(w->text + at + cast))
            memcpy(own_text(w) + at, "cast on", 7);
        return;
    }
    if (!inside && (heads_label(w->text + at) || words_row(w->text + at))) {
        w->cast_on = true;
        w->label = at;
        w->nlabel = heads_label(w->text + at);
        w->labelled |= w->nlabel > 0;
    }
    if (length && stop)
        memset(own_text(w) + at + digits, ' ', length - digits);
    else if (length)
        memset(own_text(w) + at, ' ', length);
    if (length && stop)
        own_text(w)[at + digits] = '.';
}

/* Of `Repeat rib rows 1 and 2` behind `Rib row 2:` the name goes; behind rows of another name it is a section's. */
static void put_labelled(struct wording *w, size_t rep)
{
    size_t at = rep + words_one_of("repeat|rep|work", w->text + rep), named, n;

    at += strspn(w->text + at, " ");
    named = at + (words_is(w->text + at, "the") ? strlen("the ") : 0);
    n = heads_rows_named(w->text + named);
    if (n && !w->labelled && w->heading && strncasecmp(w->text + named, w->written + w->heading, n - 1) == 0 && w->written[w->heading + n - 1] == ':')
        memset(own_text(w) + at, ' ', named + n - at);
    if (!n || !w->labelled)
        return;
    if (n == w->nlabel && strncasecmp(w->text + named, w->written + w->label, n) == 0)
        memset(own_text(w) + at, ' ', named + n - at);
    else if (words_one_of("repeat|rep", w->text + rep) && (w->nlabel || !words_one_of("pattern|patt|pat|main|stitch", w->text + named)))
        memcpy(own_text(w) + named, "section", strlen("section"));
}

/* Leaves of `Cast on as many sts as you like, in a multiple of 4` the multiple. */
static void put_multiple(struct wording *w, size_t at)
{
    size_t cast = at + words_one_of("cast on|cast-on|co", w->text + at), close, length = cast > at ? casts_many(w->text + cast, &close) : 0, by;

    if (!length)
        return;
    memset(own_text(w) + cast, ' ', length);
    if (close)
        own_text(w)[cast + close] = ' ';
    by = words_one_of("divisible by|evenly divisible by", w->text + cast + length);
    if (by)
        memcpy(memset(own_text(w) + cast + length, ' ', by), "multiple of", strlen("multiple of"));
}

/* Leaves of `Cast on a multiple of 4 (I used 24)` the number that was. */
static void put_example(struct wording *w, size_t at)
{
    size_t cast = at + words_one_of("cast on|cast-on|co", w->text + at), number, length = cast > at ? heads_example(w->text + cast, &number) : 0, digits;

    if (!length)
        return;
    number += cast;
    digits = strspn(w->text + number, "0123456789");
    memset(own_text(w) + cast, ' ', number - cast);
    memset(own_text(w) + number + digits, ' ', cast + length - number - digits);
}

/* Puts brackets for the inner pair of `*k2, **p1, k1** twice, p2; rep from *`. */
static void put_inner(struct wording *w, size_t at)
{
    size_t line = at, close = at + 2 + strcspn(w->text + at + 2, "*:(){}[]\r\n"), behind;

    if (strncmp(w->text + close, "**", 2) != 0 || w->text[close + 2] == '*')
        return;
    while (line > 0 && !strchr("\r\n:", w->text[line - 1]))
        line--;
    behind = phrases_skip(w->text, close + 2);
    if (line == 0 || w->text[line - 1] != ':' || !memchr(w->text + line, '*', at - line) || words_is(w->text + close - (close > 5 ? 5 : 0), "from") || !(isdigit((unsigned char)w->text[behind]) || words_one_of("twice|thrice|once|two|three|four|x", w->text + behind)))
        return;
    memcpy(own_text(w) + at, " (", 2);
    memcpy(own_text(w) + close, ") ", 2);
}

/* Where the sign + or # or ^ stands that `rep from +` names; or 0. */
static size_t named_sign(const char *text)
{
    static const char *const phrase[] = {"rep|repeat|rpt", "from|between|bet|btw", "the"};
    size_t at = 0;

    for (int i = 0; i < 3; i++) {
        size_t n = words_one_of(phrase[i], text + at);

        if (!n && i == 0)
            return 0;
        at += n + strspn(text + at + n, " \t");
    }
    return strchr("+#^@~", text[at]) && text[at] && !isalnum((unsigned char)text[at + 1]) ? at : 0;
}

/* Puts stars for the signs of `+k2, p2; rep from +`, where the row has one or a pair of them and no star. */
static void put_stars(struct wording *w, size_t rep)
{
    size_t sign = rep + named_sign(w->text + rep), first = 0, to = sign + 1, word;
    char c = w->text[sign];
    int n = 0;

    for (size_t at = rep; at > 0 && !strchr(":{}", w->text[at - 1]); at--) {
        if (w->text[at - 1] == '*')
            return;
        if (w->text[at - 1] == c) {
            first = at - 1;
            if (++n > 2)
                return;
        }
    }
    if (!n || !strchr("kKpP([", w->text[phrases_skip(w->text, first + 1)]))
        return;
    to += strspn(w->text + to, " \t");
    word = words_one_of("to|and|-", w->text + to);
    to += word + strspn(w->text + to + word, " \t");
    to = word && w->text[to] == c ? to : sign;
    for (char *text = own_text(w); first <= to; first++)
        if (text[first] == c)
            text[first] = '*';
}

/* Puts `k2 p2 rib` for `Rib: *k2, p2*` at the beginning of a sentence. */
static void put_described_rib(struct wording *w, size_t at)
{
    char plain[RIBS_PLAIN];
    size_t length = strchr("\n.;", words_sign_before(w->text, at, " \t")) ? ribs_length(w->text + at, plain) : 0;

    if (length)
        put_blanks(w, at, length, plain);
}

/* ---- rows that are rounds ---- */

/* `Row 1` is `Rnd 1`. */
static void put_rounds(struct wording *w)
{
    for (size_t at = 0, n; at < w->size; at += n ? n : 1) {
        n = words_length(w->text + at);
        if (n > 2 && n < 5 && strncasecmp(w->text + at, "row", 3) == 0 && (n == 3 || tolower((unsigned char)w->text[at + 3]) == 's') && (at == 0 || !isalnum((unsigned char)w->text[at - 1])))
            memcpy(own_text(w) + at + 1, "nd", 2);
    }
}

/* ---- the text ---- */

static bool begins_word(const struct wording *w, size_t at)
{
    return at == 0 || !isalnum((unsigned char)w->text[at - 1]);
}

/* Whether stitches are cast on behind a place. */
static bool casts_on_later(struct wording *w, size_t at)
{
    for (size_t i = w->size; !w->last_cast_on && i-- > at;)
        if ((w->text[i] | 0x20) == 'c' && begins_word(w, i) && prose_begins_cast_on(w->text + i))
            w->last_cast_on = i;
    return w->last_cast_on > at;
}

/* Puts a cast-on for `Multiple of 4 (I used 24)`, `An odd number of sts - I used 25`, where the page has no other. */
static void put_used(struct wording *w, size_t at)
{
    size_t number, length = words_one_of("multiple of|multiples of|even number|odd number|uneven number", w->text + at) ? heads_example(w->text + at, &number) : 0;
    size_t digits = length ? strspn(w->text + at + number, "0123456789") : 0;

    if (!length || w->cast_on || casts_on_later(w, at))
        return;
    memset(own_text(w) + at, ' ', number);
    memcpy(own_text(w) + at, "co", 2);
    memset(own_text(w) + at + number + digits, ' ', length - number - digits);
    w->cast_on = true;
}

/* `Middle:`, `Second half:`, and no more on the line. */
static bool is_part_name(const char *line)
{
    size_t n = strcspn(line, ":\r\n");

    return n > 0 && isalpha((unsigned char)*line) && line[n] == ':' && prose_line_ends(line + n + 1);
}

/* `*k1, p1* for 4 rows` is `for 4 rows:*k1, p1*`. */
static void put_repeated_row(struct wording *w, size_t at)
{
    char rows[64];
    size_t rest, n = fabrics_repeated(w->text + at, &rest);

    if (!n || rest >= sizeof rows)
        return;
    memcpy(rows, w->text + at + n, rest);
    memmove(own_text(w) + at + rest + 1, w->text + at, n - 1);
    memcpy(own_text(w) + at, rows, rest);
    own_text(w)[at + rest] = ':';
}

/* What a line begins with, behind its marks: the head of a part of the pattern, a dash of a list. */
static void put_line(struct wording *w, size_t at, int depth)
{
    size_t mark = at + strspn(w->text + at, " \t-");

    if (mark < w->size && !words_ends_line(w->text[mark]))
        put_head(w, mark, depth > 0 || goes_on(w, at));
    if (is_part_name(w->written + mark))
        w->heading = mark;
    put_repeated_row(w, mark);
    if (mark > at && w->text[mark - 1] == '-' && prose_statement_follows(w->text + mark))
        memset(own_text(w) + at, ' ', mark - at);
}

/* Takes the bracket around a whole row, `Row 1: {(k1, p1) to last st, k1} across`, and what is said of it. */
static void put_whole_row(struct wording *w, size_t at)
{
    size_t close = groups_close(w->text + at), end = at + close + 1;

    if (!close || !strchr("\n:", words_sign_before(w->text, at, " \t")) || !groups_fill_row(w->text + at, close))
        return;
    end += strspn(w->text + end, " ");
    end += words_one_of("across|to end|to the end", w->text + end);
    if (!prose_line_ends(w->text + end + (w->text[end] == '.'))) {
        own_text(w)[at] = '[';      /* `.. across for 5 rows`: refused as such */
        own_text(w)[at + close] = ']';
        return;
    }
    own_text(w)[at] = ' ';
    memset(own_text(w) + at + close, ' ', end - at - close);
}

/* Closes the bracket of `k2, (k1, p1 to last 2 sts), k2` where what is repeated ends. */
static void put_repeated(struct wording *w, size_t at)
{
    size_t close = groups_close(w->text + at), end = close && strchr(":,;.)*0123456789", words_sign_before(w->text, at, " \t")) ? groups_repeated(w->text + at, close) : 0;

    if (!end)
        return;
    own_text(w)[at + end] = w->text[at + close];
    own_text(w)[at + close] = ' ';
}

/* Brackets that only group: of further sizes, of a rib, braces of a measure or of stitches. */
static void put_brackets(struct wording *w, size_t at)
{
    char c = w->text[at];

    if (c && strchr("([{", c))
        put_whole_row(w, at);
    if (w->text[at] == '(' || w->text[at] == '[')
        put_repeated(w, at);
    if ((c == '(' || c == '[') && groups_of_star(w->text, at)) {
        size_t close = groups_of_star(w->text, at);

        own_text(w)[at] = own_text(w)[close] = ' ';
    }
    if ((c == '(' || c == '[') && groups_sizes(w->text, at, w->facts))
        memset(own_text(w) + at, ' ', groups_sizes(w->text, at, w->facts));
    if (c == '(' && groups_said_again(w->text, at))
        put_blanks(w, at, groups_said_again(w->text, at), "");
    if (w->text[at] == '(' && groups_rib(w->text + at))
        put_rib(w, at, groups_rib(w->text + at));
    if (c == '{' && groups_braces(w->text + at)) {
        own_text(w)[at + groups_braces(w->text + at) - 1] = ')';
        own_text(w)[at] = '(';
    }
}

/* What a word begins: `Cast on .. (I used 24)`, `Repeat rib rows ..`, `rep from +`. */
static void put_word(struct wording *w, size_t at)
{
    char c = begins_word(w, at) ? (char)tolower((unsigned char)w->text[at]) : '\0';

    if (c == 'c') {
        w->cast_on |= prose_begins_cast_on(w->text + at) > 0;
        put_multiple(w, at);
        put_example(w, at);
    }
    if (c && strchr("meou", c))
        put_used(w, at);
    if ((c == 'r' || c == 'w') && words_one_of("repeat|rep|work", w->text + at))
        put_labelled(w, at);
    if (c == 'r' && named_sign(w->text + at))
        put_stars(w, at);
}

/* Takes the yarn that whole rows are worked with. */
static void put_yarn(struct wording *w, size_t at)
{
    size_t length = 0;

    if (w->text[at] == '(' || w->text[at] == ',' || (w->text[at] && strchr("wWuUcCsSjJaAiIBDEFM", w->text[at]) && begins_word(w, at)))
        length = yarns_length(w->text, at, begins_sentence(w->text, at));
    if (length)
        put_blanks(w, at, length, "");
}

/* Takes a sentence on the edge stitches that rows name: it is a fact of the page. */
static void put_edges(struct wording *w, size_t at)
{
    enum edge_stitch kind;
    size_t length = isalnum((unsigned char)w->text[at]) ? edge_stitches_length(w->text, at, &kind) : 0;

    if (length && kind != EDGE_UNCLEAR)
        put_blanks(w, at, length, "");
}

/* The turns of phrase that begin at a place. */
static void put_phrases(struct wording *w, size_t at)
{
    if (!isgraph((unsigned char)w->text[at]))
        return;
    put_phrase(w, w->printed, turns_of_books, at);
    put_phrase(w, w->phrases, turns_of_pages, at);
}

/* Behind the word, or the sign, that stands at a place. */
static size_t behind_word(const struct wording *w, size_t at)
{
    bool word = isalnum((unsigned char)w->text[at++]);

    while (word && at < w->size && isalnum((unsigned char)w->text[at]))
        at++;
    return at;
}

const char *wording_plain(struct arena *arena, const char *text, size_t size, const struct page_facts *facts)
{
    struct wording w = {.arena = arena, .text = text, .size = size, .facts = facts, .written = text,
                        .phrases = phrases_read(arena, turns_of_pages, turns_of_pages_number),
                        .printed = phrases_read(arena, turns_of_books, turns_of_books_number)};
    struct words_line line = {0};
    int depth = 0;

    put_printed(&w);
    if (facts->rounds)
        put_rounds(&w);
    for (size_t at = 0; at < size;) {
        if (words_line_is_long(&line, w.text, at)) {
            depth = words_depth(w.text + at, line.end - at, depth);
            at = line.end;
            continue;
        }
        if (w.text[at] == '"') {
            at = words_skip_quoted(w.text, at);
            continue;
        }
        if (w.text[at] && strchr("rRkK123456", w.text[at]) && begins_word(&w, at))
            put_described_rib(&w, at);
        if (at == 0 || strchr("\r\n", w.text[at - 1]))
            put_line(&w, at, depth);
        at += stitches_length(w.text + at);
        put_brackets(&w, at);
        if (strncmp(w.text + at, "**", 2) == 0 && w.text[at + 2] != '*')
            put_inner(&w, at);
        put_word(&w, at);
        if (depth == 0)
            put_yarn(&w, at);
        if (facts->edges)
            put_edges(&w, at);
        depth += w.text[at] == '{' ? 1 : w.text[at] == '}' && depth > 0 ? -1 : 0;
        put_sign(&w, at);
        put_phrases(&w, at);
        at = behind_word(&w, at);
    }
    return w.text;
}
