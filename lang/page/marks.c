/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same out in plain characters, as many bytes: what has no
 * meaning in a pattern is blank. */
#include "lang/page/marks.h"

#include <stdio.h>
#include <string.h>

#include "lang/page/words.h"

/* ---- characters ---- */

enum mark { MARK_NONE, MARK_BLANK, MARK_SHAPE, MARK_ARROW, MARK_GONE, MARK_WIDE, MARK_HEAVY, MARK_FIGURE, MARK_CIRCLED };

/* Which characters are what; between them all others stay. */
static const struct range {
    unsigned first, last;
    enum mark mark;
} ranges[] = {
    {0xA9, 0xA9, MARK_BLANK},           /* of rights and trades */
    {0xAE, 0xAE, MARK_BLANK},
    {0xAD, 0xAD, MARK_GONE},            /* a hyphen that is not seen */
    {0x200C, 0x200F, MARK_GONE},        /* joiners, marks of direction */
    {0x2122, 0x2122, MARK_BLANK},
    {0x2190, 0x21FF, MARK_ARROW},
    {0x2460, 0x2473, MARK_CIRCLED},     /* 1 to 20 in circles */
    {0x25A0, 0x25FF, MARK_SHAPE},       /* squares, triangles, circles */
    {0x2600, 0x2714, MARK_BLANK},       /* pictures: weather, hands, stars, ticks */
    {0x2717, 0x2730, MARK_BLANK},
    {0x2732, 0x2793, MARK_BLANK},
    {0x2794, 0x27A3, MARK_ARROW},
    {0x27A5, 0x27BF, MARK_ARROW},
    {0x2B00, 0x2B11, MARK_ARROW},
    {0x2B12, 0x2BFF, MARK_SHAPE},
    {0x3010, 0x3011, MARK_BLANK},       /* brackets around a title */
    {0xFE0E, 0xFE0F, MARK_GONE},        /* how a picture is drawn */
    {0xFF01, 0xFF5E, MARK_WIDE},
    {0x1D400, 0x1D6A3, MARK_HEAVY},     /* thirteen alphabets of letters, bold, slanted .. */
    {0x1D7CE, 0x1D7FF, MARK_FIGURE},    /* and five of figures */
    {0x1F000, 0x1FAFF, MARK_BLANK},     /* more pictures */
};

/* Single characters, and what is written for them. */
static const struct letter {
    unsigned code;
    const char *plain;
} letters[] = {
    {0x20E3, "."},  /* the frame of a key: behind a figure */
    {0x2500, "---"}, {0x2501, "---"}, {0x2550, "---"}, {0x2502, "|"}, {0x2503, "|"}, {0x2551, "|"},
    {0x2715, "\xC3\x97"}, {0x2716, "\xC3\x97"}, {0x2A2F, "\xC3\x97"}, {0x2E3A, "---"}, {0x2E3B, "---"},
    {0x3001, ","}, {0x3002, "."},
    {0xFB00, "ff"}, {0xFB01, "fi"}, {0xFB02, "fl"}, {0xFB03, "ffi"}, {0xFB04, "ffl"}, {0xFB05, "st"}, {0xFB06, "st"},
};

/* The bytes of the character that begins here; one that is none is a byte. */
static size_t decode(const char *text, unsigned *code)
{
    const unsigned char *byte = (const unsigned char *)text;
    size_t n = *byte >= 0xF0 ? 4 : *byte >= 0xE0 ? 3 : *byte >= 0xC2 ? 2 : 1;

    *code = n == 1 ? *byte : *byte & (0x7F >> n);
    for (size_t i = 1; i < n; i++) {
        if ((byte[i] & 0xC0) != 0x80)
            return *code = *byte, 1;
        *code = *code << 6 | (byte[i] & 0x3F);
    }
    return n;
}

static enum mark mark_of(unsigned code)
{
    for (size_t i = 0; code >= 0xA9 && i < sizeof ranges / sizeof *ranges; i++)
        if (code >= ranges[i].first && code <= ranges[i].last)
            return ranges[i].mark;
    return MARK_NONE;
}

/* What is written for a character that is a letter, a figure or a sign of its own; 0: it is none of them. */
static size_t plain_letters(unsigned code, char plain[static 4])
{
    static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

    for (size_t i = 0; code >= 0x2000 && i < sizeof letters / sizeof *letters; i++)
        if (code == letters[i].code)
            return strlen(strcpy(plain, letters[i].plain));
    switch (mark_of(code)) {
    case MARK_WIDE:
        return (size_t)snprintf(plain, 4, "%c", (char)(code - 0xFF01 + '!'));
    case MARK_HEAVY:
        return (size_t)snprintf(plain, 4, "%c", alphabet[(code - 0x1D400) % 52]);
    case MARK_FIGURE:
        return (size_t)snprintf(plain, 4, "%u", (code - 0x1D7CE) % 10);
    case MARK_CIRCLED:
        return (size_t)snprintf(plain, 4, "%u.", code - 0x2460 + 1);
    default:
        return 0;
    }
}

/* A shape alone is an ornament; beside others it is a stitch of a chart, which stays. */
static bool is_alone(const char *text, size_t at, size_t length)
{
    unsigned code;

    decode(text + at + length, &code);
    if (mark_of(code) == MARK_SHAPE)
        return false;
    for (length = 1; length < 4 && length <= at && ((unsigned char)text[at - length] & 0xC0) == 0x80;)
        length++;
    if (length > at)
        return true;
    decode(text + at - length, &code);
    return mark_of(code) != MARK_SHAPE;
}

/* An arrow between numbers or before a count is a dash; in brackets it is the side a row is worked on. */
static size_t plain_arrow(const char *text, size_t at, size_t length, unsigned code, char plain[static 8])
{
    const char *behind = text + at + length, *number = words_skip_blanks(behind);
    char before = at > 0 ? text[at - 1] : ' ', last = at > 1 && before == ' ' ? text[at - 2] : before;

    if ((before == '(' || before == '[') && *behind == (before == '(' ? ')' : ']') && length == 3 && (code == 0x2190 || code == 0x2192))
        return (size_t)snprintf(plain, 8, "%s", code == 0x2190 ? "RS" : "WS");
    if (isdigit((unsigned char)*number) && (isdigit((unsigned char)last) || words_are_stitches(words_skip_blanks(number + strspn(number, "0123456789")))))
        return (size_t)snprintf(plain, 8, "-");
    return 0;
}

/* One text that is being written, the same or shorter by `at - to` in this word. */
struct page {
    const char *text;
    char *own;
    size_t size, at, to;
};

static void write_bytes(struct page *page, const char *bytes, size_t n)
{
    memmove(page->own + page->to, bytes, n);
    page->to += n;
}

/* Blanks up to behind what was read. */
static void write_blanks(struct page *page, size_t length)
{
    memset(page->own + page->to, ' ', page->at + length - page->to);
    page->to = page->at + length;
}

/* Whether a row is repeated from this character, `♦ k2, p2, rep from ♦`, on its line or the next. */
static bool is_repeated_from(const char *text, size_t at, size_t length, unsigned code)
{
    size_t reach = at > WORDS_REACH ? at - WORDS_REACH : 0, from = at, lines = 0;

    if (code < 0x2020 || (code >= 0x2032 && code <= 0x2044))   /* primes, fractions */
        return false;
    while (from > reach && !words_ends_line(text[from - 1]))
        from--;
    for (; text[from] && from < at + WORDS_REACH && lines < 2; from++) {
        lines += text[from] == '\n';
        if ((text[from] | 0x20) == 'f' && words_is(text + from, "from") && strncmp(words_next(text + from), text + at, length) == 0)
            return true;
    }
    return false;
}

/* One character in braces as it is, else plainly. */
static void write_character(struct page *page, size_t length, unsigned code, bool braces)
{
    char plain[8];
    enum mark mark = braces ? MARK_NONE : mark_of(code);
    size_t n = braces ? 0 : plain_letters(code, plain);

    if (!braces && is_repeated_from(page->text, page->at, length, code))
        n = (size_t)snprintf(plain, sizeof plain, "*");
    if (mark == MARK_ARROW)
        n = plain_arrow(page->text, page->at, length, code, plain);
    if (n)
        write_bytes(page, plain, n);
    else if (mark == MARK_BLANK || mark == MARK_ARROW || (mark == MARK_SHAPE && is_alone(page->text, page->at, length)))
        write_blanks(page, length);
    else if (mark != MARK_GONE)
        write_bytes(page, page->text + page->at, length);
}

/* Puts plain characters; the bytes that are saved are blank behind the word. */
static void put_characters(struct page *page)
{
    size_t length;
    unsigned code;
    int depth = 0;

    for (page->at = page->to = 0; page->at < page->size; page->at += length) {
        length = decode(page->text + page->at, &code);
        depth += code == '{' ? 1 : code == '}' && depth > 0 ? -1 : 0;
        if (code == '"') {
            length = words_skip_quoted(page->text, page->at) - page->at;
            write_bytes(page, page->text + page->at, length);
            continue;
        }
        if (code < 0x80 && strchr(" \t\r\n\f\v.,;:!?", (int)code))
            write_blanks(page, 0);
        write_character(page, length, code, depth > 0);
    }
    write_blanks(page, 0);
}

static bool has_characters(const char *text, size_t size)
{
    for (size_t i = 0; i < size; i++)
        if ((unsigned char)text[i] >= 0xC2)
            return true;
    return false;
}

/* ---- lines ---- */

/* Whether a word ends here that has a dash before the next: `stocking-stitch`. */
static bool is_compound(const char *text, size_t at)
{
    static const char *const words[] = {"stocking", "garter", "seed", "moss", "right", "wrong", "set", "cast", "knit", "purl", "double", "single", "reverse", "wise"};
    size_t from = at;

    while (from > 0 && isalpha((unsigned char)text[from - 1]))
        from--;
    return words_find(text + from, words, sizeof words / sizeof *words) >= 0;
}

/* Joins `re-` and `peat`, parted at a line's end: the rest of the word moves up, blanks stand for the end. */
static void join_word(char *text, size_t at)
{
    size_t rest = at + 1 + (text[at + 1] == '\r'), n;

    /* `Rows 3-` and `4:`. */
    if (at > 0 && isdigit((unsigned char)text[at - 1]) && text[rest] == '\n' && isdigit((unsigned char)text[rest + 1]))
        memset(text + at + 1, ' ', rest - at);
    if (at < 2 || !isalpha((unsigned char)text[at - 1]) || !isalpha((unsigned char)text[at - 2]) || text[rest] != '\n' || !islower((unsigned char)text[rest + 1]))
        return;
    if (is_compound(text, at)) {
        memset(text + at + 1, ' ', rest - at);
        return;
    }
    n = words_length(text + ++rest);
    memmove(text + at, text + rest, n);
    memset(text + at + n, ' ', rest - at);
}

/* ---- Markdown and HTML ---- */

/* Whether nothing but blanks, marks and numbers of a list stand before, on the line. */
static bool begins_item(const char *text, size_t at)
{
    size_t margin = at > WORDS_MARGIN ? at - WORDS_MARGIN : 0;

    while (at > margin && strchr(" \t-*+>.)0123456789", text[at - 1]))
        at--;
    return at == 0 || words_ends_line(text[at - 1]);
}

/* How long `~~k2, p2~~` is, which was struck out; or 0. */
static size_t struck_length(const char *text)
{
    size_t end = 2 + strcspn(text + 2, "~\r\n");

    return strncmp(text, "~~", 2) == 0 && end > 2 && text[end] == '~' && text[end + 1] == '~' ? end + 2 : 0;
}

/* How long `[ ]`, `[x]` is before an item of a list; or 0. */
static size_t box_length(const char *text, size_t at)
{
    return strchr(" xX", text[at + 1]) && text[at + 1] && text[at + 2] == ']' && text[at + 3] == ' ' && begins_item(text, at) ? 3 : 0;
}

/* How long `<b>`, `</p>`, `<br />` is; or 0. `line`: it ends a line; `cell`: a cell of a table. */
static size_t tag_length(const char *text, bool *line, bool *cell)
{
    static const char *const names[] = {"br", "p", "div", "li", "tr", "ul", "ol", "h", "table", "tbody", "thead", "blockquote", "hr", "td", "th",
                                        "b", "i", "u", "a", "em", "strong", "small", "span", "sup", "sub", "code", "pre", "font", "center", "section"};
    const char *name = text + 1 + (text[1] == '/');
    int which = words_find(name, names, sizeof names / sizeof *names);
    size_t length = strspn(text + 1, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 =\"'/:;.,_#%-") + 1;

    *line = which >= 0 && which < 13;
    *cell = which == 13 || which == 14;
    name += words_length(name);
    name += strspn(name, "123456");
    return which >= 0 && text[length] == '>' && strchr(" />", *name) && *name ? length + 1 : 0;
}

bool marks_are_tag(const char *text)
{
    bool line, cell;

    return *text == '<' && tag_length(text, &line, &cell) > 0;
}

/* Whether letters of emphasis may begin here: no stitches, which stars may repeat. */
static bool is_emphasised(const char *text, size_t n, size_t marks)
{
    static const char *const rows[] = {"row", "rows", "round", "rounds", "rnd", "rnds", "rs", "ws", "r", "next", "all", "every", "even", "odd",
                                       "set", "setup", "repeat", "rep", "cast", "co", "bind", "bo", "for", "work", "multiple"},
                             *const stitches[] = {"k", "p"};
    size_t from = n;

    while (from > 0 && isalpha((unsigned char)text[from - 1]))
        from--;
    if (!n || isspace((unsigned char)*text) || isspace((unsigned char)text[n - 1]) || words_is(text + from, "from"))
        return false;
    return marks == 2 ? isalnum((unsigned char)*text) && words_find(text, stitches, 2) < 0 && !memchr(text, ',', n) : words_find(text, rows, sizeof rows / sizeof *rows) >= 0;
}

/* How long `Row 1:` is in `**Row 1:**`, `*Row 1:*`, `_Row 1:_`: letters of emphasis; or 0. */
static size_t emphasis_length(const char *text, size_t at, size_t marks)
{
    const char close[] = {text[at], '\r', '\n', '\0'};
    size_t n = strcspn(text + at + marks, close);
    char before = at > 0 ? text[at - 1] : ' ', behind = text[at + marks + n] ? text[at + marks + n + marks] : ' ';

    if (text[at] == '_' && (isalnum((unsigned char)before) || isalnum((unsigned char)behind) || !isalpha((unsigned char)text[at + 1])))
        return 0;
    if (text[at] == '_')
        return text[at + 1 + n] == '_' && !isspace((unsigned char)text[at + n]) ? n : 0;
    if (text[at + marks + n] != '*' || (marks == 2) != (text[at + marks + n + 1] == '*') || (!isdigit((unsigned char)text[at + marks]) && (marks == 1) != begins_item(text, at)))
        return 0;
    return is_emphasised(text + at + marks, n, marks) ? n : 0;
}

/* Puts blanks for marks of emphasis. */
static void put_emphasis(char *text, size_t at)
{
    size_t marks = text[at] == '*' && text[at + 1] == '*' ? 2 : 1, n = emphasis_length(text, at, marks);

    if (!n)
        return;
    memset(text + at, ' ', marks);
    memset(text + at + marks + n, ' ', marks);
}

/* A line end before the row of `purl 4Row 3: knit`. */
static void put_line_end(char *text, size_t at)
{
    size_t n = words_length(text + at), number = at + n + (text[at + n] == ' '), digits = strspn(text + number, "0123456789");

    if (at == 0 || !(islower((unsigned char)text[at - 1]) || isdigit((unsigned char)text[at - 1]) || text[at - 1] == ')') || !digits || text[number + digits] != ':')
        return;
    if (strncmp(text + at, "Row", n) == 0 && n == 3)
        memcpy(text + at, "\nR ", 3);
    else if (strncmp(text + at, "Round", n) == 0 && n == 5)
        memcpy(text + at, "\nRnd ", 5);
}

/* Puts a blank for a backslash, a line end or a bar for a tag that stands for one. */
static void put_mark(char *text, size_t at)
{
    bool line = false, cell = false;
    size_t length = 0;

    switch (text[at]) {
    case '-':
        join_word(text, at);
        break;
    case 'R':
        put_line_end(text, at);
        break;
    case '`':
        length = 1;
        break;
    case '\\':
        length = ispunct((unsigned char)text[at + 1]) || !text[at + 1] || strchr("\r\n", text[at + 1]);
        break;
    case '~':
        length = struck_length(text + at);
        break;
    case '[':
        length = box_length(text, at);
        break;
    case '<':
        length = tag_length(text + at, &line, &cell);
        break;
    case '*':
    case '_':
        put_emphasis(text, at);
    }
    memset(text + at, ' ', length);
    if (length && (line || cell))
        text[at] = line ? '\n' : '|';
}

static const char marks[] = "-R`\\~[<*_\"{}";

/* Whether a quote stands for the star of `rep from" to end`. */
static bool is_star(const char *text, size_t at)
{
    size_t end = at, word;

    while (end > 0 && text[end - 1] == ' ')
        end--;
    for (word = end; word > 0 && isalpha((unsigned char)text[word - 1]);)
        word--;
    return end - word == 4 && strncasecmp(text + word, "from", 4) == 0 && text[at + 1] && strchr(" ,;.\r\n", text[at + 1]) && word > 4 &&
           (strncasecmp(text + word - 4, "rep ", 4) == 0 || strncasecmp(text + word - 4, "eat ", 4) == 0);
}

static void put_marks(char *text, size_t size)
{
    struct words_line line = {0};
    int depth = 0;

    for (size_t at = 0; (at += strcspn(text + at, marks)) < size; at++) {
        if (words_line_is_long(&line, text, at)) {
            depth = words_depth(text + at, line.end - at, depth);
            at = line.end;
            continue;
        }
        depth += text[at] == '{' ? 1 : text[at] == '}' && depth > 0 ? -1 : 0;
        if (text[at] == '"' && is_star(text, at))
            text[at] = '*';
        else if (text[at] == '"')
            at = words_skip_quoted(text, at) - 1;
        else if (depth == 0)
            put_mark(text, at);
    }
}

const char *marks_plain(struct arena *arena, const char *text, size_t size)
{
    struct page page = {.text = text, .size = size};
    bool characters = has_characters(text, size);

    if (!characters && strcspn(text, marks) == size)
        return text;
    page.own = arena_copy(arena, text, size);
    if (characters)
        put_characters(&page);
    put_marks(page.own, size);
    return page.own;
}
