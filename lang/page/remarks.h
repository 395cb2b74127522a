/* SPDX-License-Identifier: GPL-3.0-or-later
 * Remarks and counts of a page: what stands in a row, or behind it, and asks for no work. */
#ifndef WEFT_REMARKS_H
#define WEFT_REMARKS_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/page/signs.h"

/* Words that say where stitches stand or what they look like, not how they are worked. */
bool remarks_are(const char *text, size_t length);

/* `this will be the border`, `ending with a WS row`: words to the reader, no count and no stitch among them. */
bool remarks_talk(const char *text, size_t length);

/* Words that name the fabric a row makes, up to the line's end, and ask for no work: `reverse stockinette`. */
bool remarks_on_fabric(const char *text);

/* Whether the line has the name of a row, and this stands behind it. */
bool remarks_in_row(const char *text, size_t at);

/* Each: how many bytes go, with `plain` in their place where there is one; 0: none. */

/* `(left border)`; `(K1, P1)` behind `seed stitch`, which it begins with, where it is not worked so many times. */
size_t remarks_length(const char *text, size_t at);

/* `(40 sts) - the rib begins`: the count, and behind it words that ask for no work; `plain` is the count. */
size_t remarks_caption(const char *text, char plain[static SIGNS_PLAIN]);

/* `<24 sts>`, `= 24`, `(total: 24 sts)` at a row's end; `plain` is `(24)`. */
size_t remarks_said(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* The bar that ends a line of a table, with a number behind it where it is no row's. */
size_t remarks_bar(const char *text, size_t at);

/* How long the row's count is in the last column of a table, with the tab before it; or 0. */
size_t remarks_column(const char *text, size_t at);

/* `(boring, I know!)`: words to the reader in brackets, and none of a technique. */
size_t remarks_chatter(const char *text);

/* `:)`, `<3` behind a blank. */
/* `(For a wider one cast on 44 sts.)`, on lines of its own: another version. */
size_t remarks_version(const char *text, size_t at);
size_t remarks_face(const char *text, size_t at);

#endif
