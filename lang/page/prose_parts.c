/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; what of a knitter's line stands there, out. */
#include "lang/page/prose.h"

#include "lang/page/lengths.h"
#include "lang/limits.h"
#include "lang/page/prose_line.h"
#include "lang/page/repeats.h"
#include "lang/syntax.h"
#include "lang/page/starred.h"
#include "lang/page/words.h"

bool prose_line_ends(const char *text)
{
    text = words_skip_blanks(text);
    text += *text == '.';
    return !*words_skip_blanks(text) || strchr("\r\n#", *words_skip_blanks(text));
}

bool prose_names_row(const char *text)
{
    for (size_t i = 0; i < WORDS_REACH && text[i] && !strchr(":\r\n", text[i]); i += words_length(text + i) + (words_length(text + i) == 0))
        if (words_are_rows(text + i))
            return true;
        else if (text[i] == '.' && isupper((unsigned char)*words_skip_blanks(text + i + 1)))
            return false;
    return false;
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

/* `Cast on enough stitches for your scarf`: how many is not said. */
static bool tells_no_number(const char *text)
{
    static const char *const which[] = {"the", "stitches", "enough", "sufficient", "your", "as", "however"}, *const count[] = {"multiple", "multiples"};
    size_t sentence = prose_sentence_length(text);

    if (words_find(text, which, sizeof which / sizeof *which) < 0)
        return false;
    for (size_t at = 0; at < sentence; at += words_length(text + at) + (words_length(text + at) == 0))
        if (words_behind_number(text + at) || text[at] == '{' || words_find(text + at, count, 2) >= 0)
            return false;
    return true;
}

bool prose_tells_how(const char *text)
{
    static const char *const how[] = {"using", "with", "via", "by"}, *const count[] = {"st", "sts", "stitch", "stitches", "multiple", "multiples", "number", "as", "for"};
    size_t line = words_line_within(text, WORDS_REACH);

    if (tells_no_number(words_skip_blanks(text)) || (prose_line_ends(text) && words_line_has(prose_line_next(text), "cast")))
        return true;
    if (words_find(words_skip_blanks(text), how, sizeof how / sizeof *how) < 0)
        return false;
    for (size_t at = 0; at < line; at += words_length(text + at) + (words_length(text + at) == 0))
        if (isdigit((unsigned char)text[at]) || text[at] == '{' || words_find(text + at, count, sizeof count / sizeof *count) >= 0)
            return false;
    return true;
}

bool prose_repeats_rows(const char *text)
{
    static const char *const word[] = {"for",  "these", "this",    "those", "last", "them", "all", "pattern",
                                       "previous", "preceding", "in", "as", "section", "sections"};

    struct starred starred;

    text = words_skip_blanks(text);
    if (starred_length(text, &starred))
        return true;
    if (words_is(text, "from") || words_is(text, "the"))
        text = words_next(text);

    /* `repeat until it measures 8 in`; not `repeat until 2 sts remain`. */
    if (words_length(text) > 3 && words_are_rows(words_next(text)))
        return true;
    if (words_is(text, "until") || words_is(text, "till"))
        return lengths_follow(text) || !stitches_are_meant(text);
    return words_find(text, word, sizeof word / sizeof *word) >= 0 || words_are_rows(text) || prose_rows_follow(text) || (words_is(text, "r") && isdigit((unsigned char)text[1])) ||
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

size_t prose_rows_within(const char *text)
{
    for (size_t i = 1; text[i]; i++) {
        const char *behind = words_next(text + i), *rows = words_behind_number(behind);

        if (isalnum((unsigned char)text[i - 1]) || !words_are(text + i, WORDS_PLAIN | WORDS_WORK))
            continue;
        if ((rows && words_are_rows(rows)) || (words_is(text + i, "work") && words_row(behind)) || (words_are(behind, WORDS_EVERY) && words_are_rows(words_next(behind))) ||
            (words_is(text + i, "work") && words_is(behind, "in") && prose_fabric_follows(words_skip_blanks(behind + 2))))
            return i;
    }
    return 0;
}

/* `3 repeats of the 2 rows`, `these 4 rows`: what begins at i is named, not counted. */
static bool is_named(const char *sentence, size_t i)
{
    static const char *const before[] = {"the", "these", "those", "this"};

    while (i > 0 && strchr(" \t", sentence[i - 1]))
        i--;
    for (size_t at = i; at > 0 && isalpha((unsigned char)sentence[at - 1]); i = --at)
        ;
    return words_find(sentence + i, before, sizeof before / sizeof *before) >= 0;
}

size_t prose_row_count(const char *sentence)
{
    for (size_t i = 1, n = words_line_within(sentence, WORDS_REACH); i < n; i++) {
        const char *behind = isspace((unsigned char)sentence[i - 1]) ? words_behind_number(sentence + i) : NULL;

        if (behind && is_named(sentence, i))
            continue;
        if (behind && words_is(behind, "more"))
            behind = words_skip_blanks(behind + 4);
        if (behind && words_are_rows(behind))
            return i;
    }
    return 0;
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

bool prose_is_bare_row(const char *text, bool plain)
{
    const unsigned work = WORDS_END | WORDS_EVERY | WORDS_AGAIN | WORDS_STITCH | WORDS_TIMES | WORDS_OFTEN | WORDS_NUMBER;
    static const char *const other[] = {"to", "across", "around", "from", "the", "of", "last", "more", "and", "place", "slip", "marker", "pm", "sm"},
                             *const whole[] = {"the", "of", "this", "each"};
    size_t at = strspn(text, "*([ \t");
    bool row = false;
    bool counted = false, closed = false;

    if (!words_are(text + at, WORDS_PLAIN))
        return false;
    for (size_t n; at < WORDS_REACH && text[at] && !strchr("\r\n#", text[at]); at += n) {
        n = words_length(text + at);
        if (words_are(text + at, WORDS_PLAIN))
            counted |= words_behind_number(words_skip_blanks(text + at + n)) != NULL;
        else if (n ? !(row && words_are_rows(text + at)) && !words_are(text + at, work) && words_find(text + at, other, sizeof other / sizeof *other) < 0 : closed || !strchr(" \t*()[],;.0123456789", text[at]))
            return false;
        closed |= text[at] == '.' && !prose_line_ends(text + at);
        row = n ? words_find(text + at, whole, sizeof whole / sizeof *whole) >= 0 : row && text[at] == ' ';
        n = n ? n : 1;
    }
    return at < WORDS_REACH && (counted || plain);
}

bool prose_row_line(const char *text)
{
    const char *first = text + (*text == '*'), *number = words_next(first);

    return words_are(first, WORDS_PLAIN) && isdigit((unsigned char)*number) && !words_are_rows(words_skip_blanks(number + strspn(number, "0123456789"))) &&
           !words_line_has(text, "rib") && !words_line_has(text, "ribbing") && !words_line_has(text, "rows") && !words_line_has(text, "more");
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

/* Behind a sentence of two words or more, none of which is a row's; NULL: it is none. */
static const char *behind_remark(const char *text)
{
    static const char *const work[] = {"end", "ending", "knits", "purls", "last", "across", "slip", "sl", "wrap", "as", "same", "turn"};
    int words = 0, nwork = sizeof work / sizeof *work - words_is(text, "do");

    if (!isupper((unsigned char)*text) || words_length(text) < 2)
        return NULL;
    for (; *text && !strchr(".!\r\n", *text); words++) {
        size_t n = words_length(text);

        if (!n || words_are(text, WORDS_OF_ROW | WORDS_STITCH | WORDS_WORK | WORDS_CAST | WORDS_BIND) || words_find(text, work, nwork) >= 0)
            return NULL;
        text += n;
        text += strspn(text, " \t,'-");
    }
    return words > 1 ? text + strspn(text, ".! \t") : NULL;
}

bool prose_footnote_follows(const char *text)
{
    static const char *const note[] = {"see", "note", "notes", "nb", "n.b"}, *const to[] = {"to", "from"};
    const unsigned work = WORDS_PLAIN | WORDS_AGAIN | WORDS_TIMES | WORDS_OFTEN | WORDS_END;
    const char *at = words_skip_blanks(text);

    if (words_find(at, note, 5) < 0)
        return false;
    for (; *at && !strchr("\r\n", *at); at += words_length(at) ? words_length(at) : 1)
        if (strchr("0123456789*[]{}", *at) || words_are(at, work) || words_find(at, to, 2) >= 0)
            return false;
    return true;
}

bool prose_footnote_below(const char *text)
{
    size_t reach = 2 * WORDS_REACH;

    for (size_t i = 0; i < reach && text[i]; i++)
        if (words_ends_line(text[i]) && text[i + 1] == '*' && (prose_footnote_follows(text + i + 2) || prose_remark_follows(text + i + 2)))
            return true;
    return false;
}

size_t prose_sentence_length(const char *text)
{
    size_t n = 0;

    while (text[n] && !strchr("\r\n;{}", text[n]) && !(text[n] == '.' && (!text[n + 1] || isspace((unsigned char)text[n + 1])) && !islower((unsigned char)*words_skip_blanks(text + n + 1))))
        n++;
    return n;
}

bool prose_counts_fabric(const char *text)
{
    const char *rows = words_behind_number(text), *of = rows && words_are_rows(rows) ? words_next(rows) : NULL;

    return of && (words_is(of, "of") || words_is(of, "in")) && prose_fabric_follows(words_skip_blanks(of + 2));
}

bool prose_number_ends(const char *text)
{
    const char *number = words_skip_blanks(text), *behind = words_skip_blanks(number + strspn(number, "0123456789"));

    return isdigit((unsigned char)*number) && (!*behind || strchr(",;.([\r\n", *behind));
}

bool prose_remark_follows(const char *text)
{
    const char *behind = behind_remark(words_skip_blanks(text)), *next;

    for (next = behind; next && *next && !strchr("\r\n", *next); next = behind_remark(next))
        behind = next;
    behind = next ? next : behind;
    return behind && (!syntax_is_row(behind) || prose_statement_follows(behind));
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

bool prose_row_is_named(const char *text)
{
    text = words_skip_blanks(text);
    return words_are_rows(text) && *words_next(text) == ':';
}

bool prose_row_is_labelled(const char *text)
{
    const char *number = words_skip_blanks(text), *behind = words_skip_blanks(number + strspn(number, "0123456789"));

    return isdigit((unsigned char)*number) && (*behind == ':' || (*behind == '-' && behind[1] == ' '));
}

bool prose_is_meaning(const char *text)
{
    text += strncasecmp(text, "(s)", 3) == 0 ? 3 : 0;
    return *words_skip_blanks(text) == '=';
}

bool prose_row_word(const char *text)
{
    return words_find(text, statement_word, nstatement_words) >= 0 || words_are_rows(text);
}

bool prose_rows_follow(const char *text)
{
    const char *behind = *text == '{' ? text + strcspn(text, "}\r\n") : words_behind_number(text);

    if (behind && *behind == '}')
        behind = words_skip_blanks(behind + 1);
    if (behind && words_is(behind, "more"))
        behind = words_skip_blanks(behind + 4);
    return behind && words_are_rows(behind);
}

bool prose_rows_are_named(const char *text)
{
    const char *behind = words_behind_number(text);

    return behind && words_are_rows(behind) && strchr(",:", *words_next(behind)) && *words_next(behind);
}

bool prose_names_needle(const char *text)
{
    static const char *const words[] = {"needle", "needles", "dpn", "pin"};

    text = words_skip_blanks(text);
    return words_find(text, words, 4) >= 0 && strchr(":,-(", *words_next(text)) && !prose_line_ends(text + words_length(text));
}

/* The words of a sentence without a sign, a number or a word of a row's text; 0: it has one. */
static int told_words(const char *text)
{
    static const char *const work[] = {"right", "wrong", "as", "same", "to", "and", "all", "end", "set", "setup", "through", "sl", "slip", "yo",
                                       "inc", "dec", "increase", "decrease", "across", "in", "with", "cable", "cross"};
    const unsigned worked = WORDS_OF_ROW | WORDS_STITCH | WORDS_WORK | WORDS_FABRIC | WORDS_CAST | WORDS_BIND;
    int words = 0;

    for (text = words_skip_blanks(text); *text && !strchr("\r\n", *text); words++) {
        size_t n = words_length(text);

        if (!n || (text[n] != '?' && (words_are(text, worked) || words_find(text, work, sizeof work / sizeof *work) >= 0)))
            return 0;
        text += n;
        text += strspn(text, " \t,.!?'-");
    }
    return words;
}

bool prose_tells_of_row(const char *text)
{
    static const char *const tool[] = {"counter", "counters", "marker", "markers"};

    text = words_skip_blanks(text);
    return words_find(text, tool, sizeof tool / sizeof *tool) >= 0 || told_words(text + strspn(text, "0123456789")) > 2;
}

bool prose_is_aside(const char *text)
{
    size_t n = words_line_within(text, WORDS_REACH);

    while (n > 0 && isspace((unsigned char)text[n - 1]))
        n--;
    return n > 0 && strchr("!?", text[n - 1]) && told_words(text) > 0;
}

bool prose_heads_rows(const char *sentence, const char *behind)
{
    static const char *const more[] = {"then", "and", "now", "next", "work", "knit", "purl", "cont", "continue", "proceed"};
    const char *next = behind + strspn(behind, " \t\f\v\r\n");

    for (sentence += words_length(sentence); *sentence && *sentence != ':'; sentence += words_length(sentence) ? words_length(sentence) : 1)
        if (words_find(sentence, more, sizeof more / sizeof *more) >= 0)
            return false;
    return prose_names_row(next) || words_row(next);
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

bool prose_is_measure(const char *text)
{
    static const char *const work[] = {"row", "round", "rnd"},
                             *const unit[] = {"cm", "cms", "mm", "in", "ins", "inch", "inches", "st", "sts", "stitches", "rows", "rounds",
                                              "ball", "balls", "skein", "skeins", "hank", "hanks", "yard", "yards", "yds", "g", "gm", "gms", "grams", "oz"};
    bool number = false, units = false, equation = false;   /* `16 sts = 4 in` */

    for (size_t n; *text && !words_ends_line(*text); text += n ? n : 1) {
        n = words_length(text);
        if (units && (words_is(text, "per") || words_is(text, "each")) && words_are_rows(words_skip_blanks(text + n)))
            return prose_line_ends(words_skip_blanks(text + n) + words_length(words_skip_blanks(text + n)));    /* `17 sts per row` */
        equation |= units && *text == '=';
        if (n ? words_are(text, WORDS_PLAIN | WORDS_CAST | WORDS_BIND | WORDS_AGAIN | WORDS_WORK) || words_find(text, work, sizeof work / sizeof *work) >= 0 : strchr(equation ? "*{}|<>" : "*={}|<>", *text) != NULL)
            return equation;
        number |= isdigit((unsigned char)*text) != 0;
        units |= number && n && words_find(text, unit, sizeof unit / sizeof *unit) >= 0;
    }
    return units;
}

bool prose_side_is_worked(const char *text)
{
    static const char *const work[] = {"knit", "purl"};
    const char *behind = words_next(text);

    return words_are(text, WORDS_SIDE) && *behind == ':' && words_find(words_skip_blanks(behind + 1), work, 2) >= 0;
}

bool prose_is_remark(const char *text)
{
    size_t n = 1, longest = 0;

    for (; isalnum((unsigned char)text[n]) || strchr(" ,-!'", text[n] ? text[n] : '.'); n += words_length(text + n) ? words_length(text + n) : 1)
        longest = words_length(text + n) > longest ? words_length(text + n) : longest;
    return *text == '(' && longest > 2 && text[n] == ')' && *words_skip_blanks(text + n + 1) == ':';
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

size_t prose_bracket_length(const char *text)
{
    static const char *const open[] = {"if", "note", "see", "this"};
    size_t n = 1;

    while (n < WORDS_REACH && text[n] && !strchr(")\r\n", text[n]))
        n++;
    return text[n] == ')' ? n + 1 : words_find(words_skip_blanks(text + 1), open, 4) >= 0 && n < WORDS_REACH ? n : 0;
}

/* Behind the numbers and the side of a row's head; or NULL. */
static const char *behind_head(const char *text)
{
    if (!words_are_rows(text))
        return NULL;
    text = words_next(text);
    if (!isdigit((unsigned char)*text))
        return NULL;
    while (isdigit((unsigned char)*text) || strchr(" \t-,&()", *text ? *text : '.') || words_is(text, "and") || words_is(text, "to") ||
           words_is(text, "rs") || words_is(text, "ws"))
        text += words_length(text) ? words_length(text) : 1;
    return text;
}

bool prose_pattern_follows(const char *text)
{
    static const char *const multiple[] = {"multiple", "mult"};
    const char *head = behind_head(text), *number = words_next(text);

    if (head)
        return *head == ':' || prose_stitches_follow(head);
    if (words_is(text, "co"))
        return prose_has_cast_on(number);
    if (words_is(text, "cast"))
        return words_is(number, "on") && prose_has_cast_on(number + 2);
    return words_find(text, multiple, 2) >= 0 && words_is(number, "of");
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
