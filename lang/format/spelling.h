/* SPDX-License-Identifier: GPL-3.0-or-later
 * How a formatted script spells a token of the expressions' register, and
 * where a blank stands between two. */
#ifndef WEFT_SPELLING_H
#define WEFT_SPELLING_H

#include "lang/format/tokens.h"

const char *spelling_of(struct arena *, const struct token *);

/* Whether there is a blank between the tokens i - 1 and i. */
bool spelling_blank(const struct tokens *, int i);

/* The tokens within a span, on one line. */
const char *spelling_of_span(struct arena *, const struct tokens *, struct span);

#endif
