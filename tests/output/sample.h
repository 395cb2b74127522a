/* SPDX-License-Identifier: GPL-3.0-or-later
 * For the tests of output: a small scene and a surface made without language
 * and solver, a folder of the test's own, whole files as text. */
#ifndef WEFT_TEST_SAMPLE_H
#define WEFT_TEST_SAMPLE_H

#include <limits.h>

#include "lang/scene.h"
#include "output/file.h"
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

/* What a test that writes files has. */
struct place {
    char            folder[PATH_MAX], path[PATH_MAX + 64];      /* a file in the folder: "x", or as sample_path says */
    struct file_log log;
    struct surface  surface;        /* 2 cells along a stitch's side: 6 x 4 */
    char           *bytes;          /* (size) of the file read last */
    size_t          size;
};

/* Set-up and tear-down of each test, for cmocka: *state is its place. */
int sample_begin(void **state);
int sample_end(void **state);

/* Names the place's file; its path. */
const char *sample_path(struct place *place, const char *name);

/* Reads the place's file; NULL if there is none. */
const char *sample_read_back(struct place *place);

/* A folder for all tests of a group, with its set-up and tear-down. */
extern char sample_shared[PATH_MAX];
int sample_shared_begin(void **state);
int sample_shared_end(void **state);

/* Names in a folder, hidden ones too. */
int sample_count(const char *folder);

/* A whole file, NUL-terminated; free it.  NULL if there is none. */
char *sample_read(const char *path, size_t *size);

#endif
