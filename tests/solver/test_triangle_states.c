/* SPDX-License-Identifier: GPL-3.0-or-later
 * Whole states of another program, each in a folder of its own as that program
 * wrote it, all in the folder that WEFT_REFERENCE names: the triangles give
 * their energies, face by face.  Skipped where it names none. */
#define _GNU_SOURCE
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "solver/memory.h"
#include "tests/solver/reference.h"

/* Reads rows of columns numbers; returns how many rows there are. */
static int read_table(const char *folder, const char *name, int columns, double **table)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "r");
    if (!file)
        fail_msg("cannot read %s", path);
    size_t count = 0, room = 1 << 12;
    *table = memory_array(room, sizeof **table);
    while (fscanf(file, "%lf", *table + count) == 1)
        if (++count == room)
            *table = memory_grow(*table, room *= 2, sizeof **table);
    fclose(file);
    return (int)(count / (size_t)columns);
}

static void read_energies(const char *folder, struct reference *r)
{
    char path[4096], line[1024];
    snprintf(path, sizeof path, "%s/energies.tsv", folder);
    FILE *file = fopen(path, "r");
    if (!file)
        fail_msg("cannot read %s", path);
    while (fgets(line, sizeof line, file))
        sscanf(line, "%*f %*f %lf %lf %lf", &r->stretching, &r->bending, &r->springs);
    fclose(file);
    r->spring = 1e-4 * 0.5;
}

static void read_folder(const char *folder, struct reference *r)
{
    double *rest, *position, *face, *face_edge, *edge_face, *angle, *sign, *energy;
    *r = (struct reference){0};
    read_energies(folder, r);
    r->nvertices = read_table(folder, "rest_vertices.txt", 3, &rest);
    r->nfaces = read_table(folder, "faces.txt", 3, &face);
    r->nedges = read_table(folder, "edge_directors.txt", 1, &angle);
    read_table(folder, "vertices.txt", 3, &position);
    read_table(folder, "face2edges.txt", 3, &face_edge);
    read_table(folder, "edge2faces.txt", 2, &edge_face);
    read_table(folder, "stitch_sign.txt", 1, &sign);
    read_table(folder, "face_energies.txt", 3, &energy);
    r->rest = reference_array(r->nvertices, sizeof *r->rest);
    r->position = reference_array(r->nvertices, sizeof *r->position);
    r->face = reference_array(r->nfaces, sizeof *r->face);
    r->knit = reference_array(r->nfaces, sizeof *r->knit);
    r->angle = reference_array(r->nedges, sizeof *r->angle);
    r->face_energy = reference_array(r->nfaces, sizeof *r->face_energy);
    for (int v = 0; v < r->nvertices; v++) {
        memcpy(r->rest[v], rest + 3 * v, sizeof r->rest[v]);
        memcpy(r->position[v], position + 3 * v, sizeof r->position[v]);
    }
    /* Their angle counts from f0's side of the edge; ours from the side of the face that meets it first. */
    char *met = memory_array((size_t)r->nedges, 1);
    int next = 0;
    for (int f = 0; f < r->nfaces; f++) {
        r->knit[f] = sign[f];
        for (int k = 0; k < 3; k++) {
            int e = (int)face_edge[3 * f + k];
            r->face[f][k] = (int)face[3 * f + k];
            if (!met[e]++)
                r->angle[next++] = edge_face[2 * e] == f ? angle[e] : -angle[e];
        }
        memcpy(r->face_energy[f], energy + 3 * f, sizeof r->face_energy[f]);
    }
    double *table[] = {rest, position, face, face_edge, edge_face, angle, sign, energy};
    for (int k = 0; k < 8; k++)
        free(table[k]);
    free(met);
}

static void folders(void **unused)
{
    (void)unused;
    const char *root = getenv("WEFT_REFERENCE");
    DIR *dir = opendir(root);
    if (!dir)
        fail_msg("cannot read %s", root);
    int states = 0;
    for (struct dirent *entry; (entry = readdir(dir));) {
        char *folder, *file;
        if (entry->d_name[0] == '.' || asprintf(&folder, "%s/%s", root, entry->d_name) < 0)
            continue;
        if (asprintf(&file, "%s/energies.tsv", folder) < 0)
            abort();
        FILE *energies = fopen(file, "r");
        if (energies) {
            struct reference r;
            fclose(energies);
            print_message("# %s\n", entry->d_name);
            read_folder(folder, &r);
            reference_check(&r);
            reference_free(&r);
            states++;
        }
        free(file);
        free(folder);
    }
    closedir(dir);
    assert_true(states > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(folders)};
    if (!getenv("WEFT_REFERENCE") || !*getenv("WEFT_REFERENCE")) {
        puts("1..0 # SKIP WEFT_REFERENCE names no folder of states");
        return 0;
    }
    return cmocka_run_group_tests_name("triangle: whole states of another program", tests, NULL, NULL);
}
