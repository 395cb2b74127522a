/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lines of a page around a pattern: which of them are prose, not statements. */
#ifndef WEFT_PROSE_H
#define WEFT_PROSE_H

#include <stdbool.h>

struct scanner;

/* All read from a place of the text to the end of its line. */
bool prose_line_ends(const char *text);             /* nothing but blanks follows */
bool prose_names_row(const char *text);             /* "1st and 3rd rows:" */
bool prose_statement_follows(const char *text);     /* a statement that a numbered list may hold */
bool prose_is_keyword(const char *text);            /* "use size 8 needles": a statement's word, but no statement */
bool prose_reads(const char *text, bool loose);     /* a sentence; loosely: of a list of materials or abbreviations */
bool prose_is_title(const char *text);

/* Whether the line that begins here is prose; warns where that is not certain. */
bool scanner_prose(struct scanner *);

#endif
