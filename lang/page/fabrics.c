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

    if (!n)
        return 0;
    pair = sign + (open ? 1 + strspn(text + sign + 1, " ") : 0);
    end = pair + ribs_pair(text + pair, &knit, &purl);
    if (end == pair)
        return 0;
    if (!open) {
        n = (size_t)snprintf(plain, SIGNS_PLAIN, "k%d p%d", knit, purl);
        if (!words_stitch_length(text + pair) || !prose_line_ends(text + end) || n + strlen(" rib") > end - at)
            return 0;
        snprintf(plain + n, SIGNS_PLAIN - n, "%*s", (int)(end - at - n), "rib");
        return end - at;
    }
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

/* Behind `knit 1 row`, `1 row knit`; NULL: another text. */
static const char *behind_one_row(const char *text, char *stitch)
{
    const char *verb = words_skip_any(text, "1|one|a|row|rows|alternate|alternating|alternately"), *end;
    size_t n = words_one_of("knit|k|purl|p", verb);

    if (!n)
        return NULL;
    *stitch = (char)tolower((unsigned char)*verb);
    end = words_skip_any(verb + n, "1|one|a|row|rows");
    return end;
}

size_t fabrics_alternate(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    bool open = text[at] == '[' || text[at] == '(' || text[at] == '*', named = false, more, all;
    char first, second;
    const char *behind = strchr("\r\n.;", words_sign_before(text, at, " \t")) ? behind_one_row(text + at + open, &first) : NULL, *number;
    int n;

    behind = behind ? behind_one_row(words_skip_any(behind, ",|and|then|."), &second) : NULL;
    if (!behind || first == second)
        return 0;
    for (const char *word = text + at; word < behind; word += words_length(word) + 1) {
        named |= words_are_rows(word);
        if (words_one_of("rnd|rnds|rd|rds|round|rounds", word))    /* garter, there */
            return 0;
    }
    number = words_skip_any(behind, ",|.|;|)|]|*");
    all = open || words_are(number, WORDS_AGAIN);       /* else `purl 1 row, 3 times` may be meant */
    number = words_skip_any(number, "repeat|rep|repeating|alternately|for|a|total|of");
    n = words_behind_number(number) ? words_number(number) : 0;
    if (!named || n < 1 || n > 999 || number == behind)
        return 0;
    number = words_behind_number(number);
    more = words_is(number, "more");
    number = more ? words_next(number) : number;
    if (all && (words_is(number, "times") || words_is(number, "x")))
        n = 2 * (n + (more || words_is(words_next(number), "more")));
    else if (!words_are_rows(number) || words_are(words_next(number), WORDS_PLAIN))
        return 0;
    number += words_length(number);
    number = words_is(words_skip_blanks(number), "more") ? words_skip_blanks(number) + 4 : number;
    snprintf(plain, SIGNS_PLAIN, "st st %d rows beg on %c row", n, first);
    return strlen(plain) <= (size_t)(number - text) - at ? (size_t)(number - text) - at : 0;
}

/* The rows of the head `Rows 7-10:` that a line begins with, and behind it; 0: it begins otherwise. */
static int rows_of_head(const char *line, const char **behind)
{
    const char *first = words_are_rows(line) ? words_next(line) : NULL, *to = first ? words_behind_number(first) : NULL, *last = to ? words_skip_any(to, "-|to|and|&") : NULL;

    *behind = last > to ? words_behind_number(last) : NULL;
    return *behind && **behind == ':' ? words_number(last) - words_number(first) + 1 : 0;
}

size_t fabrics_of_rows(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char fabrics[] = "garter|seed|moss|stockinette|stocking|rev|reverse|st|stitch";
    const char *work, *fabric, *count = words_skip_any(text + at, "work|for"), *rows = words_behind_number(count), *end;
    int n = rows && words_are_rows(rows) ? rows_of_head(text + words_line_start(text, at), &work) : 0;

    (void)plain;        /* nothing stands for it */
    if (n < 1 || words_number(count) != n)
        return 0;
    rows += words_length(rows);
    work = words_skip_blanks(work + 1);
    fabric = work == text + at ? words_skip_any(rows + 1, "in|of") : work;
    end = words_skip_any(fabric, fabrics);
    if (end == fabric || !prose_line_ends(work == text + at ? end + (*end == '.') : rows + (*rows == '.')))
        return 0;
    return work == text + at ? (size_t)(fabric - work) : end == text + at ? (size_t)(rows - end) : 0;
}

size_t fabrics_begun(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *stitch = words_skip_any(text + at, "starting|beginning|commencing|start|begin|beg|with");
    size_t length = stitch > text + at ? words_stitch_length(stitch) : 0, gap = words_gap_length(stitch + length);
    const char *work = stitch + length + gap, *count = words_skip_any(work, "work|knit"), *rows = words_behind_number(count), *first;

    (void)plain;
    if (!length || !gap || count == work || !rows || !words_are_rows(rows))
        return 0;
    first = words_skip_any(words_next(rows), "in|of");
    return words_stitch_length(first) == length && strncasecmp(first, stitch, length) == 0 ? (size_t)(work - text) - at : 0;
}

size_t fabrics_changed(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *verb = text + at, *fabric, *behind, *work, *rows;
    size_t n = words_one_of("change|changing|switch|begin|start|proceed", verb);

    if (!n || !strchr("\r\n.;:", words_sign_before(text, at, " \t")))
        return 0;
    fabric = words_skip_any(verb + n, "to|with|in|working|work|knitting|the");
    behind = words_skip_any(fabric, "garter|seed|moss|stockinette|stocking|st|stitch");
    if (behind == fabric)
        return 0;
    work = words_skip_any(behind, ".|:|,|;|and|then|now");
    rows = words_skip_any(work, "work|knit|continue|for");
    if (work == behind || rows == work || !prose_rows_follow(rows))
        return 0;
    for (n = (size_t)(behind - fabric); n > 0 && fabric[n - 1] == ' ';)
        n--;
    n -= n > 6 && strncasecmp(fabric + n - 6, "stitch", 6) == 0 ? 4 : 0;
    if (n > 30)
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%.*s for", (int)n, fabric);
    return strlen(plain) < (size_t)(rows - text) - at ? (size_t)(rows - text) - at - 1 : 0;
}

size_t fabrics_repeated(const char *text, size_t *length)
{
    size_t line = words_line_length(text), n = 0;
    const char *rows, *first = words_next(text);

    if (!*text || !(strchr("*([", *text) || (words_are(text, WORDS_PLAIN) && words_behind_number(first) && !words_are_rows(words_behind_number(first)))))
        return 0;
    while (n < line && !(words_is(text + n, "for") && text[n - 1] == ' '))
        n++;
    rows = n < line && isdigit((unsigned char)*words_next(text + n)) ? words_behind_number(words_next(text + n)) : NULL;
    if (!rows || !words_are_rows(rows) || !prose_stitches_follow(text + strspn(text, "*([ ")))
        return 0;
    rows += words_length(rows);
    *length = (size_t)(rows - text) - n;
    return prose_line_ends(rows + (*rows == '.')) ? n : 0;
}
