/* SPDX-License-Identifier: GPL-3.0-or-later
 * Slips of the pen in what knitters write: the words a row is made of besides its
 * stitches, and those that begin a line. */
#ifndef WEFT_TYPOS_H
#define WEFT_TYPOS_H

#include <stdbool.h>

#include "lang/diag.h"

/* Whether it is one of the words rows and repeats are made of: `from`, `last`, `times`. */
bool typos_is_word(const char *word);

/* The one that was meant by a word that is nearly one; else NULL. */
const char *typos_meant(const char *word);

/* The first word from a span's start to the end of its line that is nearly one; NULL: there is none.
 * The span becomes that word's. */
const char *typos_in_line(struct arena *, struct span *);

/* "Cast no 8", "Multiple fo 4", "All WS rwos:": what a line begins with, and the bytes of it
 * that are written so; NULL: it begins in no such way. */
const char *typos_beginning(const char *text, size_t *length);

#endif
