/* SPDX-License-Identifier: GPL-3.0-or-later
 * Texts in, unique pointers out; a wrong word in, the nearest right one out. */
#include "lang/names.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

struct name_entry {
    struct name_entry *next;
    size_t length;
    unsigned hash;
    const char *text;
};

/* FNV-1a. */
static unsigned hash_of(const char *text, size_t length)
{
    unsigned hash = 2166136261u;

    for (size_t i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)text[i]) * 16777619u;
    return hash;
}

/* Twice the buckets, and every name in its new one. */
static void grow(struct names *names)
{
    size_t larger = names->nbuckets ? 2 * names->nbuckets : 1024;
    struct name_entry **bucket = arena_array(names->arena, struct name_entry *, larger);

    for (size_t i = 0; i < names->nbuckets; i++)
        for (struct name_entry *entry = names->bucket[i], *next; entry; entry = next) {
            next = entry->next;
            entry->next = bucket[entry->hash % larger];
            bucket[entry->hash % larger] = entry;
        }
    names->bucket = bucket;
    names->nbuckets = larger;
}

const char *names_intern(struct names *names, const char *text, size_t length)
{
    unsigned hash = hash_of(text, length);
    struct name_entry **bucket, *entry;

    if (names->n == names->nbuckets)
        grow(names);
    bucket = &names->bucket[hash % names->nbuckets];
    for (entry = *bucket; entry; entry = entry->next)
        if (entry->length == length && memcmp(entry->text, text, length) == 0)
            return entry->text;
    entry = arena_new(names->arena, struct name_entry);
    *entry = (struct name_entry){*bucket, length, hash, arena_copy(names->arena, text, length)};
    *bucket = entry;
    names->n++;
    return entry->text;
}

enum { LONGEST = 40 }; /* longer words are compared no further */

static int least(int a, int b, int c)
{
    int ab = a < b ? a : b;

    return ab < c ? ab : c;
}

/* Insertions, deletions, replacements and swaps of neighbours that turn a into b. */
static int distance(const char *a, const char *b)
{
    int row[3][LONGEST + 1];
    int na = (int)strnlen(a, LONGEST), nb = (int)strnlen(b, LONGEST);
    int *two = row[0], *one = row[1], *now = row[2];

    for (int j = 0; j <= nb; j++)
        one[j] = j;
    for (int i = 1; i <= na; i++) {
        int *free = two;

        now[0] = i;
        for (int j = 1; j <= nb; j++) {
            int ca = tolower((unsigned char)a[i - 1]), cb = tolower((unsigned char)b[j - 1]);

            now[j] = least(one[j] + 1, now[j - 1] + 1, one[j - 1] + (ca != cb));
            if (i > 1 && j > 1 && ca == tolower((unsigned char)b[j - 2]) &&
                cb == tolower((unsigned char)a[i - 2]) && two[j - 2] + 1 < now[j])
                now[j] = two[j - 2] + 1;
        }
        two = one;
        one = now;
        now = free;
    }
    return one[nb];
}

/* `ot` for `to`. */
static bool is_turned(const char *a, const char *b)
{
    return strlen(a) == 2 && strlen(b) == 2 && tolower((unsigned char)a[0]) == tolower((unsigned char)b[1]) &&
           tolower((unsigned char)a[1]) == tolower((unsigned char)b[0]);
}

struct nearest nearest_to(const char *word)
{
    size_t length = strnlen(word, LONGEST);

    /* A third of the letters may be wrong, and never all; of two, only their order. */
    return (struct nearest){.word = word, .distance = (int)(length < 3 ? 2 : length / 3 + 1), .turned = length < 3};
}

void nearest_offer(struct nearest *nearest, const char *candidate)
{
    size_t length = strnlen(nearest->word, LONGEST), other = strnlen(candidate, LONGEST);
    bool begins = length > 2 && strncasecmp(nearest->word, candidate, length) == 0;
    int d;

    /* So many letters more or less are as far. */
    if (!begins && (int)(length > other ? length - other : other - length) >= nearest->distance)
        return;
    d = distance(nearest->word, candidate);
    if (nearest->turned && d && !is_turned(nearest->word, candidate))
        return;

    /* The beginning of a longer name is near. */
    if (begins && d > 1)
        d = 1;

    if (d < nearest->distance && d < (int)other) {
        nearest->distance = d;
        nearest->best = candidate;
    }
}

const char *names_count(long long n, const char *one, const char *many)
{
    return n == 1 ? one : many;
}

const char *names_multiple(struct arena *arena, long long of, long long plus)
{
    return plus ? arena_printf(arena, "%lld + %lld", of, plus) : arena_printf(arena, "%lld", of);
}

const char *nearest_in(const char *word, const char *const *candidate, int n)
{
    struct nearest nearest = nearest_to(word);

    for (int i = 0; i < n; i++)
        nearest_offer(&nearest, candidate[i]);
    return nearest.best;
}
