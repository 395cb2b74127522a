/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line's beginning in; out, how much of it is no part of the pattern that follows it. */
#include "lang/page/heads.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { NEEDLES = 60 };  /* bytes that say which they are */

/* ---- titles ---- */

/* Whether a cast-on follows: `Cast on 20 sts`, `With No. 9 needles cast on 20 sts`. */
static bool cast_on_follows(const char *text)
{
    static const char *const with[] = {"with", "using", "on"};
    size_t line = words_line_length(text);

    text += strspn(text, " \t");
    for (size_t i = 0; words_find(text, with, 3) >= 0 && i < line; i++)
        if (text[i] == ' ' && prose_begins_cast_on(text + i + 1))
            return true;
    return prose_begins_cast_on(text) > 0;
}

/* How long `Scarf #1:`, `1st Square:`, `STRIP A.` is at the beginning of a line, where a part of the pattern follows it; or 0. */
static size_t title_length(const char *text)
{
    static const char *const text_of[] = {"note", "notes", "tip", "tips", "gauge", "tension", "sample", "size", "sizes", "for"};
    size_t at = 0, words = 0, digits = 0;

    for (; words < 6 && text[at] != ':'; at += strspn(text + at, " .&,-#'")) {
        size_t n = strspn(text + at, "0123456789"), letters = words_length(text + at + n);

        if (n + letters == 0 || (prose_row_word(text + at + n) && !(at && words_is(text + at, "stitch"))) || words_find(text + at, text_of, sizeof text_of / sizeof *text_of) >= 0)
            return 0;
        at += n + letters;
        digits = letters ? 0 : n;
        words++;
    }
    if (text[at] != ':' || !words)
        return 0;
    at++;
    return cast_on_follows(text + at) || (digits && words > 1 && prose_pattern_follows(text + at + strspn(text + at, " \t"))) ? at : 0;
}

/* How long `Lace panel - ` is at the beginning of a line, before a row with its number; or 0. */
static size_t label_length(const char *text)
{
    static const char *const dashes[] = {"- ", "\xE2\x80\x93 ", "\xE2\x80\x94 "};
    size_t at = 0;

    for (int words = 0; words < 4 && isalpha((unsigned char)text[at]); words++) {
        if (prose_row_word(text + at) && !words_row(text + at))
            return 0;
        while (isalpha((unsigned char)text[at]))
            at++;
        at += strspn(text + at, " ");
    }
    for (int i = 0; at > 0 && i < 3; i++)
        if (strncmp(text + at, dashes[i], strlen(dashes[i])) == 0)
            return words_row(text + at + strlen(dashes[i])) ? at + strlen(dashes[i]) : 0;
    return 0;
}

/* How long `Beg 1 x 1 rib - ` is before a row or what is worked in it; or 0. */
static size_t begin_length(const char *text)
{
    size_t at, line = words_line_length(text);

    if (!words_is(text, "beg") && !words_is(text, "begin"))
        return 0;
    for (at = words_length(text); at < line && (isalnum((unsigned char)text[at]) || text[at] == ' '); at++)
        ;
    if (text[at - 1] != ' ' || text[at] != '-' || text[at + 1] != ' ')
        return 0;
    at += 1 + strspn(text + at + 1, " ");
    return words_row(text + at) || words_are(text + at, WORDS_WORK) ? at : 0;
}

size_t heads_rows_named(const char *text)
{
    static const char *const not_it[] = {"all", "every", "each", "even", "odd", "uneven", "next", "last", "first", "other", "following", "set", "setup", "prep", "as",
                                         "preparation", "foundation", "base", "rs", "ws", "right", "wrong", "alternate", "from", "to", "until", "end", "starting", "beg",
                                         "purl", "k", "p", "work", "and", "the", "for", "on", "in", "then", "now", "of", "same", "like", "this", "these", "a"};
    size_t at = 0, words = 0;

    for (; words < 3 && isalpha((unsigned char)text[at]) && !words_are_rows(text + at); words++) {
        if (prose_row_word(text + at) || words_find(text + at, not_it, sizeof not_it / sizeof *not_it) >= 0)
            return 0;
        at += words_length(text + at);
        at += strspn(text + at, " ");
    }
    return words && text[at - 1] == ' ' && words_row(text + at) ? at : 0;
}

size_t heads_label(const char *text)
{
    size_t at = heads_rows_named(text), end = at + words_length(text + at) + 1;

    if (!at)
        return 0;
    end += strspn(text + end, "0123456789 ,&-");
    end += words_is(text + end, "and") ? 3 + strspn(text + end + 3, "0123456789 ") : 0;
    end += strncasecmp(text + end, "(rs)", 4) == 0 || strncasecmp(text + end, "(ws)", 4) == 0 ? 4 : 0;
    return text[end] == ':' ? at : 0;
}

/* How long `Row 1:` is before a cast-on; or 0. */
static size_t first_row_length(const char *text)
{
    size_t at = words_are_rows(text) ? words_length(text) : tolower((unsigned char)*text) == 'r';

    at += at ? strspn(text + at, " ") : 0;
    if (!at || text[at] != '1' || isdigit((unsigned char)text[at + 1]))
        return 0;
    at++;
    at += strspn(text + at, " ") + strspn(text + at + strspn(text + at, " "), ":.");
    at += strspn(text + at, " ");
    return (words_is(text + at, "cast") || words_is(text + at, "co")) && prose_pattern_follows(text + at) ? at : 0;
}

/* How long `Row 2 (WS): purl and ` is, `Next row: `, before `bind off`, which is no row; or 0. Of some stitches it is refused. */
static size_t bind_off_length(const char *text)
{
    static const char *const next[] = {"next", "last", "final"}, *const off[] = {"bind", "cast", "binding", "casting"}, *const and[] = {"and", "while", "all", "sts", "stitches"},
                             *const some[] = {"but", "except", "first", "next", "last", "until", "to"};
    const char *at = words_find(text, next, 3) >= 0 ? words_next(text) : text, *bind;

    if (!words_are_rows(at) || (at == text && !words_row(text)))
        return 0;
    at = words_next(at);
    at = words_skip_blanks(at + strspn(at, "0123456789"));
    at = words_skip_blanks(at + (*at == '(' ? strcspn(at, ")\r\n") + 1 : 0));
    if (!*at || !strchr(":,-", *at))
        return 0;
    bind = at = words_skip_blanks(at + 1);
    bind = words_are(at, WORDS_PLAIN) ? words_next(at) : at;
    bind += *bind == ',' ? 1 + strspn(bind + 1, " ") : 0;
    while (bind > at && words_find(bind, and, 5) >= 0)
        bind = words_next(bind);
    if (words_find(bind, off, 4) < 0 || !words_is(words_next(bind), "off"))
        return 0;
    for (at = words_next(words_next(bind)); *at && !strchr("\r\n.;", *at); at += words_length(at) ? words_length(at) : 1)
        if (isdigit((unsigned char)*at) || *at == '{' || words_are(at, WORDS_NUMBER | WORDS_PLAIN) || words_find(at, some, 7) >= 0)
            return 0;
    return (size_t)(bind - text);
}

int heads_bound_off(const char *text)
{
    return bind_off_length(text) ? words_row(text) : 0;
}

/* Words of headings behind which no work is meant, though they name some. */
static bool is_aside(const char *text, size_t n)
{
    static const char *const words[] = {"gauge", "tension", "swatch", "note", "notes", "tip", "tips", "finishing", "abbreviations", "example", "option", "optional",
                                        "variation", "sizing", "instead"};

    for (size_t i = 0; i < n; i += words_length(text + i) + 1)
        if (words_find(text + i, words, sizeof words / sizeof *words) >= 0)
            return true;
    return false;
}

/* `Knit 4 rows`, `repeat rows 1-4`, a row with its number, a cast-on. */
static bool is_work(const char *text)
{
    const char *behind = words_next(text);

    return prose_pattern_follows(text) || (words_are(text, WORDS_PLAIN | WORDS_WORK) && prose_rows_follow(behind)) ||
           (words_are(text, WORDS_AGAIN) && prose_repeats_rows(behind));
}

/* How long `Final border: ` is before rows to work; or 0. */
static size_t part_length(const char *text)
{
    bool bold = strncmp(text, "**", 2) == 0;
    size_t at = bold ? 2 : 0, words = 0;

    for (; isalpha((unsigned char)text[at]); at += strspn(text + at, " &'-"), words++) {
        if (prose_row_word(text + at))
            return 0;
        at += words_length(text + at);
    }
    if (words < 1 || words > 5 || !strchr(":*", text[at]) || !text[at] || is_aside(text, at))
        return 0;
    at += strspn(text + at, bold ? ":* \t" : ": \t");
    return is_work(text + at) ? at : 0;
}

/* ---- pages and films ---- */

/* How long `12 comments:` is, `3 replies`: what pages count; or 0. */
static size_t counter_length(const char *text)
{
    static const char *const words[] = {"comment", "comments", "like", "likes", "reply", "replies", "view", "views", "share", "shares", "upvotes", "points", "hours", "days",
                                        "months", "years", "min", "minutes", "people", "responses", "thoughts"};
    const char *word = words_skip_blanks(text + strspn(text, "0123456789,.kK"));

    return words_find(word, words, sizeof words / sizeof *words) >= 0 ? words_line_length(text) : 0;
}

/* How long `[20 stitches each row]` is, a line of its own; or 0. */
static size_t note_length(const char *text)
{
    size_t line = words_line_length(text), n = 1;
    bool stitches = false;

    while (line > 0 && strchr(" \t.", text[line - 1]))
        line--;
    if (!strchr("([", *text) || line < 3 || !strchr(")]", text[line - 1]) || !isdigit((unsigned char)text[1]))
        return 0;
    for (; n + 1 < line; n += words_length(text + n) + 1) {
        stitches |= words_are_stitches(text + n);
        if (!isalnum((unsigned char)text[n]) && text[n] != ' ')
            return 0;
    }
    return stitches ? line : 0;
}

/* How long a line is that is an address of the web, or nothing but marks; or 0. */
static size_t furniture_length(const char *text)
{
    size_t line = words_line_length(text), word = strcspn(text, " \t\r\n"), marks = 0;

    if (strncasecmp(text, "www.", 4) == 0 || strncasecmp(text, "http", 4) == 0 || (word == line && memchr(text, '@', line) && isalnum((unsigned char)*text)))
        return word == line ? line : 0;
    for (size_t i = 0; i < line; i++) {
        if (!strchr("*=_~-.|: \t", text[i]))
            return 0;
        marks += text[i] != ' ';
    }
    return marks > 2 ? line : 0;
}

/* How long `3:10` or `1:02:45` is before a row with its stitches or a cast-on; before other words the line is text. */
static size_t time_length(const char *text)
{
    size_t at = strspn(text, "0123456789"), places = 0, n;

    for (n = at; n && n <= 2 && text[at] == ':' && strspn(text + at + 1, "0123456789") == 2; places++)
        at += 3;
    if (!places || !strchr(" \t-", text[at]) || !text[at])
        return 0;
    at += strspn(text + at, " \t-");
    return prose_pattern_follows(text + at) ? at : words_length(text + at) ? words_line_length(text) : 0;
}

/* How long a line is that is a number alone: of a page, or of a table's cell. Where the next line
 * holds stitches it is a row's, which goes on there: up to that line, with a stop. */
static size_t number_length(const char *text, bool *stop)
{
    size_t digits = strspn(text, "0123456789"), end = digits + strspn(text + digits, " \t"), next;

    if (!digits || digits > 4 || !text[end] || !strchr("\r\n", text[end]))
        return 0;
    next = end + strspn(text + end, " \t\r\n");
    if (text[next] && strchr("])},", text[next]))
        return 0;
    *stop = prose_stitches_follow(text + next) && !words_are_rows(words_next(text + next));
    return *stop ? next : end;
}

/* ---- tables ---- */

/* Whether a cell holds a row's number or side. */
static bool names_row(const char *cell, size_t n)
{
    static const char *const sides[] = {"rs", "ws", "right", "wrong", "next", "all", "every"};

    for (size_t i = 0; i < n; i++)
        if (isdigit((unsigned char)cell[i]) || (words_length(cell + i) && (i == 0 || !isalpha((unsigned char)cell[i - 1])) && words_find(cell + i, sides, sizeof sides / sizeof *sides) >= 0))
            return true;
    return false;
}

/* `let b = c || d`, `motif m { chart { k | k p | k } }`: a bar of the language's own, not of a table. */
static bool is_statement(const char *text)
{
    static const struct {
        const char *word, *marks;   /* one of which its line has */
    } statements[] = {{"let", "="}, {"param", "="}, {"motif", "{="}, {"swatch", "?"}, {"if", "{"}, {"for", "{"}, {"stitch", "{"},
                      {"gauge", "{"}, {"material", "{"}, {"springs", "{"}, {"mesh", "{"}, {"solve", "{"}, {"output", "{"}};
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (words_is_name(text, statements[i].word) && words_line_has_sign(text, statements[i].marks))
            return true;
    return false;
}

/* Whether the line has nothing but words of a table's head, `Row  Side  Instructions`. */
static bool is_table_head(const char *text)
{
    static const char *const words[] = {"row", "rnd", "round", "side", "instruction", "instructions", "stitches", "sts", "st", "stitch", "count", "pattern", "work",
                                        "number", "notes", "directions", "done", "total"};
    size_t line = words_line_length(text), n = 0;

    for (size_t at = 0, length; at < line; at += length + strspn(text + at + length, " \t#|/")) {
        length = words_length(text + at);
        if (!length || words_find(text + at, words, sizeof words / sizeof *words) < 0)
            return false;
        n++;
    }
    return n > 1;
}

/* `## Row 1` of Markdown, its stitches on the next line: the signs. */
static size_t signs_of_heading(const char *text)
{
    size_t at = strspn(text, "#"), line = words_line_length(text);

    at += strspn(text + at, " *");
    return at && words_row(text + at) && prose_stitches_follow(text + line + strspn(text + line, "\r\n \t*-")) && !memchr(text + at, ',', line - at) ? at : 0;
}

size_t heads_cast_on(const char *text)
{
    static const char *const what[] = {"stitches", "sts", "instructions"};
    size_t bold = strspn(text, "*"), on = bold + words_length(text + bold), end, next;

    on += strspn(text + on, " -");
    if (!words_is(text + bold, "cast") || !words_is(text + on, "on"))
        return 0;
    on += 2 + strspn(text + on + 2, " \t");
    on += isupper((unsigned char)text[on]) && words_find(text + on, what, 3) >= 0 ? words_length(text + on) : 0;
    end = on + strspn(text + on, ":* \t");
    next = end + strspn(text + end, "\r\n \t");
    if (!text[end] || !strchr("\r\n", text[end]))
        return 0;
    return words_behind_number(text + next) && words_are_stitches(words_behind_number(text + next)) ? next : end;
}

/* `Border`, `Edging`: the name of a part of a piece, no abbreviation. */
static bool is_part(const char *text)
{
    static const char *const words[] = {"edges", "setup", "set", "main", "center", "centre", "top", "bottom", "rib", "ribbing", "cuff", "base",
                                        "start", "end", "begin", "pattern", "next", "repeat", "last", "first"};

    return words_are(text, WORDS_PART) || words_find(text, words, sizeof words / sizeof *words) >= 0;
}

/* Of `CO | Cast on 12 sts |` the first cell goes, of `| K | Knit |` and of a table's head all. */
static size_t table_length(const char *text)
{
    size_t first = strspn(text, "| \t"), bar = first + strcspn(text + first, "|\r\n"), next, line = words_line_length(text);

    bool numbers = words_line_has_sign(text, "0123456789");

    next = bar + strspn(text + bar, "| \t");
    if (text[bar] != '|' || bar == first || !isalpha((unsigned char)text[first]) ||
        (names_row(text + first, bar - first) && (numbers || prose_stitches_follow(text + next))))
        return 0;
    if (prose_pattern_follows(text + next) || (prose_rows_follow(words_next(text + next))))
        return next;
    if (is_part(text + first))
        return next;
    return memchr(text, '*', line) || (prose_stitches_follow(text + next) && numbers) ? 0 : line;
}

/* `knit 4 rows`, `beginning with a knit row work ..`. */
static bool work_follows(const char *text)
{
    static const char *const work[] = {"knit", "purl", "k", "p", "work", "rep", "repeat", "continue", "cont"},
                             *const begin[] = {"beg", "begin", "beginning", "start", "starting", "commencing"};

    return words_find(text, work, sizeof work / sizeof *work) >= 0 ||
           (words_find(text, begin, sizeof begin / sizeof *begin) >= 0 && words_is(words_next(text), "with"));
}

/* How long `Using smaller needles,` is before work, `Change to 4.5mm needles and` before `knit 4 rows`; or 0. */
static size_t needles_length(const char *text)
{
    static const char *const lead[] = {"with", "using", "on", "change", "changing", "switch"}, *const needles[] = {"needle", "needles", "pins"},
                             *const then[] = {"and", "then"};
    size_t at = words_length(text), n;

    if (words_find(text, lead, sizeof lead / sizeof *lead) < 0)
        return 0;
    for (; at < NEEDLES && text[at] && words_find(text + at, needles, 3) < 0; at += n ? n : 1) {
        n = words_length(text + at);
        if (n ? work_follows(text + at) : strchr(":;\r\n*", text[at]) != NULL)
            return 0;
    }
    if (at >= NEEDLES || !text[at])
        return 0;
    at += words_length(text + at);
    at += strspn(text + at, "., \t");
    while (words_find(text + at, then, 2) >= 0)
        at += words_length(text + at), at += strspn(text + at, ", \t");
    return work_follows(text + at) ? at : 0;
}

size_t heads_length(const char *text, bool inside, bool *stop)
{
    size_t length;

    *stop = false;
    if (!inside && isdigit((unsigned char)*text) &&
        ((length = time_length(text)) || (length = counter_length(text)) || (length = number_length(text, stop))))
        return length;
    if (*text == '#')
        return signs_of_heading(text);
    if (!inside && ((length = furniture_length(text)) || (length = note_length(text))))
        return length;
    if (!inside && is_table_head(text))
        return words_line_length(text);
    if (!inside && (length = needles_length(text)))
        return length;
    if (!inside && memchr(text, '|', words_line_length(text)) && !is_statement(text))
        return table_length(text);
    if ((length = title_length(text)) || (length = label_length(text)) || (length = begin_length(text)) || (length = inside ? 0 : heads_label(text)))
        return length;
    return (length = part_length(text)) || (length = inside ? 0 : bind_off_length(text)) ? length : first_row_length(text);
}

/* The `20 sts` of `multiple of 4 (20 sts)`. */
static bool is_alone(const char *text, size_t open, size_t number, size_t end)
{
    end += strspn(text + end, " ");
    return text[open] == '(' && number == open + 1 && text[end + (words_are_stitches(text + end) ? words_length(text + end) : 0)] == ')';
}

/* From the bracket of `(4 + 2 = 6 sts)` up to its sign; 0: it has none. */
static size_t sum_length(const char *text)
{
    size_t sum = strspn(text + 1, "0123456789 +x*") + 1, words = 0;

    while (*text == '(' && isalpha((unsigned char)text[sum]) && words++ < 4)
        sum += words_length(text + sum), sum += strspn(text + sum, " 0123456789+");
    return *text == '(' && text[sum] == '=' ? sum : 0;
}

size_t heads_example(const char *text, size_t *number)
{
    static const char *const named[] = {"i", "we", "sample", "shown", "example", "mine", "used", "eg", "e", "such", "photo", "model", "pictured", "ex", "say",
                                         "approx", "approximately", "about", "around", "roughly"},
                             *const multiple[] = {"multiple", "multiples", "even", "odd", "any", "number"}, *const once[] = {"sts", "st", "stitches"},
                             *const did[] = {"did", "used", "uses", "have", "had", "has", "on"};
    size_t line = words_line_within(text, WORDS_REACH), at = 0, from = 0, word = 0, n;
    bool of = false, said = false;

    /* Behind the multiple, a comma, a dash or a bracket begins what says who has how many, or a sentence: `I did 42.` */
    for (*number = 0; at < line && !(said && *number && strchr(").", text[at])); at += n ? n : 1) {
        n = words_length(text + at);
        of = of || (n && words_find(text + at, multiple, 6) >= 0);
        from = of && (strncmp(text + at, ". ", 2) == 0 ? !said : !from && strchr("(,;-\xE2", text[at])) ? at : from;
        if (from == at && sum_length(text + at)) {
            at += sum_length(text + at);
            said = true;
        }
        said |= from && n && words_find(text + at, named, sizeof named / sizeof *named) >= 0;
        word = n ? at : word;
        if (from && !n && isdigit((unsigned char)text[at])) {
            if (*number || (text[from] == '.' && words_find(text + word, did, sizeof did / sizeof *did) < 0))
                return 0;
            *number = words_is(text + word, "plus") && word > from ? 0 : at;
            n = strspn(text + at, "0123456789");
            said |= is_alone(text, from, at, at + n);
        } else if (*number && n && text[from] != '(' && words_find(text + at, once, 3) < 0) {
            return 0;
        }
    }
    return said && *number ? at + (text[at] == ')') : 0;
}
