/* SPDX-License-Identifier: GPL-3.0-or-later
 * A pattern that was read from a chart file, as a script. */
#ifndef WEFT_IMPORT_H
#define WEFT_IMPORT_H

#include "charts/pattern.h"
#include "charts/text.h"

/* Writes a script whose swatch is the pattern: one motif, its smallest repeat, as
 * a chart or as rows, whichever is shorter; or the pattern's own words. path is that of the chart file ("-": standard input);
 * the motif is named after it. `what` says what the file was, for a comment. */
void import_script(struct text *, const struct pattern *, const char *path, const char *what);

#endif
