/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script in its canonical layout: the same statements, comments and blank
 * lines, evenly written.  Formatting again changes nothing. */
#ifndef WEFT_FORMAT_H
#define WEFT_FORMAT_H

#include "lang/compile.h"

/* The text, NUL-terminated, in the arena; the source's own where it would read otherwise in another layout, which
 * is told by its statements and, with these options (NULL: not), by what it compiles to; NULL where the script
 * cannot be parsed, with the errors in diag. */
const char *format_script(struct arena *, struct diag *, const struct source *, const struct compile_options *, size_t *length);

#endif
