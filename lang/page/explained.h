/* SPDX-License-Identifier: GPL-3.0-or-later
 * Fabrics that a page explains in words, `Garter st: every row knit`. */
#ifndef WEFT_EXPLAINED_H
#define WEFT_EXPLAINED_H

#include <stdbool.h>

/* Whether the line that begins here says how a fabric is worked, as this one is, and no more: not `Garter st: 4 rows`. Behind
 * the cast-on `St st: knit 1 row, purl 1 row` is work. */
bool explained_fabric(const char *line, bool cast_on);

#endif
