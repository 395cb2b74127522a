/* SPDX-License-Identifier: GPL-3.0-or-later
 * Charts that a script uses, read as `weft import` does. */
#ifndef WEFT_CLI_IMPORT_H
#define WEFT_CLI_IMPORT_H

#include "lang/compile.h"

/* For compile_options.chart: by first bytes and extension; a text is a chart if its
 * first row is K and P alone. */
compile_chart import_chart;

#endif
