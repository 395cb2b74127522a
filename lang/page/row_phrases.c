/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a row's text in, what stands for its words plainly out: `alternate k1 and p1`, `purl on RS, knit on WS`. */
#include "lang/page/row_phrases.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/page/lengths.h"
#include "lang/page/prose.h"
#include "lang/page/prose_line.h"
#include "lang/page/remarks.h"
#include "lang/page/ribs.h"
#include "lang/page/words.h"

size_t row_phrases_star(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const times[] = {"times", "x"}, *const again[] = {"rep", "repeat"};
    size_t digits = at + 1 + strspn(text + at + 1, " "), word = digits + strspn(text + digits, "0123456789"), close = word + strspn(text + word, " ");
    int stars = 0;

    if (word == digits || word - digits > 5 || words_find(text + close, times, 2) < 0 || text[close + words_length(text + close)] != ')')
        return 0;
    close += words_length(text + close) + 1;
    for (size_t before = at; before > 0 && !strchr(":{}\r\n", text[before - 1]); before--)
        stars += text[before - 1] == '*';
    if (stars != 1 || words_line_has(text + close, again[0]) || words_line_has(text + close, again[1]) || words_line_has_sign(text + close, "*") || !remarks_in_row(text, at))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "* %d x", atoi(text + digits));
    return strlen(plain) <= close - at ? close - at : 0;
}

/* `k1`, `purl 2`, `knit one stitch`: its bytes, and how many; or 0. */
static size_t stitch_length(const char *text, int *number)
{
    const char *digits = words_are(text, WORDS_PLAIN) ? words_skip_blanks(text + words_length(text)) : "", *end;

    *number = words_number(digits);
    end = words_behind_number(digits);
    if (*number < 1 || !end)
        return 0;
    if (words_are_stitches(end))
        return (size_t)(end - text) + words_length(end);
    return (size_t)(digits - text) + (words_length(digits) ? words_length(digits) : strspn(digits, "0123456789"));
}

size_t row_phrases_alternate(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const words[] = {"alternate", "alternating", "alternately"}, *const joins[] = {"and", "with"};
    bool before = words_find(text + at, words, 2) >= 0;
    size_t first = before ? (size_t)(words_next(text + at) - text) : at, end, second;
    int n, m;

    end = first + stitch_length(text + first, &n);
    second = end + strspn(text + end, " ,&");
    second += words_find(text + second, joins, 2) >= 0 ? words_length(text + second) : 0;
    second += strspn(text + second, " ");
    if (end == first || second == end || !stitch_length(text + second, &m) || !remarks_in_row(text, at))
        return 0;
    end = second + stitch_length(text + second, &m);
    if (!before) {
        size_t word = end + strspn(text + end, " ,");

        if (words_find(text + word, words, 3) < 0 || words_line_has_sign(text + words_line_start(text, at), "*"))
            return 0;
        end = word + words_length(text + word);
    }
    snprintf(plain, SIGNS_PLAIN, prose_line_ends(text + end) ? "*%c%d,%c%d rep" : "(%c%d,%c%d)", text[first], n, text[second], m);
    return strlen(plain) <= end - at ? end - at : 0;
}

/* `knit on the right side`, `K on RS rows`: its bytes, the stitch and the side in small letters; or 0. */
static size_t on_side_length(const char *text, char *stitch, char *side)
{
    static const char *const on[] = {"on", "the"}, *const sides[] = {"rs", "ws", "right", "wrong"};
    size_t at = words_are(text, WORDS_PLAIN) ? words_length(text) : 0;

    *stitch = (char)tolower((unsigned char)*text);
    for (at += at ? strspn(text + at, " ") : 0; at && words_find(text + at, on, 2) >= 0; at += strspn(text + at, " "))
        at += words_length(text + at);
    if (!at || words_find(text + at, sides, 4) < 0)
        return 0;
    *side = (char)tolower((unsigned char)text[at]);
    at += words_length(text + at);
    for (size_t next = at + strspn(text + at, " -"); words_is(text + next, "side") || words_are_rows(text + next); next = at + strspn(text + at, " "))
        at = next + words_length(text + next);
    return at;
}

size_t row_phrases_sided(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    char stitch[2], side[2];
    size_t first = on_side_length(text + at, &stitch[0], &side[0]), second = at + first;

    second += strspn(text + second, " ,;");
    second += words_is(text + second, "and") ? 3 + strspn(text + second + 3, " ") : 0;
    if (!first || !on_side_length(text + second, &stitch[1], &side[1]) || stitch[0] == stitch[1] || side[0] == side[1] || !remarks_in_row(text, at))
        return 0;
    strcpy(plain, (stitch[0] == 'k') == (side[0] == 'r') ? "st st" : "rev st st");
    return second + on_side_length(text + second, &stitch[1], &side[1]) - at;
}

size_t row_phrases_repeats(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const lead[] = {"work", "cont", "continue"};
    const char *number = words_find(text + at, lead, 3) >= 0 ? words_skip_any(text + at, "work|cont|continue|in|the|pattern|patt|pat|until|till|you|have|there|are|worked") : text + at, *rows, *first, *last, *end;
    bool until = false;
    int n = number > text + at && words_behind_number(number) ? words_number(number) : 0;

    if (n < 1)
        return 0;
    rows = words_skip_any(words_behind_number(number), "full|complete|completed|whole|pattern|repeat|repeats|reps|repetitions|of|the");
    first = words_next(rows);
    if (!words_are_rows(rows) || !isdigit((unsigned char)*first) || tolower((unsigned char)rows[words_length(rows) - 1]) != 's')
        return 0;
    for (const char *word = text + at; word < number; word += words_length(word) + 1)
        until |= words_is(word, "until") || words_is(word, "till");
    last = first + strspn(first, "0123456789");
    last += strspn(last, " -\xE2\x80\x93");
    last = words_skip_any(last, "to|and|through");
    end = last + strspn(last, "0123456789");
    if (end == last || rows - number > 80)
        return 0;
    end = words_skip_any(end, "have|has|are|is|been|worked|completed|complete|done|made|knitted");
    snprintf(plain, SIGNS_PLAIN, until ? "rep %.*s %d-%d %d x in all" : "work %.*s %d-%d %d x", (int)words_length(rows), rows, atoi(first), atoi(last), n);
    return strchr(".,;\r\n", *end) && strlen(plain) + 1 < SIGNS_PLAIN && strlen(plain) <= (size_t)(end - text) - at ? (size_t)(end - text) - at : 0;
}

/* The number that `(I did 44 rows.)` says, and whether of rows; 0: the brackets say more, or `open` opens none. */
static int told_number(const char *open, bool *rows, size_t *length)
{
    static const char talk[] = "about|around|approximately|approx|roughly|or|so|that|this|is|was|will|be|i|we|you|did|made|worked|knit|knitted|repeated|had|took|mine|it|them|for|me|in|all|total|a|of",
                      *const times[] = {"times", "repeats", "reps", "repetitions"};
    const char *number = words_skip_any(open + 1, talk), *unit = *open == '(' && isdigit((unsigned char)*number) ? words_behind_number(number) : NULL, *end;

    *rows = unit && words_are_rows(unit);
    if (!unit || !(*rows || words_find(unit, times, 4) >= 0))
        return 0;
    end = words_skip_any(words_next(unit), talk);
    end += *end == '.';
    *length = (size_t)(end - open) + 1;
    return *end == ')' && strchr(".,;\r\n", end[1]) ? words_number(number) : 0;
}

/* Whether `repeat` or `work` stands before a place, in its sentence. */
static bool is_repeated(const char *text, size_t at)
{
    bool again = false;

    while (at > 0 && !strchr(".;:()\r\n", text[at - 1])) {
        at--;
        again |= (at == 0 || !isalpha((unsigned char)text[at - 1])) && words_are(text + at, WORDS_AGAIN);
    }
    return again;
}

size_t row_phrases_told(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t open = strcspn(text + at, ".;:()\r\n"), length;
    bool rows;
    int n;

    if ((!words_is(text + at, "until") && !words_is(text + at, "till")) || open > 200 || !is_repeated(text, at))
        return 0;
    open += strspn(text + at + open, ". ");
    n = told_number(text + at + open, &rows, &length);
    if (n < 1 || (rows && lengths_follow(text + at)))
        return 0;
    snprintf(plain, SIGNS_PLAIN, rows ? "for %d rows in all" : "%d times in all", n);
    return strlen(plain) < open + length ? open + length : 0;
}

/* The number of the first of the rows whose text begins with the `repeat` before a place; 0: none does. */
static int rows_repeated(const char *text, size_t at)
{
    size_t again = words_before(text, at), line = words_line_start(text, at);

    line += strspn(text + line, " \t*-");
    return again > line && words_are(text + again, WORDS_AGAIN) && words_sign_before(text, again, " \t") == ':' ? words_row(text + line) : 0;
}

size_t row_phrases_last(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *number = words_skip_any(text + at, "the|last|previous|preceding|prior|above|these|those"), *rows = number > text + at ? words_behind_number(number) : NULL, *end;
    int first, n;

    if (!rows || !words_are_rows(rows) || (at > 0 && text[at - 1] != ' '))
        return 0;
    n = words_number(number);
    first = rows_repeated(text, at);
    if (n < 2 || first <= n)
        return 0;
    end = rows + words_length(rows);
    snprintf(plain, SIGNS_PLAIN, "rows %d-%d", first - n, first - 1);
    return strlen(plain) <= (size_t)(end - text) - at ? (size_t)(end - text) - at : 0;
}

/* Whether the line above begins with a name of so many bytes, as a row's head does. */
static bool is_head_above(const char *text, size_t at, const char *name, size_t length)
{
    size_t line = words_line_start(text, at), above = line, end;

    if (line == 0)
        return false;
    above = words_line_start(text, line - 1 - (line > 1 && text[line - 2] == '\r'));
    end = above + length;
    return strncasecmp(text + above, name, length) == 0 && (text[end] == ':' || strncasecmp(text + end, " (RS):", 6) == 0 || strncasecmp(text + end, " (WS):", 6) == 0);
}

size_t row_phrases_named(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *name = words_next(text + at), *row = name;
    size_t length;

    if (!words_are(text + at, WORDS_AGAIN) || words_sign_before(text, at, " \t") != '\n' || words_are_rows(name))
        return 0;
    for (int i = 0; i < 3 && words_length(row) && !words_are_rows(row); i++)
        row = words_next(row);
    length = (size_t)(row - name) + words_length(row);
    if (!words_are_rows(row) || !is_head_above(text, at, name, length))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "rep last %.*s", (int)words_length(row), row);
    length += (size_t)(name - text) - at;
    return strlen(plain) <= length ? length : 0;
}

/* Behind `3 edge sts`, `the last 3 stitches`; NULL: another text. *n: how many. */
static const char *behind_some(const char *text, int *n)
{
    const char *number = words_skip_any(text, "the|first|last|next|other|following|remaining|rem"), *sts = words_behind_number(number);

    *n = sts ? words_number(number) : 0;
    sts = sts ? words_skip_any(sts, "edge|border|selvedge") : NULL;
    return sts && words_are_stitches(sts) && *n > 0 ? words_next(sts) : NULL;
}

/* Behind `seed st`, `in garter stitch`; NULL: another text. *name: that of the fabric. */
static const char *behind_fabric(const char *text, const char **name)
{
    static const char *const fabrics[] = {"seed", "moss", "garter", "stockinette", "stocking"};
    int fabric;

    text = words_skip_any(text, "in|of|the");
    fabric = words_find(text, fabrics, 5);
    *name = fabric < 0 ? NULL : fabric == 4 ? fabrics[3] : fabrics[fabric];
    return fabric < 0 ? NULL : words_skip_any(words_next(text), "st|stitch");
}

size_t row_phrases_fabric(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *begin = words_skip_any(text + at, "work|knit|keep|keeping"), *name, *fabric = behind_fabric(begin, &name), *end;
    int n;

    end = fabric ? behind_some(fabric, &n) : behind_some(begin, &n);
    end = end && !fabric ? behind_fabric(end, &name) : end;
    if (!end || (begin == text + at && !remarks_in_row(text, at)))
        return 0;
    if (!strchr(",;.)]\r\n", *end) && !words_are(end, WORDS_PLAIN))
        return 0;
    while (end[-1] == ' ')
        end--;
    snprintf(plain, SIGNS_PLAIN, "%s %d", name, n);
    return strlen(plain) <= (size_t)(end - text) - at ? (size_t)(end - text) - at : 0;
}

size_t row_phrases_form(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t n = words_one_of("to form|to make|to create|to establish|to complete|forming", text + at), end = at + n, last = at;

    if (!n || !strchr("swd0123456789", words_sign_before(text, at, " ")))
        return 0;
    for (size_t word; text[end] && !strchr(".,;:()*0123456789\r\n", text[end]); end += word + (word == 0)) {
        word = words_length(text + end);
        last = word ? end : last;
    }
    if (!words_one_of("pattern|patt|stitch|st|rib|texture", text + last))
        return 0;
    strcpy(plain, "for patt");
    return end - at;
}

size_t row_phrases_previous(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const leads[] = {"same", "ditto", "idem", "as", "like", "repeat", "rep", "work", "for", "the", "do", "exactly"}, *const which[] = {"previous", "preceding", "last", "prior", "above", "before"};
    bool same = false;
    size_t end = at, line = words_line_start(text, at);
    int row = strchr(":-", words_sign_before(text, at, " ")) ? words_row(text + line + strspn(text + line, " \t*-")) : 0, lead;

    for (; row > 1 && (lead = words_find(text + end, leads, 12)) >= 0; same |= lead < 3)
        end += words_length(text + end) + (text[end + words_length(text + end)] == ' ');
    if (end == at)
        return 0;
    if (words_find(text + end, which, 6) >= 0) {
        same = words_find(text + end, which, 6) > 3;
        end += words_length(text + end) + (text[end + words_length(text + end)] == ' ');
        if (words_are_rows(text + end))
            end += words_length(text + end);
        else if (!same)
            return 0;
    } else if (!same) {
        return 0;
    }
    /* `Same`, and on the next line `as row 2`. */
    if (!prose_line_ends(text + end) || words_is(prose_line_next(text + end), "as"))
        return 0;
    end += text[end] == '.';
    snprintf(plain, SIGNS_PLAIN, "as %d", row - 1);
    return strlen(plain) <= end - at ? end - at : 0;
}

size_t row_phrases_passive(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *first = words_next(text + at), *join = words_behind_number(first), *second, *verb;

    if (!strchr("\n.", words_sign_before(text, at, " \t")) || !words_are_rows(text + at) || !join)
        return 0;
    second = words_skip_any(join + (*join == '-' || *join == '&'), "and|to|through");
    verb = second > join ? words_behind_number(second) : NULL;
    if (!verb || !(words_is(verb, "are") || words_is(verb, "is")))
        return 0;
    verb = words_skip_any(words_next(verb), "to|be|then|now");
    if (!words_one_of("repeated|worked|knitted", verb))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%s %.*s %d-%d", words_is(verb, "repeated") ? "rep" : "work", (int)words_length(text + at), text + at, words_number(first), words_number(second));
    verb += words_length(verb);
    return (words_behind_number(words_skip_blanks(verb)) || words_one_of("twice|once|until|till|for", words_skip_blanks(verb))) && strlen(plain) <= (size_t)(verb - text) - at
               ? (size_t)(verb - text) - at : 0;
}

size_t row_phrases_formed(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *name = words_is(text + at, "in") ? words_skip_any(words_next(text + at), "the") : text, *end = name;
    size_t length = 0, reach = at > WORDS_REACH ? at - WORDS_REACH : 0;

    for (int words = 0; words < 4 && words_length(end) && *end != '\n' && !words_one_of("pattern|patt|pat", end); words++) {
        length = (size_t)(end - name) + words_length(end);
        end = words_skip_blanks(end + words_length(end));
    }
    if (!length || !words_one_of("pattern|patt|pat", end))
        return 0;
    for (size_t i = reach; i < at; i++) {
        const char *formed = (text[i] | 0x20) == 'f' && words_one_of("form|forms", text + i) ? words_skip_any(text + i, "form|forms|the|a") : NULL;

        if (!formed || strncasecmp(formed, name, length) != 0)
            continue;
        strcpy(plain, "in patt");
        return (size_t)(end - text) - at + words_length(end);
    }
    return 0;
}

size_t row_phrases_rib(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *pair = words_skip_any(text + at, "work|in"), *rib, *to;
    int knit, purl;
    size_t n = ribs_pair(pair, &knit, &purl), word;

    rib = words_skip_blanks(pair + n);
    word = words_one_of("ribbing|rib", rib);
    to = words_skip_blanks(rib + word);
    if (!n || !word || strchr("\n.", words_sign_before(text, at, " \t")) || !words_one_of("to the last|to last|to marker|to next|to m|to the next|to the marker", to))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "(k%d, p%d)", knit, purl);
    return strlen(plain) <= (size_t)(rib + word - text) - at ? (size_t)(rib + word - text) - at : 0;
}
