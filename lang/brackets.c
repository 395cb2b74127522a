/* SPDX-License-Identifier: GPL-3.0-or-later
 * A bracket in, what it opens or closes where it stands out. */
#include "lang/scanner.h"

#include <string.h>

static bool is_in_line(enum bracket kind)
{
    return kind == BRACKET_ROUND || kind == BRACKET_SQUARE || kind == BRACKET_HOLE;
}

/* What a brace opens follows from the statement it stands in. */
static enum bracket brace_of(const struct scanner *scanner, bool in_expression)
{
    bool number = scanner->previous == TOKEN_MULTIPLE_OF || (!in_expression && scanner->previous == '+');

    switch (scanner->statement) {
    case TOKEN_MOTIF:
        return number ? BRACKET_HOLE : BRACKET_STATEMENTS;
    case TOKEN_FOR:
    case TOKEN_IF:
    case TOKEN_ELSE:
        return BRACKET_STATEMENTS;
    case TOKEN_CHART:
        return BRACKET_CHART;
    case TOKEN_ROW:
    case TOKEN_ALL:
    case TOKEN_SETUP:
    case TOKEN_AS_ROW:
    case TOKEN_PLAIN_ROWS:
    case TOKEN_WORK:
    case TOKEN_WORK_ROWS:
    case TOKEN_CAST_ON:
    case TOKEN_MULTIPLE_OF:
    case TOKEN_REPEAT_ROWS:
    case TOKEN_REPEAT_LAST:
    case TOKEN_REPEAT_THEM:
    case TOKEN_REPEAT_ALL:
    case TOKEN_REPEAT_STARRED:
    case TOKEN_GO_ON_ROWS:
        return BRACKET_HOLE;
    default:
        return BRACKET_SETTINGS;
    }
}

enum bracket scanner_open(struct scanner *scanner, struct span span, char c, int state, bool in_expression)
{
    enum bracket kind = c == '('   ? BRACKET_ROUND
                        : c == '[' ? BRACKET_SQUARE
                                   : brace_of(scanner, in_expression);

    /* Its other half was looked for. */
    if (c == '(' && !in_expression)
        scanner_looks(scanner, strcspn(SCANNER_TEXT(scanner), ")\r\n"));
    if (scanner->nopen == LIMIT_NESTING) {
        if (!scanner->quiet)
            diag_error(scanner->parse->diag, CODE_LIMIT_NESTING, span,
                       "brackets are nested more than %d deep", LIMIT_NESTING);
        scanner->quiet = true;
        return BRACKET_TOO_DEEP;
    }
    scanner->open[scanner->nopen++] = (struct open){kind, state, span};
    return kind;
}

int scanner_close(struct scanner *scanner, char c)
{
    /* A brace also closes what is still open inside it. */
    if (c == '}')
        while (scanner->nopen && scanner->open[scanner->nopen - 1].kind <= BRACKET_SQUARE)
            scanner->nopen--;
    if (!scanner->nopen || (c != '}' && scanner->open[scanner->nopen - 1].kind > BRACKET_SQUARE))
        return -1;
    scanner->nopen--;
    scanner->hole = scanner->open[scanner->nopen].kind == BRACKET_HOLE;
    return is_in_line(scanner->open[scanner->nopen].kind) ? scanner->open[scanner->nopen].state : 0;
}

int scanner_end(struct scanner *scanner)
{
    if (scanner->nopen && !scanner->quiet) {
        struct span span = scanner->open[scanner->nopen - 1].span;

        diag_error(scanner->parse->diag, CODE_UNCLOSED, span, "this '%c' is never closed",
                   span.source->text[span.start]);
        scanner->quiet = true;
    }
    return scanner_token(scanner, TOKEN_END);
}

bool scanner_in_bracket(const struct scanner *scanner)
{
    return scanner->nopen && is_in_line(scanner->open[scanner->nopen - 1].kind);
}

bool scanner_end_line(struct scanner *scanner)
{
    scanner->unclosed = scanner_in_bracket(scanner) ? scanner->open[scanner->nopen - 1].span : (struct span){NULL, 0, 0};
    while (scanner_in_bracket(scanner))
        scanner->nopen--;
    return scanner->nopen && scanner->open[scanner->nopen - 1].kind == BRACKET_SETTINGS;
}
