/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script that is a command's result: to the files of -o, or to standard output. */
#ifndef WEFT_DELIVER_H
#define WEFT_DELIVER_H

#include "charts/text.h"
#include "cli/options.h"
#include "lang/grid.h"

/* STATUS_USAGE, with a message, where -o names a kind: `foo:x.knit`. */
enum status deliver_check(const struct options *options);

/* A script of which weft has made the text; name stands for it in messages. It
 * is read again first: STATUS_SCRIPT, with the reason on standard error, if that
 * does not give the grid, because some fabrics are too long for the language's
 * limits. STATUS_FILES, with the reason, if it cannot be written. */
enum status deliver_script(const struct options *options, const struct text *text, const char *name,
                           const struct grid *grid);

#endif
