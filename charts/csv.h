/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts as tables: a cell for each stitch, as a spreadsheet shows them. */
#ifndef WEFT_CSV_H
#define WEFT_CSV_H

#include <stdbool.h>

#include "charts/pattern.h"
#include "charts/text.h"
#include "lang/diag.h"
#include "lang/scene.h"

/* A table of that extension whose rows are named, `Row 12` above `Row 11`? It looks like written rows. */
bool csv_is(const struct source *);

/* Reads a line for each row, the top row first, with cells k, knit or 1 and p,
 * purl or 0, small or capital, in quotes or not, separated by commas, semicolons
 * or tabs (what the first line has). Without a letter one sign is purl, - or a dot,
 * and an empty cell knit, which the remark says. Numbers of rows and stitches
 * around them are left out, if they count the rows from the bottom and the
 * stitches from an end, and so are empty edges. Errors are in diag; after one
 * there is no grid. */
struct pattern csv_read(struct arena *, struct diag *, const struct source *);

/* Writes the swatch the same way, with commas, k and p, lines ending as on Unix;
 * a stitch of the script itself by its name, which csv_read does not know. */
void csv_write(struct text *, const struct scene *);

#endif
