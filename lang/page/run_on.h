/* SPDX-License-Identifier: GPL-3.0-or-later
 * Rows that follow each other on one line, and a cast-on behind other text. */
#ifndef WEFT_RUN_ON_H
#define WEFT_RUN_ON_H

#include <stddef.h>

#include "lang/arena.h"

/* The text with a line end for the blank before each of them, `1.row: k4  2.row: p4`, and before `Cast on 20 sts. Row 1:`
 * behind a page's materials; in as many bytes. */
const char *run_on_plain(struct arena *, const char *text, size_t size);

#endif
