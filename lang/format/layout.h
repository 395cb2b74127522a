/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lines of a formatted text: words in, lines with their indentation, columns
 * of neighbouring lines under each other, and blank lines out. */
#ifndef WEFT_LAYOUT_H
#define WEFT_LAYOUT_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/arena.h"

/* What stands in a column with the line above: its second part moves right. */
enum layout_kind { LAYOUT_PLAIN, LAYOUT_BLOCK, LAYOUT_ROW };

struct layout;

struct layout *layout_new(struct arena *);

/* Begins a line; `gap`: with an empty one before it. */
void layout_line(struct layout *, int indent, bool gap);

/* Adds to the line.  A line end in the text is a blank at which a line that
 * grows too long is broken. */
void layout_add(struct layout *, const char *text, size_t length);
void layout_print(struct layout *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The line is not broken. */
void layout_whole(struct layout *);

/* Here the line's second part begins, once for a line; at the line's begin: it has none, but
 * does not part the lines around it. */
void layout_column(struct layout *, enum layout_kind);

/* A comment behind the line. */
void layout_comment(struct layout *, const char *text, size_t length);

/* Characters on the line so far, its indentation included. */
int layout_width(const struct layout *);
bool layout_empty(const struct layout *);       /* no line yet */

/* The whole, NUL-terminated. */
char *layout_text(struct layout *, size_t *length);

/* Characters of a UTF-8 text. */
int layout_characters(const char *text, size_t length);

#endif
