/* SPDX-License-Identifier: GPL-3.0-or-later
 * Characters and marks of pages that no script has: pictures, arrows, letters of another
 * width or weight, Markdown, HTML. */
#ifndef WEFT_MARKS_H
#define WEFT_MARKS_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/arena.h"

/* The text in plain characters, in as many bytes. A word that gets shorter is followed by blanks;
 * texts in quotes and what stands between braces is left alone. */
const char *marks_plain(struct arena *, const char *text, size_t size);

/* Whether a tag of a paragraph or of letters begins here, `<p>`, `<b>`: a piece of a page, no file of its own format. */
bool marks_are_tag(const char *text);

#endif
