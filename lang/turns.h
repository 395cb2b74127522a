/* SPDX-License-Identifier: GPL-3.0-or-later
 * The turns of phrase of printed books: `3 plain, 2 purl`, `Knit 4 rows plain`. */
#ifndef LANG_TURNS_H
#define LANG_TURNS_H

#include "lang/phrases.h"

/* They are put plainly before those of pages (wording.c), which may then find more. */
extern const struct phrase turns[];
extern const int turns_number;

#endif
