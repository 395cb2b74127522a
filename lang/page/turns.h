/* SPDX-License-Identifier: GPL-3.0-or-later
 * Turns of phrase that are put plainly (wording.c): of pages, `the rest of the row`, and of printed books, `3 plain, 2 purl`. */
#ifndef WEFT_TURNS_H
#define WEFT_TURNS_H

#include "lang/page/phrases.h"

/* Those of books come first: those of pages may then find more. */
extern const struct phrase turns_of_books[], turns_of_pages[];
extern const int turns_of_books_number, turns_of_pages_number;

#endif
