/* SPDX-License-Identifier: GPL-3.0-or-later
 * For the tests of output: a small scene and a surface made without language
 * and solver, a folder of the test's own, whole files as text. */
#include <config.h>

#include "tests/output/sample.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const stitch_id cells[] = {0, 1, 0, 1, 0, 2};
static const struct grid grid = {.columns = 3, .rows = 2, .cell = cells};

static const struct stitch stitches[] = {
    {.name = "K", .symbol = "k", .kx = -1, .ky = 1, .ws = STITCH_P},
    {.name = "P", .symbol = "p", .kx = 1, .ky = -1, .ws = STITCH_K},
    {.name = "Slip", .symbol = "<>", .kx = 0.1, .ky = 1. / 3, .ws = 2},
};

static const struct setting settings[] = {
    {.name = "thickness", .unit = "length", .number = 0.5, .from = FROM_DEFAULT, .low = 1},
    {.name = "method", .unit = "", .text = "auto", .from = FROM_FILE, .low = 1},
    {.name = "half", .unit = "", .number = 1. / 3, .from = FROM_COMMAND_LINE, .is_param = true, .low = 0, .high = 1},
};

const struct scene sample_scene = {
    .file = "a \"quoted\" \xFF name.knit",
    .grid = &grid,
    .nstitches = 3,
    .stitch = stitches,
    .gauge = {1.4, 1.2},
    .solve = {.steps = 2, .seed = UINT64_MAX},
    .nsettings = 3,
    .setting = settings,
};

static void fill(double *array, size_t n, double seed)
{
    for (size_t i = 0; i < n; i++)
        array[i] = sin(seed + (double)i) / 3;
}

struct surface sample_surface(int per_stitch)
{
    struct surface s = surface_make(grid.columns, grid.rows, per_stitch);
    size_t points = (size_t)(s.nx + 1) * (size_t)(s.ny + 1), ncells = (size_t)s.nx * (size_t)s.ny;
    fill(s.position, 3 * points, 1);
    fill(s.normal, 3 * points, 2);
    fill(s.displacement, 3 * points, 3);
    fill(s.mean, ncells, 4);
    fill(s.gauss, ncells, 5);
    fill(s.stretching, ncells, 6);
    fill(s.bending, ncells, 7);
    return s;
}

void sample_folder(char folder[PATH_MAX])
{
    const char *parent = getenv("TMPDIR");
    snprintf(folder, PATH_MAX, "%s/weft-test-XXXXXX", parent ? parent : P_tmpdir);
    if (!mkdtemp(folder)) {
        perror(folder);
        exit(1);
    }
}

int sample_count(const char *folder)
{
    int count = 0;
    DIR *stream = opendir(folder);
    for (struct dirent *entry; stream && (entry = readdir(stream));)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    if (stream)
        closedir(stream);
    return count;
}

void sample_remove(const char *folder)
{
    DIR *stream = opendir(folder);
    for (struct dirent *entry; stream && (entry = readdir(stream));) {
        char path[2 * PATH_MAX];
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            remove(path);
    }
    if (stream)
        closedir(stream);
    rmdir(folder);
}

char *sample_read(const char *path, size_t *size)
{
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return NULL;
    fseek(stream, 0, SEEK_END);
    *size = (size_t)ftell(stream);
    rewind(stream);
    char *text = calloc(*size + 1, 1);
    if (text && fread(text, 1, *size, stream) != *size)
        abort();
    fclose(stream);
    return text;
}

/* ---- for cmocka ---- */

int sample_begin(void **state)
{
    struct place *place = calloc(1, sizeof *place);
    sample_folder(place->folder);
    sample_path(place, "x");
    place->surface = sample_surface(2);
    *state = place;
    return 0;
}

int sample_end(void **state)
{
    struct place *place = *state;
    sample_remove(place->folder);
    file_log_free(&place->log);
    surface_free(&place->surface);
    free(place->bytes);
    free(place);
    return 0;
}

const char *sample_path(struct place *place, const char *name)
{
    snprintf(place->path, sizeof place->path, "%s/%s", place->folder, name);
    return place->path;
}

const char *sample_read_back(struct place *place)
{
    free(place->bytes);
    place->bytes = sample_read(place->path, &place->size);
    return place->bytes;
}

char sample_shared[PATH_MAX];

int sample_shared_begin(void **state)
{
    (void)state;
    sample_folder(sample_shared);
    return 0;
}

int sample_shared_end(void **state)
{
    (void)state;
    sample_remove(sample_shared);
    return 0;
}
