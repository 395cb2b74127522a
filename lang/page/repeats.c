/* SPDX-License-Identifier: GPL-3.0-or-later
 * A statement's `repeat` in, the token it is out: of rows with their numbers, the last rows, or all. */
#include "lang/page/repeats.h"

#include "lang/page/prose.h"
#include "lang/scanner.h"
#include "lang/page/starred.h"
#include "lang/page/words.h"

size_t repeats_rows_length(const char *text)
{
    if ((*text | 0x20) == 'r' && isdigit((unsigned char)text[1]))
        return 1;
    return words_are_rows(text) ? words_length(text) : 0;
}

/* `1st`, `second`, before a blank or a comma: its bytes, or 0. */
static size_t ordinal_length(const char *text)
{
    size_t n = words_are(text, WORDS_NTH) ? words_length(text) : words_ordinal_length(text);

    return n && text[n] && strchr(" \t,", text[n]) ? n : 0;
}

/* Behind a word where a word of a list of further things to repeat may end; or NULL. */
static const char *behind_word(const char *text, const char *ends)
{
    const char *behind = text + words_length(text);

    return *behind && strchr(ends, *behind) ? behind : NULL;
}

/* `these rows`, `them`, `the pattern rows`, `all rows`: its bytes, or 0. */
static size_t them_length(const char *text)
{
    static const char *const lead[] = {"from", "the", "this"}, *const rows_word[] = {"them", "it", "these", "this"};
    const char *at = text, *rows = words_next(text), *behind = NULL;

    if ((words_is(text, "these") || words_is(text, "the")) && words_are_rows(rows))
        return (size_t)(rows + words_length(rows) - text);
    while (words_find(at, lead, 3) >= 0)
        at = words_next(at);
    if (words_is(at, "pattern")) {
        rows = words_next(at);
        behind = words_are_rows(rows) ? behind_word(rows, " \t.,") : NULL;
        behind = behind ? behind : behind_word(at, " \t.,");
    } else if (words_is(text, "all") && words_are_rows(rows)) {
        behind = behind_word(rows, " \t.,");
    } else if (words_find(text, rows_word, 4) >= 0) {
        behind = behind_word(text, words_is(text, "them") || words_is(text, "it") ? " \t.," : ".,");
    }
    return behind ? (size_t)(behind - text) : 0;
}

size_t repeats_everything_length(const char *text)
{
    return words_one_of("everything above|everything so far|everything|the whole thing|the whole piece|it all|all of it|all of this|all of that|all of the above|all of these rows|all the above", text);
}

/* `the last `, `these `: its bytes, or 0. */
static size_t last_length(const char *text)
{
    static const char *const word[] = {"the", "this", "these", "those", "last", "previous", "prev", "preceding"};
    const char *at = text;

    while (words_find(at, word, sizeof word / sizeof *word) >= 0 && words_next(at) > at + words_length(at))
        at = words_next(at);
    return (size_t)(at - text);
}

bool repeats_so_often(const char *text)
{
    const char *at = words_are(text, WORDS_OFTEN) ? words_next(text) : prose_times_follow(text) ? words_skip_blanks(words_behind_number(text)) : NULL;

    while (at && (words_are(at, WORDS_TIMES) || words_is(at, "more")))
        at = words_next(at);
    return at && (!*at || strchr(".,;\r\n", *at));
}

/* `Repeat the instructions between the stars`, `Repeat the following four rows:`: nothing that is worked here. */
static bool is_advice(const char *text)
{
    static const char *const word[] = {"instructions", "directions", "following"};

    return words_is(text, "the") && words_find(words_next(text), word, 3) >= 0 && !prose_says_how_often(text);
}

/* `sections A and B`: its bytes to the sentence's end, or 0. */
static size_t sections_length(const char *text)
{
    const char *section = words_is(text, "the") || words_is(text, "both") ? words_next(text) : text;

    if (!words_is(section, "section") && !words_is(section, "sections"))
        return 0;
    return words_next(section) > section + words_length(section) ? strcspn(text, "\r\n.;{}") : 0;
}

bool repeats_range(const char *text)
{
    static const char *const to[] = {"to", "through", "thru", "and"}, *const until[] = {"until", "till", "for", "as", "again"};
    const char *last = words_skip_blanks(text + strspn(text, "0123456789"));

    if (!isdigit((unsigned char)*text))
        return false;
    last = words_find(last, to, 4) >= 0 ? words_next(last) : words_skip_blanks(last + (*last == '-' || *last == '&'));
    if (!isdigit((unsigned char)*last) || last == text)
        return false;
    last = words_skip_blanks(last + strspn(last, "0123456789"));
    return !*last || strchr(".,\r\n", *last) || words_find(last, until, 5) >= 0 || words_are(last, WORDS_OFTEN) || prose_times_follow(last);
}

int repeats_kind(const char *text, size_t *length)
{
    const char *word = words_next(text), *rows = words_is(word, "from") ? words_next(word) : word;
    size_t before = (size_t)(word - text), n;
    struct starred starred;

    if ((n = repeats_rows_length(rows)) > 0) {
        *length = (size_t)(rows - text) + n;
        return TOKEN_REPEAT_ROWS;
    }
    if (repeats_range(word)) {
        *length = before;
        return TOKEN_REPEAT_ROWS;
    }
    if ((n = starred_length(word, &starred)) > 0) {
        *length = before + n;
        return TOKEN_REPEAT_STARRED;
    }
    *length = words_length(text);
    if (is_advice(word))
        return 0;
    if (repeats_so_often(word))
        return TOKEN_REPEAT_THEM;
    if ((n = ordinal_length(rows)) > 0)
        return prose_names_row(rows + n) ? TOKEN_REPEAT_ROWS : 0;
    if (words_is(word, "for"))
        return prose_rows_follow(words_next(word)) ? TOKEN_REPEAT_THEM : 0;
    if (words_is(word, "until") || words_is(word, "till"))
        return words_next(word) > word + words_length(word) ? TOKEN_REPEAT_THEM : 0;
    *length = before + (n = sections_length(word));
    if (n)
        return TOKEN_PROSE;
    *length = before + (n = repeats_everything_length(word));
    if (n)
        return TOKEN_REPEAT_ALL;
    *length = before + (n = them_length(word));
    if (n)
        return TOKEN_REPEAT_THEM;
    *length = before + (n = last_length(word));
    return n || (isdigit((unsigned char)*word) && prose_rows_follow(word)) ? TOKEN_REPEAT_LAST : 0;
}

size_t repeats_name_length(const char *text)
{
    static const char *const behind[] = {"for", "until", "till", "to", "then", "and"}, *const amount[] = {"inch", "inches", "in", "cm", "cms", "few", "several", "some", "many",
                                                                                                        "half", "about", "total", "number", "another", "long", "length"};
    const unsigned work = WORDS_ROW | WORDS_TIMES | WORDS_OFTEN | WORDS_EVERY | WORDS_NUMBER | WORDS_NTH | WORDS_AGAIN | WORDS_END | WORDS_PLAIN;
    size_t at = 0, end = 0, n;

    for (; text[at] && !strchr(".,;\r\n", text[at]) && words_find(text + at, behind, 6) < 0; at += n ? n : 1) {
        n = words_length(text + at);
        if (n ? words_are(text + at, work) || words_find(text + at, amount, sizeof amount / sizeof *amount) >= 0 : !strchr(" '-", text[at]))
            return 0;
        end = n ? at + n : end;
    }
    return end;
}
