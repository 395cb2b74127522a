/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a printed book in, what stands for it plainly out: `_Second row._--The same.`
 * is `2nd row: as 1`. */
#include "lang/printed.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/words.h"

enum { LABEL = 40, HEAD = 100, MARKED = 200, LOOK_BACK = 500 };

static bool begins_word(const char *text, size_t at)
{
    return at == 0 || !isalnum((unsigned char)text[at - 1]);
}

static size_t blanks(const char *text)
{
    return strspn(text, " \t");
}

/* Where the line begins, or so far before `at` as is looked back. */
static size_t line_within(const char *text, size_t at, size_t most)
{
    size_t line = at;

    while (line > 0 && at - line < most && !strchr("\r\n", text[line - 1]))
        line--;
    return line;
}

static size_t line_start(const char *text, size_t at)
{
    return line_within(text, at, LOOK_BACK);
}

/* Where the word begins that ends before `at`, blanks and a full stop aside. */
static size_t word_before(const char *text, size_t at)
{
    while (at > 0 && strchr(" \t.", text[at - 1]))
        at--;
    while (at > 0 && isalpha((unsigned char)text[at - 1]))
        at--;
    return at;
}

/* A long dash, or two hyphens or more: its bytes. */
static size_t dash_length(const char *text)
{
    size_t hyphens = strspn(text, "-");

    if (hyphens > 1)
        return hyphens;
    return strncmp(text, "\xE2\x80\x93", 3) == 0 || strncmp(text, "\xE2\x80\x94", 3) == 0 || strncmp(text, "\xE2\x80\x95", 3) == 0 ? 3 : 0;
}

/* ---- marks of a typed book ---- */

static bool opens_italics(const char *text, size_t at)
{
    return text[at] == '_' && (at == 0 || !(isalnum((unsigned char)text[at - 1]) || strchr("_}\"", text[at - 1]))) && isalnum((unsigned char)text[at + 1]);
}

static bool closes_italics(const char *text, size_t at)
{
    return text[at] == '_' && at > 0 && (isalnum((unsigned char)text[at - 1]) || strchr(".,:;)", text[at - 1])) && !isalnum((unsigned char)text[at + 1]) && text[at + 1] != '_';
}

/* Whether the underscores that stand here mark several words, or one with its stop: a name has neither. */
static bool marks_words(const char *text, size_t open, size_t close)
{
    return close > open + 1 && close - open < MARKED && (memchr(text + open, ' ', close - open) || strchr(".,:;", text[close - 1]));
}

static bool is_italics(const char *text, size_t at)
{
    size_t other = at;

    if (opens_italics(text, at)) {
        for (other++; text[other] && other - at < MARKED && !closes_italics(text, other) && !opens_italics(text, other);)
            other++;
        return closes_italics(text, other) && marks_words(text, at, other);
    }
    if (!closes_italics(text, at))
        return false;
    for (other--; other > 0 && at - other < MARKED && !opens_italics(text, other) && !closes_italics(text, other);)
        other--;
    return opens_italics(text, other) && marks_words(text, other, at);
}

static bool sentence_ends(const char *text)
{
    text += blanks(text);
    return !*text || strchr(".;,\r\n", *text);
}

/* `=1st row.=--Plain` at the beginning of a line. */
static bool is_bold(const char *text, size_t at)
{
    size_t line = line_start(text, at), close = line + 1;

    if (text[line] != '=' || !isalpha((unsigned char)text[line + 1]))
        return false;
    close += strcspn(text + close, "=\r\n");
    return text[close] == '=' && text[close + 1] != '=' && text[close - 1] != ' ' && !sentence_ends(text + close + 1) && (at == line || at == close);
}

/* `[Illustration: ..]`, `[Pg 12]` */
static size_t note_length(const char *text)
{
    static const char *const word[] = {"illustration", "pg", "page", "footnote", "transcriber"};
    size_t close = strcspn(text, "]={}");

    if (words_find(text + 1, word, sizeof word / sizeof *word) < 0 || text[close] != ']' || close > MARKED)
        return 0;
    return words_length(text + 1) > 4 || isdigit((unsigned char)text[1 + words_length(text + 1) + 1]) ? close + 1 : 0;
}

size_t printed_mark(const char *text, size_t at)
{
    switch (text[at]) {
    case '_':
        return is_italics(text, at);
    case '=':
        return is_bold(text, at);
    case '[':
        return note_length(text + at);
    default:
        return 0;
    }
}

/* ---- ordinals ---- */

/* `first`, `Twenty-second`: its bytes, and the number. */
static size_t letters_length(const char *text, int *number)
{
    static const char *const ones[] = {"first",    "second",   "third",      "fourth",     "fifth",     "sixth",     "seventh",     "eighth",     "ninth",     "tenth",
                                       "eleventh", "twelfth",  "thirteenth", "fourteenth", "fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth"},
                             *const tens[] = {"twentieth", "thirtieth", "fortieth", "fiftieth"}, *const first[] = {"twenty", "thirty", "forty", "fifty"};
    size_t n = words_length(text), behind = n + strspn(text + n, "- ");
    int one = words_find(text, ones, 19), ten = words_find(text, tens, 4), begun = words_find(text, first, 4);

    if (begun >= 0 && (one = words_find(text + behind, ones, 9)) >= 0) {
        *number = 20 + 10 * begun + one + 1;
        return behind + words_length(text + behind);
    }
    *number = ten >= 0 ? 20 + 10 * ten : one + 1;
    return begun < 0 && *number > 0 ? n : 0;
}

/* `3rd`, `third`: its bytes, and the number. */
static size_t ordinal_length(const char *text, int *number)
{
    static const char *const ends[] = {"st", "nd", "rd", "th"};
    size_t n = strspn(text, "0123456789");

    if (!n)
        return letters_length(text, number);
    *number = n < 6 ? atoi(text) : 0;
    return n < 6 && words_find(text + n, ends, 4) >= 0 ? n + words_length(text + n) : 0;
}

/* ---- heads of rows ---- */

/* `, and`, `to`, `--` between ordinals: its bytes. */
static size_t join_length(const char *text)
{
    static const char *const words[] = {"and", "to", "or"};
    size_t at = blanks(text);

    at += text[at] == ',' || text[at] == '&' || text[at] == '-' ? 1 : dash_length(text + at);
    at += blanks(text + at);
    at += words_find(text + at, words, 3) >= 0 ? words_length(text + at) : 0;
    return at == blanks(text) ? 0 : at + blanks(text + at);
}

/* `6th, 7th, and 8th rows`: its bytes. */
static size_t rows_length(const char *text)
{
    size_t at = 0, n, join;
    int number;

    while ((n = ordinal_length(text + at, &number)) > 0) {
        at += n;
        join = join_length(text + at);
        if (!join || !ordinal_length(text + at + join, &number))
            break;
        at += join;
    }
    n = at + blanks(text + at);
    return at > 0 && n > at && words_are_rows(text + n) ? n + words_length(text + n) : 0;
}

/* What ends a row's head: a colon, a full stop, a dash, a side in brackets. */
static bool head_ends(const char *text)
{
    text += blanks(text);
    return (*text && strchr(":.(", *text)) || dash_length(text) || strncmp(text, "- ", 2) == 0;
}

/* Whether the head of a row may end here: with its number, a side, brackets. */
static bool may_end_head(const char *text, size_t end)
{
    static const char *const words[] = {"rs", "ws", "side", "facing", "incl", "inclusive"};
    size_t word = word_before(text, end);

    return end > 0 && (isdigit((unsigned char)text[end - 1]) || strchr(")]", text[end - 1]) || words_are_rows(text + word) || words_find(text + word, words, 6) >= 0);
}

/* Where the head begins of the row whose text begins at `at`; or `at`. */
static size_t head_of(const char *text, size_t at)
{
    size_t end = at, line;

    while (end > 0 && strchr(" \t:-\xE2\x80\x93\x94\x95", text[end - 1]))
        end--;
    end -= end > 0 && text[end - 1] == '.';
    if (strspn(text + end, " \t") == at - end || !may_end_head(text, end))
        return at;
    line = line_within(text, end, HEAD);
    if (end - line == HEAD)
        return at;
    for (size_t i = line; i < end; i++)
        if (begins_word(text, i) && words_are_rows(text + i))
            return memchr(text + line, ':', end - line) ? at : line;
    return at;
}

/* The row before those that the head names; 0: none. */
static int row_before(const char *text, size_t head)
{
    size_t n = strcspn(text + head, "0123456789:\r\n");

    return isdigit((unsigned char)text[head + n]) ? atoi(text + head + n) - 1 : 0;
}

/* ---- rows told by others ---- */

/* `the`, `in the`, `for the`: its bytes, with the blanks behind. */
static size_t article_length(const char *text)
{
    static const char *const words[] = {"in", "for", "the"};
    size_t at = 0;

    for (int i = 0; i < 2 && words_find(text + at, words, 3) >= 0; i++) {
        at += words_length(text + at);
        at += blanks(text + at);
    }
    return at;
}

/* `same as the fourth row`, `like the 1st and 2nd rows of pattern`, behind the words before the first ordinal. */
static size_t others_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const of[] = {"of"}, *const pattern[] = {"pattern", "patt"};
    int first, second = 0;
    bool range;
    size_t at = ordinal_length(text, &first), join, n;

    if (!at)
        return 0;
    join = join_length(text + at);
    range = words_is(text + at + blanks(text + at), "to");
    join += article_length(text + at + join);
    n = join ? ordinal_length(text + at + join, &second) : 0;
    at += n ? join + n : 0;
    n = at + blanks(text + at);
    at = words_are_rows(text + n) ? n + words_length(text + n) : at;
    n = at + blanks(text + at);
    if (words_find(text + n, of, 1) == 0) {
        n += 2 + blanks(text + n + 2);
        n += article_length(text + n);
        at = words_find(text + n, pattern, 2) >= 0 ? n + words_length(text + n) : at;
    }
    if (second)
        snprintf(plain, PRINTED_PLAIN, "as %d %s %d", first, range ? "to" : "and", second);
    else
        snprintf(plain, PRINTED_PLAIN, "as %d", first);
    return at;
}

/* A row's text that names others: `The same.`, `Work as in the 1st row`, `Repeat second row`. */
static size_t as_length(const char *text, size_t at, size_t head, char plain[static PRINTED_PLAIN])
{
    static const char *const lead[] = {"work", "knit", "the", "same", "just", "exactly"}, *const as[] = {"as", "like", "repeat", "rep"};
    const char *here = text + at;
    size_t n = 0, others;
    bool same = false;

    while (words_find(here + n, lead, 6) >= 0) {
        same |= words_find(here + n, lead + 3, 1) == 0;
        n += words_length(here + n);
        n += blanks(here + n);
    }
    if (same && sentence_ends(here + n) && row_before(text, head) > 0) {
        while (n > 0 && here[n - 1] == ' ')
            n--;
        snprintf(plain, PRINTED_PLAIN, "as %d", row_before(text, head));
        n += here[n] == '.' && strlen(plain) > n;
        return strlen(plain) <= n ? n : 0;
    }
    if (words_find(here + n, as, 4) < 0)
        return 0;
    n += words_length(here + n);
    n += here[n] == '.';
    n += blanks(here + n);
    n += article_length(here + n);
    others = others_length(here + n, plain);
    return others && strlen(plain) <= n + others ? n + others : 0;
}

/* A row that is `Plain.` all across. */
static size_t plain_length(const char *text)
{
    static const char *const plain[] = {"plain"}, *const knitting[] = {"knitting", "across", "throughout"};
    size_t n = words_find(text, plain, 1) == 0 ? 5 : 0, behind = n + strspn(text + n, "- ");

    if (n && words_find(text + behind, knitting, 3) >= 0)
        n = behind + words_length(text + behind);
    return n && sentence_ends(text + n) ? n : 0;
}

/* ---- full stops and dashes ---- */

/* Whether a figure follows that counts stitches: `K. 2`, `P.1`; not `K. 2nd row`, nor `K. 2. P.` of a numbered list. */
static bool counts_stitches(const char *text)
{
    size_t at = blanks(text), n = strspn(text + at, "0123456789");
    int number;

    if (!n || ordinal_length(text + at, &number))
        return false;
    at += n;
    if (text[at] != '.' || !strchr("kKpP", text[at + 1 + blanks(text + at + 1)]))
        return true;
    at += 2 + blanks(text + at + 1);
    at += text[at] == '.';
    return isalnum((unsigned char)text[at + blanks(text + at)]);
}

/* Whether a label of a few words ends here, or a row's head: the dash behind it is its colon. */
static bool is_label(const char *text, size_t at)
{
    size_t line = line_start(text, at), words = 0;

    if (words_are_rows(text + word_before(text, at)) && word_before(text, at) < at)
        return true;
    for (size_t i = line; i < at; i++) {
        words += isalpha((unsigned char)text[i]) && begins_word(text, i);
        if (strchr(",:;*", text[i]) || dash_length(text + i))
            return false;
    }
    return words > 0 && words < 5 && at - line < LABEL;
}

static bool has_figure(const char *text, size_t from, size_t to)
{
    while (from < to && !isdigit((unsigned char)text[from]))
        from++;
    return from < to;
}

/* Whether a cast-on follows, of so many: `Bib.  Cast on 25 sts.` */
static bool cast_on_follows(const char *text)
{
    text += blanks(text);
    if (words_is(text, "cast"))
        text += 4 + strspn(text + 4, " -");
    return (words_is(text, "on") || words_is(text, "co")) && words_behind_number(text + 2 + blanks(text + 2));
}

/* A full stop and what goes with it. */
static size_t stop_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    static const char *const no[] = {"no", "nos"}, *const referring[] = {"rep", "as", "work", "then", "from", "and", "patt"};
    size_t word = word_before(text, at), dash = dash_length(text + at + 1), behind = at + 1 + blanks(text + at + 1);
    bool letter = word + 1 == at && begins_word(text, word) && strchr("kKpP", text[word]);

    if (text[at + 1] == ')')
        return 1;
    dash += !dash && text[at + 1] == '-' && words_are_rows(text + word);
    if (letter && counts_stitches(text + at + 1))
        return 1;
    if (dash) {
        strcpy(plain, is_label(text, at) ? ":" : ".");
        return 1 + dash;
    }
    if (words_find(text + word, no, 2) >= 0 && isdigit((unsigned char)text[behind]))
        return 1;
    if (behind > at + 1 && rows_length(text + behind) && head_ends(text + behind + rows_length(text + behind)) && words_find(text + word, referring, 7) < 0) {
        strcpy(plain, "\n");
        return 1;
    }
    if (cast_on_follows(text + at + 1) && is_label(text, at) && !has_figure(text, line_start(text, at), at)) {
        strcpy(plain, "\n");
        return 1;
    }
    return 0;
}

/* `:--`, `:-`, a printer's colon. */
static size_t colon_length(const char *text)
{
    size_t dash = dash_length(text + 1);

    dash += !dash && text[1] == '-' && strchr(" \t\r\n", text[2]);
    return dash ? 1 + dash : 0;
}

/* ---- ribs without their name ---- */

/* `knit two`, `P. 3`: its bytes, and how many. */
static size_t stitches_of(const char *text, char letter, int *number)
{
    static const char *const word[] = {"one", "two", "three", "four", "five", "six", "seven", "eight"};
    size_t at = words_length(text), n;

    if (tolower((unsigned char)*text) != letter || !(at == 1 || words_is(text, letter == 'k' ? "knit" : "purl")))
        return 0;
    at += text[at] == '.';
    at += blanks(text + at);
    n = strspn(text + at, "0123456789");
    *number = n ? atoi(text + at) : 1 + words_find(text + at, word, 8);
    return *number > 0 && n < 3 ? at + (n ? n : words_length(text + at)) : 0;
}

/* `Knit 2, purl 2 for 6 rows` at the beginning of a sentence, up to `for`: a rib. */
static size_t rib_length(const char *text, char plain[static PRINTED_PLAIN])
{
    int knit, purl;
    size_t at = stitches_of(text, 'k', &knit), n;
    const char *rows;

    if (!at)
        return 0;
    at += strspn(text + at, ", ");
    at += words_is(text + at, "and") ? 3 + blanks(text + at + 3) : 0;
    n = stitches_of(text + at, 'p', &purl);
    at += n + strspn(text + at + n, ", ");
    rows = words_behind_number(text + at + 3 + blanks(text + at + 3));
    if (!n || !words_is(text + at, "for") || !rows || !words_are_rows(rows))
        return 0;
    snprintf(plain, PRINTED_PLAIN, "k%d p%d rib", knit, purl);
    return at + 3;
}

/* Whether a sentence begins at `at`, or `work in` stands before. */
static bool begins_sentence(const char *text, size_t at)
{
    static const char *const then[] = {"then", "now", "in", "of"};

    while (at > 0 && strchr(" \t", text[at - 1]))
        at--;
    if (at == 0 || strchr("\r\n.;", text[at - 1]))
        return true;
    at = word_before(text, at);
    return words_find(text + at, then, 4) >= 2 || (words_find(text + at, then, 2) >= 0 && begins_sentence(text, at));
}

/* ---- others ---- */

/* `re-` at a line's end and `peat` on the next: the word, for both and the hyphen. */
static size_t broken_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const word[] = {"repeat", "stitch", "stitches", "ending", "remaining", "pattern", "across", "purl", "knitting"};
    size_t n = words_length(text), behind = n + 1 + strspn(text + n + 1, "\r\n \t"), m = words_length(text + behind);

    if (!n || text[n] != '-' || !strchr("\r\n", text[n + 1]) || !text[n + 1] || n + m + 1 > PRINTED_PLAIN)
        return 0;
    memcpy(plain, text, n);
    memcpy(plain + n, text + behind, m);
    plain[n + m] = '\0';
    return words_find(plain, word, sizeof word / sizeof *word) >= 0 ? behind + m : 0;
}

/* `stitches in tens`, `stitches in threes`: a multiple. */
static size_t tens_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const in[] = {"in"}, *const many[] = {"twos", "threes", "fours", "fives", "sixes", "sevens", "eights", "nines", "tens", "elevens", "twelves"};
    size_t at = words_are_stitches(text) ? words_length(text) + blanks(text + words_length(text)) : 0;
    int n;

    if (!at || words_find(text + at, in, 1) < 0)
        return 0;
    at += 2 + blanks(text + at + 2);
    n = words_find(text + at, many, sizeof many / sizeof *many);
    snprintf(plain, PRINTED_PLAIN, "mult of %d", n + 2);
    at += words_length(text + at);
    return n >= 0 && strlen(plain) <= at ? at : 0;
}

/* `(Swatch: ` before a cast-on, on the line of a multiple: a line of its own begins. */
static size_t sample_length(const char *text, size_t at)
{
    size_t n = 1, line;

    for (int words = 0; words < 3 && !words_is(text + at + n, "cast") && !words_is(text + at + n, "co") && words_length(text + at + n) > 0; words++) {
        n += words_length(text + at + n);
        n += strspn(text + at + n, " :,");
    }
    if (!cast_on_follows(text + at + n))
        return 0;
    line = line_start(text, at);
    return words_line_has(text + line, "multiple") || words_line_has(text + line, "multiples") ? n : 0;
}

/* `3 times in all` behind `rep from *`: so many more, one less. */
static size_t in_all_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    static const char *const in[] = {"in"}, *const all[] = {"all", "total"}, *const time[] = {"times", "time"};
    size_t n = (size_t)(words_behind_number(text + at) ? words_behind_number(text + at) - text - at : 0), line;
    int number = n ? atoi(text + at) : 0;

    if (number < 2 || words_find(text + at + n, time, 2) < 0)
        return 0;
    line = line_start(text, at);
    if (!memchr(text + line, '*', at - line))
        return 0;
    n += words_length(text + at + n) + blanks(text + at + n + words_length(text + at + n));
    if (words_find(text + at + n, in, 1) < 0 || words_find(text + at + n + 3, all, 2) < 0)
        return 0;
    n += 3 + words_length(text + at + n + 3);
    snprintf(plain, PRINTED_PLAIN, "%d more times", number - 1);
    return strlen(plain) <= n ? n : 0;
}

/* `an even number of sts (16)`: so many. */
static size_t count_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const word[] = {"a", "an", "any", "even", "odd", "uneven", "number", "of"};
    size_t at = 0, n;

    while (words_find(text + at, word, 8) >= 0) {
        at += words_length(text + at);
        at += blanks(text + at);
    }
    if (!at || !words_are_stitches(text + at))
        return 0;
    at += words_length(text + at);
    at += blanks(text + at);
    n = strspn(text + at + 1, "0123456789");
    if (text[at] != '(' || !n || n > 4 || text[at + 1 + n] != ')')
        return 0;
    snprintf(plain, PRINTED_PLAIN, "%d sts", atoi(text + at + 1));
    return at + n + 2;
}

/* `the` or `from` of `repeat the 5th and 6th rows`. */
static size_t lead_length(const char *text, size_t at)
{
    static const char *const words[] = {"the", "from"}, *const leads[] = {"repeat", "rep", "work", "then"};
    size_t n = words_find(text + at, words, 2) >= 0 ? words_length(text + at) : 0;

    return n && rows_length(text + at + n + blanks(text + at + n)) && words_find(text + word_before(text, at), leads, 4) >= 0 ? n : 0;
}

/* A word that begins at `at`, by its first letter. */
static size_t word_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    const char *here = text + at;
    size_t length = broken_length(here, plain), head;
    char c = (char)tolower((unsigned char)*here);

    if (!length && c == 'k' && begins_sentence(text, at))
        length = rib_length(here, plain);
    if (!length && c == 's')
        length = tens_length(here, plain);
    if (!length && strchr("tf", c))
        length = lead_length(text, at);
    if (!length && strchr("aeuon", c))
        length = count_length(here, plain);
    if (length || !strchr("wtsjealrpk", c) || (head = head_of(text, at)) == at)
        return length;
    length = as_length(text, at, head, plain);
    if (!length && plain_length(here))
        strcpy(plain, "knit");
    return length ? length : plain_length(here);
}

/* `First row`: `1st row`. */
static size_t in_figures(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const ends[] = {"th", "st", "nd", "rd"};
    int number;
    size_t length = strchr("fstenFSTEN", *text) && rows_length(text) ? letters_length(text, &number) : 0;

    if (length)
        snprintf(plain, PRINTED_PLAIN, "%d%s", number, ends[number % 10 < 4 && number / 10 != 1 ? number % 10 : 0]);
    return length;
}

size_t printed_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    const char *here = text + at;
    size_t length;

    *plain = '\0';
    if (*here == '.')
        return at > 0 ? stop_length(text, at, plain) : 0;
    if (*here == '(' && (length = sample_length(text, at))) {
        strcpy(plain, "\n");
        return length;
    }
    if (*here == ':' && colon_length(here)) {
        strcpy(plain, ":");
        return colon_length(here);
    }
    if (!isalnum((unsigned char)*here) || !begins_word(text, at))
        return 0;
    if ((length = in_all_length(text, at, plain)) || isdigit((unsigned char)*here))
        return length;
    length = word_length(text, at, plain);
    return length ? length : in_figures(here, plain);
}
