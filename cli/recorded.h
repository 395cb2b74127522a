/* SPDX-License-Identifier: GPL-3.0-or-later
 * A manifest that stands beside a run's outputs: its path in, what it says of
 * that run out. */
#ifndef WEFT_RECORDED_H
#define WEFT_RECORDED_H

#include "cli/options.h"
#include "output/file.h"
#include "output/json.h"

enum { RECORDED_WHY = 400 };

/* Begin with all zero. */
struct recorded {
    cJSON         *root;        /* as json_parse has it */
    struct options options;     /* of the run; its words stay the root's */
    char         **argv;
    char           why[RECORDED_WHY];   /* what is wrong with it */
};

/* Reads the manifest; false: why.  Free with recorded_free in any case. */
bool recorded_read(struct recorded *recorded, const char *path);
void recorded_free(struct recorded *recorded);

/* Parses its command line, called by the name of this program; threads: those it had.  false: why. */
bool recorded_parse(struct recorded *recorded, char *program);

/* Members of it: of the command, a text ("" where there is none), a whole number (0). */
const cJSON *recorded_command(const struct recorded *recorded);
const char  *recorded_text(const cJSON *object, const char *key);
int          recorded_integer(const cJSON *object, const char *key);

/* Is a file the same as the output it lists, as far as that lasts? */
bool recorded_same(const cJSON *output, const struct file_entry *entry);

#endif
