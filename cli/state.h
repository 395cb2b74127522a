/* SPDX-License-Identifier: GPL-3.0-or-later
 * Where a fold ended, on the level it grew on: a file for another fold to begin from. */
#ifndef WEFT_STATE_H
#define WEFT_STATE_H

#include "output/file.h"
#include "solver/fold.h"

/* Begin with all zero. */
struct state {
    const char       *path;
    char              sha256[FILE_HASH];
    struct fold_start start;
    double           *x;        /* (start.n) owned */
};

/* A line "weft state 1", one with columns, rows and n, and n + 1 numbers of 64 bits, the
 * lowest byte first: the energy and x.  false: see log->error. */
bool state_write(struct file_log *log, const char *path, const struct fold_start *start);

/* Reads one; false, with the reason on standard error, if it is none.  Free with state_free in any case. */
bool state_read(struct state *state, const char *path);
void state_free(struct state *state);

#endif
