/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lines of a page around a pattern: which of them are prose, not statements. */
#ifndef WEFT_PROSE_H
#define WEFT_PROSE_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/diag.h"

struct scanner;

enum { PROSE_NAME = 200 };                          /* bytes a pattern's name is looked for in */

/* All read from a place of the text to the end of its line. */
/* Whether a sentence, `Work 6 rows of rib as follows:`, is the heading of the rows that begin behind it or on the next line. */
bool prose_heads_rows(const char *sentence, const char *behind);

bool prose_is_aside(const char *text);              /* "Easy, right?": no word of a row's text */

/* Whether the line holds measures, `24 stitches, 12 rows`, `To fit chest 81[86:91] cm`, and no work. */
bool prose_is_measure(const char *text);

bool prose_works_until(const char *text);           /* `Knit until it measures 8 in`: which rows these are is open */
bool prose_line_ends(const char *text);             /* nothing but blanks follows */
bool prose_names_row(const char *text);             /* "1st and 3rd rows:" */
bool prose_statement_follows(const char *text);     /* a statement that a numbered list may hold */
bool prose_is_keyword(const char *text);            /* "use size 8 needles": a statement's word, but no statement */
bool prose_is_long(const char *text);               /* so many plain words that stitches and signs among them do not matter */
bool prose_reads(const char *text, bool loose);     /* a sentence; loosely: of a list of materials or abbreviations */
bool prose_is_title(const char *text);
bool prose_repeats_rows(const char *text);          /* behind `repeat`: rows, not a part of one */
bool prose_fabric_follows(const char *text);        /* "garter st", "k2, p2 rib" */
bool prose_has_cast_on(const char *text);           /* "20 sts": so many stitches come next */
bool prose_stitches_follow(const char *text);       /* a row's text, of a list that numbers its rows */
bool prose_sentence_begins(const char *text);       /* "repeat rows 1-4", "then purl 3 rows", "bind off": of a line's several */
bool prose_row_is_labelled(const char *text);       /* behind `Row`: "2: k4", "2 - k4" */
bool prose_is_head(const char *text);               /* "work in pattern thus:", rows behind it or nothing */
bool prose_is_side_mistyped(const char *text);      /* "(SR)" */
bool prose_repeat_follows(const char *text);        /* "rep", "repeat" */
size_t prose_names_pattern(const char *text);       /* "work panel A over 12 sts": its bytes, no more than of a name; or 0 */
size_t prose_bracket_length(const char *text);      /* "(see below)": its bytes, where it is closed near by; or 0 */
size_t prose_but_end(const char *text);             /* "but end with ": its bytes, or 0 */
bool prose_footnote_follows(const char *text);      /* "see note": behind a star that repeats nothing */
bool prose_footnote_below(const char *text);        /* a line with that and a star is below, near by */
size_t prose_sentence_length(const char *text);     /* up to its full stop, or to the line's end */
bool prose_counts_fabric(const char *text);         /* "4 rows of garter" */
bool prose_number_ends(const char *text);           /* "3", before a comma, a stop or the line's end */
bool prose_tells_fabric(const char *text);          /* `the last 4 rows are garter st` */
bool prose_places_markers(const char *text);       /* `place a stitch marker`, over a line's end */
bool prose_remark_follows(const char *text);        /* " Place markers at both ends.": a sentence without a row's words */
bool prose_count_follows(const char *text);         /* "24 sts." and no more */
bool prose_times_follow(const char *text);          /* "3 times", "two more" */
bool prose_says_how_often(const char *text);        /* "work in pattern twice": whole patterns, no length */
bool prose_comma_is_idle(const char *text);         /* "3 times", "or until .." behind it */
bool prose_row_is_named(const char *text);          /* "row:" */
bool prose_tells_how(const char *text);             /* "using the long-tail method", "enough stitches", and no number */
size_t prose_sizes_length(const char *text, int *n);    /* of "(5, 6)", "[5:6:7]", "(5, 6 sts)"; n: how many */
bool prose_is_named_row(const char *text);          /* "Eyelet rnd: knit", "Garter ridge row (RS): purl" */
bool prose_is_meaning(const char *text);            /* "(s) = round(s)", behind an abbreviation */
bool prose_row_word(const char *text);              /* "row", "rounds", or a statement's word */
bool prose_rows_follow(const char *text);           /* "3 rows", "{n} more rows" */
bool prose_rows_are_named(const char *text);        /* "3 rows," or "3 rows:" */
bool prose_names_needle(const char *text);          /* "needle:" */
bool prose_tells_of_row(const char *text);          /* behind "Row": "4 looks odd at first" */
bool prose_side_is_worked(const char *text);        /* "RS: knit all sts", not "RS = right side" */
bool prose_is_bare_row(const char *text, bool plain);    /* `k2, p2 to end` and no more, or, `plain`, `knit` alone */
bool prose_row_line(const char *text);              /* `*knit 5, purl 1`: a row goes on */
bool prose_is_remark(const char *text);             /* "(set-up row):": words before a row's colon */
bool prose_pattern_follows(const char *text);       /* a row with its name, a cast-on, a multiple */

/* The bytes of "cast on", "co" before a number; 0: the text begins otherwise. */
size_t prose_begins_cast_on(const char *text);

/* Where in a remark rows begin: "and knit 5 rows"; 0: nowhere. */
size_t prose_rows_within(const char *text);

/* "Cast off 4 sts at beg of next 2 rows": not all of them. */
bool prose_casts_some(const char *text);

/* Where in a sentence "18 rows" stands; 0: nowhere. */
size_t prose_row_count(const char *sentence);

/* Warns of a row or a cast-on in a line that is taken as text. */
void prose_warn_hidden(struct scanner *, struct span line);

/* Whether the line the scanner is in speaks of a multiple. */
bool prose_of_multiple(const struct scanner *);

/* Whether numbers of several sizes stand in a part of a line, `4 (6, 8) rows`: reports them. */
bool prose_sizes(struct scanner *, struct span);

/* The bytes of prose: to the end of the line, or to the full stop that a part of the pattern follows. */
size_t prose_length(const struct scanner *, const char *text);

/* Whether the line that begins here is prose; warns where that is not certain. */
bool scanner_prose(struct scanner *);

#endif
