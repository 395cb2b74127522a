/* SPDX-License-Identifier: GPL-3.0-or-later
 * Between the scanner, the parser and their caller: one text in, its syntax
 * tree out. */
#ifndef WEFT_PARSE_H
#define WEFT_PARSE_H

#include "lang/ast.h"
#include "lang/page/named.h"
#include "lang/names.h"
#include "lang/page/page_facts.h"
#include "lang/page/ribs.h"
#include "lang/page/words.h"

struct parse {
    struct arena        *arena;
    struct diag         *diag;
    struct names        *names;
    const struct source *source;
    const char          *text;          /* the source's, byte for byte, its blanks and turns of phrase put plainly */
    struct stmt         *file;          /* the result: statements, */
    struct expr         *expression;    /* or the value of an option */
    struct scanner      *scanner;
    const struct page_chart *chart;     /* a page's, whose lines are text; or NULL */
    struct named         named;         /* patterns it calls by a name, */
    struct ribs          ribs;          /* and ribs */
    struct page_facts    facts;
    struct words_line    line;          /* of the source that an error was in last */
    struct span          knitted;       /* a part of it without a word that cannot be knitted */
    bool                 too_deep;      /* an expression was: it is said once */
};

/* A text as it is read, nothing of it parsed yet; its `text` is NULL, with an error in diag, where it is no script. */
struct parse parse_read(struct arena *, struct diag *, struct names *, const struct source *);

/* Statements of a whole script; NULL also for one without any. Errors are in diag. */
struct stmt *parse_statements(struct parse *);

/* The expression at byte `start` of a text and to its end; never NULL. */
struct expr *parse_expression(struct arena *, struct diag *, struct names *, const struct source *, unsigned start);

/* Bytes of the blank a text begins with, a no-break or other space of a page among them; 0: none. */
size_t source_blank(const char *text);

/* Its first byte behind a byte order mark, which says nothing to us. */
unsigned source_start(const struct source *);

/* Words a statement can begin with, for "did you mean". */
extern const char *const statement_word[];
extern const int nstatement_words;

#endif
