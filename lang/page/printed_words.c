/* SPDX-License-Identifier: GPL-3.0-or-later
 * Words of a printed book in, what stands for them plainly out: `Knit 2, purl 2 for 6 rows` is a rib. */
#include <stdio.h>
#include <stdlib.h>

#include "lang/page/printed_parts.h"

/* ---- ribs without their name ---- */

/* `knit two`, `P. 3`: its bytes, and how many. */
static size_t stitches_of(const char *text, char letter, int *number)
{
    static const char *const word[] = {"one", "two", "three", "four", "five", "six", "seven", "eight"};
    size_t at = words_length(text), n;

    if (tolower((unsigned char)*text) != letter || !(at == 1 || words_is(text, letter == 'k' ? "knit" : "purl")))
        return 0;
    at += text[at] == '.';
    at += print_blanks(text + at);
    n = strspn(text + at, "0123456789");
    *number = n ? atoi(text + at) : 1 + words_find(text + at, word, 8);
    return *number > 0 && n < 3 ? at + (n ? n : words_length(text + at)) : 0;
}

/* `2 plain`, `two purl`: the same. */
static size_t turned_of(const char *text, char letter, int *number)
{
    static const char *const plain[] = {"plain", "knit", "k"}, *const purl[] = {"purl", "p", "pearl", "seam"};
    const char *behind = words_behind_number(text);

    *number = behind ? atoi(text) : 0;
    if (!*number || words_find(behind, letter == 'k' ? plain : purl, letter == 'k' ? 3 : 4) < 0)
        return 0;
    return (size_t)(behind - text) + words_length(behind);
}

/* `Knit 2, purl 2 for 6 rows`, `Rib 2 plain, 2 purl for 6 rows` at the beginning of a sentence, up to `for`: a rib. */
static size_t rib_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const work[] = {"knit", "k", "rib", "work"};
    int knit, purl;
    size_t at = stitches_of(text, 'k', &knit), lead, n;
    bool turned = !at || words_is(text + at + print_blanks(text + at), "plain");
    const char *rows;

    if (turned) {
        lead = words_find(text, work, 4) >= 0 ? words_length(text) : 0;
        lead += print_blanks(text + lead);
        at = turned_of(text + lead, 'k', &knit);
        at += at ? lead : 0;
    }
    if (!at)
        return 0;
    at += strspn(text + at, ", ");
    at += words_is(text + at, "and") ? 3 + print_blanks(text + at + 3) : 0;
    n = turned ? turned_of(text + at, 'p', &purl) : stitches_of(text + at, 'p', &purl);
    at += n + strspn(text + at + n, ", ");
    rows = words_behind_number(text + at + 3 + print_blanks(text + at + 3));
    if (!n || !words_is(text + at, "for") || !rows || !words_are_rows(rows))
        return 0;
    snprintf(plain, PRINTED_PLAIN, "k%d p%d rib", knit, purl);
    return at + 3;
}

/* Whether a sentence begins at `at`, or `work in` stands before. */
static bool begins_sentence(const char *text, size_t at)
{
    static const char *const then[] = {"then", "now", "work", "in", "of"};
    int lead = 0;

    while (lead >= 0 && lead < 2) {
        size_t word;

        while (at > 0 && strchr(" \t", text[at - 1]))
            at--;
        if (at == 0 || strchr("\r\n.;", text[at - 1]))
            return true;
        word = print_word_before(text, at);
        lead = word < at ? words_find(text + word, then, 5) : -1;
        at = word;
    }
    return lead >= 2;
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
    size_t at = words_are_stitches(text) ? words_length(text) + print_blanks(text + words_length(text)) : 0;
    int n;

    if (!at || words_find(text + at, in, 1) < 0)
        return 0;
    at += 2 + print_blanks(text + at + 2);
    n = words_find(text + at, many, sizeof many / sizeof *many);
    snprintf(plain, PRINTED_PLAIN, "mult of %d", n + 2);
    at += words_length(text + at);
    return n >= 0 && strlen(plain) <= at ? at : 0;
}

/* `(Swatch: ` before a cast-on, on the line of a multiple: a line of its own begins. */
size_t print_sample_length(const char *text, size_t at)
{
    size_t n = 1, line;

    for (int words = 0; words < 3 && !words_is(text + at + n, "cast") && !words_is(text + at + n, "co") && words_length(text + at + n) > 0; words++) {
        n += words_length(text + at + n);
        n += strspn(text + at + n, " :,");
    }
    if (!print_cast_on_follows(text + at + n))
        return 0;
    line = print_line_start(text, at);
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
    line = print_line_start(text, at);
    if (!memchr(text + line, '*', at - line))
        return 0;
    n += words_length(text + at + n) + print_blanks(text + at + n + words_length(text + at + n));
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

    for (int words = 0; words < 8 && words_find(text + at, word, 8) >= 0; words++) {
        at += words_length(text + at);
        at += print_blanks(text + at);
    }
    if (!at || !words_are_stitches(text + at))
        return 0;
    at += words_length(text + at);
    at += print_blanks(text + at);
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

    return n && print_rows_length(text + at + n + print_blanks(text + at + n)) && words_find(text + print_word_before(text, at), leads, 4) >= 0 ? n : 0;
}

/* ---- what a row's last repeat has instead ---- */

/* `k 5`, `purl 2`: its bytes, its letter and how many. */
static size_t item_length(const char *text, char *letter, int *number)
{
    *letter = (char)tolower((unsigned char)*text);
    return strchr("kp", *letter) && *letter ? stitches_of(text, *letter, number) : 0;
}

/* Where the text between a star and `repeat from *`, which ends before `at`, begins and ends; false: none does. */
static bool find_repeated(const char *text, size_t at, size_t *start, size_t *end)
{
    size_t line = print_line_start(text, at);

    for (*end = at; *end > line && !(print_begins_word(text, *end) && (words_is(text + *end, "rep") || words_is(text + *end, "repeat")));)
        --*end;
    for (*start = *end; *start > line && text[*start - 1] != '*';)
        --*start;
    *start += print_blanks(text + *start);
    while (*end > *start && strchr(" ,;.\r\n", text[*end - 1]))
        --*end;
    return *start > line && *end > *start;
}

/* `ending with`, `end last rep`, `finish`: its bytes, with the blanks behind; or 0. */
static size_t ending_length(const char *text)
{
    static const char *const ending[] = {"end", "ending", "finish", "finishing"}, *const with[] = {"with", "in", "last", "rep", "repeat"};
    size_t n = words_find(text, ending, 4) >= 0 ? words_length(text) : 0;

    n += n ? print_blanks(text + n) : 0;
    while (n && words_find(text + n, with, 5) >= 0) {
        n += words_length(text + n);
        n += print_blanks(text + n);
    }
    return n;
}

/* `ending with k 5 instead of k 3` behind `*p 1, k 3; repeat from *`: `end p 1, k5`. */
static size_t instead_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    static const char of[] = "instead of ";
    struct item { char letter; int number; } end, usual, last;
    size_t n = ending_length(text + at), item = n ? item_length(text + at + n, &end.letter, &end.number) : 0, from, to, begins;

    if (!item)
        return 0;
    n += item + print_blanks(text + at + n + item);
    item = strncasecmp(text + at + n, of, sizeof of - 1) == 0 ? item_length(text + at + n + sizeof of - 1, &usual.letter, &usual.number) : 0;
    if (!item || !find_repeated(text, at, &from, &to))
        return 0;
    n += sizeof of - 1 + item;
    for (begins = to; begins > from && !strchr(",;.", text[begins - 1]);)
        begins--;
    if (begins == from || !item_length(text + begins + print_blanks(text + begins), &last.letter, &last.number) ||
        last.letter != usual.letter || last.number != usual.number)
        return 0;
    if (snprintf(plain, PRINTED_PLAIN, "end %.*s %c%d", (int)(begins - from), text + from, end.letter, end.number) >= PRINTED_PLAIN)
        *plain = '\0';
    return *plain && strlen(plain) <= n ? n : 0;
}

/* ---- rows again ---- */

/* `1st row`, `row 1`: its bytes; or 0. */
static size_t first_row_length(const char *text)
{
    int number;
    size_t n = print_ordinal_length(text, &number);

    if (n) {
        n += print_blanks(text + n);
        return number == 1 && words_are_rows(text + n) ? n + words_length(text + n) : 0;
    }
    n = words_are_rows(text) ? words_length(text) + print_blanks(text + words_length(text)) : 0;
    return n && text[n] == '1' && !isdigit((unsigned char)text[n + 1]) ? n + 1 : 0;
}

/* `Repeat from the 1st row`, `Begin again at row 1`, which says no number of times. */
static size_t begin_again_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const words[] = {"repeat", "rep", "begin", "commence", "start"}, *const behind[] = {"again", "from", "at", "with", "the"};
    size_t first = words_find(text, words, 5) >= 0 ? words_length(text) + print_blanks(text + words_length(text)) : 0, n = first, row;

    while (n && words_find(text + n, behind, 5) >= 0) {
        n += words_length(text + n);
        n += print_blanks(text + n);
    }
    row = n > first ? first_row_length(text + n) : 0;
    strcpy(plain, "rep for patt");
    return row && print_sentence_ends(text + n + row) && strlen(plain) <= n + row ? n + row : 0;
}

/* `C.O.` that ends a line: no number is cast on, all are cast off. */
static size_t cast_off_length(const char *text, char plain[static PRINTED_PLAIN])
{
    size_t n = strncasecmp(text, "c.o", 3) == 0 ? 3 : strncasecmp(text, "c. o", 4) == 0 ? 4 : 0;

    n += n && text[n] == '.';
    strcpy(plain, "bo");
    return n && (!text[n + print_blanks(text + n)] || strchr("\r\n", text[n + print_blanks(text + n)])) ? n : 0;
}

/* `plus 1 edge st at each side`: `plus 2`. */
static size_t each_side_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const words[] = {"edge", "selvedge", "selvage", "extra", "st", "sts", "stitch", "stitches", "at", "on", "for", "each", "either"},
                             *const side[] = {"side", "end", "edge"};
    size_t n = strlen("plus");
    int number;
    bool each = false;

    if (!words_is(text, "plus"))
        return 0;
    n += print_blanks(text + n);
    number = words_number(text + n);
    n += strspn(text + n, "0123456789");
    for (n += print_blanks(text + n); number > 0 && words_find(text + n, words, 13) >= (each ? 13 : 0); n += print_blanks(text + n)) {
        each = words_find(text + n, words, 13) >= 11;
        n += words_length(text + n);
    }
    snprintf(plain, PRINTED_PLAIN, "plus %lld", 2LL * number);
    return each && words_find(text + n, side, 3) >= 0 ? n + words_length(text + n) : 0;
}

/* ---- all of them ---- */

/* Whether a cast-on follows, of so many: `Bib.  Cast on 25 sts.` */
bool print_cast_on_follows(const char *text)
{
    text += print_blanks(text);
    if (words_is(text, "cast"))
        text += 4 + strspn(text + 4, " -");
    return (words_is(text, "on") || words_is(text, "co")) && words_behind_number(text + 2 + print_blanks(text + 2));
}

size_t print_word_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    const char *here = text + at;
    char c = (char)tolower((unsigned char)*here);
    bool begins = strchr("kw0123456789rbcs", c) && begins_sentence(text, at);
    size_t length = broken_length(here, plain);

    if (!length && (isdigit((unsigned char)c) || strchr("totfsen", c)))
        length = in_all_length(text, at, plain);
    if (!length && begins)
        length = rib_length(here, plain);
    if (!length && begins)
        length = begin_again_length(here, plain);
    if (!length && strchr("ef", c))
        length = instead_length(text, at, plain);
    if (!length && c == 's')
        length = tens_length(here, plain);
    if (!length && c == 'c')
        length = cast_off_length(here, plain);
    if (!length && c == 'p')
        length = each_side_length(here, plain);
    if (!length && strchr("tf", c) && lead_length(text, at)) {
        *plain = '\0';
        return lead_length(text, at);
    }
    if (!length && strchr("aeuon", c))
        length = count_length(here, plain);
    return length || !strchr("wtsjealrpk", c) ? length : print_told_length(text, at, plain);
}
