/* SPDX-License-Identifier: GPL-3.0-or-later
 * The vocabulary of work: a place of a text in; the classes of its word, and the number it says, out. */
#include "lang/page/words.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

struct word {
    const char *word;
    unsigned    classes;
    int         number;
};

/* Under their first letters. */
static const struct word *const words[26] = {
    ['a' - 'a'] = (const struct word[]){{"all", WORDS_EVERY, 0}, {0}},
    ['b' - 'a'] = (const struct word[]){{"bind", WORDS_BIND, 0}, {"bo", WORDS_BIND, 0}, {"body", WORDS_PART, 0}, {"border", WORDS_PART, 0}, {0}},
    ['c' - 'a'] = (const struct word[]){{"cast", WORDS_CAST, 0}, {"co", WORDS_CAST, 0}, {"cont", WORDS_GO_ON, 0},
        {"continue", WORDS_GO_ON, 0}, {0}},
    ['e' - 'a'] = (const struct word[]){{"each", WORDS_EVERY, 0}, {"edge", WORDS_PART, 0}, {"edging", WORDS_PART, 0}, {"eight", WORDS_NUMBER, 8},
        {"eighth", WORDS_NTH, 8}, {"eleven", WORDS_NUMBER, 11}, {"eleventh", WORDS_NTH, 11}, {"end", WORDS_END, 0},
        {"ending", WORDS_END, 0}, {"ends", WORDS_END, 0}, {"every", WORDS_EVERY, 0}, {0}},
    ['f' - 'a'] = (const struct word[]){{"fifth", WORDS_NTH, 5}, {"finish", WORDS_END, 0},
        {"finishing", WORDS_END, 0}, {"first", WORDS_NTH, 1}, {"five", WORDS_NUMBER, 5}, {"four", WORDS_NUMBER, 4},
        {"fourth", WORDS_NTH, 4}, {0}},
    ['g' - 'a'] = (const struct word[]){{"garter", WORDS_FABRIC, 0}, {0}},
    ['h' - 'a'] = (const struct word[]){{"hem", WORDS_PART, 0}, {0}},
    ['k' - 'a'] = (const struct word[]){{"k", WORDS_PLAIN, 0}, {"knit", WORDS_PLAIN, 0}, {0}},
    ['m' - 'a'] = (const struct word[]){{"moss", WORDS_FABRIC, 0}, {0}},
    ['n' - 'a'] = (const struct word[]){{"nine", WORDS_NUMBER, 9}, {"ninth", WORDS_NTH, 9}, {"now", WORDS_THEN, 0},
        {0}},
    ['o' - 'a'] = (const struct word[]){{"once", WORDS_OFTEN, 1}, {"one", WORDS_NUMBER, 1}, {0}},
    ['p' - 'a'] = (const struct word[]){{"p", WORDS_PLAIN, 0}, {"purl", WORDS_PLAIN, 0}, {0}},
    ['r' - 'a'] = (const struct word[]){{"rd", WORDS_ROW, 0}, {"rds", WORDS_ROW, 0}, {"rep", WORDS_AGAIN, 0},
        {"repeat", WORDS_AGAIN, 0}, {"rib", WORDS_FABRIC, 0}, {"ribbing", WORDS_FABRIC, 0}, {"rnd", WORDS_ROW, 0},
        {"rnds", WORDS_ROW, 0}, {"round", WORDS_ROW, 0}, {"rounds", WORDS_ROW, 0}, {"row", WORDS_ROW, 0},
        {"rows", WORDS_ROW, 0}, {"rs", WORDS_SIDE, 0}, {0}},
    ['s' - 'a'] = (const struct word[]){{"second", WORDS_NTH, 2}, {"seed", WORDS_FABRIC, 0},
        {"seven", WORDS_NUMBER, 7}, {"seventh", WORDS_NTH, 7}, {"six", WORDS_NUMBER, 6}, {"sixth", WORDS_NTH, 6},
        {"st", WORDS_STITCH, 0}, {"stitch", WORDS_STITCH, 0}, {"stitches", WORDS_STITCH, 0},
        {"stockinette", WORDS_FABRIC, 0}, {"sts", WORDS_STITCH, 0}, {0}},
    ['t' - 'a'] = (const struct word[]){{"ten", WORDS_NUMBER, 10}, {"tenth", WORDS_NTH, 10}, {"then", WORDS_THEN, 0},
        {"third", WORDS_NTH, 3}, {"three", WORDS_NUMBER, 3}, {"thrice", WORDS_OFTEN, 3}, {"time", WORDS_TIMES, 0},
        {"times", WORDS_TIMES, 0}, {"twelfth", WORDS_NTH, 12}, {"twelve", WORDS_NUMBER, 12},
        {"twice", WORDS_OFTEN, 2}, {"two", WORDS_NUMBER, 2}, {0}},
    ['w' - 'a'] = (const struct word[]){{"work", WORDS_WORK, 0}, {"ws", WORDS_SIDE, 0}, {0}},
};

/* The word a text begins with; or NULL. */
static const struct word *find(const char *text)
{
    const struct word *word = isalpha((unsigned char)*text) ? words[(*text | 0x20) - 'a'] : NULL;
    size_t length = word ? words_length(text) : 0;

    for (; word && word->word; word++)
        if ((length == 1 || word->word[1] == (text[1] | 0x20)) && strncasecmp(word->word, text, length) == 0 && !word->word[length])
            return word;
    return NULL;
}

unsigned words_class(const char *text)
{
    const struct word *word = find(text);

    return word ? word->classes : 0;
}

int words_value(const char *text)
{
    const struct word *word = find(text);

    return word ? word->number : 0;
}

int words_number(const char *text)
{
    if (isdigit((unsigned char)*text))
        return (int)fmin(strtod(text, NULL), INT_MAX);
    return words_are(text, WORDS_NUMBER) ? words_value(text) : 0;
}

size_t words_ordinal_length(const char *text)
{
    static const char *const ending[] = {"st", "nd", "rd", "th"};
    size_t digits = strspn(text, "0123456789");

    return digits && words_find(text + digits, ending, 4) >= 0 ? digits + 2 : 0;
}

const char *words_behind_number(const char *text)
{
    size_t digits = strspn(text, "0123456789");

    if (digits)
        return words_ordinal_length(text) ? NULL : words_skip_blanks(text + digits);
    return words_are(text, WORDS_NUMBER) ? words_next(text) : NULL;
}

int words_row(const char *text)
{
    size_t ordinal = words_ordinal_length(text);

    if (ordinal)
        return words_are_rows(words_skip_blanks(text + ordinal)) ? words_number(text) : 0;
    if (words_is(text, "r"))
        return isdigit((unsigned char)text[1]) ? words_number(text + 1) : 0;
    return words_are_rows(text) ? words_number(words_next(text)) : 0;
}

bool words_line_is_long(struct words_line *line, const char *text, size_t at)
{
    if (at < line->start || at >= line->end)
        *line = (struct words_line){words_line_start(text, at), at + words_line_length(text + at)};
    return line->end - line->start > WORDS_LINE && at < line->end;
}

bool words_are_page(const char *text, size_t size)
{
    size_t looks = 0;

    for (size_t at = 0, line; size <= WORDS_PAGE && at < size; at += line + 1) {
        line = words_line_length(text + at);
        looks += line > WORDS_LINE ? 0 : line * line;
    }
    return size <= WORDS_PAGE && looks <= WORDS_LOOKS;
}

int words_depth(const char *text, size_t length, int depth)
{
    if (!memchr(text, '{', length) && !memchr(text, '}', length))
        return depth;
    for (size_t i = 0; i < length; i++)
        depth += text[i] == '{' ? 1 : text[i] == '}' && depth > 0 ? -1 : 0;
    return depth;
}

size_t words_one_of(const char *list, const char *text)
{
    for (const char *word = list; *word; word += *word == '|') {
        if (((*word ^ *text) & 0xDF) == 0) {
            size_t n = strcspn(word, "|");

            if (strncasecmp(text, word, n) == 0 && (!isalnum((unsigned char)word[n - 1]) || !isalnum((unsigned char)text[n])))
                return n;
        }
        while (*word && *word != '|')
            word++;
    }
    return 0;
}

bool words_any_of(const char *list, const char *text, size_t start, size_t end)
{
    for (size_t at = start; at < end; at += words_length(text + at) ? words_length(text + at) : 1)
        if (words_one_of(list, text + at))
            return true;
    return false;
}

enum { MOST_SKIPPED = 24 };     /* words: sentences have fewer */

const char *words_skip_any(const char *text, const char *list)
{
    text = words_skip_blanks(text);
    for (size_t n, skipped = 0; skipped < MOST_SKIPPED && (n = words_one_of(list, text)) > 0; skipped++)
        text = words_skip_blanks(text + n);
    return text;
}

size_t words_skip_quoted(const char *text, size_t at)
{
    bool inches = at > 0 && isdigit((unsigned char)text[at - 1]);
    size_t length = inches ? 0 : strcspn(text + at + 1, "\"\r\n");

    return inches || text[at + 1 + length] != '"' ? at + 1 : at + length + 2;
}
