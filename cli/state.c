/* SPDX-License-Identifier: GPL-3.0-or-later
 * Where a fold ended, on the level it grew on: a file for another fold to begin from. */
#include <config.h>

#include "cli/state.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/little.h"
#include "solver/memory.h"

static const char title[] = "weft state 1\n";

bool state_write(struct file_log *log, const char *path, const struct fold_start *start)
{
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    file_print(file, "%s%d %d %d\n", title, start->columns, start->rows, start->n);
    little_f64(file, start->energy);
    for (int i = 0; i < start->n; i++)
        little_f64(file, start->x[i]);
    return file_commit(file);
}

static bool read_number(FILE *stream, double *number)
{
    unsigned char byte[8];
    uint64_t bits = 0;
    if (fread(byte, sizeof byte, 1, stream) != 1)
        return false;
    for (size_t i = 0; i < sizeof byte; i++)
        bits |= (uint64_t)byte[i] << 8 * i;
    memcpy(number, &bits, sizeof bits);
    return true;
}

/* Is the rest of the file what so many numbers take? */
static bool holds_numbers(FILE *stream, long n)
{
    long here = ftell(stream);
    if (here < 0 || fseek(stream, 0, SEEK_END) != 0 || ftell(stream) - here != 8 * n)
        return false;
    return fseek(stream, here, SEEK_SET) == 0;
}

static bool read_all(struct state *state, FILE *stream)
{
    struct fold_start *start = &state->start;
    char line[sizeof title + 40], end;
    if (!fgets(line, sizeof line, stream) || strcmp(line, title) != 0 || !fgets(line, sizeof line, stream) ||
        sscanf(line, "%d %d %d%c", &start->columns, &start->rows, &start->n, &end) != 4 || start->n < 0 ||
        !holds_numbers(stream, 1L + start->n))
        return false;
    start->x = state->x = MEMORY_ARRAY(double, start->n);
    bool read = read_number(stream, &start->energy);
    for (int i = 0; read && i < start->n; i++)
        read = read_number(stream, &state->x[i]);
    return read;
}

bool state_read(struct state *state, const char *path)
{
    FILE *stream = fopen(path, "rb");
    bool there = stream && file_hash_path(path, state->sha256);
    const char *why = there ? "this is no state of a fold, or a damaged one" : strerror(errno);
    bool read = there && read_all(state, stream);
    state->path = path;
    if (!read)
        fprintf(stderr, "weft: cannot start from '%s': %s\n", path, why);
    if (stream)
        fclose(stream);
    return read;
}

void state_free(struct state *state)
{
    free(state->x);
}
