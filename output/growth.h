/* SPDX-License-Identifier: GPL-3.0-or-later
 * How a fabric grew: the steps of a fold's record in, a plot or a table of them out. */
#ifndef WEFT_GROWTH_H
#define WEFT_GROWTH_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

/* What output->graph asks for over growth: the energies (springs only where there
 * are any), or the largest gradient and the iterations of each step.  false, with
 * log->error set, if the file could not be written. */
bool growth_plot(struct file_log *log, const struct output *output, const struct fold_record *record);

/* The steps as CSV: a line of names, those of the report's steps, and a line for
 * each step; numbers read back exactly, what is not finite is empty. */
bool growth_table(struct file_log *log, const char *path, const struct fold_record *record);

#endif
