/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft run --cached`: a run about to begin in; whether all that it would write
 * stands there already out. */
#ifndef WEFT_CACHED_H
#define WEFT_CACHED_H

#include "cli/run.h"

/* Is the manifest there the one this run would write (same build, libraries and
 * machine, same sources, parameters, outputs asked for, seeds and threads), of a
 * fold that converged, and does every output it lists stand as it was?  A report
 * is compared as --from does it: not its times and memory.  Says so on standard output
 * unless quiet; if not so, with -v, why not on standard error.  Of the run,
 * script and outputs must be begun. */
bool cached_holds(const struct run *run);

#endif
