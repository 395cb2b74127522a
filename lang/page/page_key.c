/* SPDX-License-Identifier: GPL-3.0-or-later
 * The lines of a page in; out, which signs of its chart are knit and which purl. */
#include "lang/page/page_key.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/words.h"

size_t page_key_character(const char *text)
{
    size_t n = 1;

    while (((unsigned char)text[n] & 0xC0) == 0x80)
        n++;
    return n;
}

const struct page_sign *page_key_find(const struct page_key *key, const char *text, size_t length)
{
    for (int i = 0; i < key->n; i++)
        if (key->sign[i].length == length && memcmp(key->sign[i].text, text, length) == 0)
            return &key->sign[i];
    return NULL;
}

/* ---- what a sign means ---- */

static const char *skip(const char *text, const char *const *word, int n)
{
    return words_find(text, word, n) < 0 ? text : words_next(text);
}

/* `RS`, `the wrong side rows`, `(WS)`: 1 or -1, and behind it; 0: no side. */
static int side_at(const char **text)
{
    static const char *const lead[] = {"on", "the", "in"}, *const rows[] = {"rows", "row", "rounds", "rnds"};
    const char *at = *text + (**text == '(');
    int side;

    for (int i = 0; i < 2; i++)
        at = skip(at, lead, 3);
    side = words_is(at, "rs") || words_is(at, "right") ? 1 : words_is(at, "ws") || words_is(at, "wrong") ? -1 : 0;
    if (!side)
        return 0;
    if (words_length(at) > 2) {
        at = words_next(at);
        at += *at == '-';
        if (!words_is(at, "side"))
            return 0;
    }
    at = skip(words_next(at), rows, 4);
    *text = words_skip_blanks(at + (*at == ')'));
    return side;
}

/* `RS: knit`, `k on RS`, `purl stitch`: the stitch as it shows from the right side, and behind it; -1: none. */
static int stitch_at(const char **text, bool *sided)
{
    static const char *const words[] = {"knit", "k", "knits", "purl", "p", "purls"};
    const char *at = *text;
    int side = side_at(&at), word;

    at = side ? words_skip_blanks(at + strspn(at, ":=,")) : at;
    word = words_find(at, words, 6);
    if (word < 0)
        return -1;
    at = words_next(at);
    at = words_are_stitches(at) ? words_next(at) : at;
    side = side ? side : side_at(&at);
    *sided |= side != 0;
    *text = at;
    return (word < 3) == (side >= 0) ? STITCH_K : STITCH_P;
}

/* `knit on RS, purl on WS`: what it is from the right side, and behind it; -1: no stitch, or not the same on both sides. */
static int meaning_at(const char **text, bool *sided)
{
    const char *at = *text, *behind;
    bool second = false;
    int stitch = stitch_at(&at, sided), other;

    if (stitch < 0)
        return -1;
    *text = at;
    behind = words_skip_blanks(at + strspn(at, ",;/&(+"));
    behind = words_is(behind, "and") ? words_skip_blanks(behind + 3) : behind;
    other = stitch_at(&behind, &second);
    if (other < 0 || !second)
        return stitch;
    *text = words_skip_blanks(behind + (*behind == ')'));
    return other == stitch ? stitch : -1;
}

/* ---- entries ---- */

/* Whether an entry may end here: at the line's end, a stop, a further entry's comma. */
static bool ends_entry(const char *text)
{
    return !*text || strchr(",;.|)\r\n", *text);
}

/* `. = purl`, `[-]: knit`, and of signs that are no letters `. purl`: its bytes; 0: none begins here. */
static size_t entry_length(const char *text, struct page_sign *sign)
{
    bool bracket = *text == '[' && text[1] != ']', sided = false, letter;
    const char *mark = text + bracket, *behind = mark + page_key_character(mark), *meaning;
    int stitch;

    letter = isalnum((unsigned char)*mark) != 0;
    if (strchr(" \t\r\n#{}\"'", *mark) || (letter && isalnum((unsigned char)*behind)) || (bracket && *behind != ']'))
        return 0;
    *sign = (struct page_sign){mark, (size_t)(behind - mark), STITCH_K, false};
    meaning = words_skip_blanks(behind + bracket);
    if (*meaning == '=' || (*meaning == ':' && !isdigit((unsigned char)*mark)))
        meaning = words_skip_blanks(meaning + 1);
    else if (letter || bracket || meaning == behind)
        return 0;
    stitch = meaning_at(&meaning, &sided);
    if (stitch < 0 || !ends_entry(meaning) || (strchr("kKpP", *mark) && !sided))
        return 0;
    sign->stitch = (stitch_id)stitch;
    return (size_t)(meaning - text);
}

static void add_sign(struct page_key *key, struct page_sign sign)
{
    if (key->n == PAGE_SIGNS || page_key_find(key, sign.text, sign.length))
        return;
    key->figures |= isdigit((unsigned char)*sign.text) != 0;
    key->sign[key->n++] = sign;
}

static void read_line(struct page_key *key, const char *line)
{
    size_t n = words_line_length(line);

    for (size_t at = 0, length; at < n && n <= WORDS_LINE; at += length ? length : 1) {
        struct page_sign sign;
        bool begins = at == 0 || strchr(" \t,;:(", line[at - 1]);

        length = begins ? entry_length(line + at, &sign) : 0;
        if (length)
            add_sign(key, sign);
    }
}

void page_key_read(struct page_key *key, const struct source *source)
{
    static const struct page_sign plain[] = {{"K", 1, STITCH_K, true}, {"P", 1, STITCH_P, true}, {"k", 1, STITCH_K, true}, {"p", 1, STITCH_P, true}};
    int depth = 0;

    for (const char *line = source->text; line < source->text + source->size; line += strspn(line, "\r\n")) {
        size_t n = words_line_length(line);

        if (depth == 0 && line[strspn(line, " \t")] != '#' && !memchr(line, '{', n))
            read_line(key, line);
        depth = words_depth(line, n, depth);
        line += n;
        line += !*line && line < source->text + source->size;
    }
    for (int i = 0; i < 4; i++)
        add_sign(key, plain[i]);
}

/* The words before a key on its line: `Key: `, `Chart of both sides (`; 0: others. */
static size_t heading_length(const char *text, const char *end)
{
    static const char *const heading[] = {"chart", "key", "legend", "symbols", "symbol"};
    struct page_sign sign;
    size_t n = words_find(text, heading, 5) < 0 ? 0 : words_length(text);

    while (n > 0 && text + n < end && (isalpha((unsigned char)text[n]) || strchr(" -:(", text[n]))) {
        n += words_length(text + n) ? words_length(text + n) : 1;
        if (strchr(" :(", text[n - 1]) && entry_length(text + n, &sign))
            return n;
    }
    return 0;
}

bool page_key_is_line(const struct page_key *key, struct span line)
{
    const char *text = line.source->text + line.start, *end = line.source->text + line.end;
    int n = 0;

    text += strspn(text, " \t");
    text += heading_length(text, end);
    for (size_t length; text < end && line.end - line.start <= WORDS_LINE; text += strspn(text, " \t,;.|):"), n++) {
        struct page_sign sign;

        length = entry_length(text, &sign);
        if (!length && n == 0 && strchr("-*(", *text) && strchr(" ", text[1]))
            length = strspn(text, "-* (");
        else if (!length || !page_key_find(key, sign.text, sign.length))
            return false;
        text += length;
    }
    return n > 0;
}
