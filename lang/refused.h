/* SPDX-License-Identifier: GPL-3.0-or-later
 * Words of row text that are known, and that version 1 cannot knit. */
#ifndef WEFT_REFUSED_H
#define WEFT_REFUSED_H

#include "lang/diag.h"

/* Whether a word is one of them; reports it, with the reason, at its place. */
bool refused_word(struct diag *, const char *word, struct span);

/* The same for the first such word of a piece of text. */
bool refused_text(struct diag *, struct span);

/* Stitches bound off before the end. */
void refused_part(struct diag *, struct span);

/* Whether a sentence asks for what cannot be knitted: `Dec 1 st at each end`, `With B, ..`. */
bool refused_sentence(struct diag *, struct span line);

#endif
