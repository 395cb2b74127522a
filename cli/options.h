/* SPDX-License-Identifier: GPL-3.0-or-later
 * The command line: argv in, a command with its operands and options out. */
#ifndef WEFT_OPTIONS_H
#define WEFT_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "lang/compile.h"

/* The program's exit status. */
enum status {
    STATUS_DONE   = 0,
    STATUS_FAILED = 1,      /* the run failed, was stopped or did not converge */
    STATUS_USAGE  = 2,
    STATUS_SCRIPT = 3,      /* an error in a script */
    STATUS_FILES  = 4       /* input or output */
};

struct command;

struct options {
    const struct command *command;
    int                   noperands;
    const char          **operand;      /* (noperands) */

    /* What a script is compiled with. */
    int                      ndefines, nsets, nincludes, noutputs;
    struct compile_override *define;    /* (ndefines)  -D name=value */
    struct compile_override *set;       /* (nsets)     "solve.steps" = "5" */
    const char             **include;   /* (nincludes) -I */
    const char             **output;    /* (noutputs)  -o, as given */
    const char              *warnings;  /* "error", or NULL */

    int         threads;                /* 0 = all processors */
    int         seeds;                  /* to fold from; 0 or 1: the scene's own */
    bool        quiet, verbose, dry_run, grid, round, json, check;
    bool        help, version;
    const char *key;                    /* of a picture's colours, or NULL */
    const char *color;                  /* "auto", "always", "never" */
    const char *diagnostics;            /* "human", "json" */
    const char *from;                   /* a manifest to repeat, or NULL */
    const char *start;                  /* a state to begin the fold from, or NULL */
    const char *into;                   /* a folder for what is repeated, or NULL */
    bool        no_manifest, resume, cached, print, collect;
    bool        warm;                   /* points of a sweep may begin at their neighbours */
    int         point;                  /* the one of a sweep to run, from 1; 0: all */
    int         walk;                   /* with warm: the point where its row of folds began; 0: it begins flat */

    int         argc;                   /* the words all of this was made of */
    char      **argv;

    struct arena arena;                 /* owns all of the above that argv does not */
};

/* An option as it is parsed and explained. */
struct option {
    const char *letter;                 /* "-o" or NULL */
    const char *name;                   /* "--steps" or NULL */
    const char *argument;               /* what the help calls its value, NULL: takes none */
    const char *commands;               /* the commands that take it: "run chart", NULL: all */
    bool      (*take)(struct options *options, const struct option *option, const char *value);
    const char *key;                    /* for take: a block's key, or the words allowed: "auto always never" */
    size_t      place;                  /* for take: offset in struct options */
    const char *help;
};

extern const struct option option_table[];      /* ends with help = NULL */

/* Parses argv.  STATUS_USAGE, with the reason on standard error, if it makes no
 * sense; free with options_free in any case. */
enum status options_parse(struct options *options, int argc, char **argv);
void        options_free(struct options *options);

/* Does the command take the option? */
bool options_belong(const struct option *option, const struct command *command);

/* The part a script is compiled with; points into options. */
struct compile_options options_compile(const struct options *options);

/* Are messages coloured? */
bool options_colored(const struct options *options);

/* Says on standard error what is wrong with the command line; STATUS_USAGE. */
enum status options_wrong(const struct options *options, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Is a path of -o written KIND:PATH, with a colon behind its first word? */
bool options_names_kind(const char *path);

#endif
