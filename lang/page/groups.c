/* SPDX-License-Identifier: GPL-3.0-or-later
 * A bracket of a text in; how long it is, where it only groups or says again, out. */
#include "lang/page/groups.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/page/page_facts.h"
#include "lang/page/phrases.h"
#include "lang/page/prose.h"
#include "lang/page/words.h"

size_t groups_rib(const char *text)
{
    size_t at = 1;

    if (tolower((unsigned char)text[1]) != 'k')
        return 0;
    while (at <= 12 && text[at] && (isalnum((unsigned char)text[at]) || strchr(" .,;", text[at])))
        at++;
    return text[at] == ')' && strncasecmp(text + phrases_skip(text, at + 1), "rib", 3) == 0 ? at + 1 : 0;
}

/* How long `{8mm}`, `{ 5 in }` is; or 0. */
static size_t measure_length(const char *text)
{
    size_t at = 1 + strspn(text + 1, " "), digits = strspn(text + at, "0123456789.,"), unit;

    at += digits + strspn(text + at + digits, " ");
    unit = words_one_of("mm|cm|cms|in|inch|inches", text + at);
    at += unit + strspn(text + at + unit, " ");
    return digits && unit && text[at] == '}' ? at + 1 : 0;
}

size_t groups_braces(const char *text)
{
    size_t at = 1, stitches = 0, side = words_one_of("rs|ws|right side|wrong side", text + 1);

    if (measure_length(text))
        return measure_length(text);
    if (side && text[1 + side] == '}')
        return side + 2;
    for (; strchr("kKpP", text[at]) && text[at]; stitches++) {
        at++;
        at += strspn(text + at, "0123456789");
        at += strspn(text + at, " ,");
    }
    return stitches > 1 && text[at] == '}' ? at + 1 : 0;
}

size_t groups_sizes(const char *text, size_t at, const struct page_facts *facts)
{
    bool counts = facts->sizes && at > facts->sizes && isdigit((unsigned char)words_sign_before(text, at, " "));
    int n;
    size_t length = counts ? prose_sizes_length(text + at, &n) : 0;
    return length && n == facts->nsizes && (n > 1 || strchr(" ,", text[at + length])) ? length : 0;
}

size_t groups_said_again(const char *text, size_t at)
{
    size_t n = words_stitch_length(text + at + 1), digits = at, word;
    const char *behind;

    while (digits > 0 && strchr(" 0123456789", text[digits - 1]))
        digits--;
    for (word = digits; word > 0 && isalpha((unsigned char)text[word - 1]);)
        word--;
    digits += strspn(text + digits, " ");
    if (!n || text[at + 1 + n] != ')' || !words_one_of("knit|purl", text + word) || tolower((unsigned char)text[word]) != tolower((unsigned char)text[at + 1]))
        return 0;

    /* `knit 1 (k1) 3 times`: a group of its own. */
    behind = words_skip_blanks(text + at + n + 2);
    if ((*behind && strchr("{*", *behind)) || words_behind_number(behind) || words_one_of("twice|thrice|once|x|rep|repeat|to|until", behind))
        return 0;
    return words_number(text + digits) == words_number(text + at + 2) ? n + 2 : 0;
}

/* Where the bracket is closed that a text begins with, within so many bytes; or 0. */
static size_t close_within(const char *text, size_t most)
{
    int open = 0;

    for (size_t at = 0; text[at] && at < most; at++) {
        open += strchr("([{", text[at]) ? 1 : strchr(")]}", text[at]) ? -1 : 0;
        if (open == 0)
            return at;
    }
    return 0;
}

size_t groups_close(const char *text)
{
    return close_within(text, words_line_length(text));
}

size_t groups_close_below(const char *text)
{
    return close_within(text, WORDS_REACH);
}

bool groups_fill_row(const char *text, size_t close)
{
    size_t inner = 1 + strspn(text + 1, " "), behind = text[inner] == '(' ? inner + groups_close(text + inner) + 1 : close;

    if (behind >= close || !words_stitch_length(text + inner + 1))
        return false;
    behind += strspn(text + behind, " ");
    return words_one_of("to last|to end", text + behind) > 0 && strcspn(text + behind, "([{") > close - behind;
}

/* Whether so far stands `to end`, `across to the last 2 sts`, and no more. */
static bool says_how_far(const char *text, const char *end)
{
    bool to = false;

    for (size_t n; text < end; text = words_skip_blanks(text + n)) {
        n = words_one_of("to|until|till|across|last|end|the|of|this|row|round|rnd", text);
        to |= words_one_of("last|end", text) > 0;
        if (!n && to && words_behind_number(text))
            n = (size_t)(words_behind_number(text) - text);
        n = !n && to && words_are_stitches(text) ? words_length(text) : n;
        if (!n)
            return false;
    }
    return to;
}

/* Whether so far stands `3 times`, `twice`, and no more. */
static bool says_how_often(const char *text, const char *end)
{
    const char *number = words_behind_number(text), *times = number ? number : text;

    return words_one_of(number ? "times|time|x|more times" : "twice|thrice", times) && words_skip_any(times, "times|time|x|more|twice|thrice") == end;
}

size_t groups_repeated(const char *text, size_t close)
{
    static const char *const times[] = {"times", "time", "twice", "thrice", "x", "more"};
    const char *behind = words_skip_blanks(text + close + 1), *number = words_behind_number(behind), *rest;
    size_t at = 1, again;

    while (at < close && !words_one_of("to|until|till|across|rep|repeat|repeated", text + at) && !strchr("([{*", text[at]))
        at += words_length(text + at) ? words_length(text + at) : 1;
    again = words_one_of("rep|repeat|repeated", text + at);
    rest = words_skip_blanks(text + at + again);
    if (at == close || words_find(number ? number : behind, times, 6) >= 0 || !(says_how_far(rest, text + close) || (again && says_how_often(rest, text + close))))
        return 0;
    while (at > 1 && strchr(" ,;", text[at - 1]))
        at--;
    return isdigit((unsigned char)text[at - 1]) && strchr(" ,;", text[at]) ? at : 0;
}

size_t groups_of_star(const char *text, size_t at)
{
    size_t n = words_one_of("repeat|rep.|rep", text + at + 1), close = at + 1 + strcspn(text + at + 1, "()[]\r\n"), line = words_line_start(text, at);
    const char *behind = words_skip_blanks(text + at + 1 + n);

    if (!n || !strchr(")]", text[close]) || !memchr(text + line, '*', at - line))
        return 0;
    return strchr(")]", *behind) || words_one_of("from|to|until|till|across", behind) ? close : 0;
}
