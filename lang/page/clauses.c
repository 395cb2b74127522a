/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sign or a clause in, what parts it from the work that follows it out. */
#include "lang/page/clauses.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* `Bind off`, all stitches. */
static bool is_bind_off(const char *text)
{
    return (words_one_of("bo", text) || (words_one_of("bind|cast", text) && words_is(words_next(text), "off"))) && !prose_casts_some(text);
}

/* `Knit 2 rows`, `repeat rows 1-4`, `bind off`: what is no part of a row. */
static bool is_work(const char *text)
{
    const char *behind = words_next(text);

    if (words_are(text, WORDS_AGAIN))
        return prose_repeats_rows(behind);
    if (words_are(text, WORDS_PLAIN | WORDS_WORK))
        return prose_rows_follow(words_skip_any(behind, "the|last|another|more"));
    return is_bind_off(text);
}

/* `2 rows seed stitch`, `garter st for 2 rows`: rows of a fabric, which follow others. */
static bool is_rows_of_fabric(const char *text)
{
    const char *rows = prose_rows_follow(text) ? words_behind_number(text) : NULL, *fabric = words_skip_any(text, "garter|seed|moss|stockinette|stocking|reverse|rev|g|st|stitch");

    if (rows)
        return prose_fabric_follows(words_skip_any(rows + words_length(rows), "of|in"));
    return fabric > text && words_is(fabric, "for") && prose_rows_follow(words_next(fabric));
}

/* Where the sentence, or the line, of a place begins. */
static size_t sentence_start(const char *text, size_t at)
{
    size_t reach = at > WORDS_REACH ? at - WORDS_REACH : 0;

    while (at > reach && !strchr(".;:!\r\n", text[at - 1]))
        at--;
    return at;
}

/* Whether one of the words stands before a place of a sentence. */
static bool sentence_has(const char *text, size_t at, const char *list)
{
    for (size_t word = sentence_start(text, at); word < at; word += words_length(text + word) ? words_length(text + word) : 1)
        if (words_one_of(list, text + word))
            return true;
    return false;
}

/* Whether it says how long rows are worked. */
static bool says_length(const char *text, size_t at)
{
    return sentence_has(text, at, "until|till|desired length|required length|length desired|length you");
}

/* `as many times as you like`. */
static size_t often_length(const char *text)
{
    size_t n = words_one_of("as many times as|as often as|as many as", text);
    const char *end = words_skip_any(text + n, "you|is|are|like|want|wish|need|please|desire|needed|desired|required|necessary|wanted|to|for|get|reach|it|the|your|length|long|enough|size");

    while (n && end[-1] == ' ')
        end--;
    return n && (prose_line_ends(end) || strchr(".,;", *end) || words_one_of("and|then", words_skip_blanks(end))) ? (size_t)(end - text) : 0;
}

/* `When the scarf is long enough, `, `For the top border: ` before work; no numbers, and nothing that is worked. */
static size_t when_length(const char *text, size_t at)
{
    size_t end = at;

    if (!words_one_of("when|once|as soon as|after|for|make|now for|as for", text + at) || !strchr("\r\n.;!", words_sign_before(text, at, " \t")))
        return 0;
    for (size_t n; text[end] && !strchr(",.;:(\r\n", text[end]); end += n ? n : 1) {
        n = words_length(text + end);
        if (words_are(text + end, WORDS_NUMBER | WORDS_PLAIN | WORDS_ROW | WORDS_EVERY | WORDS_SIDE) || isdigit((unsigned char)text[end]) || end - at > WORDS_REACH)
            return 0;
    }
    return (text[end] == ',' || text[end] == ':') && is_work(words_skip_any(text + end + 1, "and|then|you|can|may|just|now")) ? end + 1 - at : 0;
}

size_t clauses_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    bool word = isalpha((unsigned char)text[at]);
    const char *next = words_skip_any(text + at + !word, "and|then|now");

    if ((word || text[at] == ',') && is_rows_of_fabric(next) && sentence_has(text, at, "rows|row|rounds|rnds|ridges")) {
        strcpy(plain, ";");
        return next > text + at ? (size_t)(next - text) - at : 0;
    }
    if (word && next > text + at) {
        strcpy(plain, ";");
        return is_work(next) && says_length(text, at) ? (size_t)(next - text) - at : 0;
    }
    switch (text[at]) {
    case ',':
        strcpy(plain, ";");
        return (is_work(next) && says_length(text, at)) || (is_bind_off(next) && sentence_has(text, at, "rows|rounds|ridges")) ? (size_t)(next - text) - at : 0;
    case ')':
        strcpy(plain, ");");
        return text[at + 1] == ' ' && isupper((unsigned char)text[at + 2]) && is_work(next) && sentence_has(text, at, "(") ? 2 : 0;
    case '!':
        strcpy(plain, ".");
        return at > 0 && isalpha((unsigned char)text[at - 1]) && (prose_line_ends(text + at + 1) || (text[at + 1] == ' ' && isupper((unsigned char)*next))) ? 1 : 0;
    default:
        strcpy(plain, often_length(text + at) ? "to desired length" : "");
        return *plain ? often_length(text + at) : when_length(text, at);
    }
}
