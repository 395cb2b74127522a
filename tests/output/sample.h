/* SPDX-License-Identifier: GPL-3.0-or-later
 * For the tests of output: a small scene and a surface made without language
 * and solver, a folder of the test's own, whole files as text. */
#ifndef WEFT_TEST_SAMPLE_H
#define WEFT_TEST_SAMPLE_H

#include <limits.h>

#include "lang/scene.h"
#include "solver/surface.h"

/* 3 columns x 2 rows; a knit, a purl and a stitch of its own "Slip" in it:
 *   row 2   P K Slip
 *   row 1   K P K        */
extern const struct scene sample_scene;

/* Its surface, per_stitch cells a stitch: every value is another number, none
 * of them short in decimal. */
struct surface sample_surface(int per_stitch);

/* A new empty folder, and its end with all that is in it. */
void sample_folder(char folder[PATH_MAX]);
void sample_remove(const char *folder);

/* Names in a folder, hidden ones too. */
int sample_count(const char *folder);

/* A whole file, NUL-terminated; free it.  NULL if there is none. */
char *sample_read(const char *path, size_t *size);

#endif
