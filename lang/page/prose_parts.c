/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; the part of a knitter's line that stands there: a cast-on, stitches, a repeat, out. */
#include "lang/page/prose.h"

#include "lang/limits.h"
#include "lang/page/lengths.h"
#include "lang/page/repeats.h"
#include "lang/page/starred.h"
#include "lang/page/words.h"
#include "lang/syntax.h"

bool prose_line_ends(const char *text)
{
    text = words_skip_blanks(text);
    text += *text == '.';
    return !*words_skip_blanks(text) || strchr("\r\n#", *words_skip_blanks(text));
}

bool prose_statement_follows(const char *text)
{
    static const char *const word[] = {"with", "using", "weave"};

    text += strspn(text, "*_ \t");
    if (words_behind_number(text))
        return words_are_rows(words_behind_number(text));
    if (words_is(text, "k") || words_is(text, "p"))
        return prose_rows_follow(words_skip_blanks(text + 1));
    return words_are(text, WORDS_ROW | WORDS_CAST | WORDS_BIND | WORDS_PLAIN | WORDS_WORK | WORDS_AGAIN) || words_find(text, word, 3) >= 0;
}

bool prose_has_cast_on(const char *text)
{
    static const char *const multiple[] = {"multiple", "mult", "odd", "even", "any", "number"};
    const char *behind = words_behind_number(text = words_skip_blanks(text));

    if (words_is(text, "more") || words_is(text, "fewer"))
        return false;
    if (!behind)
        return words_find(words_next(text), multiple, sizeof multiple / sizeof *multiple) >= 0;
    behind = words_skip_blanks(behind);
    if (prose_line_ends(behind))
        return true;
    if (*behind == '(' && behind[strcspn(behind, ")\r\n")] == ')' && prose_line_ends(behind + strcspn(behind, ")") + 1))
        return true;
    behind += strcspn(behind, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.\r\n");
    return words_are_stitches(behind);
}

/* `until 2 sts remain`, `until the end`. */
static bool stitches_are_meant(const char *text)
{
    static const char *const word[] = {"st", "sts", "stitch", "stitches", "end", "last", "marker", "m", "row", "round", "rnd"};

    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (words_line_has(text, word[i]))
            return !words_line_has(text, "rows") && !words_line_has(text, "rounds") && !words_line_has(text, "yarn");
    return !*words_next(text);
}

bool prose_repeats_rows(const char *text)
{
    static const char *const word[] = {"for",  "these", "this",    "those", "last", "them", "all", "pattern",
                                       "previous", "preceding", "in", "as", "section", "sections"};

    struct starred starred;

    text = words_skip_blanks(text);
    if (starred_length(text, &starred) || repeats_everything_length(text))
        return true;
    if (words_is(text, "from") || words_is(text, "the"))
        text = words_next(text);

    /* `repeat until it measures 8 in`; not `repeat until 2 sts remain`. */
    if (words_length(text) > 3 && words_are_rows(words_next(text)))
        return true;
    if (words_is(text, "until") || words_is(text, "till"))
        return lengths_follow(text) || !stitches_are_meant(text);
    return words_find(text, word, sizeof word / sizeof *word) >= 0 || words_are_rows(text) || prose_rows_follow(text) || repeats_range(text) || (words_is(text, "r") && isdigit((unsigned char)text[1])) ||
           (isdigit((unsigned char)*text) && isalpha((unsigned char)text[strspn(text, "0123456789")]));
}

bool prose_fabric_follows(const char *text)
{
    static const char *const word[] = {"garter", "g",    "rev",   "reverse", "stockinette", "stocking", "stockinet",
                                       "st",     "seed", "moss",  "single",  "double",      "rib",     "ribbing"},
                             *const knit[] = {"k", "knit"};
    const char *by = words_skip_blanks(text + strspn(text, "0123456789"));

    return words_find(text, word, sizeof word / sizeof *word) >= 0 ||
           (isdigit((unsigned char)*text) && ((*by && strchr("xX/\xC3", *by)) || words_is(by, "by"))) ||
           (words_find(text, knit, 2) >= 0 && isdigit((unsigned char)*words_next(text)) &&
            (words_line_has(text, "rib") || words_line_has(text, "ribbing")));
}

bool prose_casts_some(const char *text)
{
    static const char *const word[] = {"beg", "beginning", "each", "next"};
    const char *off = text;

    while (*off && !words_is(off, "off"))
        off += words_length(off) ? words_length(off) : 1;
    if (!*off || !isdigit((unsigned char)*words_skip_blanks(off + 3)))
        return false;
    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (words_line_has(text, word[i]))
            return true;
    return words_line_has(text, "to") && words_line_has(text, "end");
}

size_t prose_begins_cast_on(const char *text)
{
    const char *on = words_next(text);

    if (words_is(text, "co"))
        return words_behind_number(on) ? 2 : 0;
    return words_is(text, "cast") && words_is(on, "on") && words_behind_number(words_skip_blanks(on + 2)) ? (size_t)(on + 2 - text) : 0;
}

static bool says_how_often(const char *text)
{
    static const char *const word[] = {"once", "twice", "times", "time", "more", "until", "for"};

    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (words_line_has(text, word[i]))
            return true;
    return false;
}

bool prose_says_how_often(const char *text)
{
    static const char *const word[] = {"once", "twice", "thrice", "times", "repeats", "reps"};

    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (words_line_has(text, word[i]))
            return !lengths_said(text);
    return false;
}

/* `k2, p2`, `*p1`, `knit`, `knit to end`, `rep row 1`. */
bool prose_stitches_follow(const char *text)
{
    static const char *const behind[] = {"to", "across", "all"};
    const char *next;

    text += strspn(text, " \t|");
    if ((*text == '*' && text[1] != '*') || (*text == '(' && syntax_is_row(text + 1)) || (*text == '[' && syntax_is_row(text + 1)))
        return true;
    next = words_next(text);
    if (words_are(text, WORDS_AGAIN) || words_is(text, "as"))
        return (words_are_rows(next) && !says_how_often(next)) || (isdigit((unsigned char)*next) && prose_line_ends(next + strspn(next, "0123456789")));
    if (!words_are(text, WORDS_PLAIN) && !(*text && strchr("kKpP", *text) && isdigit((unsigned char)text[1])))
        return false;
    if ((words_is(next, "every") || words_is(next, "each")) && words_are_stitches(words_next(next)))
        return true;
    if (strchr("([", *next) && *next && isdigit((unsigned char)next[1]))
        return true;
    return isdigit((unsigned char)text[1]) || !*next || strchr(".,|\r\n", *next) || words_find(next, behind, 3) >= 0 ||
           (words_behind_number(next) && !words_are_rows(words_behind_number(next)));
}

/* `repeat rows 1-4`, `bind off`, `purl 3 rows`, `work in rib`. */
static bool part_begins(const char *text)
{
    static const char *const again[] = {"the", "these", "this", "those", "them", "last", "for", "all"}, *const even[] = {"even", "straight"};
    const char *next = words_next(text), *rows = next;

    if (words_are(text, WORDS_AGAIN))
        return isdigit((unsigned char)*next) || repeats_rows_length(next) || words_find(next, again, sizeof again / sizeof *again) >= 0;
    if (words_is(text, "bind") || words_is(text, "cast"))
        return words_is(next, "off") && !isdigit((unsigned char)*words_next(next)) && *words_next(next) != '{';
    if (!words_are(text, WORDS_PLAIN | WORDS_WORK))
        return false;
    while (isalnum((unsigned char)*rows))
        rows++;
    rows = words_skip_blanks(rows);
    if (words_are_rows(words_is(rows, "more") ? words_next(rows) : rows))
        return true;
    while (words_find(next, even, 2) >= 0)
        next = words_next(next);
    return words_is(text, "work") && words_is(next, "in");
}

bool prose_sentence_begins(const char *text)
{
    static const char *const then[] = {"then", "and", "now"}, *const first[] = {"cont", "continue", "weave", "fasten", "cut", "break", "these", "this"},
                             *const begin[] = {"beg", "begin", "beginning", "start", "starting", "commencing"};
    const char *next = words_next(text), *side = words_is(words_next(next), "a") || words_is(words_next(next), "an") ? words_next(words_next(next)) : words_next(next);
    size_t ordinal = words_ordinal_length(text);

    if (part_begins(words_find(text, then, 3) >= 0 ? next : text))
        return true;
    if (words_find(text, first, sizeof first / sizeof *first) >= 0 || strncasecmp(text, "bo", 2) == 0)
        return true;
    if (words_find(text, begin, sizeof begin / sizeof *begin) >= 0)
        return (words_is(next, "with") || words_is(next, "on")) && strchr("kprwKPRW", *side) && *side;
    if (ordinal)
        return words_are_rows(words_skip_blanks(text + ordinal));
    if (words_is(text, "the") && words_is(next, "last"))
        return words_behind_number(words_next(next)) && words_are_rows(words_behind_number(words_next(next)));
    return (words_is(text, "next") && words_are_rows(next)) || (words_is(text, "cast") && words_is(next, "on"));
}

bool prose_is_head(const char *text)
{
    const char *colon = strchr(text, ':');

    return colon && (prose_line_ends(colon + 1) || prose_heads_rows(text, colon + 1));
}

bool prose_is_side_mistyped(const char *text)
{
    return *text == '(' && strspn(text + 1, "rRwWsS") == 2 && text[3] == ')';
}

bool prose_repeat_follows(const char *text)
{
    return words_are(words_skip_blanks(text), WORDS_AGAIN);
}

size_t prose_sentence_length(const char *text)
{
    size_t n = 0;

    while (text[n] && !strchr("\r\n;{}", text[n]) && !(text[n] == '.' && (!text[n + 1] || isspace((unsigned char)text[n + 1])) && !islower((unsigned char)*words_skip_blanks(text + n + 1))))
        n++;
    return n;
}

bool prose_number_ends(const char *text)
{
    const char *number = words_skip_blanks(text), *behind = words_skip_blanks(number + strspn(number, "0123456789"));

    return isdigit((unsigned char)*number) && (!*behind || strchr(",;.([\r\n", *behind));
}

bool prose_count_follows(const char *text)
{
    const char *sts;

    text = words_skip_blanks(text);
    sts = words_skip_blanks(text + strspn(text, "0123456789"));
    return sts > text && words_are_stitches(sts) && prose_line_ends(sts + words_length(sts));
}

bool prose_times_follow(const char *text)
{
    const char *behind = words_behind_number(words_skip_blanks(text));

    return behind && (words_is(behind, "times") || words_is(behind, "time") || words_is(behind, "more"));
}

size_t prose_but_end(const char *text)
{
    static const char *const but[] = {"but", "except"};
    const char *at = text;

    if (words_find(at, but, 2) < 0)
        return 0;
    at = words_next(at);
    if (!words_are(at, WORDS_END))
        return 0;
    at = words_next(at);
    at = words_is(at, "with") ? words_skip_blanks(at + 4) : at;
    return (size_t)(at - text);
}

bool prose_comma_is_idle(const char *text)
{
    return prose_but_end(words_skip_blanks(text)) || prose_times_follow(text) || strchr(".:", *words_skip_blanks(text)) || words_is(words_skip_blanks(text), "or");
}

bool prose_row_word(const char *text)
{
    return words_find(text, statement_word, nstatement_words) >= 0 || words_are_rows(text);
}

bool prose_works_until(const char *text)
{
    static const char *const work[] = {"k", "knit", "p", "purl"};
    const char *next = words_next(text);

    if (words_find(text, work, 4) < 0)
        return false;
    if (words_is(next, "for"))
        return lengths_follow(words_skip_blanks(next + 3));
    return (words_is(next, "until") || words_is(next, "till")) && (lengths_follow(next) || words_line_has(next, "length") || words_line_has(next, "measures"));
}

size_t prose_names_pattern(const char *text)
{
    static const char *const words[] = {"pattern", "patt", "chart", "motif", "panel"};
    size_t lead = words_length(text), end = lead, named = 0;

    while (end < PROSE_NAME && (isalnum((unsigned char)text[end]) || text[end] == ' ' || (text[end] && !strchr("\r\n.,;(){}[]*", text[end]))))
        end++;
    for (size_t at = lead + 1; at < end && named < end; at++)
        for (int i = isspace((unsigned char)text[at - 1]) && !isspace((unsigned char)text[at]) ? 0 : 5; i < 5; i++) {
            size_t behind = at + strlen(words[i]);

            if ((text[at] | 0x20) == *words[i] && strncasecmp(text + at, words[i], strlen(words[i])) == 0)
                named = behind < end && isspace((unsigned char)text[behind]) ? end : named > behind ? named : behind;
        }
    return named > LIMIT_NAME ? LIMIT_NAME : named;
}

size_t prose_sizes_length(const char *text, int *n)
{
    const char *at = text + 1, *close;

    for (*n = 0; isdigit((unsigned char)*(at += strspn(at, " \t"))); ++*n) {
        at += strspn(at, "0123456789");
        at += strspn(at, " \t");
        if (!strchr(",:/-", *at) || !*at) {
            ++*n;
            break;
        }
        at++;
    }
    close = at + strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ \t.");
    if (*close != (*text == '(' ? ')' : ']') || (*n == 1 && close > at))
        return 0;
    return *n ? (size_t)(close + 1 - text) : 0;
}
