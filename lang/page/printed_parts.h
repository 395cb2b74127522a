/* SPDX-License-Identifier: GPL-3.0-or-later
 * Parts of a printed book's lines, for the files behind printed.h alone. */
#ifndef WEFT_PRINTED_PARTS_H
#define WEFT_PRINTED_PARTS_H

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "lang/page/printed.h"
#include "lang/page/words.h"

enum { LOOK_BACK = 500 };

static inline bool print_begins_word(const char *text, size_t at)
{
    return at == 0 || !isalnum((unsigned char)text[at - 1]);
}

static inline size_t print_blanks(const char *text)
{
    return strspn(text, " \t");
}

/* Where the line begins, or so far before `at` as is looked back. */
static inline size_t print_line_within(const char *text, size_t at, size_t most)
{
    size_t line = at;

    while (line > 0 && at - line < most && text[line - 1] != '\n' && text[line - 1] != '\r')
        line--;
    return line;
}

static inline size_t print_line_start(const char *text, size_t at)
{
    return print_line_within(text, at, LOOK_BACK);
}

/* Where the word begins that ends before `at`, blanks and a full stop aside. */
static inline size_t print_word_before(const char *text, size_t at)
{
    size_t margin = at > WORDS_MARGIN ? at - WORDS_MARGIN : 0;

    while (at > margin && (text[at - 1] == ' ' || text[at - 1] == '\t' || text[at - 1] == '.'))
        at--;
    while (at > 0 && isalpha((unsigned char)text[at - 1]))
        at--;
    return at;
}

/* A long dash, or two hyphens or more: its bytes. */
static inline size_t print_dash_length(const char *text)
{
    size_t hyphens = strspn(text, "-");

    if (hyphens > 1)
        return hyphens;
    return strncmp(text, "\xE2\x80\x93", 3) == 0 || strncmp(text, "\xE2\x80\x94", 3) == 0 || strncmp(text, "\xE2\x80\x95", 3) == 0 ? 3 : 0;
}

static inline bool print_sentence_ends(const char *text)
{
    text += print_blanks(text);
    return !*text || strchr(".;,\r\n", *text);
}

/* ---- printed_heads.c ---- */

/* `first`, `Twenty-second`: its bytes, and the number; 0: no ordinal in letters. */
size_t print_letters_length(const char *text, int *number);

/* The same of `3rd`, too. */
size_t print_ordinal_length(const char *text, int *number);

/* `6th, 7th, and 8th rows`: its bytes. */
size_t print_rows_length(const char *text);

/* Whether a row's head ends here: a colon, a full stop, a dash, a side in brackets. */
bool print_head_ends(const char *text);

/* A row's text at `at` that is told by others, `The same.`, `Work as in the 1st row`, or is `Plain.`: its bytes. */
size_t print_told_length(const char *text, size_t at, char plain[static PRINTED_PLAIN]);

/* ---- printed_words.c ---- */

/* A turn of phrase of books that begins with the word at `at`: its bytes. */
size_t print_word_length(const char *text, size_t at, char plain[static PRINTED_PLAIN]);

/* `(Swatch: ` before a cast-on, on the line of a multiple: a line of its own begins. */
size_t print_sample_length(const char *text, size_t at);

/* Whether a cast-on of so many follows: ` Cast on 25 sts.` */
bool print_cast_on_follows(const char *text);

#endif
