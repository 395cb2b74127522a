/* SPDX-License-Identifier: GPL-3.0-or-later
 * Whether two texts of one script mean the same. */
#ifndef WEFT_MEANING_H
#define WEFT_MEANING_H

#include "lang/compile.h"

/* Both compile to the same grid of the same stitches, as rows or as rounds; or both have the same errors, by their
 * codes. options may be NULL. */
bool meaning_same(const struct source *, const struct source *, const struct compile_options *);

#endif
