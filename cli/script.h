/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script's path in, its scene out; what is wrong is said on standard error. */
#ifndef WEFT_SCRIPT_H
#define WEFT_SCRIPT_H

#include "cli/options.h"

struct script {
    const struct source *source;        /* NULL if it could not be read */
    const struct scene  *scene;         /* NULL after an error */
    double               compile_s;
    struct arena         arena;         /* owns both */
};

/* STATUS_FILES: not readable; STATUS_SCRIPT: errors in the script; STATUS_USAGE:
 * errors in what the command line asks of it.  Free with script_free in any case. */
enum status script_load(struct script *script, const char *path, const struct options *options);

/* STATUS_SCRIPT, with the reason on standard error, where the swatch has other
 * stitches than knit and purl: what knitters exchange has no place for them. */
enum status script_knit_and_purl(const struct scene *scene);

void        script_free(struct script *script);

#endif
