/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the grammar's actions leave to functions: syntax errors in a knitter's
 * words, and the parts of a row put together. */
#ifndef WEFT_SYNTAX_H
#define WEFT_SYNTAX_H

#include "lang/parse.h"

/* `found` and `expected` are the grammar's names of tokens. */
void syntax_error(struct parse *, struct span, const char *found, const char *const *expected, int n);

/* The word of rows that was meant by the one found, or NULL. */
const char *syntax_meant(struct parse *, struct span);

/* A word that is none of those expected; returns the parser's error token. */
int syntax_unknown_word(struct parse *, struct span, const char *expected);

/* Whether a text looks like the stitches of a row: `k2`, `*`, `[`, `rep`. */
bool syntax_is_row(const char *text);
void syntax_too_deep(struct parse *, struct span);
void syntax_star_is_left(struct parse *, struct span);  /* a star that no `rep from *` follows */

struct row syntax_head(struct parse *, enum side round, enum side, struct row_numbers *);
struct row syntax_head_only(struct parse *, struct span, struct all, struct row_numbers *);
/* Rows without numbers: "knit 4 rows" (no count: every row), "work 6 rows in st st". */
struct row syntax_plain_rows(struct parse *, struct span, struct span word, const char *stitch, struct expr *count,
                             enum side round);
struct row syntax_fabric(struct span, struct fabric, struct expr *count, enum side round, enum side starting);
struct row syntax_ridges(struct parse *, struct span all, struct expr *count, enum side starting);
struct row syntax_total(struct row);                                /* so many in all */
/* `Work 4 rows in st st, keeping 2 sts at each edge in garter st`. */
struct stmt *syntax_keeps(struct stmt *, struct span, struct kept_edges);

struct row syntax_as_others(struct row);
struct expr *syntax_two_rows(struct parse *, struct span);          /* how many is not said: warns */

/* A length, in rows where it is known how many: of plain rows and fabrics, of rows worked again. */
struct expr *syntax_rows_of(struct parse *, struct span, struct measure);
struct row syntax_measured(struct row, struct measure);
struct again syntax_again_until(struct parse *, struct span, struct measure);

/* `k1, p1, rep to end`: all that stands before is what is repeated. Warns. */
struct item *syntax_whole(struct parse *, struct span, struct item *, struct until, struct item *tail);

/* `k5, *p3, k5 to end`: what goes to the end is the star's repeat. `before` is what stands before it. */
struct item *syntax_open_star(struct parse *, struct span star, struct item *before, struct item *);

struct multiple syntax_parity(struct parse *, struct span, int of, int plus);
void syntax_first_size(struct parse *, struct span);
struct stmt *syntax_goes_on(struct parse *, struct span, struct measure);

/* The head with the side that is said behind the row's text. */
struct row syntax_sided(struct parse *, struct row head, struct span, enum side);

struct row syntax_row(struct parse *, struct row head, struct span head_span, struct row body, struct span body_span);
struct item *syntax_fabric_stitches(struct parse *, struct span, struct fabric, struct expr *count, struct until);
struct again syntax_work_again(struct row_numbers *, struct again);
struct again syntax_group(struct again);
struct again syntax_again(struct row_numbers *, struct expr *last, struct again);
void syntax_rows_times(struct parse *, struct span);
void syntax_rows_so_far(struct parse *, struct span);       /* a second count of rows, behind those worked */
struct again syntax_rib(struct again);
bool syntax_onwards(const struct parse *, struct span, const struct row_numbers *);    /* `from row 3`, to the last */
struct row syntax_bare_head(struct parse *, struct span, enum side round);
struct again syntax_go_on(struct span, struct expr *count);

/* Behind what is repeated, `.. then rows 1 and 2`: those once where nothing is said; the first n rows. */
void syntax_then(struct parse *, struct again *all, struct span, struct again);
struct again syntax_starred(struct starred, struct again);
struct row_numbers *syntax_first_rows(struct parse *, struct span, struct expr *n);

#endif
