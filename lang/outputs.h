/* SPDX-License-Identifier: GPL-3.0-or-later
 * The files a script asks for: kinds by name and by extension. */
#ifndef WEFT_OUTPUTS_H
#define WEFT_OUTPUTS_H

#include "lang/eval.h"

struct outputs {
    struct output *output;
    int            n, room;
    bool           sweep;               /* the script has one: its plots are of all points */
};

/* An `output` statement; an -o of the command line. Errors are in diag. */
void outputs_statement(struct eval *, struct outputs *, const struct stmt *);
void outputs_option(struct eval *, struct outputs *, const struct source *);

#endif
