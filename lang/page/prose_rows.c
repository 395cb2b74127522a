/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in; the rows that are named or counted there, out. */
#include "lang/page/prose.h"

#include "lang/page/words.h"

bool prose_names_row(const char *text)
{
    for (size_t i = 0; i < WORDS_REACH && text[i] && !strchr(":\r\n", text[i]); i += words_length(text + i) + (words_length(text + i) == 0))
        if (words_are_rows(text + i))
            return true;
        else if (text[i] == '.' && isupper((unsigned char)*words_skip_blanks(text + i + 1)))
            return false;
    return false;
}

size_t prose_rows_within(const char *text)
{
    for (size_t i = 1; text[i]; i++) {
        const char *behind = words_next(text + i), *rows = words_behind_number(behind);

        if (isalnum((unsigned char)text[i - 1]) || !words_are(text + i, WORDS_PLAIN | WORDS_WORK))
            continue;
        if ((rows && words_are_rows(rows)) || (words_is(text + i, "work") && words_row(behind)) || (words_are(behind, WORDS_EVERY) && words_are_rows(words_next(behind))) ||
            (words_is(text + i, "work") && words_is(behind, "in") && prose_fabric_follows(words_skip_blanks(behind + 2))))
            return i;
    }
    return 0;
}

/* `3 repeats of the 2 rows`, `these 4 rows`: what begins at i is named, not counted. */
static bool is_named(const char *sentence, size_t i)
{
    static const char *const before[] = {"the", "these", "those", "this"};

    while (i > 0 && strchr(" \t", sentence[i - 1]))
        i--;
    for (size_t at = i; at > 0 && isalpha((unsigned char)sentence[at - 1]); i = --at)
        ;
    return words_find(sentence + i, before, sizeof before / sizeof *before) >= 0;
}

/* `rows of squares`: of what rows make, not of stitches. */
static bool are_of_shapes(const char *rows)
{
    static const char *const shape[] = {"squares", "blocks", "boxes", "checks", "bricks", "diamonds", "triangles", "tiles", "baskets", "waves", "bumps"};
    const char *of = words_next(rows);

    return words_is(of, "of") && words_find(words_next(of), shape, sizeof shape / sizeof *shape) >= 0;
}

size_t prose_row_count(const char *sentence)
{
    for (size_t i = 1, n = words_line_within(sentence, WORDS_REACH); i < n; i++) {
        const char *behind = isspace((unsigned char)sentence[i - 1]) ? words_behind_number(sentence + i) : NULL;

        if (behind && is_named(sentence, i))
            continue;
        if (behind && words_is(behind, "more"))
            behind = words_skip_blanks(behind + 4);
        if (behind && words_are_rows(behind) && !are_of_shapes(behind))
            return i;
    }
    return 0;
}

bool prose_is_bare_row(const char *text, bool plain)
{
    const unsigned work = WORDS_END | WORDS_EVERY | WORDS_AGAIN | WORDS_STITCH | WORDS_TIMES | WORDS_OFTEN | WORDS_NUMBER;
    static const char *const other[] = {"to", "across", "around", "from", "the", "of", "last", "more", "and", "place", "slip", "marker", "pm", "sm"},
                             *const whole[] = {"the", "of", "this", "each"};
    size_t at = strspn(text, "*([ \t");
    bool row = false;
    bool counted = false, closed = false;

    if (!words_are(text + at, WORDS_PLAIN))
        return false;
    for (size_t n; at < WORDS_REACH && text[at] && !strchr("\r\n#", text[at]); at += n) {
        n = words_length(text + at);
        if (words_are(text + at, WORDS_PLAIN))
            counted |= words_behind_number(words_skip_blanks(text + at + n)) != NULL;
        else if (n ? !(row && words_are_rows(text + at)) && !words_are(text + at, work) && words_find(text + at, other, sizeof other / sizeof *other) < 0 : closed || !strchr(" \t*()[],;.0123456789", text[at]))
            return false;
        closed |= text[at] == '.' && !prose_line_ends(text + at);
        row = n ? words_find(text + at, whole, sizeof whole / sizeof *whole) >= 0 : row && text[at] == ' ';
        n = n ? n : 1;
    }
    return at < WORDS_REACH && (counted || plain);
}

bool prose_row_line(const char *text)
{
    const char *first = text + (*text == '*'), *number = words_next(first);

    return words_are(first, WORDS_PLAIN) && isdigit((unsigned char)*number) && !words_are_rows(words_skip_blanks(number + strspn(number, "0123456789"))) &&
           !words_line_has(text, "rib") && !words_line_has(text, "ribbing") && !words_line_has(text, "rows") && !words_line_has(text, "more");
}

bool prose_counts_fabric(const char *text)
{
    const char *rows = words_behind_number(text), *of = rows && words_are_rows(rows) ? words_next(rows) : NULL;

    return of && (words_is(of, "of") || words_is(of, "in")) && prose_fabric_follows(words_skip_blanks(of + 2));
}

bool prose_row_is_named(const char *text)
{
    text = words_skip_blanks(text);
    return words_are_rows(text) && *words_next(text) == ':';
}

bool prose_row_is_labelled(const char *text)
{
    const char *number = words_skip_blanks(text), *behind = words_skip_blanks(number + strspn(number, "0123456789"));

    return isdigit((unsigned char)*number) && (*behind == ':' || (*behind == '-' && behind[1] == ' '));
}

bool prose_rows_follow(const char *text)
{
    const char *behind = *text == '{' ? text + strcspn(text, "}\r\n") : words_behind_number(text);

    if (behind && *behind == '}')
        behind = words_skip_blanks(behind + 1);
    if (behind && words_is(behind, "more"))
        behind = words_skip_blanks(behind + 4);
    return behind && (words_are_rows(behind) || words_one_of("ridges|ridge", behind));
}

bool prose_rows_are_named(const char *text)
{
    const char *behind = words_behind_number(text);

    return behind && words_are_rows(behind) && strchr(",:", *words_next(behind)) && *words_next(behind);
}

bool prose_heads_rows(const char *sentence, const char *behind)
{
    static const char *const more[] = {"then", "and", "now", "next", "work", "knit", "purl", "cont", "continue", "proceed"};
    const char *next = behind + strspn(behind, " \t\f\v\r\n");

    for (sentence += words_length(sentence); *sentence && *sentence != ':'; sentence += words_length(sentence) ? words_length(sentence) : 1)
        if (words_find(sentence, more, sizeof more / sizeof *more) >= 0)
            return false;
    return prose_names_row(next) || words_row(next);
}

bool prose_side_is_worked(const char *text)
{
    static const char *const work[] = {"knit", "purl"};
    const char *behind = words_next(text);

    return words_are(text, WORDS_SIDE) && *behind == ':' && words_find(words_skip_blanks(behind + 1), work, 2) >= 0;
}

/* Behind the numbers and the side of a row's head; or NULL. */
static const char *behind_head(const char *text)
{
    if (!words_are_rows(text))
        return NULL;
    text = words_next(text);
    if (!isdigit((unsigned char)*text))
        return NULL;
    while (isdigit((unsigned char)*text) || strchr(" \t-,&()", *text ? *text : '.') || words_is(text, "and") || words_is(text, "to") ||
           words_is(text, "rs") || words_is(text, "ws"))
        text += words_length(text) ? words_length(text) : 1;
    return text;
}

bool prose_pattern_follows(const char *text)
{
    static const char *const multiple[] = {"multiple", "mult"};
    const char *head = behind_head(text), *number = words_next(text);

    if (head)
        return *head == ':' || prose_stitches_follow(head);
    if (words_is(text, "co"))
        return prose_has_cast_on(number);
    if (words_is(text, "cast"))
        return words_is(number, "on") && prose_has_cast_on(number + 2);
    return words_find(text, multiple, 2) >= 0 && words_is(number, "of");
}
