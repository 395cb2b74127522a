/* SPDX-License-Identifier: GPL-3.0-or-later
 * Phrases in, their words numbered; a text in, the phrases that stand there out. */
#include "lang/page/phrases.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/page/words.h"

enum { WORDING = 32 };  /* bytes of the longest plain wording */
enum { WORDS = 1024, BUCKETS = 4096, ALTERNATIVES = 8192, PIECES = 4096, MOST = 576 };

/* The words are numbered; the first stand for `#`, as figures do, the next for `$`. */
enum { NO_WORD, NUMBER, LAST_NUMBER = 12, STITCH };

/* One place of a phrase: the words that may stand there. */
struct piece {
    unsigned short first;
    unsigned char n;
    bool stays, optional;
};

/* Phrases, as bits. */
struct set {
    unsigned long long bits[MOST / 64];
};

struct word {
    const char *text;
    unsigned char length;
    unsigned hash;
    struct set begins, within; /* those phrases */
};

struct phrases {
    int nwords, nalternatives, npieces;
    struct word word[WORDS];
    unsigned short bucket[BUCKETS];
    unsigned short alternative[ALTERNATIVES]; /* numbers of words */
    struct piece piece[PIECES];
    unsigned short start[MOST + 1]; /* of a phrase's pieces; behind the last: the end */
    struct set alone; /* may be a single word */
};

/* What stands at a place of a text: a word, the same with its full stop, or neither. */
struct at_place {
    int word, dotted;
    size_t length;
};

/* ---- words ---- */

/* FNV-1a, of small letters. */
static unsigned hash_of(const char *text, size_t length)
{
    unsigned hash = 2166136261u;

    for (size_t i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)tolower((unsigned char)text[i])) * 16777619u;
    return hash;
}

/* The bucket of a word, or the empty one that is its. */
static unsigned short *bucket_of(struct phrases *phrases, const char *text, size_t length, unsigned hash)
{
    for (unsigned at = hash;; at++) {
        unsigned short *bucket = &phrases->bucket[at % BUCKETS];
        const struct word *word = &phrases->word[*bucket];

        if (!*bucket || (word->hash == hash && word->length == length && strncasecmp(word->text, text, length) == 0))
            return bucket;
    }
}

static int word_number(struct phrases *phrases, const char *text, size_t length)
{
    unsigned hash = hash_of(text, length);
    unsigned short *bucket = bucket_of(phrases, text, length, hash);

    if (!*bucket) {
        assert(phrases->nwords < WORDS && length < 256);
        phrases->word[phrases->nwords] = (struct word){.text = text, .length = (unsigned char)length, .hash = hash};
        *bucket = (unsigned short)phrases->nwords++;
    }
    return *bucket;
}

static void read_number_words(struct phrases *phrases)
{
    static const char *const word[] = {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};

    phrases->nwords = NUMBER;
    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        word_number(phrases, word[i], strlen(word[i]));
    assert(phrases->nwords == LAST_NUMBER + 1);
    word_number(phrases, "$", 1);
}

static struct at_place look(struct phrases *phrases, const char *text)
{
    struct at_place at = {0};

    while (isdigit((unsigned char)text[at.length]))
        at.length++;
    if (at.length) {
        at.word = NUMBER;
        return at;
    }
    if (strncmp(text, "\xE2\x80\x93", 3) == 0 || strncmp(text, "\xE2\x80\x94", 3) == 0) {   /* a longer dash */
        at.length = 3;
        at.word = *bucket_of(phrases, "-", 1, hash_of("-", 1));
        return at;
    }
    if (strncmp(text, "\xE2\x80\x99", 3) == 0) {   /* an apostrophe */
        at.length = 3;
        at.word = *bucket_of(phrases, "'", 1, hash_of("'", 1));
        return at;
    }
    while (isalnum((unsigned char)text[at.length]))
        at.length++;
    at.length += at.length == 0 && *text;
    at.word = *bucket_of(phrases, text, at.length, hash_of(text, at.length));
    if (at.word && at.word <= LAST_NUMBER)
        at.word = NUMBER;
    else if (*text && strchr("kKpP", *text) && at.length > 1 && strspn(text + 1, "0123456789") == at.length - 1)
        at.word = STITCH;
    if (text[at.length] == '.' && isalpha((unsigned char)*text))
        at.dotted = *bucket_of(phrases, text, at.length + 1, hash_of(text, at.length + 1));
    return at;
}

/* ---- reading the table ---- */

/* `=rep|repeat?` */
static void read_piece(struct phrases *phrases, const char *text, size_t length)
{
    struct piece *piece = &phrases->piece[phrases->npieces++];
    bool stays = *text == '=', optional = text[length - 1] == '?';
    const char *end = text + length - optional;

    assert(phrases->npieces < PIECES);
    *piece = (struct piece){(unsigned short)phrases->nalternatives, 0, stays, optional};
    for (const char *word = text + stays; word < end; piece->n++) {
        size_t n = strcspn(word, "|");

        n = word + n > end ? (size_t)(end - word) : n;
        assert(phrases->nalternatives < ALTERNATIVES);
        phrases->alternative[phrases->nalternatives++] =
            (unsigned short)(n == 1 && *word == '#' ? NUMBER : word_number(phrases, n == 1 && *word == '~' ? "#" : word, n));
        word += n + 1;
    }
}

static void put_bit(struct set *set, int phrase)
{
    set->bits[phrase / 64] |= 1ull << phrase % 64;
}

/* Under each of its words, and under those it may begin with. */
static void index_phrase(struct phrases *phrases, int phrase)
{
    int required = 0;

    for (int p = phrases->start[phrase]; p < phrases->npieces; p++) {
        const struct piece *piece = &phrases->piece[p];

        for (int i = 0; i < piece->n; i++) {
            struct word *word = &phrases->word[phrases->alternative[piece->first + i]];

            put_bit(&word->within, phrase);
            if (required == 0)
                put_bit(&word->begins, phrase);
        }
        required += !piece->optional;
    }
    if (required < 2)
        put_bit(&phrases->alone, phrase);
}

struct phrases *phrases_read(struct arena *arena, const struct phrase *table, int n)
{
    struct phrases *phrases = arena_new(arena, struct phrases);

    assert(n <= MOST);
    read_number_words(phrases);
    for (int i = 0; i < n; i++) {
        const char *words = table[i].words + (strchr("@<^>!", *table[i].words) ? 2 : 0);

        phrases->start[i] = (unsigned short)phrases->npieces;
        for (size_t length; *words; words += length + (words[length] == ' ')) {
            length = strcspn(words, " ");
            read_piece(phrases, words, length);
        }
        phrases->start[i + 1] = (unsigned short)phrases->npieces;
        index_phrase(phrases, i);
    }
    return phrases;
}

/* ---- finding ---- */

size_t phrases_skip(const char *text, size_t at)
{
    while (text[at] == ' ' || text[at] == '\t')
        at++;
    if (text[at] == '\r' && text[at + 1] == '\n')
        at++;
    if (text[at] == '\n' || text[at] == '\r')
        at++;
    while (text[at] == ' ' || text[at] == '\t')
        at++;
    return at;
}

static bool has(const struct phrases *phrases, const struct piece *piece, int word)
{
    for (int i = 0; word && i < piece->n; i++)
        if (phrases->alternative[piece->first + i] == word)
            return true;
    return false;
}

static bool match(struct phrases *phrases, int piece, int end, const char *text, size_t at, struct found *found)
{
    const struct piece *p = &phrases->piece[piece];
    size_t from = found->n ? phrases_skip(text, at) : at, length = 0;
    struct at_place place;

    if (piece == end)
        return true;
    place = look(phrases, text + from);
    if (has(phrases, p, place.dotted))
        length = place.length + 1;
    else if (has(phrases, p, place.word))
        length = place.length;
    if (length && found->n < PHRASE_WORDS) {
        found->start[found->n] = from;
        found->end[found->n] = from + length;
        found->stays[found->n++] = p->stays;
        if (match(phrases, piece + 1, end, text, from + length, found))
            return true;
        found->n--;
    }
    return p->optional && match(phrases, piece + 1, end, text, at, found);
}

/* The phrases from a number on that may begin with the word at a place, by that word and the next;
 * where a full stop is a part of either, by the first alone. */
static struct set candidates(struct phrases *phrases, const char *text, size_t at, int from)
{
    struct at_place first = look(phrases, text + at), second;
    struct set set = phrases->word[first.word].begins;
    bool any = false;

    for (int i = 0; i < MOST / 64; i++) {
        set.bits[i] |= phrases->word[first.dotted].begins.bits[i];
        set.bits[i] &= i < from / 64 ? 0 : i == from / 64 ? ~0ull << from % 64 : ~0ull;
        any |= set.bits[i] != 0;
    }
    if (!any || first.dotted)
        return set;
    second = look(phrases, text + phrases_skip(text, at + first.length));
    for (int i = 0; i < MOST / 64; i++)
        set.bits[i] &= phrases->alone.bits[i] | phrases->word[second.word].within.bits[i] | phrases->word[second.dotted].within.bits[i];
    return set;
}

int phrases_find(struct phrases *phrases, const char *text, size_t at, int from, struct found *found)
{
    struct set set = candidates(phrases, text, at, from);

    for (int i = 0; i < MOST / 64; i++)
        for (unsigned long long bits = set.bits[i]; bits; bits &= bits - 1) {
            int phrase = 64 * i + __builtin_ctzll(bits);

            found->n = 0;
            if (match(phrases, phrases->start[phrase], phrases->start[phrase + 1], text, at, found))
                return phrase;
        }
    return -1;
}

/* ---- what stands for them ---- */

bool phrases_break(const char *text, const struct found *found)
{
    size_t start = found->start[0], length = found->end[found->n - 1] - start;

    return memchr(text + start, '\n', length) || memchr(text + start, '\r', length);
}

bool phrases_change(const char *text, const struct found *found)
{
    for (int i = 0; i < found->n; i++)
        if (!found->stays[i])
            return true;
    return phrases_break(text, found);
}

static bool is_number(const char *text)
{
    return isdigit((unsigned char)*text) || words_one_of("one|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve", text);
}

/* Which word of a phrase its number is: one that goes before one that stays. */
static int number_of(const char *text, const struct found *found)
{
    int number = found->n - 1;

    for (int i = found->n - 1; i >= 0; i--)
        if (is_number(text + found->start[i]) && (!found->stays[i] || found->stays[number]))
            number = i;
    return number;
}

/* The plain wording with the phrase's number for each `#`; 0: there is none, or it is too long. */
static size_t with_number(const char *text, const struct found *found, const char *plain, char wording[static WORDING])
{
    int i = number_of(text, found);
    size_t number = found->end[i] - found->start[i], n = 0;

    for (; *plain; plain++) {
        bool figures = *plain == '#';

        if (n + (figures ? number : 1) > WORDING)
            return 0;
        memcpy(wording + n, figures ? text + found->start[i] : plain, figures ? number : 1);
        n += figures ? number : 1;
    }
    return n;
}

bool phrases_put(char *text, const struct found *found, const char *plain)
{
    char wording[WORDING];
    size_t length = with_number(text, found, plain, wording), from = 0, end = found->end[found->n - 1];
    int first = 0;

    while (first < found->n && found->stays[first])
        first++;
    if (length) {
        from = found->start[first];
        for (int i = first; i < found->n && !found->stays[i]; i++)
            end = found->end[i];
        if (first == found->n || from + length > end)
            return false;
    }
    for (int i = 0; i < found->n; i++) {
        if (!found->stays[i])
            memset(text + found->start[i], ' ', found->end[i] - found->start[i]);
        if (i + 1 < found->n)
            memset(text + found->end[i], ' ', found->start[i + 1] - found->end[i]);
    }
    memcpy(text + from, wording, length);
    return true;
}
