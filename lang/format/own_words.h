/* SPDX-License-Identifier: GPL-3.0-or-later
 * Statements of a page that the formatter does not put in other words. */
#ifndef WEFT_OWN_WORDS_H
#define WEFT_OWN_WORDS_H

#include "lang/ast.h"
#include "lang/format/tokens.h"

/* Whether a knitter's statement, its tokens from `first` up to `end`, keeps its words. */
bool own_words(const struct token *first, const struct token *end, const struct stmt *);

/* Where its text ends: behind a bracket read over in part, and behind a word whose letters are written in more bytes. */
unsigned own_words_end(struct span);

#endif
