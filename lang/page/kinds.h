/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows of a kind in a sentence: `Purl all even rows`, `WS rows - purl`. */
#ifndef WEFT_KINDS_H
#define WEFT_KINDS_H

#include <stddef.h>

#include "lang/page/signs.h"

/* The bytes of such a sentence that begins at a place, up to its stitch or a list of stitches; in plain words its head,
 * and the stitch: `even rows:p`, `WS rows:`. 0: there is none. */
size_t kinds_length(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* Of `(and every other row)` behind a row's number; plainly without its brackets. */
size_t kinds_added(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* How long `Only RS rows are given` is, which asks for no work; or 0. Before what follows it ends its line, plainly. */
size_t kinds_given(const char *text);
size_t kinds_given_before(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

#endif
