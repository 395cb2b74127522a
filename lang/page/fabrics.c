/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a page's text in, the fabric that is worked there in the language's words out. */
#include "lang/page/fabrics.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/ribs.h"
#include "lang/page/words.h"

/* Whether a full stop ends a sentence, not a word that is cut short. */
static bool ends_sentence(const char *text)
{
    const char *behind = words_skip_blanks(text + 1);

    return !*behind || words_ends_line(*behind) || (behind > text + 1 && isupper((unsigned char)*behind));
}

/* `st`, and a full stop that cuts it short; 0: another text. */
static size_t stitch_length(const char *text)
{
    size_t n = words_one_of("stitch|st", text);

    return n + (n && text[n] == '.' && !ends_sentence(text + n));
}

size_t fabrics_short(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const struct { const char *word, *plain; } cut[] = {{"st", "st st"}, {"s", "st st"}, {"g", "g st"}};

    for (size_t i = 0; i < sizeof cut / sizeof *cut; i++) {
        size_t n = words_one_of(cut[i].word, text + at), joins = n ? strspn(text + at + n, ".- ") : 0, st = joins ? stitch_length(text + at + n + joins) : 0;

        if (!st || joins > 2 || text[at + n] == ' ' || strlen(cut[i].plain) > n + joins + st)
            continue;
        strcpy(plain, cut[i].plain);
        return n + joins + st;
    }
    return 0;
}

size_t fabrics_rib(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char opens[] = "([,-", closes[] = ")] -";
    size_t n = words_one_of("ribbing|rib", text + at), sign = at + n + strspn(text + at + n, " "), pair, end;
    const char *open = n && text[sign] ? strchr(opens, text[sign]) : NULL;
    int knit, purl;

    if (!open)
        return 0;
    pair = sign + 1 + strspn(text + sign + 1, " ");
    end = pair + ribs_pair(text + pair, &knit, &purl);
    if (end == pair)
        return 0;
    end += *open == '-' ? strspn(text + end, " ") : 0;
    if (*open != ',' && text[end] != closes[open - opens] && !(*open == '-' && prose_line_ends(text + end)))
        return 0;
    end += *open != ',' && text[end] == closes[open - opens];
    snprintf(plain, SIGNS_PLAIN, "k%d p%d rib", knit, purl);
    return strlen(plain) <= end - at ? end - at : 0;
}

size_t fabrics_rows(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    bool work = words_is(text + at, "work") || words_is(text + at, "knit");
    const char *number = work ? words_next(text + at) : text + at, *rows = words_behind_number(number), *pair, *end;
    int knit, purl;
    size_t n, rib;

    if (!strchr("\n.;:", words_sign_before(text, at, " \t")) || !rows || !words_are_rows(rows))
        return 0;
    pair = words_next(rows);
    pair = words_is(pair, "of") || words_is(pair, "in") ? words_next(pair) : pair;
    n = ribs_pair(pair, &knit, &purl);
    end = words_skip_blanks(pair + n);
    rib = words_one_of("ribbing|rib", end);
    end += rib;
    if (!n || (work && rib) || (!prose_line_ends(end) && !strchr(".,;", *end)))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%dx%d rib %d %.*s", knit, purl, words_number(number), (int)words_length(rows) % 8, rows);
    n = (size_t)(end - text) - at;
    return strlen(plain) <= n ? n : 0;
}

size_t fabrics_repeated(const char *text, size_t *length)
{
    size_t line = words_line_length(text), n = 0;
    const char *rows;

    if (!strchr("*([", *text))
        return 0;
    while (n < line && !(words_is(text + n, "for") && text[n - 1] == ' '))
        n++;
    rows = n < line ? words_behind_number(words_next(text + n)) : NULL;
    if (!rows || !words_are_rows(rows) || !prose_stitches_follow(text + strspn(text, "*([ ")))
        return 0;
    rows += words_length(rows);
    *length = (size_t)(rows - text) - n;
    return prose_line_ends(rows + (*rows == '.')) ? n : 0;
}
