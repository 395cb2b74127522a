/* SPDX-License-Identifier: GPL-3.0-or-later
 * A word of row text in; out whether it is one that version 1 cannot knit, with
 * a message that names it and says why. */
#include "lang/refused.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum reason { TOPOLOGY, SHORT_ROWS, COLOURS, ELSEWHERE, RIBS, MACHINE };
enum { WORDS = 64, LONGEST = 100 };

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
    [ELSEWHERE] = {CODE_ELSEWHERE, "'%s' is %s; version 1 needs the row's stitches themselves",
                   "write the row out, edges and all; or make the panel a motif: `beside(tile(garter, 5, 2), panel, ..)`"},
    [MACHINE] = {CODE_ELSEWHERE, "'%s' (%s): a machine knits every row from one side, and here the sides take turns",
                 "what `knit 20 rows` makes on a machine is `Work 20 rows in st st`"},
    [RIBS] = {CODE_ELSEWHERE, "'%s' is %s; version 1 needs the stitches themselves", "`[k1, p1] twice`, or `*k1, p1; rep from * to last 3 sts`"},
};

/* '#' stands for digits, '*' for anything between; words of a phrase may have commas between them. */
static const struct {
    const char *what;
    enum reason reason;
    const char *word[WORDS];
} refused[] = {
    {"brioche, slipped and knitted together", TOPOLOGY,
     {"brk*", "brp*", "bark", "burp", "sl#yo*", "brioche"}},
    {"a decrease", TOPOLOGY,
     {"k#tog*", "p#tog*", "*-k#tog*", "bk#tog*", "slk#tog*", "ssk", "sssk", "ssp", "sssp", "skp*", "sk#p*", "s#kp*", "s#k",
      "sl*sso", "s#k*sso", "cdd", "dec*", "tog", "psso*", "p#sso", "decrease*", "ktog", "together", "narrow*", "slip slip knit",
      "slip slip purl"}},
    {"an increase", TOPOLOGY,
     {"yo", "yo#*", "yo-*", "yfwd", "yfd", "yf", "yrn", "yon", "yfon", "yfrn", "y#rn", "wfwd", "wrn", "won", "yarn over",
      "yarn forward", "yarn round needle", "yarn round", "yarn fwd", "m#*", "make 1", "make one", "kfb*", "kf&b", "pfb", "pf&b",
      "kbf", "pbf", "kfbf#", "k#fb", "p#fb", "k#f&b", "p#f&b", "inc*", "lli", "rli", "llinc", "rlinc", "llpi", "rlpi", "kll",
      "krl", "kyok", "k#yok#", "pick up", "widen*", "into front and back", "front and back", "into the front and back"}},
    {"binding off", TOPOLOGY,
     {"bo", "bo#", "bind"}},
    {"casting on or off", TOPOLOGY,
     {"cast", "co", "co#"}},
    {"a slipped stitch", TOPOLOGY,
     {"sl", "sl#*", "slip*", "slst", "s#", "s#p", "sp#", "wyif", "wyib", "wyf", "wyb", "ytf", "ytb", "yb", "pwise", "kwise",
      "purlwise", "knitwise"}},
    {"a twisted stitch", TOPOLOGY,
     {"ktbl", "k#tbl", "k#-tbl", "ptbl", "p#tbl", "tbl", "tbl*", "k#b-tbl", "ktb", "kb#", "pb#", "k-b", "p-b",
      "through the back loop", "through back loop", "through", "into the back", "into back"}},
    {"a stitch into the row below", TOPOLOGY,
     {"k#b", "p#b", "k#-b", "p#-b", "k#below", "below"}},
    {"a cable", TOPOLOGY,
     {"c#f*", "c#b*", "c#l*", "c#r*", "cf#", "cb#", "t#f*", "t#b*", "t#l", "t#r", "tw#*", "cr#*", "rt", "lt", "rt#", "lt#",
      "rc", "lc", "rpc", "lpc", "fc", "bc", "fpc", "bpc", "cable*", "cn", "#/#*", "#-st*", "cross*", "twist*"}},
    {"a bobble", TOPOLOGY,
     {"mb", "make bobble", "make a bobble", "bobble*", "nupp*", "popcorn*"}},
    {"a crochet stitch", TOPOLOGY,
     {"sc", "dc", "hdc", "ch", "ch#"}},
    {"a dropped stitch", TOPOLOGY,
     {"drop*"}},
    {"an elongated stitch", TOPOLOGY,
     {"kw", "kw#", "k#w#", "ek", "k#-wrap*", "elongated", "wrapping"}},
    {"a short row", SHORT_ROWS,
     {"w&t", "w+t", "wrap*", "turn", "w&t*", "ds", "gsr"}},
    {"a bead", TOPOLOGY,
     {"bead*", "pb", "place", "add bead", "add a bead"}},
    {"a colour", COLOURS,
     {"mc", "cc", "cc#", "with", "using", "in a", "in b", "in c", "in mc", "in cc", "in white", "in black", "in red", "in blue", "in green",
      "in main", "in contrast", "colour*", "color*", "col", "yarn", "change",
      "switch"}},
    {"a rib whose stitches are not said", RIBS,
     {"rib", "rib#", "ribbing"}},
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

/* Whether a small letter, a word's first, is a pattern's, or that begins with a sign. */
static bool may_match(const char *pattern, int first)
{
    return *pattern == first || *pattern < 'a';
}

/* The words from the span on that a phrase has, in small letters and with one blank between; "" where it has one word. */
static struct span phrase_at(const char *pattern, struct span span, char copy[LONGEST])
{
    const char *text = span.source->text;
    size_t words = 1, n = 0;

    for (const char *blank = strchr(pattern, ' '); blank; blank = strchr(blank + 1, ' '))
        words++;
    for (size_t i = 0; words > 1 && !strchr(pattern, '*') && i < words; i++) {
        size_t length = strcspn(text + span.start + n, " ,\t\r\n.;:()[]*#");

        n += length;
        if (i + 1 < words)
            n += strspn(text + span.start + n, " ,\t");
    }
    n = n < LONGEST ? n : 0;
    memcpy(copy, text + span.start, n);
    copy[n] = '\0';
    span.end = span.start + (unsigned)n;
    return span;
}

/* As `matches`; a blank of the pattern for blanks and commas of the text. */
static bool phrase_matches(const char *pattern, const char *text)
{
    char plain[LONGEST];
    size_t n = 0;

    for (; *text; text++)
        if (!strchr(" ,\t", *text))
            plain[n++] = *text;
        else if (n && plain[n - 1] != ' ')
            plain[n++] = ' ';
    plain[n] = '\0';
    return matches(pattern, plain);
}

/* `k2 A`: a letter right behind a number of stitches. */
static bool is_colour(const char *word, struct span span)
{
    unsigned at = span.start;

    while (at > 0 && span.source->text[at - 1] == ' ')
        at--;
    return strlen(word) == 1 && strchr("ABCDEF", *word) && at > 0 && at < span.start && isdigit((unsigned char)span.source->text[at - 1]);
}

/* `.. and so you cast on 60 sts` where no stitches are on the needle: it is the piece's own. */
static void hint_cast_on(struct diag *diag, struct span span)
{
    const char *text = span.source->text;
    size_t behind = prose_begins_cast_on(text + span.start);
    int n;

    for (unsigned at = 0; behind && at < span.start; at++)
        if (strchr("cC", text[at]) && (at == 0 || !isalnum((unsigned char)text[at - 1])) && prose_begins_cast_on(text + at))
            return;
    n = behind ? words_number(words_skip_blanks(text + span.start + behind)) : 0;
    if (n)
        diag_hint(diag, "the stitches the piece begins with stand on a line of their own, above its rows: `Cast on %d sts`", n);
}

static void report(struct diag *diag, const char *word, struct span span, enum reason reason, const char *what)
{
    char plain[LONGEST];
    size_t n = strlen(word);

    /* What a phrase of the text has left over is blank. */
    while (n > 0 && word[n - 1] == ' ')
        n--;
    if (n < LONGEST) {
        memcpy(plain, word, n);
        plain[n] = '\0';
        word = plain;
    }
    diag_error(diag, reasons[reason].code, span, reasons[reason].text, word, what);
    if (reasons[reason].hint)
        diag_hint(diag, "%s", reasons[reason].hint);
    if (tolower((unsigned char)*word) == 'c')
        hint_cast_on(diag, span);
}

/* `5/6 rows`: one of two numbers; not the cable 2/2. */
static bool is_choice(struct diag *diag, struct span span)
{
    const char *text = span.source->text + span.start;
    size_t digits = strspn(text, "0123456789"), others = digits && text[digits] == '/' ? strspn(text + digits + 1, "0123456789") : 0;
    const char *noun = words_skip_blanks(text + digits + 1 + others);

    if (!others || !words_one_of("row|rows|round|rounds|rnd|rnds|st|sts|stitch|stitches|times|inch|inches|cm|needle|needles", noun))
        return false;
    span.end = span.start + (unsigned)(digits + 1 + others);
    diag_error(diag, CODE_STITCH, span, "which of the two numbers holds is not said");
    diag_hint(diag, "write one of them: `%d %.*s`", words_number(text), (int)words_length(noun), noun);
    return true;
}

/* `.. ending with st as established`: the `with` is no yarn's. */
static bool is_ending(struct diag *diag, struct span span)
{
    const char *text = span.source->text;
    unsigned at = span.start;

    if (!words_is(text + at, "with"))
        return false;
    for (int i = 0; i < 2; i++) {
        while (at > 0 && text[at - 1] == ' ')
            at--;
        while (at > 0 && isalpha((unsigned char)text[at - 1]))
            at--;
        if (!words_one_of("end|ends|ending|finish|finishing", text + at))
            continue;
        diag_error(diag, CODE_STITCH, span, "what the row ends with is not said in stitches");
        diag_hint(diag, "the stitches themselves: `*k1, p1; rep from * to last st, k1`");
        return true;
    }
    return false;
}

bool refused_word(struct diag *diag, const char *word, struct span span)
{
    char copy[LONGEST];
    int first = tolower((unsigned char)span.source->text[span.start]);

    if (is_choice(diag, span) || is_ending(diag, span))
        return true;

    /* Phrases of several words come first: "yarn over" is no yarn. */
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        for (int j = 0; j < WORDS && refused[i].word[j]; j++) {
            struct span phrase = span;

            if (!may_match(refused[i].word[j], first))
                continue;
            phrase = phrase_at(refused[i].word[j], span, copy);
            if (!*copy || !phrase_matches(refused[i].word[j], copy))
                continue;
            report(diag, copy, phrase, refused[i].reason, refused[i].what);
            return true;
        }
    if (is_colour(word, span)) {
        report(diag, word, span, COLOURS, "a colour");
        return true;
    }
    first = tolower((unsigned char)*word);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        for (int j = 0; j < WORDS && refused[i].word[j]; j++) {
            if (!may_match(refused[i].word[j], first) || !matches(refused[i].word[j], word))
                continue;
            report(diag, word, span, refused[i].reason, refused[i].what);
            return true;
        }
    return false;
}

/* `place a marker` */
static bool is_marker(const char *text)
{
    const char *what = words_next(text);

    what = words_is(what, "a") ? words_skip_blanks(what + 1) : what;
    return words_is(text, "place") && (words_is(what, "marker") || words_is(what, "markers"));
}

bool refused_text(struct diag *diag, struct span span)
{
    const char *text = span.source->text;

    for (unsigned at = span.start; at < span.end; at++) {
        struct span word = {span.source, at, at};
        char copy[LONGEST];

        while (word.end < span.end && (isalnum((unsigned char)text[word.end]) || strchr("&/-+", text[word.end] ? text[word.end] : ' ')))
            word.end++;
        if (word.end == at)
            continue;
        at = word.end;
        if (word.end - word.start >= LONGEST || is_marker(text + word.start))
            continue;
        memcpy(copy, text + word.start, word.end - word.start);
        copy[word.end - word.start] = '\0';
        if (refused_word(diag, copy, word))
            return true;
    }
    return false;
}

/* ---- sentences ---- */

/* What a sentence of a page may ask for, as the words it begins with or has in it. `~` stands for a
 * colour: A, MC; `^` in front: only where the line or a clause of it begins. */
static const struct {
    const char *words, *what;
    enum reason reason;
} sentences[] = {
    {"dec #", "a decrease", TOPOLOGY},
    {"dec one", "a decrease", TOPOLOGY},
    {"decrease #", "a decrease", TOPOLOGY},
    {"decrease one", "a decrease", TOPOLOGY},
    {"^dec at", "a decrease", TOPOLOGY},
    {"^decrease at", "a decrease", TOPOLOGY},
    {"^dec each", "a decrease", TOPOLOGY},
    {"inc #", "an increase", TOPOLOGY},
    {"inc one", "an increase", TOPOLOGY},
    {"increase #", "an increase", TOPOLOGY},
    {"increase one", "an increase", TOPOLOGY},
    {"^inc at", "an increase", TOPOLOGY},
    {"^increase at", "an increase", TOPOLOGY},
    {"^inc each", "an increase", TOPOLOGY},
    {"^k#tog", "a decrease", TOPOLOGY},
    {"^p#tog", "a decrease", TOPOLOGY},
    {"^pick up and knit", "an increase", TOPOLOGY},
    {"^pick up and k", "an increase", TOPOLOGY},
    {"^slip #", "a slipped stitch", TOPOLOGY},
    {"^slip first", "a slipped stitch", TOPOLOGY},
    {"^slip the first", "a slipped stitch", TOPOLOGY},
    {"rc #", "a machine's row counter", MACHINE},
    {"carriage", "a machine's", MACHINE},
    {"^work short rows", "short rows", SHORT_ROWS},
    {"^with ~", "a colour", COLOURS},
    {"^using ~", "a colour", COLOURS},
    {"^change to ~", "a colour", COLOURS},
    {"^join ~", "a colour", COLOURS},
    {"^switch to ~", "a colour", COLOURS},
};

static bool is_colour_name(const char *text, size_t length)
{
    if (length == 1)
        return strchr("ABCDEF", *text) != NULL;
    return (length == 2 || (length == 3 && isdigit((unsigned char)text[2]))) && (strncmp(text, "MC", 2) == 0 || strncmp(text, "CC", 2) == 0);
}

/* How many bytes of the text the words take; 0: it has others. */
static size_t sentence_length(const char *words, const char *text)
{
    size_t at = 0;

    for (const char *word = words; *word; word += strcspn(word, " "), word += *word == ' ') {
        size_t n = strcspn(word, " "), length = strcspn(text + at, " \t\r\n,.;:(){}[]*");
        char pattern[LONGEST], copy[LONGEST];

        if (!length || length >= sizeof copy)
            return 0;
        memcpy(pattern, word, n);
        memcpy(copy, text + at, length);
        pattern[n] = copy[length] = '\0';
        if (*pattern == '~' ? !is_colour_name(copy, length) : !matches(pattern, copy))
            return 0;
        at += length;
        if (word[n])
            at += strspn(text + at, " \t\r\n");
    }
    return at;
}

bool refused_sentence(struct diag *diag, struct span line)
{
    const char *text = line.source->text;
    bool first = true;

    for (unsigned at = line.start; at < line.end; at++) {
        bool begins = isalnum((unsigned char)text[at]) && (at == line.start || !isalnum((unsigned char)text[at - 1]));

        for (size_t i = 0; begins && i < sizeof sentences / sizeof *sentences; i++) {
            bool clause = sentences[i].words[0] == '^';
            size_t length = (clause && !first) || sentences[i].words[clause] != tolower((unsigned char)text[at]) ? 0 : sentence_length(sentences[i].words + clause, text + at);
            char copy[LONGEST];

            if (!length || length >= sizeof copy || (sentences[i].reason == COLOURS && strchr(".\r\n", text[at + length])))
                continue;       /* `Change to MC.` is of whole rows */
            for (size_t j = 0; j < length; j++)
                copy[j] = (char)(isspace((unsigned char)text[at + j]) ? ' ' : text[at + j]);
            copy[length] = '\0';
            report(diag, copy, (struct span){line.source, at, at + (unsigned)length}, sentences[i].reason, sentences[i].what);
            return true;
        }
        first = strchr(".:;,", text[at]) || (first && text[at] == ' ');
    }
    return false;
}

void refused_part(struct diag *diag, struct span span)
{
    report(diag, "cast off", span, TOPOLOGY, "shaping");
}
