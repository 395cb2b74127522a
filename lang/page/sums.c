/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; how long the sum is that stands there, and what it is plainly, out. */
#include "lang/page/sums.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/remarks.h"
#include "lang/page/words.h"

/* What is counted, whether it is `in all`, and whether of the piece. */
struct sum {
    int  number;
    bool rows, times, all, piece;
};

/* One word or sign of `total of 6 rows`: its bytes, or 0. */
static size_t word_length(const char *text, struct sum *sum)
{
    static const char *const total[] = {"total", "altogether", "all", "in", "of", "a", "for", "pattern"}, *const repeats[] = {"times", "time", "repeats", "reps", "patterns"};
    size_t n = words_length(text);
    const char *behind = sum->number ? NULL : words_behind_number(text);
    int word = n ? words_find(text, total, 8) : -1;

    if (behind) {
        sum->number = words_number(text);
        return (size_t)(behind - text);
    }
    sum->all |= word >= 0 && word < 3;
    if (word >= 0 || !n)
        return word >= 0 ? n : *text == ' ';
    sum->rows |= sum->number && !sum->times && words_are_rows(text);
    sum->times |= sum->number && !sum->rows && words_find(text, repeats, 5) >= 0;
    return words_are_rows(text) ? n * sum->rows : words_find(text, repeats, 5) >= 0 ? n * sum->times : 0;
}

/* `, counting the 5 of the border`, `from the cast-on`, to what closes the sum: its bytes, or 0. */
static size_t remark_length(const char *text, char close, struct sum *sum)
{
    static const char *const piece[] = {"counting", "including", "incl", "inclusive", "from", "since"};
    size_t comma = strspn(text, ", "), n = strcspn(text, close ? "()\r\n" : ".;()\r\n");
    bool counts = words_find(text + comma, piece, 6) >= 0;

    if (!counts && !(close && comma && sum->times && isdigit((unsigned char)text[comma])))     /* `(6 times in all, 12 rows)` */
        return 0;
    sum->piece = counts && sum->rows;
    return n;
}

/* The bytes of a sum behind the sign that begins it. */
static size_t read_sum(const char *text, struct sum *sum)
{
    char close = *text == '(' ? ')' : '\0';
    size_t at = 1, n;

    while (text[at] && !strchr("\r\n.,;:)", text[at]) && (n = word_length(text + at, sum)) > 0)
        at += n;
    sum->times |= close && sum->all && !sum->rows;     /* `(3 in all)` */
    if (!(sum->rows || sum->times) || !sum->number)
        return 0;
    at += sum->all ? remark_length(text + at, close, sum) : 0;
    if (close ? text[at] != close : text[at] && !strchr("\r\n.,;:)", text[at]))
        return 0;
    return at + (close != 0);
}

/* Whether `times`, `twice` stands before. */
static bool behind_times(const char *text, size_t at)
{
    static const char *const times[] = {"times", "time", "twice", "once", "thrice", "more", "x"};

    return words_find(text + words_before(text, at), times, sizeof times / sizeof *times) >= 0;
}

size_t sums_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    struct sum sum = {0};
    size_t length = behind_times(text, at) ? read_sum(text + at, &sum) : 0;
    bool in_row = remarks_in_row(text, at);

    if (!length || sum.number > 99999 || !(sum.all || (in_row && sum.rows)))
        return 0;
    if (!in_row)    /* of a row that is like others its numbers say it */
        snprintf(plain, SIGNS_PLAIN, " in %d %s%s", sum.number, sum.rows ? "rows" : "x", sum.piece ? " total" : "");
    return strlen(plain) <= length ? length : 0;
}
