/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line of a page in, the name that it gives to rows out. */
#include "lang/page/definitions.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/edges.h"
#include "lang/page/headings.h"
#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { LONGEST_NAME = 40, LINES_BETWEEN = 3 };

/* The head of a row that has none; where rounds are told so, of a round. */
static const char row_1[] = "r1:", round_1[] = "rnd 1:";

bool definitions_is_of_pattern(const char *text)
{
    static const char *const words[] = {"st", "sts", "stitch", "pattern", "patt", "pat"};

    return words_find(text, words, sizeof words / sizeof *words) >= 0;
}

const char *definitions_next_line(const char *text)
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

/* Behind `All rows:`, `Every rnd:`, `Pattern row:`; or NULL. */
static const char *behind_all_rows(const char *text)
{
    const char *rows = words_are(text, WORDS_EVERY) || words_one_of("pattern|patt", text) ? words_next(text) : "";
    const char *behind = words_are_rows(rows) ? words_next(rows) : "";

    return *behind == ':' ? words_skip_blanks(behind + 1) : NULL;
}

/* Stitches that are one row: a part of them is repeated, and nothing is said of others. */
static bool is_one_row(const char *text)
{
    bool repeated = false;

    if (!prose_stitches_follow(text))
        return false;
    for (size_t at = 0, n; text[at] && !words_ends_line(text[at]); at += n ? n : 1) {
        n = words_length(text + at);
        repeated |= strchr("*([", text[at]) != NULL;
        if (n && words_one_of("rows|next|over|following|each|on|rs|ws", text + at))
            return false;
    }
    return repeated;
}

/* `K2, P2 Rib`, `Pattern 2`: figures are a part of a name only beside such a word, and where no rows are counted. */
static bool is_name_with_figures(const char *text, size_t length)
{
    return words_any_of("rib|ribbing|stitch|pattern", text, 0, length) && !words_any_of("row|rows|rnd|rnds|round|rounds", text, 0, length);
}

/* `Border`, `BODY:`, and no more of the line: a heading that parts of a piece have. */
static bool is_part(const char *line)
{
    size_t length = strcspn(line, "(:\r\n");
    bool part = words_any_of("band", line, 0, length);

    for (size_t at = 0; at < length; at += words_length(line + at) ? words_length(line + at) : 1)
        part |= words_are(line + at, WORDS_PART);
    return part && line[length] != '(' && prose_line_ends(line + length + (line[length] == ':'));
}

/* The name that a line is, up to a bracket, a colon or a dash with a blank; without a length: it is none. */
static struct definition name_of(const char *line)
{
    size_t length = strcspn(line, "(:\r\n"), at = 0, end = 0, letters = 0, figures = 0, heading;

    if (length > LONGEST_NAME || prose_row_word(line) || edges_is(line) || (headings_find(line, &heading) && !is_part(line)))
        return (struct definition){0};
    while (at < length && isalnum((unsigned char)line[at]) && strncmp(line + at, "- ", 2) != 0) {
        size_t word = strspn(line + at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"), letter = words_length(line + at);

        letters += letter;
        figures += letter < word;
        end = definitions_is_of_pattern(line + at) ? end : at + word;
        at += word;
        at += strncmp(line + at, " - ", 3) == 0 ? 1 : strspn(line + at, letter < word ? " ,/-" : " '-");
    }
    if (figures ? at < length || !is_name_with_figures(line, at) : !letters)
        return (struct definition){0};
    return (struct definition){.text = line, .length = end, .figures = figures > 0, .part = is_part(line)};
}

/* The row 1 that follows a line, but for remarks about it, or all its rows. */
static bool find_rows_below(const char *line, struct definition *found)
{
    const char *next = definitions_next_line(line);

    for (int i = 0; i < LINES_BETWEEN && is_about_rows(next) && !is_one_row(next); i++)
        next = definitions_next_line(next);
    found->rows = next;
    found->stitches = behind_all_rows(next);
    return words_row(next) == 1 || found->stitches;
}

/* Behind `Rice Stitch (odd number of sts):`, where more is on the line; or NULL. */
static const char *behind_name(const char *line)
{
    const char *behind = line + strcspn(line, "(:\r\n");

    behind = *behind == '(' ? words_skip_blanks(behind + strcspn(behind, ")\r\n") + 1) : behind;
    return *behind == ':' ? words_skip_blanks(behind + 1) : NULL;
}

/* Where stitches stand alone, on the line of their name or on the next; NULL: other rows do. */
static const char *find_stitches(const char *line, const char *behind)
{
    const char *end = line + words_line_length(line), *below = definitions_next_line(line);
    size_t breaks = strspn(end, "\r\n");

    if (behind && !prose_line_ends(behind))
        return is_one_row(behind) ? behind : NULL;
    return breaks == 1 + (*end == '\r') && is_one_row(below) ? below : NULL;
}

/* The rows on the line of their name, or stitches without a head.  Those of `Rib` alone are not the same on both sides. */
static bool find_rows_beside(const char *line, struct definition *found)
{
    const char *behind = behind_name(line);

    found->beside = true;
    if (behind && words_row(behind) == 1) {
        found->rows = behind;
        return !found->part;
    }
    found->rows = line + 1;
    found->stitches = behind ? behind_all_rows(behind) : NULL;
    if (!found->stitches && !words_any_of("rib|ribbing", line, 0, found->length))
        found->stitches = find_stitches(line, behind);
    return found->stitches && !found->part && found->stitches - line > (long)strlen(row_1);
}

/* Behind `Pattern stitch:`, `Stitch pattern:`, where a name follows on the line; or the line itself. */
static const char *behind_label(const char *line)
{
    size_t n = words_one_of("pattern stitch|stitch pattern|main pattern|pattern|stitch", line);
    const char *name = words_skip_blanks(line + n + (line[n] == ':'));

    return n && line[n] == ':' && isalpha((unsigned char)*name) && !words_row(name) && !prose_stitches_follow(name) ? name : line;
}

struct definition definitions_read(const char *line)
{
    struct definition found = {0};

    line = behind_label(line);
    if (words_row(line) || behind_all_rows(line) || is_about_rows(line))
        return found;
    found = name_of(line);
    if (!found.length || find_rows_below(line, &found) || find_rows_beside(line, &found))
        return found;
    return (struct definition){0};
}

void definitions_put(const struct definition *definition, char *copy)
{
    char *rows = copy + (definition->rows - definition->text), *stitches = definition->stitches ? copy + (definition->stitches - definition->text) : rows;
    bool of_rounds = stitches - rows >= (long)strlen(round_1) && words_any_of("rnd|rnds|round|rounds", copy, 0, (size_t)(stitches - copy));
    const char *head = of_rounds ? round_1 : row_1;

    for (char *at = definition->beside ? copy : rows; at < stitches; at++)
        *at = words_ends_line(*at) ? *at : ' ';
    if (definition->beside)
        *copy = '\n';
    if (definition->stitches)
        memcpy(rows, head, strlen(head));
}
