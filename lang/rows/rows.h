/* SPDX-License-Identifier: GPL-3.0-or-later
 * Written rows whose numbers are known: what widths they fit, and the grid
 * they make.  A row is written in working order; the grid is the right side's
 * view.  An RS row is worked from its right edge, so it is drawn reversed; a WS
 * row is worked from the left edge, and every stitch shows its other face. */
#ifndef WEFT_ROWS_H
#define WEFT_ROWS_H

#include <stdbool.h>

#include "lang/ast.h"
#include "lang/grid.h"

/* How often something is worked. */
enum work_until {
    WORK_TIMES,         /* n times in all */
    WORK_EITHER,        /* n times, or n + 1: the text can be read both ways */
    WORK_LAST_OR_ALL,   /* n times, and with it the last runs before it, or none: the text can be read so */
    WORK_LAST,          /* until n stitches are left */
    WORK_MARKER,        /* to n stitches before a marker */
    WORK_FIT            /* as often as leaves room for what follows */
};

/* In work, not in grids: what shows the same as the stitch below, or its other face; stitches of a fabric. */
enum { STITCH_SAME = 255, STITCH_OTHER = 254, STITCH_SEED = 253, STITCH_GARTER = 252, STITCH_STOCKINETTE = 251, STITCH_REVERSE = 250 };

/* What is done with a marker at a place of a row; which of those that hang there a row is worked to. */
enum mark_done { MARK_NONE, MARK_PLACED, MARK_SLIPPED, MARK_REMOVED };
enum marker { MARKER_NEXT, MARKER_SECOND, MARKER_LAST };

/* So many stitches of a kind. */
struct run {
    unsigned  length;
    stitch_id stitch;
};

/* Stitches in a row, or a group, worked again and again. */
struct work {
    struct span     span;
    struct run     *run;        /* (nruns) stitches, */
    struct work    *child;      /* or a group: its parts */
    int             nruns;
    long long       length;     /* stitches of one pass */
    enum work_until until;
    long long       n;
    bool            ending;     /* WORK_FIT: what follows may be the end of the last time, */
    bool            unmarked;   /* `k1, p1 to end`: where the repeat begins is not marked, nor what its last time is */
    bool            told;       /* which was said */
    enum mark_done  mark;       /* no stitch: a marker's place */
    enum marker     marker;     /* WORK_MARKER */
    const struct within *within;    /* no stitch: a pattern's place; else NULL */
    bool            bare;       /* a group without a number of times: once, or as often as fills the row */
    struct work    *next;
};

/* Edges that are kept in a fabric: `between` them are the stitches of the rows' own, or these have them. */
struct row_edges {
    int         n;
    stitch_id   stitch;
    struct span span;
    bool        decided, between;
    struct row_edges *above;    /* of the sentence before; or NULL */
};

/* One row's text. */
struct row_text {
    int          label;         /* its number in the pattern; 0: none yet */
    enum side    side;          /* as marked */
    bool         round;
    bool         as_below;      /* knits over knits, purls over purls */
    bool         rib;           /* as_below, where that is a rib */
    bool         as_opposite;   /* knits over purls, purls over knits */
    bool         cut;           /* `work` again and again, cut off behind its last or its first stitches */
    struct work *work;
    bool         marked;        /* `work` has to do with markers */
    struct work *on_ws;         /* the work on the wrong side, where it is another; or NULL */
    struct work *end;           /* in place of its last stitches, of a row told by another; or NULL */
    long long    end_length;    /* so many */
    long long    check;         /* (n sts), -1: none */
    struct span  span, head, check_span;
    struct row_edges *edges;    /* kept there; or NULL */
    bool         failed;        /* an error was reported: it only takes its place */
    bool         shaped;        /* for a stitch that was refused: how many there are behind it is not known */
    bool         seen;
    bool         worked;        /* at least once */
    bool         flanked;       /* a pattern's row between other stitches, its edges among them */
    int          drawn[3];      /* 1 + the grid row that shows it, by side; 0: none */
};

/* Widths multiple * n + plus, n >= 0 (and >= least); multiple 0: plus alone. */
struct fit {
    long long multiple, plus, least;
};

struct page_facts;
struct row_list;

/* Where a width comes from, for messages. */
enum width_from { WIDTH_CAST_ON, WIDTH_MULTIPLE, WIDTH_ASKED, WIDTH_ROWS };

struct row_list *rows_new(struct arena *, struct diag *);

/* What a page says of all its rows: row 1 is worked on a side where no row is marked otherwise; on a loom, all
 * from the front. */
void rows_of_page(struct row_list *, const struct page_facts *);
bool rows_any(const struct row_list *);

/* Adds a text at a row number. */
void rows_add(struct row_list *, struct row_text *, int label);

/* Works the rows given so far. */
void rows_work(struct row_list *);

/* Whether rows were given since the last were worked that stand for both sides, and no row with a number:
 * `RS rows: knit`, `WS rows: purl`. */
bool rows_described(const struct row_list *);

/* Works a row that has no number: a set-up row, one of `knit 4 rows`. */
void rows_add_next(struct row_list *, struct row_text *);

/* Works a set-up row of this number. */
void rows_add_setup(struct row_list *, struct row_text *, int label);

/* `all WS rows`: the text of every row of a kind that has none of its own, up to row `last`; 0: of all. */
void rows_fill(struct row_list *, struct row_text *, enum all_kind, int first, int last);

/* The text of a row already given, by its number or with all rows of its kind; or NULL. */
const struct row_text *rows_find(struct row_list *, int label);

/* The same among those whose first stands at a place; 0: among the last ones. */
const struct row_text *rows_find_of(struct row_list *, unsigned first, int label);

/* Rows to be worked again. */
struct row_texts {
    struct row_text **text;
    int               n, told;  /* those said to be the pattern: 1 + the place of the first among them; else 0 */
};

/* Those with the labels given (false, with a message, where one is missing); the
 * last n worked; the numbered ones of this part of the pattern, in the order in
 * which they follow the last one worked, or from the first. */
bool rows_labelled(struct row_list *, struct span, const int *label, int n, struct row_texts *);
struct row_texts rows_last(struct row_list *, int n);
struct row_texts rows_pattern(struct row_list *, bool going_on);

/* `These 4 rows form the pattern`: they are what `rows_pattern` gives, until rows with numbers follow. */
void rows_tell(struct row_list *, struct span, struct told);

/* The rows of the part whose first stands at a place; n 0: there is none. */
struct row_texts rows_of_name(struct row_list *, unsigned first);

/* These are the pattern, until rows with numbers follow; the one at place `next` is worked next. */
void rows_tell_texts(struct row_list *, struct row_texts, int next);

/* A mark of so many stars behind the rows given so far, and the rows between those last made; false, with a message,
 * where there are none. */
void rows_mark(struct row_list *, int stars);
bool rows_starred(struct row_list *, struct span, struct starred, struct row_texts *);

/* The number of the last row given. */
int rows_last_number(const struct row_list *);

/* How many rows the piece has with the one that has this number, or would have, were rows that are worked again numbered, too. */
int rows_up_to(const struct row_list *, int number);

/* The rows given so far are a pattern only: not worked yet. */
void rows_define(struct row_list *);

/* Whether each part that begins at row 1 is a pattern of its own, to be defined only. */
void rows_describe(struct row_list *, bool);

/* The rows whose first stands at a place are the pattern from here on; false: there are none. */
bool rows_choose(struct row_list *, struct span, unsigned first);

/* Whether several patterns are described, and none of them chosen. */
bool rows_to_choose(const struct row_list *);

/* Whether these can be a rib: knit and purl stitches in each, the edges of each showing what those of the next show. */
bool rows_are_rib(struct row_texts);

/* Whether others were worked behind these. */
bool rows_passed(const struct row_list *, struct row_texts);

/* Whether others that have numbers come before these, or, `unnumbered`, others before all that have numbers. */
bool rows_come_before(const struct row_list *, struct row_texts, bool unnumbered);

/* Whether the first of these was worked. */
bool rows_worked(const struct row_list *, struct row_texts);

/* How many of the rows worked last are of these, which go on with the first: they end with the last of them. */
int rows_gone_on(const struct row_list *, struct row_texts);

/* Whether these are the rows worked last, and not twice. */
bool rows_just_worked(const struct row_list *, struct row_texts);

/* `Repeat this row`, right behind it: the same words on both sides, whatever side
 * it is marked with; the mark has said where the work began. */
void rows_both_sides(struct row_list *, struct row_texts);

/* Works rows again: `times` more, or until there are `total`. */
void rows_again(struct row_list *, struct span, struct row_texts, long long times, long long total);

/* Closes the list: fills the gaps, decides the sides. False after an error. */
bool rows_finish(struct row_list *);

/* Whether rows below a sentence that keeps edges are worked between them: by their counts, with a warning; `last`: the
 * last of these sentences, or NULL. Width 0: it is open. False after an error. */
bool rows_keep_edges(struct row_list *, const struct row_edges *last, int width);

/* Whether every text is good. */
bool rows_good(const struct row_list *);

bool rows_round(const struct row_list *);
int rows_count(const struct row_list *);

/* Whether the row at a place in the order of work, from 0, is another than the one before it. */
bool rows_begin_at(const struct row_list *, long long place);

/* Whether the first row worked is worked on the wrong side, of rows that are closed. */
bool rows_ws_first(const struct row_list *);

/* The side the last row was worked on; SIDE_OPEN: there is none, or it is a round. */
enum side rows_last_side(const struct row_list *);

/* The place in the order of work, from 0, of the row with a number; where it is beyond the rows as they are numbered,
 * of the one that it repeats. -1: there is none. */
int rows_place(const struct row_list *, long number);

/* The count behind the first row that has one, `(24 sts)`; 0: none has. */
long long rows_said_width(const struct row_list *);

/* Whether one row alone says how the widths repeat that all fit. */
bool rows_one_repeat(const struct row_list *, const struct fit *);

/* The widths all rows fit; reports rows that contradict each other. */
bool rows_fit(const struct row_list *, struct fit *);

/* The grid of a width; height 0: each row once. The first stitch counts come
 * from `from`. NULL after an error. */
const struct grid *rows_grid(struct row_list *, int width, int height, enum width_from from, const stitch_id *ws);

#endif
