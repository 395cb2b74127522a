/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft run --from`: a manifest in; the run repeated, and whether every output
 * came out the same. */
#ifndef WEFT_REPEAT_H
#define WEFT_REPEAT_H

#include "cli/options.h"

/* Repeats the run of options->from in the folder it was made in, or, where its
 * script is not there, in the manifest's own; writes into options->into or a
 * folder that is removed afterwards.  Nothing the first run wrote is touched.
 * Of a report, "time", "memory", the script's path and the number of threads
 * are not compared.  STATUS_DONE: all the same; STATUS_FAILED: not;
 * STATUS_FILES: no manifest, or the script is missing or another one. */
enum status repeat_run(const struct options *options);

#endif
