/* SPDX-License-Identifier: GPL-3.0-or-later
 * Stars of a page that mark what is worked again: `** Row 1: ..`, `.. purl. **`, `Rep from ** to ** twice`. */
#ifndef WEFT_STARRED_H
#define WEFT_STARRED_H

#include <stddef.h>

#include "lang/ast.h"

/* The bytes for the brackets around rows, `[Knit 2 rows, purl 2 rows] twice`. */
enum { STARRED_GROUP = 4, STARRED_GROUP_END };

/* The text, in as many bytes, with the byte 1, 2 or 3 for as many stars of a mark, on a line of its own, and of a
 * `Repeat from **` that names one. */
const char *starred_plain(struct arena *, const char *text, size_t size);

/* The stars of a mark at a place of that text; 0: none. `source`: the text as it was. */
int starred_mark(const char *plain, const char *source, size_t at);

/* The bytes of `from ** to **`, its stars put so; 0: the text begins otherwise. */
size_t starred_length(const char *plain, struct starred *);

#endif
