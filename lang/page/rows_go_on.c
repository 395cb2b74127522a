/* SPDX-License-Identifier: GPL-3.0-or-later
 * The first stitches of a row and `etc.` in, what is repeated out. */
#include "lang/page/rows_go_on.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { MOST = 64 };

/* The stitches a row begins with, one by one, and where each run of them ends in the text. */
struct stitches {
    char   stitch[MOST];
    size_t end[MOST];   /* behind the run that this is the last stitch of; 0: it is not */
    int    n;
};

/* `knit 2`, `k2`: its bytes; 0: no stitches with their number. */
static size_t run_length(const char *text, int *n)
{
    const char *number = words_are(text, WORDS_PLAIN) ? words_next(text) : text, *behind = number > text ? words_behind_number(number) : NULL;

    *n = behind ? words_number(number) : 0;
    while (behind && behind[-1] == ' ')
        behind--;
    return *n > 0 ? (size_t)(behind - text) : 0;
}

/* Behind the list of stitches that the text begins with. */
static const char *behind_stitches(const char *text, struct stitches *stitches)
{
    const char *at = text;
    int n;

    for (size_t length; (length = run_length(at, &n)) > 0 && n <= MOST - stitches->n; at = words_skip_any(at, "stitches|stitch|sts|st|,|and|then")) {
        memset(stitches->stitch + stitches->n, tolower((unsigned char)*at), (size_t)n);
        memset(stitches->end + stitches->n, 0, (size_t)n * sizeof *stitches->end);
        stitches->n += n;
        at += length;
        stitches->end[stitches->n - 1] = (size_t)(at - text);
    }
    return at;
}

/* Behind `- continue in this pattern to the end`; NULL: another text. *begun: the stitches are a beginning, and no whole
 * number of repeats. */
static const char *behind_go_on(const char *text, bool *begun)
{
    static const char rest[] = "in|with|this|the|that|same|these|it|as|pattern|patt|sequence|manner|way|fashion|like|alternating|stitches|stitch|sts|st|until|till|to|all|across|along|"
                               "end|of|row|round|rnd|each|every|you|reach|get";
    const char *verb = words_skip_any(text, "-|\xE2\x80\x93|\xE2\x80\x94|,|.|;|(|and"), *end;
    size_t n = words_one_of("etc.|etc|so on|so forth|continue|continuing|keep going|keep on|carry on|go on|on and on|all the way|all across", verb);

    *begun = n > 0;
    n = n ? n : words_one_of("keep repeating|repeat this|repeat these|repeat it|repeat pattern|repeat the|rep these|rep this", verb);
    end = n ? verb + n : NULL;
    while (end && (words_one_of(rest, words_skip_blanks(end)) || words_behind_number(words_skip_blanks(end)) || *end == '.')) {
        const char *word = words_skip_blanks(end), *number = words_behind_number(word);

        if (number && (!words_are_stitches(number) || !strchr(" ", number[-1])))
            return NULL;
        end = number ? number : *end == '.' ? end + 1 : word + words_one_of(rest, word);
        if (end[-1] == '.')
            break;
    }
    if (!end)
        return NULL;
    end += *end == ')' && memchr(text, '(', (size_t)(verb - text)) != NULL;
    return prose_line_ends(end) || strchr(".;", *end) || end[-1] == '.' ? end : NULL;
}

/* The least number of stitches that give the others when they are repeated, and end a run. */
static int period(const struct stitches *stitches)
{
    for (int p = 1; p < stitches->n; p++)
        if (stitches->end[p - 1] && memcmp(stitches->stitch, stitches->stitch + p, (size_t)(stitches->n - p)) == 0)
            return p;
    return stitches->n;
}

size_t rows_go_on_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    struct stitches stitches = {.n = 0};
    const char *first = words_skip_blanks(text + at + 1), *behind = words_are(first, WORDS_PLAIN) ? behind_stitches(first, &stitches) : first, *end;
    bool begun;
    size_t kept, room;

    end = stitches.n ? behind_go_on(behind, &begun) : NULL;
    if (!end || !memchr(stitches.stitch, stitches.stitch[0] == 'k' ? 'p' : 'k', (size_t)stitches.n))
        return 0;
    kept = (size_t)(first - text) - at + stitches.end[(begun ? period(&stitches) : stitches.n) - 1];
    room = (size_t)(end - text) - at - kept;
    if (kept + strlen(" to end") >= SIGNS_PLAIN || room < strlen(" rep"))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%.*s%s", (int)kept, text + at, room < strlen(" to end") ? " rep" : " to end");
    return kept + room;
}
