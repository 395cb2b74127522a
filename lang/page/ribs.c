/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in; the rib that is described before a place of it out. */
#include "lang/page/ribs.h"

#include <stdio.h>
#include <stdlib.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { LONGEST_PAIR = 24, LONGEST_LABEL = 60 };

struct pair {
    int knit, purl;
};

static const char *const rib_word[] = {"rib", "ribbing"};

static bool is_rib(const char *text)
{
    return words_find(text, rib_word, 2) >= 0;
}

/* A number of one or two figures: its bytes. */
static size_t number_length(const char *text, int *number)
{
    size_t n = strspn(text, "0123456789");

    *number = n && n < 3 ? atoi(text) : 0;
    return *number ? n : 0;
}

/* `k2`, `Knit 2`: its bytes. */
static size_t stitches_length(const char *text, const char *letter, const char *word, int *number)
{
    size_t n = words_is(text, letter) || words_is(text, word) ? words_length(text) : 0;
    size_t digits = n ? number_length(words_skip_blanks(text + n), number) : 0;

    return digits ? (size_t)(words_skip_blanks(text + n) - text) + digits : 0;
}

/* `k2, p2`, `knit 2 and purl 2`: its bytes. */
static size_t pair_length(const char *text, struct pair *pair)
{
    size_t at = stitches_length(text, "k", "knit", &pair->knit), n;

    if (!at)
        return 0;
    at += strspn(text + at, " \t,");
    at += words_is(text + at, "and") ? strlen("and") : 0;
    at += strspn(text + at, " \t");
    n = stitches_length(text + at, "p", "purl", &pair->purl);
    return n ? at + n : 0;
}

/* `2 x 2`, `2 and 2`: the same. */
static size_t numbers_length(const char *text, struct pair *pair)
{
    static const char *const between[] = {"and", "by", "x"};
    size_t at = number_length(text, &pair->knit), n;

    at += at ? strspn(text + at, " \t") : 0;
    n = words_find(text + at, between, 3) >= 0 ? words_length(text + at) : strspn(text + at, "/&");
    if (!at || !n)
        return 0;
    at += n + strspn(text + at + n, " \t");
    n = number_length(text + at, &pair->purl);
    return n ? at + n : 0;
}

/* `single`, `double`: the same. */
static size_t named_length(const char *text, struct pair *pair)
{
    static const char *const name[] = {"single", "double"};
    int which = words_find(text, name, 2);

    *pair = (struct pair){which + 1, which + 1};
    return which < 0 ? 0 : words_length(text);
}

static size_t any_pair_length(const char *text, struct pair *pair)
{
    size_t n = pair_length(text, pair);

    n = n ? n : numbers_length(text, pair);
    return n ? n : named_length(text, pair);
}

/* `last 2 sts, k2`: the repeat begins once more; its bytes. */
static size_t tail_length(const char *text, const struct pair *pair)
{
    int left, knit = 0;
    size_t at = words_is(text, "last") ? strlen("last") : 0, n;

    at += at ? strspn(text + at, " \t") : 0;
    if (!at)
        return 0;
    n = number_length(text + at, &left);
    left = n ? left : 1;
    at += n + strspn(text + at + n, " \t");
    at += words_are_stitches(text + at) ? words_length(text + at) : 0;
    at += strspn(text + at, " \t,;");
    n = stitches_length(text + at, "k", "knit", &knit);
    return n && knit == left && knit <= pair->knit ? at + n : 0;
}

/* `*k2, p2; rep from * to end`, `(k2, p2) around`: its bytes, the blanks behind it among them. */
static size_t row_length(const char *text, struct pair *pair)
{
    static const char *const repeat[] = {"from", "to", "the", "of", "across", "around"};
    size_t at = strspn(text, "*([ \t"), n = pair_length(text + at, pair);

    if (!n)
        return 0;
    for (at += n; n; at += n) {
        n = strspn(text + at, "*)],; \t");
        n = n ? n : words_are(text + at, WORDS_AGAIN | WORDS_END | WORDS_ROW | WORDS_EVERY) || words_find(text + at, repeat, sizeof repeat / sizeof *repeat) >= 0 ? words_length(text + at) : tail_length(text + at, pair);
    }
    return at;
}

/* `Rib:`, `K2, p2 rib pattern =`: its bytes. */
static size_t label_length(const char *text)
{
    static const char *const kind[] = {"pattern", "patt", "pat", "stitch", "st"};
    struct pair pair;
    size_t at = any_pair_length(text, &pair);

    at += strspn(text + at, " \t");
    if (!is_rib(text + at))
        return 0;
    at += words_length(text + at);
    at += strspn(text + at, " \t");
    at += words_find(text + at, kind, sizeof kind / sizeof *kind) >= 0 ? words_length(text + at) : 0;
    at += strspn(text + at, " \t");
    return strchr(":=", text[at]) && text[at] ? at + 1 : 0;
}

/* `Rib: *k2, p2; rep from * to end`: its bytes. */
static size_t description_length(const char *text, struct pair *pair)
{
    size_t label = label_length(text), row = label ? row_length(text + label, pair) : 0;

    return row ? label + row : 0;
}

/* The rib whose word stands at a place; false: its numbers are not said there. */
static bool rib_at(const char *text, size_t at, struct pair *pair)
{
    size_t label = at;

    for (size_t back = 1; back <= LONGEST_PAIR && back <= at; back++) {
        size_t n = back < at && isalnum((unsigned char)text[at - back - 1]) ? 0 : any_pair_length(text + at - back, pair);

        if (n && n + strspn(text + at - back + n, " \t)]*,") == back)
            return true;
    }
    while (label > 0 && at - label < LONGEST_LABEL && !words_ends_line(text[label - 1]))
        label--;
    label += strspn(text + label, " \t*-");
    return at - label < LONGEST_LABEL && description_length(text + label, pair) > 0;
}

void ribs_read(struct ribs *ribs, const char *text, size_t at)
{
    struct pair pair;

    for (; ribs->at < at && text[ribs->at]; ribs->at += words_length(text + ribs->at) ? words_length(text + ribs->at) : 1) {
        if (!is_rib(text + ribs->at) || !rib_at(text, ribs->at, &pair) || (ribs->n && pair.knit == ribs->knit && pair.purl == ribs->purl))
            continue;
        if (ribs->n++ == 0) {
            ribs->knit = pair.knit;
            ribs->purl = pair.purl;
        }
    }
}

/* Where a rib is worked that is only called so, last. */
static size_t last_mention(const char *text)
{
    size_t last = 0;

    for (size_t at = 0, n; text[at]; at += n ? n : 1) {
        n = words_length(text + at);
        if (is_rib(text + at) && (words_one_of("in|of|work|rows|rnds|rounds", text + words_before(text, at)) || words_one_of("for|until|till", words_next(text + at))))
            last = at;
    }
    return last;
}

bool ribs_describes(struct ribs *ribs, const char *text, size_t at)
{
    struct pair pair;
    size_t length = strchr("rRkK123456789sSdD", text[at]) ? description_length(text + at, &pair) : 0;

    if (!length || !prose_line_ends(text + at + length))
        return false;
    if (!ribs->looked)
        ribs->last = last_mention(text);
    ribs->looked = true;
    return ribs->last > at;
}

size_t ribs_length(const char *text, char plain[static RIBS_PLAIN])
{
    static const char *const until[] = {"for", "until", "till"};
    struct pair pair;
    size_t length = description_length(text, &pair), lead = is_rib(text) ? words_length(text) : 0;

    if (!length && lead) {
        lead += strspn(text + lead, " \t");
        length = numbers_length(text + lead, &pair);
        length += length ? lead : 0;
        length += length ? strspn(text + length, " \t") : 0;
    }
    if (!length || words_find(text + length, until, 3) < 0 || isalnum((unsigned char)text[length - 1]))
        return 0;
    snprintf(plain, RIBS_PLAIN, "k%d p%d rib", pair.knit, pair.purl);
    return strlen(plain) < length ? length : 0;
}

size_t ribs_pair(const char *text, int *knit, int *purl)
{
    struct pair pair;
    size_t n = any_pair_length(text, &pair);

    *knit = pair.knit;
    *purl = pair.purl;
    return n;
}
