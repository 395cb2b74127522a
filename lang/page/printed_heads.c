/* SPDX-License-Identifier: GPL-3.0-or-later
 * The heads of a printed book's rows, and rows that are told by others: `3rd and 4th rows--Like the
 * first two` in, what that is plainly out. */
#include <stdio.h>
#include <stdlib.h>

#include "lang/page/printed_parts.h"

enum { HEAD = 100 };

/* ---- ordinals ---- */

/* `first`, `Twenty-second`: its bytes, and the number. */
size_t print_letters_length(const char *text, int *number)
{
    static const char *const ones[] = {"first",    "second",   "third",      "fourth",     "fifth",     "sixth",     "seventh",     "eighth",     "ninth",     "tenth",
                                       "eleventh", "twelfth",  "thirteenth", "fourteenth", "fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth"},
                             *const tens[] = {"twentieth", "thirtieth", "fortieth", "fiftieth"}, *const first[] = {"twenty", "thirty", "forty", "fifty"};
    size_t n = words_length(text), behind = n + strspn(text + n, "- ");
    bool scanned = strncmp(text, "lst ", 4) == 0 || strncmp(text, "Ist ", 4) == 0;     /* the figure read as a letter */
    int one = scanned ? 0 : words_find(text, ones, 19), ten = words_find(text, tens, 4), begun = words_find(text, first, 4);

    if (begun >= 0 && (one = words_find(text + behind, ones, 9)) >= 0) {
        *number = 20 + 10 * begun + one + 1;
        return behind + words_length(text + behind);
    }
    *number = ten >= 0 ? 20 + 10 * ten : one + 1;
    return begun < 0 && *number > 0 ? n : 0;
}

/* `3rd`, `third`: its bytes, and the number. */
size_t print_ordinal_length(const char *text, int *number)
{
    size_t n = strspn(text, "0123456789");

    if (!n)
        return print_letters_length(text, number);
    *number = n < 6 ? atoi(text) : 0;
    return n < 6 ? words_ordinal_length(text) : 0;
}

/* ---- heads of rows ---- */

/* `, and`, `to`, `--` between ordinals: its bytes. */
static size_t join_length(const char *text)
{
    static const char *const words[] = {"and", "to", "or"};
    size_t at = print_blanks(text);

    at += text[at] == ',' || text[at] == '&' || text[at] == '-' ? 1 : print_dash_length(text + at);
    at += print_blanks(text + at);
    at += words_find(text + at, words, 3) >= 0 ? words_length(text + at) : 0;
    return at == print_blanks(text) ? 0 : at + print_blanks(text + at);
}

/* `6th, 7th, and 8th rows`: its bytes. */
size_t print_rows_length(const char *text)
{
    size_t at = 0, n, join;
    int number;

    while ((n = print_ordinal_length(text + at, &number)) > 0) {
        at += n;
        join = join_length(text + at);
        if (!join || !print_ordinal_length(text + at + join, &number))
            break;
        at += join;
    }
    n = at + print_blanks(text + at);
    return at > 0 && n > at && words_are_rows(text + n) ? n + words_length(text + n) : 0;
}

/* What ends a row's head: a colon, a full stop, a dash, a side in brackets. */
bool print_head_ends(const char *text)
{
    text += print_blanks(text);
    return (*text && strchr(":.(", *text)) || print_dash_length(text) || strncmp(text, "- ", 2) == 0;
}

/* Whether the head of a row may end here: with its number, a side, brackets. */
static bool may_end_head(const char *text, size_t end)
{
    static const char *const words[] = {"rs", "ws", "side", "facing", "incl", "inclusive"};
    size_t word = print_word_before(text, end);

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
    line = print_line_within(text, end, HEAD);
    if (end - line == HEAD)
        return at;
    for (size_t i = line; i < end; i++)
        if (print_begins_word(text, i) && words_are_rows(text + i))
            return memchr(text + line, ':', end - line) ? at : line;
    return at;
}

/* The number of the row that a line begins with, `3rd row`, `Row 3`; 0: none. */
static int line_number(const char *text)
{
    text += print_blanks(text);
    if (print_rows_length(text))
        return atoi(text);
    text += words_are_rows(text) ? words_length(text) : 0;
    return atoi(text + print_blanks(text));
}

/* The row before those that the head names, or before `Next 7 rows`; 0: none. */
static int row_before(const char *text, size_t head)
{
    static const char *const next[] = {"next", "following"};
    size_t n = strcspn(text + head, "0123456789:\r\n");
    int number = 0;

    if (words_find(text + head + print_blanks(text + head), next, 2) < 0)
        return isdigit((unsigned char)text[head + n]) ? atoi(text + head + n) - 1 : 0;
    for (int lines = 0; lines < 4 && head > 0 && !number; lines++) {
        head = print_line_start(text, head - 1);
        number = line_number(text + head);
    }
    return number;
}

/* ---- rows told by others ---- */

/* `the`, `in the`, `for the`: its bytes, with the blanks behind. */
static size_t article_length(const char *text)
{
    static const char *const words[] = {"in", "for", "the"};
    size_t at = 0;

    for (int i = 0; i < 2 && words_find(text + at, words, 3) >= 0; i++) {
        at += words_length(text + at);
        at += print_blanks(text + at);
    }
    return at;
}

/* `same as the fourth row`, `like the 1st and 2nd rows of pattern`, behind the words before the first ordinal. */
static size_t others_length(const char *text, char plain[static PRINTED_PLAIN])
{
    static const char *const of[] = {"of"}, *const pattern[] = {"pattern", "patt"};
    int first, second = 0;
    bool range;
    size_t at = print_ordinal_length(text, &first), join, n;

    if (!at)
        return 0;
    join = join_length(text + at);
    range = words_is(text + at + print_blanks(text + at), "to");
    join += article_length(text + at + join);
    n = join ? print_ordinal_length(text + at + join, &second) : 0;
    at += n ? join + n : 0;
    n = at + print_blanks(text + at);
    at = words_are_rows(text + n) ? n + words_length(text + n) : at;
    n = at + print_blanks(text + at);
    if (words_find(text + n, of, 1) == 0) {
        n += 2 + print_blanks(text + n + 2);
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
        n += print_blanks(here + n);
    }
    if (same && print_sentence_ends(here + n) && !words_is(here + n + strspn(here + n, " \t\r\n"), "as") && row_before(text, head) > 0) {
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
    n += print_blanks(here + n);
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
    return n && print_sentence_ends(text + n) ? n : 0;
}

size_t print_told_length(const char *text, size_t at, char plain[static PRINTED_PLAIN])
{
    size_t head = head_of(text, at), length = head < at ? as_length(text, at, head, plain) : 0;

    if (head == at || length)
        return length;
    if (plain_length(text + at))
        strcpy(plain, "knit");
    return plain_length(text + at);
}
