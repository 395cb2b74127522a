/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text that is a command's result: to the files of -o, or to standard output. */
#ifndef WEFT_DELIVER_H
#define WEFT_DELIVER_H

#include "charts/text.h"
#include "cli/options.h"

/* STATUS_FILES, with the reason on standard error, if it cannot be written. */
enum status deliver(const struct options *options, const struct text *text);

#endif
