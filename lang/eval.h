/* SPDX-License-Identifier: GPL-3.0-or-later
 * The evaluator's inside: files and the names in them, values, motifs.  Only
 * the files of lang/ include this; compile.h is the face. */
#ifndef WEFT_EVAL_H
#define WEFT_EVAL_H

#include "lang/ast.h"
#include "lang/compile.h"
#include "lang/names.h"
#include "lang/parse.h"
#include "lang/rows/rows.h"

/* ---- values ---- */

enum value_kind {
    VALUE_BAD,          /* an error was reported */
    VALUE_NUMBER,
    VALUE_STRING,
    VALUE_STITCH,
    VALUE_LIST,
    VALUE_GRID,
    VALUE_MOTIF,        /* rows or a chart that can still take a width */
    VALUE_MAKER         /* a motif that wants its arguments */
};

struct value {
    enum value_kind kind;
    int             dimension;          /* number: power of length; 0 also for lengths in the gauge's unit */
    union {
        double              number;
        const char         *text;
        stitch_id           stitch;
        const struct list  *list;
        const struct grid  *grid;
        struct motif       *motif;
        struct binding     *maker;
    };
};

struct list {
    int           n;
    struct value *item;                 /* (n) */
};

/* ---- names ---- */

enum binding_kind { BINDING_LET, BINDING_PARAM, BINDING_MOTIF, BINDING_STITCH, BINDING_ALIAS, BINDING_SPACE };
enum progress_state { TO_DO, DOING, DONE };

/* A name of a file: evaluated when first wanted. */
struct binding {
    const char         *name;
    enum binding_kind   kind;
    struct span         span;
    struct module      *module;         /* whose name it is; space: the file it stands for */
    const struct stmt  *stmt;
    struct binding     *target;         /* alias */
    enum progress_state state;
    struct value        value;
    enum origin         from;           /* param */
    struct span         given;          /* param: its value on the command line */
    double              low, high;      /* param: its range; low > high: none */
    struct binding     *next;           /* in its bucket */
    struct binding     *after;          /* in the order of the file */
};

/* One file. */
struct module {
    const struct source *source;
    const char          *folder;        /* of the file, for what it uses; NULL: built in */
    const char          *key;           /* its identity: two files of one key are one */
    struct stmt         *file;
    struct page_facts    facts;
    bool                 loading;
    int                  nnames;
    struct binding      *first, *last;
    struct binding      *bucket[64];
    struct module       *next;
};

/* A name inside a motif, a loop, a formula. */
struct local {
    const char   *name;
    struct value  value;
    struct local *up;
};

/* Where an expression is evaluated. */
struct where {
    struct module *module;
    struct local  *local;
};

/* ---- motifs ---- */

struct motif {
    const char         *name;
    struct span         span;           /* of its definition */
    struct span         used;           /* of the place that made it */
    const struct stmt  *stmt;
    struct where        where;          /* what its body sees */
    long long           multiple, plus; /* widths multiple * n + plus, n >= 1; multiple 0: plus alone */
    struct row_list    *rows;           /* made of rows, */
    const struct grid  *grid;           /* or of a chart or formula: one repeat */
    int                 box;            /* its first column that is repeated */
    const struct grid  *natural;        /* kept once made */
};

/* ---- the evaluator ---- */

/* A word of rows that was looked up: patterns have few of them, each a thousand times. */
struct known_word {
    const struct module *module;
    const char          *word;          /* (length) not terminated */
    size_t               length;
    stitch_id            stitch;
    long long            count;         /* as in vocabulary.h */
};
enum { KNOWN_WORDS = 64 };

/* A file that was read for the scene. */
struct used_file {
    const struct source *source;
    struct used_file    *next;
};

struct eval {
    struct arena       *arena;
    struct diag        *diag;
    struct names       *names;
    struct module      *module;         /* all files, the newest first */
    struct module      *main;
    struct used_file    *used;          /* by the main file, the last read first */
    const char *const  *include;        /* folders to look in */
    int                 nincludes, include_depth;
    compile_chart      *chart;          /* reads chart files that are used, or NULL */
    int                 nstitches;
    struct stitch       stitch[STITCH_MAX];
    stitch_id           ws[STITCH_MAX + 1];
    struct binding     *stitch_binding[STITCH_MAX];
    enum origin         stitch_from[STITCH_MAX][5];     /* where each key's value comes from */
    struct known_word   known[KNOWN_WORDS];
    long long           steps, cells, items;
    int                 depth, calls, written_rows;
    struct span         refused;        /* the line of a stitch that was refused last */
    bool                exhausted;      /* a limit of time was reported */
    bool                moss;           /* that 'moss' stitches are taken as seed was said */
    const char         *word_K, *word_P, *word_pi;
    const char        **function;       /* names of the built-in functions, in their table's order */
};

void eval_init(struct eval *, struct arena *, struct diag *);

/* eval.c: expressions */
struct value eval_expr(struct eval *, struct where, const struct expr *);
struct value eval_binding(struct eval *, struct binding *, struct span used);
bool eval_number(struct eval *, struct where, const struct expr *, int dimension, double *number);
bool eval_whole(struct eval *, struct where, const struct expr *, long long low, long long high, const char *what,
                long long *number);
bool eval_range(struct eval *, struct where, const struct range *, double **point, int *n);
bool eval_step(struct eval *, struct span);
const char *value_type(struct value);

static inline struct value value_number(double number, int dimension)
{
    return (struct value){.kind = VALUE_NUMBER, .dimension = dimension, .number = number};
}

static inline struct value value_grid(const struct grid *grid)
{
    return (struct value){.kind = grid ? VALUE_GRID : VALUE_BAD, .grid = grid};
}

/* module.c: files and names */
struct module *module_main(struct eval *, const struct source *, const char *folder);
struct binding *module_find(const struct module *, const char *name);
struct binding *binding_target(struct binding *);
void module_unknown(struct eval *, struct where, const char *name, struct span);

/* builtin.c: functions */
struct builtin;
void builtin_init(struct eval *);
const struct builtin *builtin_find(const struct eval *, const char *name);
struct value builtin_call(struct eval *, struct where, const struct builtin *, const struct expr *call);
void builtin_offer(struct nearest *);

/* motif.c: motifs and fabrics */
struct value motif_make(struct eval *, struct binding *, struct where, const struct expr *call, struct span used);
const struct grid *motif_grid(struct eval *, struct motif *, long long width, long long height, struct span);
int motif_rows(const struct motif *);
const struct grid *fabric_of(struct eval *, struct value, struct span);
bool fabric_size(struct eval *, struct span, long long columns, long long rows);

/* body.c: rows and charts of a body */
struct body {
    struct row_list   *rows;
    const struct grid *chart;
    int                box, box_width;  /* the repeat a chart marks with | .. |; width 0: none */
    bool               round;           /* what its rows are where their statements do not say */
    bool               top;             /* rows of the file itself: cast on is allowed */
    long long          cast_on;         /* 0: none */
    struct span        cast_on_span;
    bool               misplaced;       /* one stood behind rows */
    struct multiple    multiple;
    struct row_edges  *edges;           /* kept from here on; or NULL */
    struct between    *between;         /* the pattern that rows work between other stitches; NULL: none does */
    int                in_pattern;      /* the last row `in pattern`; 0: none */
    int                period;          /* the rows before it, and before those in pattern right before it */
    bool               failed;
    struct span        first;           /* of its first statement */
};
bool body_describes(const struct stmt *);   /* its rows above the cast-on are patterns, worked by their names */
bool body_in_rounds(const struct stmt *);   /* by the first row that says what it is */
void body_run(struct eval *, struct where, const struct stmt *, struct body *);
void body_statement(struct eval *, struct where, const struct stmt *, struct body *);

/* body_again.c: `repeat rows 1-4 5 times`, `continue in pattern for 8 rows`; false after an error */
bool body_again(struct eval *, struct where, const struct stmt *, const struct again *, struct body *);

/* body_pattern.c: the text of a row that works a pattern between other stitches, NULL after an error; that the pattern's rows
 * between these are the pattern from here on; whether one of them was worked last,
 * where these begin at a place, 0: at any */
struct row_text *body_of_pattern(struct eval *, struct where, const struct row *, struct body *);
void body_tell_pattern(struct body *);
bool body_works_between(struct body *, unsigned from);

/* stitches.c: kinds of stitches */
enum { STITCH_KEYS = 5 };       /* kx, ky, twist, symbol, ws */
void stitches_declare(struct eval *, struct module *);
void stitches_evaluate(struct eval *);
bool stitches_override(struct eval *, const char *name, const char *key, struct span, const struct expr *value);
void stitches_finish(struct eval *);
int stitches_settings(struct eval *, struct setting *);

/* library.c */
const struct source *library_source(struct arena *, const char *motif);
void library_offer(struct nearest *);

#endif
