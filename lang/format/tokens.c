/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text in, its tokens and comments out.  The scanner says where tokens are;
 * whatever lies between two of them is blanks, line ends, comments and the
 * words a row may do without. */
#include "lang/format/tokens.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/page_chart.h"
#include "lang/page/prose.h"
#include "lang/scanner.h"

struct reader {
    struct arena        *arena;
    const struct source *source;
    const char          *plain;     /* its text as it is read: a # there begins a comment */
    struct tokens        list;
    int                  room;
    unsigned             end;       /* of the token before */
    unsigned             line;      /* behind the line end before */
    bool                 first;     /* the next one begins a statement */
    bool                 opened;    /* the one before is a '{' */
};

static void add(struct reader *reader, struct token token)
{
    struct tokens *list = &reader->list;

    if (list->n == reader->room)
        list->at = arena_larger(reader->arena, list->at, &reader->room, sizeof *list->at);
    list->at[list->n++] = token;
}

/* A comment reaches from # to the end of its line; blanks there are no part of it. */
static unsigned comment_end(const char *text, unsigned start, unsigned end)
{
    unsigned at = start;

    while (at < end && text[at] != '\n' && text[at] != '\r')
        at++;
    while (at > start && strchr(" \t\f\v", text[at - 1]))
        at--;
    return at;
}

/* Adds the comments before `end`; returns the line ends behind the last of them. */
static int add_gap(struct reader *reader, unsigned end)
{
    const char *text = reader->source->text;
    int breaks = 0;

    for (unsigned at = reader->end; at < end; at++) {
        if (reader->plain[at] == '#') {
            struct span span = {reader->source, at, comment_end(text, at, end)};

            add(reader, (struct token){.kind = TOKEN_COMMENT, .breaks = breaks, .span = span});
            at = span.end - 1;
            breaks = 0;
        } else if (text[at] == '\n' || (text[at] == '\r' && text[at + 1] != '\n')) {
            breaks++;
        }
    }
    return breaks;
}

/* Behind the rest of a word, the first letter of which stood for a mark: `and` before `bind off`. */
static unsigned behind_word(const char *text, unsigned at, unsigned end)
{
    while (at > 0 && at < end && isalnum((unsigned char)text[at - 1]) && isalnum((unsigned char)text[at]))
        at++;
    return at;
}

/* The words the scanner read over in a part of a line, before a comment, without blanks and stops around them. */
static struct span words_in(const struct reader *reader, unsigned start, unsigned end)
{
    const char *text = reader->source->text;
    const char *comment = memchr(reader->plain + start, '#', end > start ? end - start : 0);
    bool letters = false;

    end = comment ? (unsigned)(comment - reader->plain) : end;
    while (end > start && isalnum((unsigned char)text[end - 1]) && isalnum((unsigned char)text[end]))  /* `Ro` of `Row1`, which is R1 */
        end--;
    while (start < end && strchr(" \t\f\v.;,", text[start]))
        start++;
    while (end > start && strchr(" \t\f\v.;,", text[end - 1]))
        end--;
    for (unsigned at = start; at < end; at++) {
        letters |= isalpha((unsigned char)text[at]);
        if (strchr("\r\n", text[at]))
            return (struct span){0};
    }
    return letters ? (struct span){reader->source, start, end} : (struct span){0};
}

static unsigned later(unsigned a, unsigned b)
{
    return a > b ? a : b;
}

/* Where a line of text begins, the marks of its page included: `**`, a bullet, a number. */
static unsigned with_marks(const struct reader *reader, unsigned start)
{
    const char *text = reader->source->text;
    unsigned at = later(reader->line, reader->end), first = start;

    for (size_t blank; at < start; at += blank ? (unsigned)blank : 1) {
        blank = source_blank(text + at);
        if (strchr("\r\n#;{}", text[at]))
            first = start;
        else if (!blank && first == start)
            first = at;
    }
    return behind_word(text, first, start);
}

/* Where what ends a line is behind: what follows on its line was read over with it. One that stands for a letter is
 * before the word. */
static unsigned line_within(const char *text, struct span span)
{
    const char *line = memchr(text + span.start, '\n', span.end - span.start);
    unsigned at = span.end;

    while (at > span.start && !strchr(line ? "\r\n" : "\r\n.;(", text[at - 1]))
        at--;
    while (at > 0 && isalnum((unsigned char)text[at - 1]) && isalnum((unsigned char)text[at]))
        at--;
    return at;
}

/* The end of a word whose plain spelling is shorter: blanks stand for the rest of it. */
static unsigned behind_spelling(const struct reader *reader, unsigned end)
{
    const char *text = reader->source->text;

    while (reader->plain[end] == ' ' && (isalnum((unsigned char)text[end]) || (unsigned char)text[end] >= 0x80))
        end++;
    return end;
}

/* A line's end is no token here: the one behind it says that it begins something. */
static void take(void *context, int kind, struct span span)
{
    struct reader *reader = context;
    struct token token;
    int breaks;

    if (kind == TOKEN_NEWLINE) {
        if (reader->list.n && !reader->first)
            reader->list.at[reader->list.n - 1].tail = words_in(reader, reader->end, span.start);
        reader->first = true;
        reader->line = line_within(reader->source->text, span);
        return;
    }
    if (kind == TOKEN_PROSE && reader->first)
        span.start = with_marks(reader, span.start);
    if (kind == TOKEN_PROSE)
        span.end = behind_spelling(reader, span.end);
    while (span.end > span.start && strchr(" \t\f\v", reader->source->text[span.end - 1]))
        span.end--;
    breaks = add_gap(reader, span.start);
    token = (struct token){.kind = kind, .first = reader->first, .breaks = breaks, .span = span};
    if (token.first || reader->opened)
        token.label = words_in(reader, behind_word(reader->source->text, later(reader->line, reader->end), span.start), span.start);
    else
        token.skipped = words_in(reader, reader->end, span.start).source != NULL;
    add(reader, token);
    reader->opened = kind == '{';
    reader->first = false;
    reader->end = span.end;
}

struct tokens tokens_read(const struct parse *parsed)
{
    struct diag diag;
    struct parse parse = *parsed;
    struct scanner scanner = {.parse = &parse, .at = source_start(parse.source), .start = TOKEN_START_FILE};
    struct reader reader = {.arena = parse.arena, .source = parse.source, .plain = parse.text, .end = scanner.at, .first = true};

    diag_init(&diag, parse.arena);
    parse.diag = &diag;
    parse.ribs = (struct ribs){0};
    parse.scanner = &scanner;
    scanner_tokens(&scanner, take, &reader);
    return reader.list;
}

int tokens_find(const struct tokens *tokens, unsigned start)
{
    int low = 0, high = tokens->n;

    while (low < high) {
        int middle = low + (high - low) / 2;

        if (tokens->at[middle].span.start < start)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
