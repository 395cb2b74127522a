/* SPDX-License-Identifier: GPL-3.0-or-later
 * A word of row text in; out whether it is one that version 1 cannot knit, with
 * a message that names it and says why. */
#include "lang/refused.h"

#include <ctype.h>
#include <string.h>

enum reason { TOPOLOGY, SHORT_ROWS, COLOURS, MARKERS, ELSEWHERE };
enum { WORDS = 40, LONGEST = 100 };

/* Each with the word and what it is. */
static const struct {
    enum diag_code code;
    const char *text, *hint;
} reasons[] = {
    [TOPOLOGY] = {CODE_SHAPING,
                  "'%s' (%s) changes the stitch count or the topology; version 1 handles knit and purl (and your own plain stitches)",
                  NULL},
    [SHORT_ROWS] = {CODE_SHAPING, "'%s' (%s) leaves stitches of the row unworked; version 1 works every row to its end", NULL},
    [COLOURS] = {CODE_SHAPING, "'%s' (%s) is nothing version 1 can show: it knits with one yarn",
                 "the fold does not depend on colours: leave them out, and work the stitches alone"},
    [MARKERS] = {CODE_ELSEWHERE, "'%s' (%s): where markers hang is not kept", "say the stitches: `k to last 4 sts`"},
    [ELSEWHERE] = {CODE_ELSEWHERE, "'%s' is %s; version 1 needs the row's stitches themselves",
                   "write the row out, edges and all; or make the panel a motif: `beside(tile(garter, 5, 2), panel, ..)`"},
};

/* '#' stands for digits, '*' for anything between. */
static const struct {
    const char *what;
    enum reason reason;
    const char *word[WORDS];
} refused[] = {
    {"a decrease", TOPOLOGY,
     {"k#tog*", "p#tog*", "ssk", "sssk", "ssp", "skp*", "sk#p*", "s#kp*", "cdd", "dec*", "tog", "psso*",
      "decrease*", "ktog"}},
    {"an increase", TOPOLOGY,
     {"yo", "yo#", "yfwd", "yf", "yrn", "yon", "m#", "m#l", "m#r", "m#p*", "kfb", "kf&b", "pfb", "kfbf", "inc*",
      "lli", "rli", "increase*", "kfbf#", "k#fb", "m1#*"}},
    {"binding off", TOPOLOGY,
     {"bo", "bo#", "bind"}},
    {"casting on or off", TOPOLOGY,
     {"cast"}},
    {"a slipped stitch", TOPOLOGY,
     {"sl", "sl#*", "slip*", "s#", "wyif", "wyib", "pwise", "kwise", "yb"}},
    {"a twisted stitch", TOPOLOGY,
     {"ktbl", "k#tbl", "k#-tbl", "ptbl", "p#tbl", "tbl", "tbl*", "through the back*"}},
    {"a stitch into the row below", TOPOLOGY,
     {"k#b"}},
    {"a cable", TOPOLOGY,
     {"c#f*", "c#b*", "c#l*", "c#r*", "t#f*", "t#b*", "t#l", "t#r", "tw#*", "cr#*", "rt", "lt", "cable*", "cn",
      "#/#*", "cross*", "twist*"}},
    {"a bobble", TOPOLOGY,
     {"mb", "bobble*", "nupp*", "popcorn*"}},
    {"a dropped stitch", TOPOLOGY,
     {"drop*"}},
    {"a short row", SHORT_ROWS,
     {"w&t", "wrap*", "turn", "w&t*", "ds"}},
    {"a bead", TOPOLOGY,
     {"bead*", "pb", "place"}},
    {"a colour", COLOURS,
     {"mc", "cc", "cc#", "with", "using", "colour*", "color*", "col", "yarn", "change", "switch"}},
    {"a marker", MARKERS,
     {"to *m", "to *marker", "until *m", "until *marker", "till *m"}},
    {"a pattern that stands elsewhere", ELSEWHERE,
     {"work *", "patt*", "follow *", "chart*"}},
};

static bool matches(const char *pattern, const char *word)
{
    for (; *pattern; pattern++) {
        if (*pattern == '*') {
            if (!pattern[1])
                return true;
            while (*word && !matches(pattern + 1, word))
                word++;
            return *word;
        }
        if (*pattern == '#') {
            if (!isdigit((unsigned char)*word))
                return false;
            word += strspn(word, "0123456789");
        } else if (tolower((unsigned char)*word++) != *pattern) {
            return false;
        }
    }
    return !*word;
}

bool refused_word(struct diag *diag, const char *word, struct span span)
{
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        for (int j = 0; j < WORDS && refused[i].word[j]; j++) {
            if (!matches(refused[i].word[j], word))
                continue;
            diag_error(diag, reasons[refused[i].reason].code, span, reasons[refused[i].reason].text, word,
                       refused[i].what);
            if (reasons[refused[i].reason].hint)
                diag_hint(diag, "%s", reasons[refused[i].reason].hint);
            return true;
        }
    return false;
}

bool refused_text(struct diag *diag, struct span span)
{
    const char *text = span.source->text;

    for (unsigned at = span.start; at < span.end; at++) {
        struct span word = {span.source, at, at};
        char copy[LONGEST];

        while (word.end < span.end && (isalnum((unsigned char)text[word.end]) || strchr("&/-", text[word.end] ? text[word.end] : ' ')))
            word.end++;
        if (word.end == at)
            continue;
        at = word.end;
        if (word.end - word.start >= LONGEST)
            continue;
        memcpy(copy, text + word.start, word.end - word.start);
        copy[word.end - word.start] = '\0';
        if (refused_word(diag, copy, word))
            return true;
    }
    return false;
}
