/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in, how much of it is a remark or a count that a row does not need out. */
#include "lang/page/remarks.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* ---- remarks ---- */

bool remarks_are(const char *text, size_t length)
{
    static const char *const where[] = {"borders", "edges", "selvedge", "selvage", "center", "centre", "middle", "panel", "main", "left", "bottom",
                                        "top", "margin", "corner", "sts", "stitches", "ridge", "fold"},
                             *const work[] = {"wrong", "all", "st", "stitch", "and", "end"};
    bool found = false;

    for (size_t at = 0, n; at < length; at += n ? n : 1) {
        n = words_length(text + at);
        if (!n && !strchr(" -,:'/", text[at]))
            return false;
        if (n && (words_are(text + at, WORDS_OF_ROW) || words_find(text + at, work, sizeof work / sizeof *work) >= 0))
            return false;
        found |= n && (words_are(text + at, WORDS_PART) || words_find(text + at, where, sizeof where / sizeof *where) >= 0);
    }
    return found;
}

bool remarks_talk(const char *text, size_t length)
{
    static const char *const talk[] = {"this", "that", "these", "it", "you", "which", "ending", "so"};

    if (words_find(text, talk, sizeof talk / sizeof *talk) < 0)
        return false;
    for (size_t at = 0, n; at < length; at += n ? n : 1) {
        n = words_length(text + at);
        if (n ? words_are(text + at, WORDS_PLAIN | WORDS_WORK | WORDS_AGAIN | WORDS_TIMES | WORDS_OFTEN | WORDS_CAST | WORDS_BIND | WORDS_NUMBER) : isdigit((unsigned char)text[at]) != 0)
            return false;
    }
    return true;
}

/* Whether `seed stitch`, `st st`, `rib` stands before: brackets behind that say how it is worked. */
static bool behind_fabric(const char *text, size_t at)
{
    static const char *const fabric[] = {"seed", "moss", "garter", "g", "st", "stocking", "stockinette", "rib", "ribbing"},
                             *const whole[] = {"seed", "moss", "garter", "stockinette", "rib", "ribbing"}, *const stitch[] = {"st", "stitch"};
    size_t word = words_before(text, at), first = words_before(text, word);

    if (words_find(text + word, stitch, 2) >= 0)
        return first < word && words_find(text + first, fabric, sizeof fabric / sizeof *fabric) >= 0;
    return words_find(text + word, whole, sizeof whole / sizeof *whole) >= 0;
}

/* `(knit all sts)`, `(one row knit, one row purl)`: how a fabric is worked. */
static bool tells_fabric(const char *text)
{
    static const char *const word[] = {"purl", "every", "one", "alternate", "right", "wrong"};

    return tolower((unsigned char)*text) == 'k' || words_find(text, word, sizeof word / sizeof *word) >= 0;
}

/* `(to make 6 boxes)`: what stitches are for; `(9 sts remain)` before those that are left, `(32 sts), k8` of those before. */
static bool is_purpose(const char *text, size_t close)
{
    static const char *const verb[] = {"make", "form", "create", "get", "keep", "match"}, *const left[] = {"remain", "remaining", "rem", "left"};
    const char *second = words_next(text + 1), *sts = words_behind_number(text + 1), *next = words_skip_blanks(text + close + 1);

    if (words_is(text + 1, "to"))
        return words_find(second, verb, sizeof verb / sizeof *verb) >= 0;
    if (!sts || !words_are_stitches(sts))
        return false;
    sts = words_next(sts);
    next = words_skip_blanks(next + (*sts == ')' && *next == ','));
    return (*sts == ')' || words_find(sts, left, 4) >= 0) && prose_stitches_follow(next) && !strchr("*([", *next);
}

/* `(25 sts, plus 5 border sts)`, `(8 sts between the markers)`: counts of parts of a row, not of the row. */
static bool counts_parts(const char *text, size_t close)
{
    static const char *const part[] = {"plus", "border", "borders", "edge", "edges", "edging", "between", "center", "centre", "panel"},
                             *const also[] = {"and", "the", "each", "side", "both", "of", "on", "for", "in", "marker", "markers", "at", "end"};
    const char *sts = isdigit((unsigned char)text[1]) ? words_behind_number(text + 1) : NULL;
    bool found = false;

    if (!sts || !words_are_stitches(sts))
        return false;
    for (size_t at = 1, n; at < close; at += n ? n : 1) {
        bool here = (n = words_length(text + at)) > 0 && words_find(text + at, part, 10) >= 0;

        if (n ? !here && !words_are_stitches(text + at) && words_find(text + at, also, 13) < 0 : !strchr(" ,+0123456789", text[at]))
            return false;
        found |= here;
    }
    return found;
}

size_t remarks_length(const char *text, size_t at)
{
    static const char *const times[] = {"x", "twice", "thrice", "once", "to", "rep", "repeat", "until", "rib", "ribbing", "across", "around"};
    const char *here = text + at;
    size_t close = 1 + strcspn(here + 1, "\r\n()");

    if (here[close] != ')' || close == 1)
        return 0;
    if (remarks_are(here + 1, close - 1) || is_purpose(here, close) || counts_parts(here, close))
        return close + 1;
    if (!behind_fabric(text, at) || !tells_fabric(here + 1))
        return 0;
    here += close + 1;
    here += strspn(here, " \t");
    return isdigit((unsigned char)*here) || words_find(here, times, sizeof times / sizeof *times) >= 0 ? 0 : close + 1;
}

/* How long `(40 sts)`, `[40 sts rem]` is; or 0. */
static size_t asserted_length(const char *text)
{
    static const char *const words[] = {"rem", "remain", "left"};
    size_t at = 1 + strspn(text + 1, " "), digits = strspn(text + at, "0123456789"), n;

    at += digits;
    for (at += strspn(text + at, " "); (n = words_length(text + at)) > 0; at += n, at += strspn(text + at, " "))
        if (!digits || !(words_are_stitches(text + at) || words_find(text + at, words, 3) >= 0))
            return 0;
    return digits && isalpha((unsigned char)text[at - 1]) && text[at] == (*text == '(' ? ')' : ']') ? at + 1 : 0;
}

bool remarks_on_fabric(const char *text)
{
    static const char *const fabric[] = {"stockinette", "stocking", "garter", "seed", "moss", "rib", "ribbing", "ridge", "ridges", "welt", "basketweave"},
                             *const also[] = {"reverse", "stitch", "st", "pattern", "fabric", "section", "this", "is", "the", "it", "a", "makes", "forms", "of", "in", "here", "side"};
    bool found = false;

    for (size_t n; *text && !words_ends_line(*text); text += n ? n : 1) {
        n = words_length(text);
        if (n && words_find(text, fabric, sizeof fabric / sizeof *fabric) >= 0)
            found = true;
        else if (n ? words_find(text, also, sizeof also / sizeof *also) < 0 : !strchr(" \t.!,'-", *text))
            return false;
    }
    return found;
}

size_t remarks_caption(const char *text, char plain[static SIGNS_PLAIN])
{
    static const char *const work[] = {"turn", "slip", "inc", "increase", "increasing", "dec", "decrease", "decreasing", "join", "change", "next",
                                       "place", "remove", "more", "as", "with", "using"};
    const unsigned worked = WORDS_PLAIN | WORDS_AGAIN | WORDS_WORK | WORDS_GO_ON | WORDS_CAST | WORDS_BIND | WORDS_THEN | WORDS_OFTEN | WORDS_TIMES;
    size_t count = asserted_length(text), at = count, n;
    bool words = false, named = false;

    if (!count || count >= SIGNS_PLAIN)
        return 0;
    for (; text[at] && !strchr("\r\n", text[at]); at += n ? n : 1) {
        n = words_length(text + at);
        if (n ? words_are(text + at, worked) || words_find(text + at, work, sizeof work / sizeof *work) >= 0 || words_row(text + at)
              : !(named && isdigit((unsigned char)text[at])) && !strchr(" \t.,:;-'\xE2\x80\x93\x94\x99", text[at]))
            return 0;
        words |= n > 0;
        named |= n > 2;
    }
    memcpy(plain, text, count);
    plain[words ? count : 0] = '\0';
    return words ? at : 0;
}

/* ---- counts ---- */

bool remarks_in_row(const char *text, size_t at)
{
    static const char *const next[] = {"next", "set"};
    size_t line = words_line_start(text, at), number;

    line += strspn(text + line, " \t-*+>|_(");
    number = line + strspn(text + line, "0123456789");
    return line < at && ((number > line && strchr(".:)|/(- \t", text[number + (text[number] == ' ')])) || words_are(text + line, WORDS_ROW | WORDS_SIDE) || words_find(text + line, next, 2) >= 0 ||
                         (tolower((unsigned char)text[line]) == 'r' && isdigit((unsigned char)text[line + 1])));
}

/* What may open a count, what closes it, and whether it must say of what. */
static const struct opening {
    const char *sign;
    char close;
    bool named;
} openings[] = {{"<", '>', false}, {"{", '}', true}, {"=", 0, false}, {"|", '|', false}, {"(", ')', true}, {"[", ']', true}, {"//", 0, true},
                {":", 0, true}, {"-", 0, true}, {"~", 0, true}, {"\xE2\x80\x93", 0, true}, {"\xE2\x80\x94", 0, true}, {"", 0, true}};
enum { OPENINGS = sizeof openings / sizeof *openings };

enum { SENTENCE = 200 };

/* `You should have 24 sts on the needle.` up to the line's end, or up to `close`; 0: something else. */
static size_t sentence_length(const char *text, char close, bool named, int *number)
{
    static const char *const words[] = {"st", "sts", "stitch", "stitches", "total", "count", "you", "should", "will", "now", "have", "there", "are",
                                        "on", "the", "your", "needle", "needles", "in", "all", "remain", "remaining", "rem", "left", "each"};
    size_t at = 0, n, numbers = 0;

    for (; text[at] && !strchr("\r\n", text[at]) && text[at] != close; at += n ? n : 1) {
        n = words_length(text + at);
        if (at > SENTENCE || (n ? words_find(text + at, words, sizeof words / sizeof *words) < 0 : !strchr(" \t.:0123456789", text[at])))
            return 0;
        named &= words_find(text + at, words, 6) < 0;
        if (!n && isdigit((unsigned char)text[at])) {
            n = strspn(text + at, "0123456789");
            *number = n < 7 ? atoi(text + at) : 0;
            if (++numbers > 1 || text[at + n] == ':')   /* `Rows 4-6: st st` */
                return 0;
        }
    }
    if (numbers != 1 || named || !*number || (close && close != '|' && text[at] != close))
        return 0;
    at += close && text[at] == close;
    n = at + strspn(text + at, " \t.");
    return text[n] && !strchr("\r\n", text[n]) ? 0 : at;
}

size_t remarks_said(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const begins[] = {"you", "there", "now", "total", "stitch"};
    const char *here = text + at;
    const struct opening *opening = openings;
    size_t length;
    int number = 0;

    while (strncmp(here, opening->sign, strlen(opening->sign)) != 0)
        opening++;
    if (strchr("([", *here) && asserted_length(here))
        return 0;
    if (!*opening->sign && (words_find(here, begins, 5) < 0 || at < 2 || !strchr(".;,", text[at - 1 - (text[at - 1] == ' ')])))
        return 0;
    length = strlen(opening->sign);
    length += opening->close ? 0 : strspn(here + length, "->");
    number = 0;
    if (!sentence_length(here + length, opening->close, opening->named, &number) || !remarks_in_row(text, at))
        return 0;
    length += sentence_length(here + length, opening->close, opening->named, &number);
    snprintf(plain, SIGNS_PLAIN, "(%d)", number);
    if (strlen(plain) > length)
        *plain = '\0';
    return *plain ? length : 0;
}

size_t remarks_column(const char *text, size_t at)
{
    size_t digits = strspn(text + at + 1, "0123456789");

    return digits && at > 0 && !isspace((unsigned char)text[at - 1]) && prose_line_ends(text + at + 1 + digits) && remarks_in_row(text, at) ? 1 + digits : 0;
}

size_t remarks_bar(const char *text, size_t at)
{
    size_t line, end = at + 1 + strspn(text + at + 1, " \t0123456789");

    end += text[end] == '|';
    end += strspn(text + end, " \t");
    if (text[end] && !strchr("\r\n", text[end]))
        return 0;
    line = words_line_start(text, at);
    if (at > 1 && text[at - 1] == ' ' && strchr(".!?", text[at - 2]))
        return end - at;
    return remarks_in_row(text, at) || prose_statement_follows(text + line + strspn(text + line, " \t|")) ? end - at : 0;
}

size_t remarks_chatter(const char *text)
{
    static const char *const work[] = {"end", "through", "back", "loop", "loops", "front", "yarn", "with", "in", "as", "if", "color", "colour", "twisted", "slip", "wrap", "turn",
                                       "yo", "ssk", "inc", "increase", "dec", "decrease", "tog", "together", "cable", "cross", "sl", "pass", "over", "lift", "drop", "next", "make"},
                             *const talk[] = {"the", "is", "are", "this", "that", "these", "you", "your", "here", "it", "not", "what", "there", "was", "i", "my", "we"};
    size_t at = 1, n, words = 0, talked = 0;

    for (; text[at] && !strchr("\r\n()", text[at]); at += n ? n : 1) {
        n = words_length(text + at);
        if (n ? (words_are(text + at, WORDS_OF_ROW) || words_one_of("ws|rs|wrong side|right side", text + at) || words_find(text + at, work, sizeof work / sizeof *work) >= 0)
              : !strchr(" ,.!?;:'\"\xE2\x80\x98\x99\x9C\x9D-", text[at]))
            return 0;
        words += n > 0;
        talked += n && words_find(text + at, talk, sizeof talk / sizeof *talk) >= 0;
    }
    if (text[at] != ')')        /* one that is never closed */
        return words > 4 && talked > 2 && text[at] != '(' ? at : 0;
    return words > 1 && (strchr("!?", text[at - 1]) || (words > 3 && talked)) ? at + 1 : 0;
}

/* Whether a text of so many bytes casts on. */
static bool casts_on(const char *text, size_t length)
{
    for (size_t at = 0; at < length; at++)
        if (words_one_of("cast on|co", text + at) && !isalnum((unsigned char)text[at - 1]))
            return true;
    return false;
}

size_t remarks_version(const char *text, size_t at)
{
    enum { BYTES = 500 };
    const char *first = text + at + 1;
    size_t close = at + 1 + strcspn(first, "()"), end = close + 1;

    if (text[close] != ')' || close - at > BYTES || !words_one_of("for|if|to|note|optional|you|alternatively|larger|smaller|wider", first))
        return 0;
    end += strspn(text + end, ".!");
    return strchr("\r\n", words_sign_before(text, at, " \t")) && prose_line_ends(text + end) && casts_on(first, close - at - 1) ? end - at : 0;
}

size_t remarks_face(const char *text, size_t at)
{
    static const char *const faces[] = {":-)", ":)", ";-)", ";)", ":D", "<3", ":-D", "^^"};

    for (size_t i = 0; at > 0 && text[at - 1] == ' ' && i < sizeof faces / sizeof *faces; i++)
        if (strncmp(text + at, faces[i], strlen(faces[i])) == 0 && (!text[at + strlen(faces[i])] || strchr(" \r\n", text[at + strlen(faces[i])])))
            return strlen(faces[i]);
    return 0;
}
