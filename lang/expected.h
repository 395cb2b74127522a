/* SPDX-License-Identifier: GPL-3.0-or-later
 * What could stand where something else stands: the grammar's tokens in, words
 * for a knitter out. */
#ifndef WEFT_EXPECTED_H
#define WEFT_EXPECTED_H

#include "lang/arena.h"

#include <stdbool.h>

enum { EXPECTED_TOKENS = 200 };     /* room for all tokens of the grammar */

bool expected_has(const char *const *token, int n, const char *name);

/* "a value", "')' or ','"; NULL where it is too much to be told. */
const char *expected_list(struct arena *, const char *const *token, int n);

/* How a statement that begins with this token is written; NULL where nothing is to be said. */
const char *expected_form(int statement);

#endif
