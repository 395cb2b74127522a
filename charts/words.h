/* SPDX-License-Identifier: GPL-3.0-or-later
 * Written rows as they stand on a page (KnitSpeak): `Rows 1 and 3 (RS): *k2, p2;
 * repeat from * to last 2 sts, k2.`  The language reads them as they are. */
#ifndef WEFT_WORDS_H
#define WEFT_WORDS_H

#include <stdbool.h>

#include "charts/pattern.h"
#include "lang/diag.h"

/* Does one of the first lines begin like a row? */
bool words_is(const struct source *);

/* Compiles the text where it stands, so that errors have their place. Rows that
 * say no width are given the least they fit, which the remark says; the
 * pattern's words are then the text behind a cast-on. */
struct pattern words_read(struct arena *, struct diag *, const struct source *);

#endif
