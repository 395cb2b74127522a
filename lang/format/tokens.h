/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script as the scanner sees it, comments included: what the formatter walks
 * over beside the syntax tree, which knows neither comments nor line ends. */
#ifndef WEFT_TOKENS_H
#define WEFT_TOKENS_H

#include "lang/parse.h"
#include "lang/parser.h"

enum { TOKEN_COMMENT = -1 };

struct token {
    int         kind;       /* TOKEN_COMMENT, or the parser's; never TOKEN_NEWLINE */
    bool        first;      /* of a statement or a setting; not for comments */
    int         breaks;     /* line ends since the one before it */
    struct span span;       /* a comment's without blanks at its end */
    struct span label;      /* words before a statement on its line, `Body:`; no source: none */
    struct span tail;       /* words behind the last token of a statement; no source: none */
    bool        skipped;    /* words stand between it and the one before, in one statement */
};

struct tokens {
    int           n;
    struct token *at;       /* (n), the last is TOKEN_END */
};

/* Of a text that parse_statements took without an error. */
struct tokens tokens_read(const struct parse *);

/* The first token that begins at a byte or behind it. */
int tokens_find(const struct tokens *, unsigned start);

#endif
