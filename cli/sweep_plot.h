/* SPDX-License-Identifier: GPL-3.0-or-later
 * A plot of a sweep: a field of its points' reports in; curves over a param or a
 * map over two out. */
#ifndef WEFT_SWEEP_PLOT_H
#define WEFT_SWEEP_PLOT_H

#include "cli/sweep_point.h"

/* Can it be drawn of this sweep?  STATUS_SCRIPT: why not is said on standard error. */
enum status sweep_plot_check(const struct sweep *sweep, const struct output *output);

/* Draws the points that converged; the others are gaps.  false: see log->error. */
bool sweep_plot_write(const struct sweep *sweep, const struct output *output, struct file_log *log);

#endif
