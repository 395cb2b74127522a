/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in, what `repeat` asks for there out: rows, a part of one, or a sentence of text. */
#ifndef WEFT_REPEATS_H
#define WEFT_REPEATS_H

#include <stdbool.h>
#include <stddef.h>

/* The token that a statement's `repeat`, which the text begins with, is, and its length in bytes: TOKEN_REPEAT_ROWS, _LAST,
 * _THEM, _ALL, or TOKEN_PROSE of sections; 0: it begins a text. */
int repeats_kind(const char *text, size_t *length);

/* `rows`, or the `r` of `r4`, that a text begins with: its bytes, or 0. */
size_t repeats_rows_length(const char *text);

/* `everything`, `the whole thing`, `all of this` that a text begins with, all rows that were worked: its bytes, or 0. */
size_t repeats_everything_length(const char *text);

/* Whether a text begins with `1-4`, `1 to 4` of a list of rows, to be worked so often or so long: no stitches follow. */
bool repeats_range(const char *text);

/* Whether a text begins with `3 times`, `once more`, and its sentence ends there. */
bool repeats_so_often(const char *text);

/* ` small basketweave` behind `repeat rows 1-4 for`, a name and no number: its bytes, or 0. */
size_t repeats_name_length(const char *text);

#endif
