/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a knitter writes, as the syntax tree has it, in the words of a formatted
 * script: `Row 1 (RS): *k2, p2; rep from * to last 2 sts, k2.` */
#ifndef WEFT_ROW_WORDS_H
#define WEFT_ROW_WORDS_H

#include "lang/format/layout.h"
#include "lang/format/tokens.h"

/* What the words of a row depend on besides its tree. */
struct row_style {
    struct arena        *arena;
    const struct tokens *tokens;        /* of the text, for the expressions in it */
    bool                 lower;         /* k and p mean knit and purl in either case */
};

/* Adds a row, cast on, multiple or repeat to the line; `first` is the kind of
 * its first token, `stopped`: it ends with a full stop. */
void row_words(struct layout *, const struct row_style *, const struct stmt *, int first, bool stopped);

#endif
