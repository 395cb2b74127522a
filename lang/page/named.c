/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with "pattern" for the names it gave to its rows out. */
#include "lang/page/named.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/edges.h"
#include "lang/page/headings.h"
#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { LONGEST_NAME = 40, LINES_BETWEEN = 3, MOST_NAMES = 32 };

/* A name's words but the last ones that say it is a pattern's: `Box` of `Box Stitch`. */
struct name {
    const char *text;
    size_t      length;
    const char *rows;       /* its row 1 */
    bool        twice;      /* other rows have it, too */
    bool        mentioned, figures;
    bool        part;       /* `Border`: of the piece, which is repeated and not a pattern to work in */
};

struct names_of_page {
    struct name name[MOST_NAMES];
    int n;
};

static const char *const of_patterns[] = {"st", "sts", "stitch", "pattern", "patt", "pat"};

static bool is_of_patterns(const char *text)
{
    return words_find(text, of_patterns, sizeof of_patterns / sizeof *of_patterns) >= 0;
}

static const char *next_line(const char *text)
{
    text += words_line_length(text);
    return text + strspn(text, " \t\r\n");
}

/* What may stand between a name and its rows. */
static bool is_about_rows(const char *text)
{
    static const char *const word[] = {"multiple", "mult", "worked", "work", "any", "note"};

    return *text == '(' || (strchr("mMwWaAnN", *text) && words_find(text, word, sizeof word / sizeof *word) >= 0);
}

/* The row 1 that follows a line, but for remarks about it; or NULL. */
static const char *rows_below(const char *line)
{
    const char *next = next_line(line);

    for (int i = 0; i < LINES_BETWEEN && is_about_rows(next); i++)
        next = next_line(next);
    return words_row(next) == 1 ? next : NULL;
}

/* `K2, P2 Rib`, `Pattern 2`: figures are a part of a name only beside such a word, and where no rows are counted. */
static bool is_name_with_figures(const char *text, size_t length)
{
    static const char *const of_names[] = {"rib", "ribbing", "stitch", "pattern"};
    bool named = false;

    for (size_t at = 0; at < length; at += words_length(text + at) ? words_length(text + at) : 1) {
        if (words_are_rows(text + at))
            return false;
        named |= words_find(text + at, of_names, sizeof of_names / sizeof *of_names) >= 0;
    }
    return named;
}

/* `Border`, `BODY:`, and no more of the line: a heading that parts of a piece have. */
static bool is_part(const char *line)
{
    size_t length = strcspn(line, "(:\r\n");
    bool part = false;

    for (size_t at = 0; at < length; at += words_length(line + at) ? words_length(line + at) : 1)
        part |= words_are(line + at, WORDS_PART) || words_is(line + at, "band");
    return part && line[length] != '(' && prose_line_ends(line + length + (line[length] == ':'));
}

/* The name that a line is, up to a bracket, a colon or a dash with a blank; without a length: it is none. */
static struct name name_of(const char *line, const char *rows)
{
    size_t length = strcspn(line, "(:\r\n"), at = 0, end = 0, letters = 0, figures = 0, heading;

    if (length > LONGEST_NAME || prose_row_word(line) || edges_is(line) || (headings_find(line, &heading) && !is_part(line)))
        return (struct name){0};
    while (at < length && isalnum((unsigned char)line[at]) && strncmp(line + at, "- ", 2) != 0) {
        size_t word = strspn(line + at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"), letter = words_length(line + at);

        letters += letter;
        figures += letter < word;
        end = is_of_patterns(line + at) ? end : at + word;
        at += word;
        at += strncmp(line + at, " - ", 3) == 0 ? 1 : strspn(line + at, letter < word ? " ,/-" : " '-");
    }
    if (figures ? at < length || !is_name_with_figures(line, at) : !letters)
        return (struct name){0};
    return (struct name){.text = line, .length = end, .rows = rows, .figures = figures > 0, .part = is_part(line)};
}

static bool same_name(const struct name *a, const struct name *b)
{
    return a->length == b->length && strncasecmp(a->text, b->text, a->length) == 0;
}

/* The names of the text's rows. */
static void find_names(const char *text, struct names_of_page *names)
{
    for (const char *line = text + strspn(text, " \t\r\n"); *line && names->n < MOST_NAMES; line = next_line(line)) {
        const char *rows = words_row(line) == 1 || is_about_rows(line) ? NULL : rows_below(line);
        struct name name = rows ? name_of(line, rows) : (struct name){0};

        if (!name.length)
            continue;
        for (int i = 0; i < names->n; i++)
            if (same_name(&name, &names->name[i]))
                names->name[i].twice = name.twice = true;
        names->name[names->n++] = name;
    }
}

/* How long the name, and what says that it is a pattern's, is at a place; or 0. */
static size_t named_length(const struct name *name, const char *text)
{
    static const char *const rib[] = {"rib", "ribbing"};
    size_t n = name->length;

    if (text >= name->rows && words_find(name->text, rib, 2) >= 0 && n == words_length(name->text) && words_find(text, rib, 2) >= 0)
        n = words_length(text);
    else if (text < name->rows || strncasecmp(text, name->text, n) != 0 || isalnum((unsigned char)text[n]))
        return 0;
    for (const char *next; next = words_skip_blanks(text + n), is_of_patterns(next);)
        n = (size_t)(next - text) + words_length(next);
    return n;
}

/* The longest name at a place; or NULL. */
static struct name *name_at(struct names_of_page *names, const char *text, size_t *length)
{
    struct name *longest = NULL;

    *length = 0;
    for (int i = 0; i < names->n; i++) {
        size_t n = names->name[i].twice ? 0 : named_length(&names->name[i], text);

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
    const char *plain = "in patt";

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

/* What the name is to be at a place of the text from `first` on: behind `in`, `of`, `change to` the pattern. NULL: the
 * word is no mention. */
static const char *plain_at(const char *first, const char *at, size_t length, bool part)
{
    static const char *const lead[] = {"in", "of", "change to", "switch to"};
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
        if (names->name[i].mentioned || names->name[i].figures)
            heading[named->nheadings++] = (unsigned)(names->name[i].text - text);
    named->heading = heading;
}

const char *named_plain(struct arena *arena, const char *text, size_t size, struct named *named)
{
    struct names_of_page names = {0};
    char *plain = NULL;

    find_names(text, &names);
    if (!names.n)
        return text;
    for (const char *at = names.name[0].rows; *at; at += words_length(at) ? words_length(at) : 1) {
        size_t length;
        struct name *name = name_at(&names, at, &length);
        const char *wording = name ? plain_at(text, at, length, name->part) : NULL;

        if (name)
            keep_mention(arena, named, (struct named_mention){(unsigned)(at - text), (unsigned)(name->rows - text), wording != NULL});
        if (!wording)
            continue;
        name->mentioned = true;
        plain = plain ? plain : arena_copy(arena, text, size);
        memset(plain + (at - text), ' ', length);
        memcpy(plain + (at - text), wording, strlen(wording));
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
