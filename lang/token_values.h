/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a token's text means: each function takes a text and sets the token's value. */
#ifndef WEFT_TOKEN_VALUES_H
#define WEFT_TOKEN_VALUES_H

#include "lang/scanner.h"

/* Each returns the token. */
int scanner_text(struct scanner *, KNIT_STYPE *, int kind, struct span, const char *text, size_t length);
int scanner_string(struct scanner *, KNIT_STYPE *, const char *text, size_t length);
int scanner_number(struct scanner *, struct span, KNIT_STYPE *, const char *text, size_t length);
int scanner_edge(struct scanner *, KNIT_STYPE *, struct span, const char *text);      /* `1 edge st`: as the page says that they are worked */
int scanner_turned(struct scanner *, KNIT_STYPE *, const char *text);    /* `4 k`: a name */
bool scanner_behind_turned(const struct scanner *, struct span next);   /* which stands before it */

/* `slip the marker`; `to the next marker`. */
int scanner_marker(struct scanner *, KNIT_STYPE *, const char *text);
int scanner_to_marker(struct scanner *, KNIT_STYPE *, const char *text);

/* `knit the knits and purl the purls`, or the knits purled and the purls knitted. */
int scanner_below(struct scanner *, KNIT_STYPE *, struct span, const char *text);

/* Each sets the value only. */
void scanner_lower(struct scanner *, KNIT_STYPE *, const char *text, size_t length);
void scanner_number_word(KNIT_STYPE *, const char *text);
void scanner_number_of(KNIT_STYPE *, const char *text);
void scanner_round(KNIT_STYPE *, const char *text);
void scanner_side(KNIT_STYPE *, const char *text);
void scanner_starting(KNIT_STYPE *, const char *text);
void scanner_all(KNIT_STYPE *, const char *text);
void scanner_side_row(KNIT_STYPE *, const char *text);
void scanner_following(KNIT_STYPE *, const char *text);
void scanner_choice(struct scanner *, struct span);

/* `Repeat sections A and B`: reports it; text. */
int scanner_section(struct scanner *, struct span);

/* `rib`, of which the page may say elsewhere which it is: the token. */
int scanner_rib(struct scanner *, KNIT_STYPE *, struct span);
void scanner_fabric(struct scanner *, KNIT_STYPE *, struct span, const char *text);

/* `until piece measures 8 in`: how many rows that is, where the page says so. */
void scanner_measure(struct scanner *, KNIT_STYPE *, struct span, const char *phrase);

/* `These 4 rows form the pattern`, `rows 3-4 set the patt`; false: they form something else, and `behind` it they
 * are not worked again. */
bool scanner_told(KNIT_STYPE *, const char *sentence, const char *behind);

/* Sets it where a side is among the words. */
bool scanner_remark(KNIT_STYPE *, const char *text);

/* Whether so many bytes read last, `(28)`, have the number that stands before them, and no other. */
bool scanner_counts_again(const struct scanner *, size_t length);

#endif
