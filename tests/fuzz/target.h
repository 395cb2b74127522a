/* SPDX-License-Identifier: GPL-3.0-or-later
 * What can be fuzzed: one input into one reader, all that it makes in an arena. */
#ifndef WEFT_TARGET_H
#define WEFT_TARGET_H

#include <stddef.h>

#include "lang/diag.h"

struct target {
    const char *name;
    void      (*run)(struct arena *, struct diag *, const struct source *);
};

/* Ends with name = NULL. A new reader is one line there, and a kind of seeds in seeds.sh. */
extern const struct target targets[];

/* Runs the target of that name and prints its messages to nowhere. */
void target_run(const char *name, const void *bytes, size_t size);

#endif
