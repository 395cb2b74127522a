/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lengths in the words of a page, "until piece measures 8 in (20 cm)", and how many rows they are. */
#ifndef WEFT_LENGTHS_H
#define WEFT_LENGTHS_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/page/signs.h"

/* Rows per millimetre by the gauge a text states, "Gauge: 20 sts and 28 rows = 4 in", and from where to where: up to
 * the number of rows; 0: none. */
double lengths_gauge(const char *text, size_t *from, size_t *to);

/* Whether a phrase says a length; whether a text goes on with one, "2 in", or up to one, "until it measures 2 in". */
bool lengths_said(const char *phrase);
bool lengths_follow(const char *text);

/* The length that rows are worked to or, `part`, for, in millimetres; 0: none is said. `phrase` ends with its text. */
double lengths_wanted(const char *phrase, bool *part);

/* The bytes of `(about 8 rows)`, `, 8 rows` behind a length, and `(8 rows)` for it; 0: it is none. */
size_t lengths_count(const char *text, size_t at, char plain[static SIGNS_PLAIN]);

/* The rows that such a count says in a phrase; 0: none. */
int lengths_counted(const char *phrase);

/* The row it ends with, "until piece measures 8 in, ending with row 2", or its side; 0: none is said. `other`: `row 2 or row 4`; 0: no choice. */
enum { ENDING_RS = -1, ENDING_WS = -2 };
int lengths_ending(const char *phrase, int *other);

#endif
