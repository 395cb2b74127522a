/* SPDX-License-Identifier: GPL-3.0-or-later
 * Turns of phrase that knitters have for what the language has a word for. */
#ifndef WEFT_WORDING_H
#define WEFT_WORDING_H

#include <stddef.h>

#include "lang/arena.h"

struct page_facts;

/* The text with its turns of phrase put plainly, in as many bytes: places stay
 * the same. Texts in quotes are left alone. */
const char *wording_plain(struct arena *, const char *text, size_t size, const struct page_facts *);

#endif
