/* SPDX-License-Identifier: GPL-3.0-or-later
 * The lines of a chart file, one after the other. */
#ifndef WEFT_LINES_H
#define WEFT_LINES_H

#include <stdbool.h>

#include "lang/diag.h"

struct lines {
    const struct source *source;
    size_t               at;        /* where the next line starts */
};

/* From the first line, behind a byte order mark if there is one. */
struct lines lines_of(const struct source *);

/* The next line without its end and without blanks around it; an empty one
 * stands where the line starts. False behind the last. */
bool lines_next(struct lines *, struct span *line);

bool lines_is_blank(char c);

#endif
