/* SPDX-License-Identifier: GPL-3.0-or-later
 * Turns of phrase that knitters have for what the language has a word for. */
#ifndef WEFT_WORDING_H
#define WEFT_WORDING_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/arena.h"

/* The text with its turns of phrase put plainly, in as many bytes: places stay
 * the same. Texts in quotes are left alone. `joined`: what its rows are called says they are rounds. */
const char *wording_plain(struct arena *, const char *text, size_t size, bool *joined);

/* Whether `join .. in the round` stands before the rows, no row has a wrong side,
 * and rows are not called both. */
bool wording_is_joined(const char *text);

#endif
