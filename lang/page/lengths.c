/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, its gauge and its lengths out. */
#include "lang/page/lengths.h"

#include "lang/page/words.h"

#include <stdio.h>
#include <stdlib.h>

enum { REGION = 400 };          /* bytes that a gauge is looked for behind its word */

static const double SHORTEST = 10;      /* mm; less is a needle */

/* Longest first where one begins another. */
static const struct unit {
    const char *sign;
    double millimetres;
} units[] = {{"\"", 25.4},      {"''", 25.4},  {"\xE2\x80\xB3", 25.4}, {"\xE2\x80\x9D", 25.4}, {"\xE2\x80\x9C", 25.4},
             {"inches", 25.4},  {"inch", 25.4}, {"ins", 25.4},         {"in", 25.4},
             {"centimetres", 10}, {"centimeters", 10}, {"cms", 10},    {"cm", 10}, {"mm", 1},
             {"feet", 304.8},   {"foot", 304.8}, {"ft", 304.8}};
enum { UNITS = sizeof units / sizeof *units };

static const struct fraction {
    const char *sign;
    double value;
} fractions[] = {{"\xC2\xBD", 1. / 2}, {"\xC2\xBC", 1. / 4}, {"\xC2\xBE", 3. / 4}, {"\xE2\x85\x93", 1. / 3},
                 {"\xE2\x85\x94", 2. / 3}, {"1/2", 1. / 2}, {"1/4", 1. / 4}, {"3/4", 3. / 4}, {"1/3", 1. / 3}, {"2/3", 2. / 3}};

/* Behind a unit; NULL: there is none. */
static const char *unit_at(const char *text, double *millimetres)
{
    for (int i = 0; i < UNITS; i++) {
        size_t length = strlen(units[i].sign);

        if (strncasecmp(text, units[i].sign, length) != 0 || (isalpha((unsigned char)*units[i].sign) && words_length(text) != length))
            continue;
        *millimetres = units[i].millimetres;
        return text + length;
    }
    return NULL;
}

static const char *fraction_at(const char *text, double *value)
{
    for (size_t i = 0; i < sizeof fractions / sizeof *fractions; i++)
        if (*text == *fractions[i].sign && strncmp(text, fractions[i].sign, strlen(fractions[i].sign)) == 0) {
            *value += fractions[i].value;
            return text + strlen(fractions[i].sign);
        }
    return NULL;
}

/* "8", "8.5", "8,5", "8½", "8 1/2", "8-1/2", "½"; NULL: there is none. */
static const char *number_at(const char *text, double *value)
{
    const char *behind, *at = text;

    *value = 0;
    if ((behind = fraction_at(text, value)))
        return behind;
    for (; isdigit((unsigned char)*at); at++)
        *value = 10 * *value + (*at - '0');
    if (at == text)
        return NULL;
    if (strchr(".,", *at) && isdigit((unsigned char)at[1]))
        for (double place = 0.1; isdigit((unsigned char)*++at); place /= 10)
            *value += place * (*at - '0');
    behind = fraction_at(at + strspn(at, " -"), value);
    return behind ? behind : at;
}

/* Behind "(9, 10)", the numbers of further sizes, or nothing. */
static const char *skip_sizes(const char *text)
{
    const char *at = words_skip_blanks(text);
    size_t length = strchr("([", *at) && *at ? 1 + strspn(at + 1, "0123456789.,:-/ \xC2\xBD\xBC\xBE") : 0;

    return length && strchr(")]", at[length]) && at[length] ? at + length + 1 : text;
}

/* "8 in", "8 (9, 10) inches", "4-inch"; NULL: there is none. */
static const char *length_at(const char *text, double *millimetres)
{
    double value, unit;
    const char *at = number_at(text, &value);

    if (!at)
        return NULL;
    at = skip_sizes(at);
    at += strspn(at, " \t-");
    at = unit_at(words_is(at, "more") ? words_skip_blanks(at + 4) : at, &unit);
    *millimetres = at ? value * unit : 0;
    return at;
}

static bool begins_number(const char *text, const char *first)
{
    unsigned char before = text > first ? (unsigned char)text[-1] : ' ';

    return (isdigit((unsigned char)*text) || (unsigned char)*text >= 0xC2) && !isalnum(before) && before != '.';
}

/* The first length of a part of a text, or the last; 0: none. */
static double find_length(const char *first, const char *end, bool last)
{
    double found = 0, millimetres;

    for (const char *at = first; at < end && (last || found == 0); at++)
        if (begins_number(at, first) && length_at(at, &millimetres) && millimetres >= SHORTEST)
            found = millimetres;
    return found;
}

/* "per inch", "to the inch", "rows/inch". */
static double one_unit(const char *first, const char *end)
{
    static const char *const one[] = {"per", "the", "an", "each", "one"};
    double millimetres;

    for (const char *at = first; at < end; at += words_length(at) + 1) {
        bool stroke = at[words_length(at)] == '/';

        if ((stroke || words_find(at, one, sizeof one / sizeof *one) >= 0) && unit_at(stroke ? at + words_length(at) + 1 : words_next(at), &millimetres) && millimetres >= SHORTEST)
            return millimetres;
    }
    return 0;
}

static const char *line_end(const char *text)
{
    return text + words_line_length(text);
}

/* The length that the rows named at `rows` make: behind them on their line, or before. */
static double length_of_rows(const char *line, const char *rows, const char *end)
{
    const char *stop = line_end(rows) < end ? line_end(rows) : end;
    double length = find_length(rows, stop, false);

    if (length == 0)
        length = one_unit(rows, stop);
    return length > 0 ? length : find_length(line, rows, true);
}

/* Where an empty line, or the text, ends what stands together. */
static const char *paragraph_end(const char *text)
{
    const char *most = text + strnlen(text, REGION), *next;

    for (const char *end = line_end(text); end < most; end = line_end(next)) {
        next = end + (end[0] == '\r' && end[1] == '\n') + 1;
        if (strchr("\r\n", *words_skip_blanks(next)))
            return end;
    }
    return most;
}

/* In what stands behind "gauge", on its lines; `place` is where its rows stand. */
static double gauge_within(const char *text, const char *end, const char **place)
{
    const char *line = text;
    double rows, length;

    for (const char *at = text; at < end; at++) {
        const char *behind = begins_number(at, text) ? number_at(at, &rows) : NULL;

        if (strchr("\r\n", *at))
            line = at + 1;
        length = behind && words_are_rows(words_skip_blanks(behind)) ? length_of_rows(line, behind, end) : 0;
        *place = at;
        if (length > 0)
            return rows / length;
    }
    return 0;
}

/* `18 stitches x 22 rows = 4"`, `20 sts and 28 rows to 10 cm`: a gauge that is not called one. */
static bool is_gauge(const char *text, const char *first)
{
    double n;
    const char *sts = begins_number(text, first) ? number_at(text, &n) : NULL, *rows, *place;

    sts = sts ? words_skip_blanks(sts) : NULL;
    if (!sts || !words_are_stitches(sts))
        return false;
    rows = number_at(words_skip_any(sts + words_length(sts), "x|\xC3\x97|by|and|&|+|,|/"), &n);
    rows = rows ? words_skip_blanks(rows) : NULL;
    if (!rows || !words_are_rows(rows))
        return false;
    for (const char *at = rows + words_length(rows); at < line_end(rows); at++)
        if (*at == '=' || words_one_of("per|to the", at) || (words_is(at, "to") && isdigit((unsigned char)*words_next(at))))
            return gauge_within(text, line_end(text), &place) > 0;
    return false;
}

double lengths_gauge(const char *text, size_t *from, size_t *to)
{
    static const char *const word[] = {"gauge", "tension"};
    const char *first = text, *place = text;
    double gauge = 0;

    while (*text && gauge == 0) {
        size_t length = words_length(text);
        bool named = words_find(text, word, sizeof word / sizeof *word) >= 0, here = named || (isdigit((unsigned char)*text) && is_gauge(text, first));

        if (here)
            *from = (size_t)(text - first);
        if (here && !named) {
            gauge = gauge_within(text, line_end(text), &place);
            break;
        }
        text += length ? length : 1;
        if (here) {
            text += strspn(text, " \t:*_.\r\n");
            gauge = gauge_within(text, paragraph_end(text), &place);
            text = paragraph_end(text);
        }
    }
    *to = (size_t)(place - first);
    return gauge;
}

static bool says(const char *text, const char *const *word, int n)
{
    for (; *text; text += words_length(text) ? words_length(text) : 1)
        if (words_find(text, word, n) >= 0)
            return true;
    return false;
}

bool lengths_said(const char *phrase)
{
    return find_length(phrase, phrase + strlen(phrase), false) > 0;
}

bool lengths_follow(const char *text)
{
    double millimetres;

    if (words_is(text, "until") || words_is(text, "till"))
        return find_length(text, line_end(text), false) > 0;
    return length_at(text, &millimetres) != NULL;
}

/* `RS row`, `wrong side row`, `WS facing for next row`, which is the RS; 0: neither. */
static int row_of_side(const char *text)
{
    bool right = words_is(text, "rs") || words_is(text, "right"), wrong = words_is(text, "ws") || words_is(text, "wrong");

    text = words_next(text);
    text += strspn(text, "-");
    text = words_is(text, "side") ? words_next(text) : text;
    if (words_is(text, "facing"))
        return right ? ENDING_WS : wrong ? ENDING_RS : 0;
    return !words_are_rows(text) ? 0 : right ? ENDING_RS : wrong ? ENDING_WS : 0;
}

/* Behind the number of `row 2`, `2nd row`. */
static const char *behind_row(const char *text)
{
    text = words_next(words_skip_blanks(text + words_ordinal_length(text)));
    return words_skip_blanks(text + strspn(text, "0123456789"));
}

/* `or row 4`, `or 4`: its number, 0 for none; -1: the row before it is of something else, or one of several. */
static int other_row(const char *text)
{
    bool choice = words_is(text, "or");

    if (words_is(text, "of") || words_is(text, "and"))
        return -1;
    text = words_next(text);
    return !choice ? 0 : isdigit((unsigned char)*text) && !words_ordinal_length(text) ? words_number(text) : words_row(text) ? words_row(text) : -1;
}

int lengths_ending(const char *phrase, int *other)
{
    static const char *const end[] = {"end", "ends", "ending", "finish", "finishing"}, *const of[] = {"with", "on", "after", "by", "having", "working", "worked", "just", "completing", "completed", "completion", "of",
                                               "either", "a", "the", "pattern", "patt"};
    const char *at = phrase;

    *other = 0;
    while (*at && words_find(at, end, 5) < 0)
        at += words_length(at) ? words_length(at) : 1;
    if (!*at || words_find(words_next(at), of, 5) < 0)
        return 0;
    for (at = words_next(at); words_find(at, of, sizeof of / sizeof *of) >= 0;)
        at = words_next(at);
    if (row_of_side(at))
        return row_of_side(at);
    *other = other_row(behind_row(at));
    if (*other >= 0)
        return words_row(at);
    *other = 0;
    return 0;
}

double lengths_wanted(const char *phrase, bool *part)
{
    static const char *const of_part[] = {"rib", "ribbing", "border", "section", "band", "edging", "hem", "cuff", "welt"};
    static const char *const not_it[] = {"less", "short", "shorter", "before", "longer"};
    static const char *const until[] = {"until", "till"};

    *part = !says(phrase, until, 2) || says(phrase, of_part, sizeof of_part / sizeof *of_part);
    return says(phrase, not_it, sizeof not_it / sizeof *not_it) ? 0 : find_length(phrase, phrase + strlen(phrase), false);
}

/* ---- rows counted behind a length ---- */

/* Before the comma, and the `long` or `in length`, that stand before a place. */
static size_t before_long(const char *text, size_t at)
{
    static const char *const words[] = {"long", "length", "tall", "high", "deep"};
    size_t before;

    for (; at > 0 && strchr(" ,", text[at - 1]); at--)
        ;
    before = words_before(text, at);
    if (before == at || words_find(text + before, words, 5) < 0)
        return at;
    return before_long(text, words_is(text + before, "length") ? words_before(text, before) : before);
}

/* Whether `14 inches`, `2" [5 cm] long,` ends before a place. */
static bool ends_length(const char *text, size_t at)
{
    double millimetres;
    size_t unit;

    at = before_long(text, at);
    if (at > 0 && strchr(")]", text[at - 1])) {
        for (at--; at > 0 && !strchr("([\r\n", text[at]);)
            at--;
        return lengths_follow(text + at + 1) && ends_length(text, at);
    }
    for (unit = at; unit > 0 && isalpha((unsigned char)text[unit - 1]);)
        unit--;
    unit -= unit == at && at > 2 ? ((unsigned char)text[at - 1] >= 0x80 ? 3 : 1 + (text[at - 1] == '\'' && text[at - 2] == '\'')) : 0;
    if (unit_at(text + unit, &millimetres) != text + at)
        return false;
    while (unit > 0 && text[unit - 1] == ' ')
        unit--;
    return unit > 0 && (isdigit((unsigned char)text[unit - 1]) || (unsigned char)text[unit - 1] >= 0x80);
}

/* Behind words of a list and the blanks and stops between. */
static const char *skip_list(const char *text, const char *const *word, int n)
{
    for (text += strspn(text, " ~"); words_find(text, word, n) >= 0; text += strspn(text, " .~\r\n"))
        text += words_length(text);
    return text;
}

size_t lengths_count(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const about[] = {"about", "around", "approximately", "approx", "roughly", "or", "so", "ca", "that", "is", "i", "we", "did", "made", "worked", "took", "mine"}, *const total[] = {"in", "total", "all", "altogether", "or", "so"};
    const char *number = skip_list(text + at + 1, about, sizeof about / sizeof *about), *rows = isdigit((unsigned char)*number) ? words_behind_number(number) : NULL, *end;
    char close = text[at] == '(' ? ')' : text[at] == '[' ? ']' : '\0';

    if (!rows || !words_are_rows(rows) || words_number(number) > 99999 || !ends_length(text, at))
        return 0;
    end = skip_list(words_skip_blanks(rows + words_length(rows)), total, 6);
    if (close ? *end != close : *end && !strchr(".,;\r\n", *end))
        return 0;
    end += close != 0;
    snprintf(plain, SIGNS_PLAIN, "(%d rows)", words_number(number));
    return strlen(plain) <= (size_t)(end - text) - at ? (size_t)(end - text) - at : 0;
}

int lengths_counted(const char *phrase)
{
    const char *open = phrase, *rows;

    for (; (open = strchr(open, '(')); open++) {
        rows = isdigit((unsigned char)open[1]) ? words_behind_number(open + 1) : NULL;
        if (rows && words_are_rows(rows) && ends_length(phrase, (size_t)(open - phrase)))
            return words_number(open + 1);
    }
    return 0;
}
