/* SPDX-License-Identifier: GPL-3.0-or-later
 * Headings of a page: "Materials:", "Instructions", "Gauge - 20 sts to 10 cm". */
#ifndef WEFT_HEADINGS_H
#define WEFT_HEADINGS_H

#include <stddef.h>

enum heading {
    HEADING_NONE,
    HEADING_PATTERN,    /* of rows */
    HEADING_TEXT        /* of what is no part of the pattern */
};

/* What a text begins with, and its bytes with the colon or dash behind it; with neither it is a line of its own. */
enum heading headings_find(const char *text, size_t *length);

#endif
