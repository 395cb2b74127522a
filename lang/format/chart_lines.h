/* SPDX-License-Identifier: GPL-3.0-or-later
 * A drawn chart's lines with stitches and row numbers under each other. */
#ifndef WEFT_CHART_LINES_H
#define WEFT_CHART_LINES_H

#include "lang/ast.h"
#include "lang/format/layout.h"

struct chart_lines;

struct chart_lines *chart_lines_new(struct arena *, const struct stmt *chart);

/* Adds the next line, from the top. */
void chart_lines_print(struct chart_lines *, struct layout *);

#endif
