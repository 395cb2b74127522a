/* SPDX-License-Identifier: GPL-3.0-or-later
 * Params: their defaults and ranges, what -D makes of them, sweeps over them. */
#ifndef WEFT_PARAMS_H
#define WEFT_PARAMS_H

#include "lang/eval.h"

/* What the command line gave, as a text to point at, and its value's expression. */
struct option_value {
    struct source source;
    struct span   name;
    struct expr  *value;
};
const struct option_value *option_parse(struct eval *, const struct compile_override *);

/* -D name=value. */
void params_define(struct eval *, const struct compile_override *);

/* Works out every param and checks it against its range. */
void params_evaluate(struct eval *);

int params_count(const struct eval *);
int params_settings(struct eval *, struct setting *);

/* A sweep statement's axes. Errors are in diag. */
const struct sweep_axis *params_sweep(struct eval *, const struct stmt *, int *naxes);

#endif
