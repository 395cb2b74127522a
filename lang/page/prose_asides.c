/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; what stands there that is no work: remarks, notes, measures, out. */
#include "lang/page/prose.h"

#include "lang/page/prose_line.h"
#include "lang/page/words.h"
#include "lang/syntax.h"

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

    if (tells_no_number(words_skip_blanks(text)) || (prose_line_ends(text) && (words_line_has(prose_line_next(text), "cast") || prose_begins_cast_on(prose_line_next(text)))))
        return true;
    if (words_find(words_skip_blanks(text), how, sizeof how / sizeof *how) < 0)
        return false;
    for (size_t at = 0; at < line; at += words_length(text + at) + (words_length(text + at) == 0))
        if (isdigit((unsigned char)text[at]) || text[at] == '{' || words_find(text + at, count, sizeof count / sizeof *count) >= 0)
            return false;
    return true;
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

bool prose_remark_follows(const char *text)
{
    const char *behind = behind_remark(words_skip_blanks(text)), *next;

    for (next = behind; next && *next && !strchr("\r\n", *next); next = behind_remark(next))
        behind = next;
    behind = next ? next : behind;
    return behind && (!syntax_is_row(behind) || prose_statement_follows(behind));
}

bool prose_is_meaning(const char *text)
{
    text += strncasecmp(text, "(s)", 3) == 0 ? 3 : 0;
    return *words_skip_blanks(text) == '=';
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

bool prose_tells_fabric(const char *text)
{
    for (text = words_next(text); *text; text += words_length(text) + (words_length(text) == 0))
        if (words_one_of("is|are", text))
            return words_are(words_next(text), WORDS_PLAIN | WORDS_FABRIC) || words_one_of("knitted|purled|repeated|worked", words_next(text)) > 0;
    return false;
}

bool prose_places_markers(const char *text)
{
    for (text = words_next(text); words_one_of("a|the|stitch|st", text); text = words_next(text))
        ;
    text += strspn(text, " \t\r\n");
    return words_one_of("marker|markers", text) > 0;
}

bool prose_is_aside(const char *text)
{
    size_t n = words_line_within(text, WORDS_REACH);

    while (n > 0 && isspace((unsigned char)text[n - 1]))
        n--;
    return n > 0 && strchr("!?", text[n - 1]) && told_words(text) > 0;
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

bool prose_is_remark(const char *text)
{
    size_t n = 1, longest = 0;

    for (; isalnum((unsigned char)text[n]) || strchr(" ,-!'", text[n] ? text[n] : '.'); n += words_length(text + n) ? words_length(text + n) : 1)
        longest = words_length(text + n) > longest ? words_length(text + n) : longest;
    return *text == '(' && longest > 2 && text[n] == ')' && *words_skip_blanks(text + n + 1) == ':';
}

size_t prose_bracket_length(const char *text)
{
    static const char *const open[] = {"if", "note", "see", "this"};
    size_t n = 1;

    while (n < WORDS_REACH && text[n] && !strchr(")\r\n", text[n]))
        n++;
    return text[n] == ')' ? n + 1 : words_find(words_skip_blanks(text + 1), open, 4) >= 0 && n < WORDS_REACH ? n : 0;
}
