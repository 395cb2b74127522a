/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts as tables: a cell for each stitch, as a spreadsheet shows them. */
#ifndef WEFT_CSV_H
#define WEFT_CSV_H

#include "charts/pattern.h"
#include "charts/text.h"
#include "lang/diag.h"
#include "lang/scene.h"

/* Reads a line for each row, the top row first, with cells k, K or 1 (knit) and
 * p, P or 0 (purl), in quotes or not, separated by commas, semicolons or tabs
 * (what the first line has). Errors are in diag; after one there is no grid. */
struct pattern csv_read(struct arena *, struct diag *, const struct source *);

/* Writes the swatch the same way, with commas, k and p, lines ending as on Unix;
 * a stitch of the script itself by its name, which csv_read does not know. */
void csv_write(struct text *, const struct scene *);

#endif
