/* SPDX-License-Identifier: GPL-3.0-or-later
 * Every limit of the language, each with a message of its own (E07..).  They
 * keep a mistake such as `x 99999999` from taking the machine with it. */
#ifndef WEFT_LIMITS_H
#define WEFT_LIMITS_H

enum {
    LIMIT_FILE         = 64 * 1000 * 1000,      /* bytes of one script */
    LIMIT_LINES        = 1000 * 1000,           /* lines of it, or parts of them */
    LIMIT_LINE         = 1000 * 1000,           /* bytes of one line */
    LIMIT_AGAIN        = 50,                    /* times that a script's bytes are read again, and a line's worth of it */
    LIMIT_AGAIN_ALL    = 100 * 1000 * 1000,     /* bytes read again of any script, beside four times its own */
    LIMIT_TEXTS        = 20 * 1000,             /* lines of text between the rows, */
    LIMIT_TEXT         = 100,                   /* of so many bytes each; a longer one is several */
    LIMIT_STATEMENTS   = 120 * 1000,            /* begun in one file; more rows than may be worked */
    LIMIT_NESTING      = 100,                   /* brackets and blocks within each other */
    LIMIT_DEPTH        = 500,                   /* operators and calls within each other in one expression */
    LIMIT_CALLS        = 100,                   /* motifs and definitions that use each other */
    LIMIT_EVALUATION   = 2500,                  /* all of these together, at one moment */
    LIMIT_INCLUDES     = 16,                    /* files that use files */
    LIMIT_STITCHES     = 4 * 1000 * 1000,       /* of one fabric */
    LIMIT_ALL_STITCHES = 64 * 1000 * 1000,      /* of all fabrics made on the way to it */
    LIMIT_ROWS         = 1000 * 1000,           /* of one fabric */
    LIMIT_WRITTEN_ROWS = 100 * 1000,            /* row instructions, loops expanded */
    LIMIT_ITEMS        = 1000 * 1000,           /* stitches and groups in them, loops expanded */
    LIMIT_MARKERS      = 500,                   /* that hang in a row at once */
    LIMIT_STEPS        = 40 * 1000 * 1000,      /* of evaluation */
    LIMIT_NAMES        = 10 * 1000,             /* declared in one file */
    LIMIT_LIST         = 100 * 1000,            /* values of one list or range */
    LIMIT_POINTS       = 1000 * 1000,           /* of a sweep, all axes together */
    LIMIT_OUTPUTS      = 100,                   /* files to write */
    LIMIT_NAME         = 100,                   /* bytes of a name */
    LIMIT_MESSAGES     = 20,                    /* shown in one run */
    LIMIT_ERRORS       = 10 * 1000,             /* after them a script is read no further, */
    LIMIT_WARNINGS     = 100 * 1000,            /* nor after these: one for each written row, */
    LIMIT_BEHIND       = 1000 * 1000,           /* nor behind so many words after the first error */
    LIMIT_PARSER_STACK = 4000                   /* symbols the parser holds */
};

#endif
