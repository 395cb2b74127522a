/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with its rows on lines of their own out: the heads of a line, `Row 1 - ..  Row 2 - ..`,
 * whose numbers count on. */
#include "lang/page/run_on.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "lang/page/headings.h"
#include "lang/page/prose.h"
#include "lang/page/repeats.h"
#include "lang/page/words.h"

/* The head of a row: its first and last number, and what its mark is followed by. */
struct head {
    int         first, last;
    const char *behind;     /* NULL: there is none */
};

/* Behind `:`, or ` - `. */
static const char *behind_mark(const char *text)
{
    text = words_skip_blanks(text);
    return *text == ':' || (*text == '-' && text[1] == ' ') ? words_skip_blanks(text + 1) : NULL;
}

/* `6 - 10 -`, `2:`, the numbers of `Rows`. */
static struct head numbers_head(const char *text)
{
    const char *end = text + strspn(text, "0123456789"), *next = words_skip_blanks(end);
    struct head head = {words_number(text), words_number(text), behind_mark(end)};

    if (end == text || end - text > 4)
        return (struct head){0};
    next = *next == '-' || *next == '&' ? words_skip_blanks(next + 1) : words_is(next, "and") || words_is(next, "to") ? words_next(next) : next;
    if (next > words_skip_blanks(end) && isdigit((unsigned char)*next) && behind_mark(next + strspn(next, "0123456789")))
        head = (struct head){head.first, words_number(next), behind_mark(next + strspn(next, "0123456789"))};
    return head;
}

/* `Row 2 -`, `R2:`, `2nd row:`, `2.row:` */
static struct head head_at(const char *text)
{
    size_t ordinal = words_ordinal_length(text), digits = strspn(text, "0123456789");
    const char *row;

    if (words_are_rows(text) || ((*text | 0x20) == 'r' && isdigit((unsigned char)text[1])))
        return numbers_head(words_next(text));
    if (!ordinal && (!digits || digits > 4 || text[digits] != '.'))
        return (struct head){0};
    row = words_skip_blanks(text + (ordinal ? ordinal : digits + 1));
    return words_are_rows(row) ? (struct head){words_number(text), words_number(text), behind_mark(row + words_length(row))} : (struct head){0};
}

/* Whether what stands behind a head is a row: `k2`, `4 k`, `knit`, `as R3`. */
static bool is_row(const char *text)
{
    const char *turned = words_skip_blanks(text + strspn(text, "0123456789"));

    if (words_is(text, "as") && (words_next(text)[0] | 0x20) == 'r')
        return isdigit((unsigned char)words_next(text)[1]) || words_are_rows(words_next(text));
    return words_are(turned, WORDS_PLAIN) || prose_stitches_follow(text);
}

/* Whether a row may end behind so many bytes of a line: with a figure or a sign, or a word that ends rows. */
static bool row_ends(const char *line, size_t n)
{
    static const char *const across[] = {"across", "around", "row", "more"};
    const unsigned last = WORDS_PLAIN | WORDS_STITCH | WORDS_TIMES | WORDS_OFTEN | WORDS_END;
    size_t word;

    while (n > 0 && strchr(" \t", line[n - 1]))
        n--;
    for (word = n; word > 0 && isalpha((unsigned char)line[word - 1]);)
        word--;
    return word == n ? n > 0 && !strchr("&(-", line[n - 1]) : words_are(line + word, last) || words_find(line + word, across, 4) >= 0;
}

/* Whether a line's first row may stand there: at its beginning, behind a sentence, or row 1 apart from it. */
static bool begins(const char *line, size_t at, const struct head *head)
{
    bool apart = at > 2 && strspn(line + at - 3, " \t*") > 2;

    return (apart && head->first == 1) || strchr(head->first == 1 ? "\n.:;" : "\n", words_sign_before(line, at, " \t*"));
}

/* `K Repeat these 10 rows`, `k4 Repeat rows 1-4`: another sentence behind the rows. */
static bool repeats(const char *line, size_t at)
{
    size_t length;

    if (words_sign_before(line, at, " \t") == ':')  /* `Rows 3 to 6: Repeat rows 1 and 2 twice` */
        return false;
    return line[at] == 'R' && words_are(line + at, WORDS_AGAIN) && row_ends(line, at) && repeats_kind(line + at, &length) != 0;
}

/* Puts an end for the blank before each of a line's rows that count on, and what is repeated behind them. */
static void part_rows(char *line, size_t length)
{
    int last = 0;
    struct head head;

    for (size_t at = 0; at < length; at++) {
        if (last && strchr(" \t", line[at - 1]) && repeats(line, at))
            line[at - 1] = '\n';
        if ((at > 0 && !strchr(" \t.", line[at - 1])) || !(head = head_at(line + at)).behind || !is_row(head.behind))
            continue;
        if (last ? head.first == last + 1 && row_ends(line, at) : begins(line, at, &head)) {
            if (last || strspn(line, " \t*") < at)
                line[at - 1] = '\n';
            last = head.last;
        }
    }
}

/* ---- the cast-on behind a page's materials ---- */

/* `: Cast on 60 stitches`, `DISHCLOTH Cast on 46 sts`: whether it is behind a mark, or a heading's word. */
static bool is_behind_heading(const char *line, size_t at)
{
    size_t n = at, word;

    while (n > 0 && strchr(" \t", line[n - 1]))
        n--;
    for (word = n; word > 0 && isupper((unsigned char)line[word - 1]);)
        word--;
    return n < at && n > 0 && (strchr(".:!", line[n - 1]) || (n - word > 2 && (word == 0 || strchr(" \t", line[word - 1]))));
}

/* Behind `first row`, `1st row`; NULL: another text. */
static const char *behind_nth(const char *text)
{
    size_t ordinal = words_ordinal_length(text);
    const char *rows = ordinal ? words_skip_blanks(text + ordinal) : words_are(text, WORDS_NTH) ? words_next(text) : NULL;

    return rows && words_are_rows(rows) ? rows + words_length(rows) : NULL;
}

/* Whether a row begins, `Row 1: k2`, `First row--`, or several, `Knit 4 rows`. */
static bool works_rows(const char *text)
{
    const char *nth = behind_nth(text);

    if (nth)
        return !isalnum((unsigned char)*words_skip_blanks(nth));
    return words_row(text) ? prose_pattern_follows(text) : words_are(text, WORDS_PLAIN | WORDS_WORK) && prose_rows_follow(words_next(text));
}

/* Whether a row is named among so many bytes, or, `worked`, is worked there. */
static bool has_row(const char *line, size_t length, bool worked)
{
    for (size_t at = 0; at < length; at++)
        if ((at == 0 || strchr(" \t.", line[at - 1])) && (worked ? works_rows(line + at) : behind_nth(line + at) || words_row(line + at)))
            return true;
    return false;
}

/* Where a line whose beginning asks for no work has its cast-on, and rows behind it; 0: nowhere. */
static size_t cast_on_within(const char *line, size_t length)
{
    size_t heading;
    bool prose = prose_reads(line, false) && !headings_find(line, &heading);    /* whose reader finds it behind a stop */

    for (size_t at = 1; at < length && !prose_statement_follows(line); at++) {
        size_t on = line[at] == 'C' && is_behind_heading(line, at) ? prose_begins_cast_on(line + at) : 0;
        const char *sts = on ? words_behind_number(words_skip_blanks(line + at + on)) : NULL;

        if (sts && words_are_stitches(sts))
            return !(prose && words_sign_before(line, at, " \t") == '.') && !has_row(line, at, false) && has_row(sts, length - (size_t)(sts - line), true) ? at : 0;
    }
    return 0;
}

/* ---- lines ---- */

/* How many heads of rows stand on a line. */
static int count_heads(const char *line, size_t length)
{
    int n = 0;

    for (size_t at = 0; at < length; at++)
        n += (at == 0 || strchr(" \t.", line[at - 1])) && head_at(line + at).behind;
    return n;
}

/* Whether the stitches are cast on there, or the first row is worked. */
static bool begins_work(const char *line)
{
    line += strspn(line, " \t*_-");
    return prose_begins_cast_on(line) || words_row(line);
}

const char *run_on_plain(struct arena *arena, const char *text, size_t size)
{
    char *own = NULL;
    bool begun = false;     /* a cast-on or a row came before */

    for (size_t at = 0, length, cast_on; at < size; at += length + 1) {
        length = words_line_within(text + at, size - at);
        begun |= begins_work(text + at);
        cast_on = begun || length > WORDS_LINE ? 0 : cast_on_within(text + at, length);
        if (!cast_on && (length > WORDS_LINE || count_heads(text + at, length) < 2))
            continue;
        own = own ? own : arena_copy(arena, text, size);
        if (cast_on)
            own[at + cast_on - 1] = '\n';
        part_rows(own + at + cast_on, length - cast_on);
        begun = true;
    }
    return own ? own : text;
}
