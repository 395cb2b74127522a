/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with "pattern" for the names it gave to its rows out. */
#include "lang/page/named.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/definitions.h"
#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { MOST_NAMES = 32 };

struct name {
    struct definition of;
    bool twice;     /* other rows have it, too */
    bool mentioned;
};

struct names_of_page {
    struct name name[MOST_NAMES];
    int n;
};

static bool same_name(const struct name *a, const struct name *b)
{
    return a->of.length == b->of.length && strncasecmp(a->of.text, b->of.text, a->of.length) == 0;
}

/* The names of the text's rows. */
static void find_names(const char *text, struct names_of_page *names)
{
    for (const char *line = text + strspn(text, " \t\r\n"); *line && names->n < MOST_NAMES; line = definitions_next_line(line)) {
        struct name name = {.of = definitions_read(line)};

        if (!name.of.length)
            continue;
        for (int i = 0; i < names->n; i++)
            if (same_name(&name, &names->name[i]))
                names->name[i].twice = name.twice = true;
        names->name[names->n++] = name;
    }
}

/* How long the name, and what says that it is a pattern's, is at a place; or 0. */
static size_t named_length(const struct definition *name, const char *text)
{
    static const char *const rib[] = {"rib", "ribbing"};
    size_t n = name->length;

    if (text >= name->rows && words_find(name->text, rib, 2) >= 0 && n == words_length(name->text) && words_find(text, rib, 2) >= 0)
        n = words_length(text);
    else if (text < name->rows || strncasecmp(text, name->text, n) != 0 || isalnum((unsigned char)text[n]))
        return 0;
    for (const char *next; next = words_skip_blanks(text + n), definitions_is_of_pattern(next);)
        n = (size_t)(next - text) + words_length(next);
    return n;
}

/* The longest name at a place; or NULL. */
static struct name *name_at(struct names_of_page *names, const char *text, size_t *length)
{
    struct name *longest = NULL;

    *length = 0;
    for (int i = 0; i < names->n; i++) {
        size_t n = names->name[i].twice ? 0 : named_length(&names->name[i].of, text);

        if (n > *length) {
            *length = n;
            longest = &names->name[i];
        }
    }
    return longest;
}

/* What stands for the name of a pattern that is worked: nothing before its rows. */
static const char *plain_of_worked(const char *behind, size_t length)
{
    const char *plain = length < strlen("in patt") ? "in pat" : "in patt";

    behind = words_skip_blanks(behind);
    if (words_are_rows(behind))
        return "";
    if (words_is(behind, "again"))
        plain = "them";
    else if (words_are(behind, WORDS_OFTEN) || prose_times_follow(behind))
        plain = "these rows";
    return length >= strlen(plain) ? plain : NULL;
}

/* What stands for the name of rows that are repeated, behind `the`, too; NULL: more than they is named. */
static const char *plain_of_repeated(const char *behind, size_t length, bool the)
{
    static const char *const next[] = {"until", "till", "for", "again", "once", "twice", "thrice"};
    const char *plain = the ? "rows" : "them";

    behind = words_skip_blanks(behind);
    if (words_are_rows(behind))
        plain = the || isdigit((unsigned char)*words_next(behind)) ? "" : "these";
    else if (*behind && !strchr(".,;\r\n", *behind) && words_find(behind, next, 7) < 0 && !prose_times_follow(behind))
        return NULL;
    return length >= strlen(plain) ? plain : NULL;
}

/* Whether a word stands before so many bytes of a text. */
static bool stands_before(const char *first, size_t bytes, const char *word)
{
    size_t n = strlen(word);

    return bytes > n && strncasecmp(first + bytes - n, word, n) == 0 && !isalnum((unsigned char)first[bytes - n - 1]);
}

/* Whether a sentence repeats rows up to a place: `Rep rows 1 and 2 for`. */
static bool repeats_rows(const char *first, size_t at)
{
    while (at > 0 && !strchr(".\r\n", first[at - 1]))
        at--;
    first = words_skip_blanks(first + at);
    return words_are(first, WORDS_AGAIN) && words_are_rows(words_next(first));
}

/* What the name is to be at a place of the text from `first` on: behind `in`, `of`, `change to` the pattern. NULL: the
 * word is no mention. */
static const char *plain_at(const char *first, const char *at, size_t length, bool part)
{
    static const char *const lead[] = {"in", "of", "change to", "switch to"}, *const rows[] = {"row", "rows", "rnds", "rounds"};
    size_t before = (size_t)(at - first);
    bool the;

    while (before > 0 && first[before - 1] == ' ')
        before--;
    the = stands_before(first, before, "the");
    before -= the ? strlen(" the") : 0;
    if (before == (size_t)(at - first))
        return NULL;
    if (stands_before(first, before, "repeat") || stands_before(first, before, "rep"))
        return plain_of_repeated(at + length, length, the);
    for (size_t i = 0; !part && i < sizeof lead / sizeof *lead; i++)
        if (stands_before(first, before, lead[i]))
            return length >= strlen("pattern") ? "pattern" : length >= strlen("pat") ? "pat" : NULL;
    for (size_t i = 0; !part && i < sizeof rows / sizeof *rows; i++)
        if (stands_before(first, before, rows[i]) && length >= strlen("in patt") && at[-1] == ' ')
            return "in patt";
    if (!part && stands_before(first, before, "for") && length >= strlen("pattern") && repeats_rows(first, before))
        return "pattern";
    return stands_before(first, before, "work") ? plain_of_worked(at + length, length) : NULL;
}

/* ---- what is kept of them ---- */

static void keep_mention(struct arena *arena, struct named *named, struct named_mention mention)
{
    if (named->nmentions == named->room)
        named->mention = arena_larger(arena, named->mention, &named->room, sizeof *named->mention);
    named->mention[named->nmentions++] = mention;
}

static void keep_headings(struct arena *arena, struct named *named, const struct names_of_page *names, const char *text)
{
    unsigned *heading = arena_array(arena, unsigned, (size_t)names->n);

    for (int i = 0; i < names->n; i++)
        if ((names->name[i].mentioned || names->name[i].of.figures) && !names->name[i].of.beside)
            heading[named->nheadings++] = (unsigned)(names->name[i].of.text - text);
    named->heading = heading;
}

const char *named_plain(struct arena *arena, const char *text, size_t size, struct named *named)
{
    struct names_of_page names = {0};
    char *plain = NULL;

    find_names(text, &names);
    if (!names.n)
        return text;
    for (const char *at = names.name[0].of.rows; *at; at += words_length(at) ? words_length(at) : 1) {
        size_t length;
        struct name *name = name_at(&names, at, &length);
        const char *wording = name ? plain_at(text, at, length, name->of.part) : NULL;

        if (name)
            keep_mention(arena, named, (struct named_mention){(unsigned)(at - text), (unsigned)(name->of.rows - text), wording != NULL});
        if (!wording)
            continue;
        name->mentioned = true;
        plain = plain ? plain : arena_copy(arena, text, size);
        memset(plain + (at - text), ' ', length);
        memcpy(plain + (at - text), wording, strlen(wording));
        definitions_put(&name->of, plain + (name->of.text - text));
    }
    keep_headings(arena, named, &names, text);
    return plain ? plain : text;
}

bool named_is_heading(const struct named *named, size_t at)
{
    for (int i = 0; i < named->nheadings; i++)
        if (named->heading[i] == at)
            return true;
    return false;
}

unsigned named_rows(const struct named *named, unsigned start, unsigned end, bool *several)
{
    int low = 0, high = named->nmentions;
    unsigned rows = 0, any = 0;
    bool differ = false;

    while (low < high) {
        int middle = (low + high) / 2;

        if (named->mention[middle].at < start)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < named->nmentions && named->mention[low].at < end; low++) {
        const struct named_mention *mention = &named->mention[low];

        differ |= any && any != mention->rows;
        any = mention->rows;
        rows = mention->works ? mention->rows : rows;
    }
    *several = rows && differ;
    return rows;
}
