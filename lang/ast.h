/* SPDX-License-Identifier: GPL-3.0-or-later
 * The syntax tree: what the parser makes of a script, before any of it means
 * anything.  Names are interned (compare with ==); lists hang together by
 * `next`; everything knows the bytes it came from. */
#ifndef WEFT_AST_H
#define WEFT_AST_H

#include <stdbool.h>

#include "lang/diag.h"

/* ---- expressions ---- */

enum expr_kind {
    EXPR_BAD,           /* reported already */
    EXPR_NUMBER,
    EXPR_STRING,
    EXPR_NAME,
    EXPR_MEMBER,        /* of a used file: f.flag */
    EXPR_LIST,
    EXPR_UNARY,
    EXPR_BINARY,
    EXPR_CHOICE,        /* a ? b : c */
    EXPR_INDEX,         /* a[b] */
    EXPR_CALL,
    EXPR_EACH           /* each (x, y) in columns by rows : cell */
};

enum operator { OP_ADD, OP_SUBTRACT, OP_MULTIPLY, OP_DIVIDE, OP_MOD, OP_LESS, OP_GREATER, OP_AT_MOST, OP_AT_LEAST,
               OP_EQUAL, OP_UNEQUAL, OP_AND, OP_OR, OP_NEGATE, OP_NOT };

struct expr {
    enum expr_kind kind;
    int            depth;           /* 1 + the deepest operand's */
    struct span    span;
    struct expr   *next;            /* in a list or among arguments */
    union {
        struct { double value; int dimension; } number;                 /* dimension: power of length */
        const char *text;                                               /* string, name */
        struct { const char *space, *name; } member;
        struct { struct expr *first; int n; } list;
        struct { enum operator op; struct expr *a, *b, *c; } operation; /* unary, binary, choice, index */
        struct { struct expr *function; struct argument *first; int n; } call;
        struct { const char *x, *y; struct expr *columns, *rows, *cell; } each;
    };
};

struct argument {
    const char      *name;          /* NULL: by position */
    struct span      span;
    struct expr     *value;
    struct argument *next;
};

/* low..high by step, or the values of a list (then only low is set). */
struct range {
    struct expr *low, *high, *step;
    struct span  span;
};

/* ---- written rows ---- */

/* The last two, of a first row alone: its stitch is told, the fabric says on which side that is worked. */
enum side { SIDE_OPEN, SIDE_RS, SIDE_WS, SIDE_OF_KNIT, SIDE_OF_PURL };

enum until_kind {
    UNTIL_ONCE,         /* nothing is said */
    UNTIL_TIMES,        /* n times */
    UNTIL_LAST_OR_ALL,  /* n times, alone or with stitches before it: "k1, p1 4 times" */
    UNTIL_MORE,         /* n more times */
    UNTIL_LAST,         /* to last n stitches */
    UNTIL_MARKER,       /* to the marker ahead, to n stitches before it */
    UNTIL_SECOND_MARKER,    /* to the row's second, */
    UNTIL_LAST_MARKER,  /* to its last */
    UNTIL_END,          /* to end, across */
    UNTIL_FIT,          /* to end, but for what follows: "across, end k2" */
    UNTIL_LAST_REPEAT   /* the same, what follows being the last repeat's beginning: "ending last rep k2" */
};

struct until {
    enum until_kind kind;
    struct expr    *n;
    struct span     span;
};

enum item_kind { ITEM_SEVERAL, ITEM_PLAIN, ITEM_COUNTED, ITEM_STITCH, ITEM_GROUP, ITEM_STARS, ITEM_REP_FROM };

/* `work row 1 of pattern to last 4 sts`: the row, 0: the one whose turn it is; how many stitches are left; or over how many
 * it is worked; 0: neither is said. */
struct within { int row, last, over; };

/* What an item has that is not plain. */
struct item_more {
    const char   *name;             /* stitch: "k2" */
    const struct within *within;    /* a pattern that is worked here, or NULL */
    struct expr  *count;            /* stitch: one that stands apart, or NULL */
    struct item  *child;            /* the others: what is repeated */
    struct until  until;
};

/* A stitch with its count; or what is repeated: a group in brackets, between two
 * stars, or from a star to its `rep from *`.  What is plain, `k2` or counted, `knit 2`, or
 * several of the first, `k2, p2`, is no more than its place in the text: patterns have
 * millions of them. */
struct item {
    struct item     *next;
    unsigned         start;         /* its bytes in the source of its statement */
    unsigned         kind : 3, length : 29;
    struct item_more more[];        /* (1); plain and counted: (0) */
};

static inline bool item_is_plain(const struct item *item)
{
    return item->kind <= ITEM_COUNTED;
}

/* Which rows a head names: a number, a first and a last, or all of a kind. */
enum all_kind { ALL_NONE, ALL_RS, ALL_WS, ALL_EVEN, ALL_ODD, ALL_OTHER, ALL_FOLLOWING, ALL_EVERY, ALL_RS_ROW, ALL_WS_ROW };

struct all { enum all_kind kind; bool round; };

struct row_numbers {
    struct expr        *first, *last;   /* last NULL: one row */
    enum all_kind       all;            /* every row of this kind; or, where first is, */
    enum all_kind       only;           /* those of first to last; ALL_NONE: each of them */
    enum side           side;           /* what stands behind this number */
    bool                round;          /* "and 3rd round" */
    struct span         span;
    struct row_numbers *next;
};

enum body_kind { BODY_ITEMS, BODY_AS_ROW, BODY_AS_BELOW, BODY_FABRIC, BODY_IN_PATTERN, BODY_IN_RIB, BODY_OF_PATTERN };

/* A fabric known by its name: `work 6 rows in k2, p2 rib`. */
enum fabric_kind { FABRIC_GARTER, FABRIC_STOCKINETTE, FABRIC_REVERSE, FABRIC_SEED, FABRIC_RIB };

struct fabric {
    enum fabric_kind kind;
    int              knit, purl;    /* of a rib */
};

/* `Keep 3 sts at each edge in garter st`: beside the rows behind it, or in them. */
struct kept_edges { int n; enum fabric_kind fabric; unsigned length; };

struct row {
    bool                round;          /* worked in the round: always from the right side */
    bool                as_others;      /* row or round is not said: what the others are */
    enum side           side;
    bool                setup;          /* before row 1, its numbers being its own */
    struct row_numbers *numbers;        /* NULL: the next row, */
    struct expr        *count;          /* or the next so many rows, */
    bool                total;          /* or as many as there are then in all, */
    bool                worked;         /* worked by then: since when is not said, */
    bool                measured;       /* which may be there already */
    enum side           starting;       /* the side of the first of them */
    struct kept_edges   edges;          /* in these rows; n 0: none */
    struct span         edges_span;
    struct span         head;
    enum body_kind      body;
    struct span         body_span;
    bool                opposite;       /* of what is below */
    unsigned            from;           /* where the rows begin whose name is mentioned; 0: none is */
    struct item        *item;
    struct fabric       fabric;
    struct row_numbers *reference;      /* as row n, as rows 1-4, */
    struct expr        *times;          /* so often; or NULL */
    struct expr        *check;          /* (n sts), or NULL */
    struct span         check_span;
};

/* Repeating rows is working them again: n times means n more times. */
enum again_kind { AGAIN_PATTERN, AGAIN_TIMES, AGAIN_UNTIL_ROWS, AGAIN_TOTAL, AGAIN_ROWS, AGAIN_TOTAL_ROWS, AGAIN_LENGTH, AGAIN_PART_LENGTH };

/* A length in rows; 0: how many they are is not said. `part`: of these rows, not of the piece. `ending`, `other`: the row it
 * ends with, or one of two. `counted`: the rows themselves are said. */
struct measure { int rows; bool part; int ending, other; bool counted; };

/* `these 4 rows form the pattern`: the last n; n 0: those with numbers from first to last. */
struct told { int n, first, last; };

/* Which rows, where no numbers are given. */
enum again_which { AGAIN_NUMBERS, AGAIN_LAST, AGAIN_THEM, AGAIN_GO_ON, AGAIN_STARRED };

/* Those between the last marks of so many stars. */
struct starred {
    int from, to;   /* to 0: up to here */
};

/* Of what "in all" gives the sum: rows that are repeated, or else of the piece; of the piece; times. */
enum sum_of { SUM_ROWS, SUM_PIECE, SUM_TIMES };

struct again {
    enum again_which    which;
    struct row_numbers *numbers;
    struct expr        *last;           /* repeat the last n rows; AGAIN_LAST and NULL: all */
    struct starred      starred;        /* those between the stars */
    bool                bracketed;      /* or in brackets, worked once */
    enum again_kind     kind;
    bool                pattern;        /* said in words: "for pattern" */
    bool                open;           /* until a length, of which no gauge says how many rows it is */
    bool                assumed;        /* "work rows 1-4 twice": in all, where they were worked just before */
    bool                more;           /* "3 more times", never in all */
    bool                worked;         /* until so many rows "have been worked": since when? */
    bool                numbered;       /* "until row 12": up to the row of this number */
    bool                onwards;        /* "from row 3": and all behind it */
    unsigned            from;           /* where the rows begin whose name is mentioned; 0: none is */
    bool                several;        /* names are mentioned */
    struct kept_edges   edges;          /* kept in these rows; n 0: none */
    struct span         edges_span;
    bool                rib;            /* they are to be one */
    int                 ending;         /* "ending with row 2"; 0: not said */
    int                 other_stop;     /* "ending with row 2 or row 4"; 0: no choice */
    int                 stop;           /* the same, said of a length: where its last repeat stops; or on which side (lengths.h) */
    struct expr        *n, *sum;        /* sum: "3 times, 6 rows in all"; NULL: not said */
    enum sum_of         sum_of;
    struct again       *then;           /* "then rows 1 and 2 once more" */
};

/* ---- statements ---- */

struct pair {               /* key = value, in a block */
    const char  *key;
    struct span  key_span;
    struct expr *value;
    struct pair *next;
};

struct name_at {            /* a name and where it stands */
    const char     *name;
    struct span     span;
    struct name_at *next;
};

struct formal {
    const char    *name;
    struct span    span;
    struct expr   *value;       /* its default, or NULL */
    struct formal *next;
};

struct symbol {             /* a chart's key: x = P */
    const char    *symbol;
    struct name_at stitch;
    struct span    span;
    struct symbol *next;
};

struct multiple {
    struct expr *of, *plus;     /* plus may be NULL; of NULL: none given */
    struct span  span;
};

struct axis {
    struct name_at param;
    struct range   range;
    struct axis   *next;
};

enum stmt_kind {
    STMT_BAD,
    STMT_VERSION,
    STMT_USE,
    STMT_LET,
    STMT_PARAM,
    STMT_STITCH,
    STMT_MOTIF,
    STMT_SWATCH,
    STMT_BLOCK,
    STMT_OUTPUT,
    STMT_SWEEP,
    STMT_CAST_ON,
    STMT_MULTIPLE,
    STMT_ROW,
    STMT_AGAIN,
    STMT_PATTERN,       /* `these 4 rows form the pattern` */
    STMT_EDGES,         /* `keep 3 sts at each edge in garter st` */
    STMT_STARS,         /* a mark of so many: a repeat begins or ends here */
    STMT_FOR,
    STMT_IF,
    STMT_CHART,
    STMT_PROSE,         /* a line of a page that is no pattern; its span is all of it */
    STMT_PAGE_CHART     /* what a page draws beside its rows; behind all other statements */
};

struct stmt {
    enum stmt_kind kind;
    struct span    span;            /* of its first line, for messages */
    struct stmt   *next;
    union {
        struct { struct expr *number; } version;
        struct { struct name_at *names; struct name_at as; const char *file; struct span file_span; bool std; } use;
        struct { struct name_at name; struct expr *value; } let;
        struct { struct name_at name; struct expr *value; struct range range; const char *about; } param;
        struct { struct name_at name; struct pair *pair; } stitch;
        struct { struct name_at name; struct formal *formal; struct multiple multiple; struct stmt *body; struct expr *value; } motif;
        struct { struct expr *value; } swatch;
        struct { struct name_at name; struct pair *pair; } block;
        struct { struct name_at kind; const char *path; struct span path_span; struct pair *pair; } output;
        struct { struct axis *axis; } sweep;
        struct { struct expr *n; } cast_on;
        struct multiple multiple;
        struct row row;
        struct again again;
        struct told told;
        struct kept_edges edges;
        int stars;
        struct { struct name_at name; struct range range; struct stmt *body; } loop;
        struct { struct expr *condition; struct stmt *then, *otherwise; } choice;
        struct { struct symbol *symbol; struct name_at *line; } chart;      /* lines: texts, top first */
        const struct page_chart *page_chart;
    };
};

/* ---- constructors ---- */

struct parse;

struct expr *expr_bad(struct parse *, struct span);
struct expr *expr_number(struct parse *, struct span, double value, int dimension);
struct expr *expr_text(struct parse *, enum expr_kind, struct span, const char *text);
struct expr *expr_member(struct parse *, struct span, const char *space, const char *name);
struct expr *expr_list(struct parse *, struct span, struct expr *first);
struct expr *expr_operation(struct parse *, enum expr_kind, struct span, enum operator, struct expr *a, struct expr *b,
                            struct expr *c);
struct expr *expr_call(struct parse *, struct span, struct expr *function, struct argument *first);
struct expr *expr_each(struct parse *, struct span, struct name_at x, struct name_at y, struct expr *columns,
                       struct expr *rows, struct expr *cell);
struct argument *ast_argument(struct parse *, struct span, const char *name, struct expr *value);

/* Without a name: several. */
struct item *item_stitch(struct parse *, struct span, const char *name, struct expr *count, struct until);

/* Stitches that show what those below them show, or the other face. */
extern const char item_same[], item_opposite[];
struct item *item_below(struct parse *, struct span, bool opposite, struct until);
bool item_is_below(const struct item *);

/* A pattern that is worked within a row. */
struct item *item_within(struct parse *, struct span, struct within);

/* Markers between two stitches: what is done with one there. */
extern const char item_placed[], item_slipped[], item_removed[];
struct item *item_marker(struct parse *, struct span, const char *done);
bool item_is_marker(const struct item *);
struct item *item_group(struct parse *, enum item_kind, struct span, struct item *child, struct until);

/* `knit 2`: a number stands behind the name. */
struct item *item_stitches(struct parse *, struct span, const char *name, struct span number, double n);

/* What any item says, plain or not: where, and how often it is worked. */
struct span item_span(const struct source *, const struct item *);
struct until item_until(const struct source *, const struct item *);

/* Moves `one` to the next of a plain item's stitches, from length 0 to the first; false behind the last. */
bool item_step(const struct source *, const struct item *, struct item *one);

/* A stitch's name, and a number apart from it: an expression, or in figures. */
struct stitch_words {
    const char        *name;        /* (length) not terminated */
    size_t             length;
    const struct expr *count;       /* or NULL */
    struct span        figures;     /* no source: none */
};
struct stitch_words item_words(const struct source *, const struct item *);
struct row_numbers *ast_row_numbers(struct parse *, struct span, struct expr *first, struct expr *last, enum all_kind);

struct pair *ast_pair(struct parse *, struct span key_span, const char *key, struct expr *value);
struct name_at *ast_name(struct parse *, struct span, const char *name);
struct formal *ast_formal(struct parse *, struct span, const char *name, struct expr *value);
struct symbol *ast_symbol(struct parse *, struct span, const char *symbol, struct name_at stitch);
struct axis *ast_axis(struct parse *, struct name_at param, struct range);

struct stmt *ast_stmt(struct parse *, enum stmt_kind, struct span);
struct stmt *stmt_use(struct parse *, struct span, struct name_at *names, struct name_at as, struct name_at file, bool std);
struct stmt *stmt_let(struct parse *, struct span, struct name_at, struct expr *value);
struct stmt *stmt_param(struct parse *, struct span, struct name_at, struct expr *value, struct range, const char *about);
struct stmt *stmt_block(struct parse *, enum stmt_kind, struct span, struct name_at, struct pair *);
struct stmt *stmt_motif(struct parse *, struct span, struct name_at, struct formal *, struct multiple, struct stmt *body,
                        struct expr *value);
struct stmt *stmt_expr(struct parse *, enum stmt_kind, struct span, struct expr *);
struct stmt *stmt_output(struct parse *, struct span, struct name_at kind, struct name_at path, struct pair *);
struct stmt *stmt_sweep(struct parse *, struct span, struct axis *);
struct stmt *stmt_multiple(struct parse *, struct multiple);
struct stmt *stmt_row(struct parse *, struct span, struct row);
struct stmt *stmt_again(struct parse *, struct span, struct again);
struct stmt *stmt_pattern(struct parse *, struct span, struct told);
struct stmt *stmt_for(struct parse *, struct span, struct name_at, struct range, struct stmt *body);
struct stmt *stmt_if(struct parse *, struct span, struct expr *condition, struct stmt *then, struct stmt *otherwise);
struct stmt *stmt_chart(struct parse *, struct span, struct symbol *, struct name_at *line);

#endif
