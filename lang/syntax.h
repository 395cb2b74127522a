/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the grammar's actions leave to functions: syntax errors in a knitter's
 * words, and the parts of a row put together. */
#ifndef WEFT_SYNTAX_H
#define WEFT_SYNTAX_H

#include "lang/parse.h"

enum { SYNTAX_EXPECTED = 6 };       /* more alternatives than this are not listed */

/* `found` and `expected` are the grammar's names of tokens. */
void syntax_error(struct parse *, struct span, const char *found, const char *const *expected, int n);

/* Whether a text looks like the stitches of a row: `k2`, `*`, `[`, `rep`. */
bool syntax_is_row(const char *text);
void syntax_too_deep(struct parse *, struct span);

struct row syntax_head(struct parse *, enum side round, enum side, struct row_numbers *);
struct row syntax_row(struct row head, struct span head_span, struct row body, struct span body_span);
struct again syntax_again(struct row_numbers *, struct expr *last, struct again);

#endif
