/* SPDX-License-Identifier: GPL-3.0-or-later
 * The rows of one fabric while they are put together: for the files behind rows.h alone. */
#ifndef WEFT_ROW_LIST_H
#define WEFT_ROW_LIST_H

#include "lang/rows/row_markers.h"
#include "lang/rows/rows.h"

/* The text that stands for every row of a kind. */
struct filler {
    enum all_kind all;
    int first; /* ALL_OTHER, ALL_FOLLOWING: the row it was given for */
    int last;  /* up to this row; 0: all */
    struct row_text *text;
    struct filler *next;
};

/* The numbered rows of a part that begins at row 1. */
struct part {
    struct row_text **label;
    int label_room, last_label, first_label, worked_label;
    struct part *next;
};

/* The rows said to be the pattern; n 0: the numbered ones are. */
struct told_rows {
    struct row_text **row;
    int n, next;    /* next: the place of the one to go on with */
};

/* So many stars behind so many rows. */
struct mark {
    int stars, rows;
};

struct row_list {
    struct arena *arena;
    struct diag *diag;

    /* Rows in working order. */
    struct row_text **order;
    int norder, room;

    /* The numbered rows not yet worked: labels first .. first + npending - 1. */
    struct row_text **pending;
    int first, npending, pending_room, ngiven;  /* ngiven: without gaps between */

    /* All numbered rows, by label, for `as row 3` and repeats. */
    struct row_text **label;
    int label_room;

    struct filler *filler;
    bool fresh;                     /* a filler was added since rows were worked */
    bool in_turn;                   /* `RS: ..` is one row: a side came again */
    int last_label, first_label;    /* of this part of the pattern */
    int nsetup;                     /* numbered set-up rows */
    int worked_label;               /* of the numbered row worked last */
    bool loose;                     /* what came last had no number, or was a repeat */
    enum side start; /* the side of the first row worked; open until known */
    struct told_rows told;
    struct mark *mark;              /* stars, in the order of the text */
    int nmarks, mark_room;
    enum side row_1; /* the side of row 1 by what the page says of its rows, or */
    bool begins;                    /* that of the first row worked, */
    bool counts_on;                 /* rows that were worked again have the numbers before later ones, */
    int bound_off;                  /* the number of the row that binds off; 0: it has none, */
    bool front;                     /* and that they are a loom's: all are worked from the front */
    struct part *part;              /* those before the one above */
    bool describes;                 /* each part is a pattern of its own, not worked yet, */
    bool to_choose;                 /* of which none was chosen */
    bool round, flat, failed;
    struct span span; /* of the row added last */
};

static inline void row_list_fail(struct row_list *list)
{
    list->failed = true;
}

/* An array of row pointers with room for n. */
struct row_text **row_list_grown(struct row_list *, struct row_text **, int *room, int n);

/* The text given with a row's own number, or NULL. */
const struct row_text *row_list_numbered(const struct row_list *, int label);

/* The row that was worked again behind all with numbers and has this one, where later numbers count such rows; or NULL. */
struct row_text *row_list_counted(const struct row_list *, int label);

/* The part so far is kept, to be chosen later. */
void row_list_keep_part(struct row_list *);

/* False, with a message, for rows among rounds. */
bool row_list_mix(struct row_list *, const struct row_text *);

/* The side the i-th row worked (from 0) is worked on. */
enum side row_list_side(const struct row_list *, int i);

/* Reports a text marked with the other side; `repeated`: so many rows are, which brings it there; 0: none. */
void row_list_check_side(struct row_list *, const struct row_text *, int i, int repeated);

/* Warns of a row 1 that falls on the wrong side, where no side is said of any row and the rows are not the same from either. */
void row_list_doubt_side(struct row_list *, struct row_text *const *text, int n);

/* `row_work` of a text between its edges, and these. */
bool row_edges_work(struct diag *, struct row_text *, int width, enum width_from, const struct row_text *before, stitch_id *worked);

/* Where no row has decided on which side the work begins, the one worked next does. */
void row_list_begin_on_side_of(struct row_list *, const struct row_text *);

/* Appends a row to the order of work; false past the limit. */
bool row_list_append(struct row_list *, struct row_text *);

#endif
