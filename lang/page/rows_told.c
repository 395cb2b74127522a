/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sentence that says what rows are in, their head and stitch as the language has them out. */
#include "lang/page/rows_told.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

static const char joins[] = ",|and|&|-|to|through|the";

/* `1st`, `third`: its number; 0: none. */
static int nth(const char *text, size_t *n)
{
    *n = words_are(text, WORDS_NTH) ? words_length(text) : words_ordinal_length(text);
    return *n ? words_number(text) : 0;
}

/* Behind `1st and third rows`, and `rows 1,3` of it in plain words; NULL: no such rows. */
static const char *behind_ordinals(const char *text, char plain[static SIGNS_PLAIN])
{
    char numbers[SIGNS_PLAIN] = "";
    int used = 0;
    bool range = false;     /* `1st to 3rd` */
    size_t n;

    for (int number; (number = nth(text, &n)) > 0 && number < 10000 && used + 8 < SIGNS_PLAIN; text = words_skip_any(text + n, joins)) {
        used += snprintf(numbers + used, sizeof numbers - (size_t)used, "%s%d", used && !range ? "," : "", number);
        range = words_one_of("to|through|-", words_skip_blanks(text + n)) > 0;
        used += range ? snprintf(numbers + used, sizeof numbers - (size_t)used, "-") : 0;
    }
    if (!used || !words_are_rows(text))
        return NULL;
    snprintf(plain, SIGNS_PLAIN, "row %s", numbers);
    return words_next(text);
}

/* Behind `Rows 1-3`, `row one`, which stay as they are; NULL: no such rows. */
static const char *behind_numbers(const char *text, char plain[static SIGNS_PLAIN])
{
    const char *first = text, *behind = words_are_rows(text) ? words_next(text) : NULL, *end = NULL;

    while (behind && words_behind_number(behind)) {
        end = words_behind_number(behind);
        while (end[-1] == ' ')
            end--;
        behind = words_skip_any(end, joins);
    }
    if (!end || end - first >= SIGNS_PLAIN - 8)
        return NULL;
    snprintf(plain, SIGNS_PLAIN, "%.*s", (int)(end - first), first);
    return words_skip_blanks(end);
}

/* Behind `(RS)`, which is kept. */
static const char *behind_side(const char *text, char plain[static SIGNS_PLAIN])
{
    size_t n = words_one_of("(rs)|(ws)|(right side)|(wrong side)", text), used = strlen(plain);

    if (n)
        snprintf(plain + used, SIGNS_PLAIN - used, " %cS", toupper((unsigned char)text[1]));
    return words_skip_blanks(text + n);
}

/* Behind `knitted across`, `a purl row`, which are all of a row; NULL: more follows, or another text. */
static const char *behind_plain(const char *text, char *stitch)
{
    const char *verb = words_skip_any(text, "all|just|simply|a|in"), *end;
    size_t n = words_one_of("knitted|knit|k|purled|purl|p", verb);

    *stitch = n ? (char)tolower((unsigned char)*verb) : '\0';
    end = words_skip_any(verb + n, "row|rows|across|every|each|all|the|way|stitches|stitch|sts|st|plain|to|end|of");
    while (n && end[-1] == ' ')
        end--;
    return n && (prose_line_ends(end) || strchr(".,;", *end) || words_one_of("and the|while the", words_skip_blanks(end))) ? end : NULL;
}

/* Where the rows are of a sentence that begins at a place, or of a part of one: `, and the second row`; NULL: nothing begins
 * there. *part: it is such a part. */
static const char *rows_at(const char *text, size_t at, bool *part)
{
    char before = words_sign_before(text, at, " \t");

    *part = before == ',' || words_is(text + at, "and");
    return *part || strchr("\r\n.:", before) ? words_skip_any(text + at, *part ? "and|then|while|the" : "the|your|then") : NULL;
}

size_t rows_told_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    char head[SIGNS_PLAIN], stitch;
    bool part;
    const char *rows = rows_at(text, at, &part), *verb = rows ? behind_numbers(rows, head) : NULL, *behind, *end;

    verb = verb || !rows ? verb : behind_ordinals(rows, head);
    verb = verb ? behind_side(verb, head) : NULL;
    behind = verb ? words_skip_any(verb, "is|are|will be|should be|gets") : NULL;
    if (!behind || behind == verb)
        return 0;
    end = behind_plain(behind, &stitch);
    if (!end) {
        end = words_skip_any(behind, "worked|knitted|made|done|the|same|exactly|just|as follows|:|,");
        stitch = '\0';
        if (!prose_stitches_follow(end) || (end == behind && !words_is(end, "as") && words_are_rows(words_next(end))))
            return 0;
    }
    if (strlen(head) + 5 > SIGNS_PLAIN)
        return 0;
    snprintf(plain, SIGNS_PLAIN, stitch ? "%s%.90s:%c" : "%s%.90s: ", part ? "\n" : "", head, stitch);
    return strlen(plain) <= (size_t)(end - text) - at ? (size_t)(end - text) - at : 0;
}
