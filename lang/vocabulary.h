/* SPDX-License-Identifier: GPL-3.0-or-later
 * The words of row text that are stitches, and those that are refused. */
#ifndef WEFT_VOCABULARY_H
#define WEFT_VOCABULARY_H

#include "lang/eval.h"

/* Whether a word is a stitch of the module's own, or one that it uses. */
bool vocabulary_has(const struct eval *, const struct module *, const char *word, size_t length);

/* `k2`, `purl`, `t`: the stitch and the number in the word (-1: none). False
 * after an error. */
bool vocabulary_stitch(struct eval *, const struct module *, const char *word, size_t length, unsigned start,
                       stitch_id *, long long *count);

#endif
