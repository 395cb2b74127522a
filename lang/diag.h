/* SPDX-License-Identifier: GPL-3.0-or-later
 * Messages about a script: where (a byte span of a source), what, and what to
 * do.  They are collected, so that one run reports several errors, and printed
 * at the end: for people with the line and a caret, for editors as JSON. */
#ifndef WEFT_DIAG_H
#define WEFT_DIAG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "lang/arena.h"
#include "lang/codes.h"
#include "lang/limits.h"

/* One text: a file, standard input, or what the command line said. */
struct source {
    const char *name;           /* as given; "-" is standard input */
    const char *text;           /* NUL-terminated; may hold further NULs */
    size_t      size;           /* bytes */
    bool        command_line;   /* the text is an option's: no line or column is printed */
};

/* Bytes start .. end-1 of a source; no source: nowhere in particular. */
struct span {
    const struct source *source;
    unsigned             start, end;
};

enum severity { SEVERITY_ERROR, SEVERITY_WARNING };

/* A line below a message: with a place (the other side of a conflict, the
 * place that used a motif), without one, or a hint what to write instead. */
struct note {
    struct span        span;
    const char        *text;
    bool               hint;
    const struct note *next;
};

/* What is being worked on, outermost behind: each error inside it says so. */
struct context {
    struct span           span;         /* the place that uses it */
    const char           *what;         /* "in motif 'flag', used here" */
    const struct context *up;
};

struct message {
    enum severity      severity;
    enum diag_code     code;
    struct span        span;
    const char        *text;
    struct note       *note;        /* first .. last */
    struct note       *last;
    const struct note *context;     /* printed behind them */
    struct message    *next;
};

struct diag {
    struct arena   *arena;
    struct message *first, *last;   /* in the order found */
    struct message *open;           /* takes notes; NULL when the last one was dropped */
    int             nerrors;        /* all, also those past the limit of what is kept */
    int             nwarnings;
    bool            full;           /* said that there are too many */
    bool            warnings_are_errors;
    bool            errors_only;    /* warnings are counted, not kept */
    const struct context *context;  /* set and put back by whoever enters and leaves */
};

void diag_init(struct diag *, struct arena *);

/* Records a message; its text is a sentence without a full stop.  A second
 * message of the same code at the same place is dropped. */
void diag_error(struct diag *, enum diag_code, struct span, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
void diag_warning(struct diag *, enum diag_code, struct span, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* How many there are of those that may be shown. */
static inline int diag_number(const struct diag *diag)
{
    return diag->nerrors + (diag->errors_only ? 0 : diag->nwarnings);
}

/* Whether one more would be shown, or only counted. */
static inline bool diag_takes_more(const struct diag *diag)
{
    return diag_number(diag) < LIMIT_MESSAGES;
}

/* Whether the message recorded last is one that will be shown: what to do about it is worth finding out. */
static inline bool diag_takes_notes(const struct diag *diag)
{
    return diag->open != NULL;
}

/* Whether there are so many that no more is worth reading: says so, once, at this place. */
bool diag_is_full(struct diag *, struct span);

/* Added to the message recorded last. */
void diag_note(struct diag *, struct span, const char *format, ...) __attribute__((format(printf, 3, 4)));
void diag_hint(struct diag *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* "did you mean 'nearest'?", where nearest is not NULL. */
void diag_did_you_mean(struct diag *, const char *nearest);

enum diag_style { DIAG_HUMAN, DIAG_JSON };

/* Writes every message, then (for people) how many were left out. */
void diag_print(const struct diag *, FILE *, enum diag_style, bool color);

/* Where a span starts: line and column from 1, the column in characters; end is
 * the column behind its last character on that line. */
struct place {
    int line, column, end;
};
struct place diag_place(struct span);

/* The whole line a span starts on, without its line end. */
struct span diag_line_around(struct span);

/* "E0301" */
const char *diag_code_name(enum diag_code, char name[static 6]);

/* Every code and what it stands for, in order, for the manual's index. */
struct diag_code_info {
    enum diag_code code;
    const char    *about;
};
extern const struct diag_code_info diag_codes[];
extern const int diag_ncodes;

/* A span from the start of a to the end of b (of one source). */
static inline struct span span_join(struct span a, struct span b)
{
    if (a.source == b.source && b.end > a.end)
        a.end = b.end;
    return a;
}

#endif
