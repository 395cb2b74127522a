/* SPDX-License-Identifier: GPL-3.0-or-later
 * A word in, the word of the row language that was meant out. */
#include "lang/typos.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/names.h"

enum { LONGEST = 20, LINE = 1000 };

/* Of words that are equally near the first is taken. */
static const char *const words[] = {
    "knit",   "purl", "from",   "to",   "end",    "last",     "until",  "across",  "times",  "time",       "twice", "once",     "thrice",
    "more",   "sts",  "st",     "stitches", "stitch", "rep",     "repeat", "rows",       "row",   "rounds",   "round",
    "rnds",   "rnd",  "remain", "rem",      "the",    "knits",   "purls",  "between",    "piece", "multiple", "garter",
    "stockinette", "stocking",  "seed",     "moss",   "rib",     "pattern", "measures",  "has",   "and",      "as",
    "of",     "on",   "in",     "for",      "all",    "every",   "each",   "work",
};
enum { WORDS = sizeof words / sizeof *words };

static bool is_one_of(const char *word, const char *const *list, int n)
{
    for (int i = 0; i < n; i++)
        if (strcasecmp(word, list[i]) == 0)
            return true;
    return false;
}

bool typos_is_word(const char *word)
{
    return is_one_of(word, words, WORDS);
}

/* One letter wrong, two of a long word; a word of two letters is near to too many. */
static const char *meant_of(const char *word, const char *const *list, int n)
{
    size_t length = strlen(word);
    struct nearest nearest = {.word = word, .distance = length > 5 ? 3 : 2};

    if (length < 2 || is_one_of(word, list, n))
        return NULL;
    for (int i = 0; i < n; i++)
        if (strlen(list[i]) > 2 ? length > 2 : strcmp(list[i], "to") == 0)
            nearest_offer(&nearest, list[i]);
    return nearest.best;
}

const char *typos_meant(const char *word)
{
    return meant_of(word, words, WORDS);
}

static size_t word_length(const char *text)
{
    size_t n = 0;

    while (isalpha((unsigned char)text[n]))
        n++;
    return n;
}

const char *typos_in_line(struct arena *arena, struct span *span)
{
    const char *text = span->source->text;

    for (unsigned at = span->start; at < span->start + LINE && text[at] && !strchr("\r\n#", text[at]);) {
        size_t n = word_length(text + at);
        const char *meant = n > 0 && n < LONGEST && !isdigit((unsigned char)text[at + n])
                                ? typos_meant(arena_copy(arena, text + at, n)) : NULL;

        if (meant) {
            *span = (struct span){span->source, at, at + (unsigned)n};
            return meant;
        }
        at += n ? (unsigned)n : 1;
    }
    return NULL;
}

/* ---- the beginning of a line ---- */

/* Copies the word at a place; false where none is, or one that is too long. */
static bool copy_word(const char *text, char word[static LONGEST])
{
    size_t n = word_length(text);

    if (n == 0 || n >= LONGEST)
        return false;
    memcpy(word, text, n);
    word[n] = '\0';
    return true;
}

static const char *meant_rows(const char *word)
{
    static const char *const rows[] = {"rows", "row", "rounds", "round", "rnds", "rnd"};

    return meant_of(word, rows, sizeof rows / sizeof *rows);
}

/* `All WS rwos:` */
static const char *all_rows(const char *text, size_t *length)
{
    size_t colon = strcspn(text, ":\r\n");
    char word[LONGEST];

    for (size_t at = 0; text[colon] == ':' && at < colon; at += word_length(text + at) + 1)
        if (copy_word(text + at, word) && meant_rows(word)) {
            *length = at + strlen(word);
            return meant_rows(word);
        }
    return NULL;
}

/* `Al WS rows: purl` */
static const char *meant_all(const char *text, const char *word, const char *next)
{
    static const char *const all[] = {"all", "every", "each"}, *const which[] = {"rs", "ws", "right", "wrong", "even", "odd", "other", "alternate"};
    struct nearest nearest = {.word = word, .distance = 2};
    size_t length;

    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        nearest_offer(&nearest, all[i]);
    return nearest.distance == 1 && is_one_of(next, which, sizeof which / sizeof *which) && strcspn(text, ":") < strcspn(text, "\r\n") &&
                   !all_rows(text, &length) ? nearest.best : NULL;
}

const char *typos_beginning(const char *text, size_t *length)
{
    static const struct {
        const char *first, *second, *both;
    } pairs[] = {{"cast", "on", "cast on"}, {"multiple", "of", "multiple of"}};
    static const char *const all[] = {"all", "every", "each", "rs", "ws"}, *const again[] = {"repeat", "rep"};
    char word[LONGEST], next[LONGEST];
    size_t n = word_length(text), behind = n + strspn(text + n, " \t");

    if (!copy_word(text, word) || !copy_word(text + behind, next))
        return NULL;
    *length = n;
    if (meant_all(text, word, next))
        return meant_all(text, word, next);
    *length = behind + strlen(next);
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct nearest nearest = {.word = next, .distance = 2};

        nearest_offer(&nearest, pairs[i].second);
        if (strcasecmp(word, pairs[i].first) == 0 && nearest.best && nearest.distance == 1 && strlen(next) <= 3)
            return pairs[i].both;
    }
    if (is_one_of(word, again, 2) && isdigit((unsigned char)text[*length + strspn(text + *length, " \t")]))
        return meant_rows(next) ? "repeat rows" : NULL;
    return is_one_of(word, all, 5) ? all_rows(text, length) : NULL;
}
