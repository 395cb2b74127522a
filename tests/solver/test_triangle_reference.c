/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state of another program on an unstructured mesh, kept here in a compact
 * form: the triangles give its energies. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <cmocka.h>

#include "tests/solver/reference.h"

static void compact_state(void **unused)
{
    (void)unused;
    char path[4096], line[512];
    const char *source = getenv("WEFT_SOURCE");
    snprintf(path, sizeof path, "%s/tests/solver/states/chains_6x8.txt", source ? source : ".");
    FILE *file = fopen(path, "r");
    if (!file)
        fail_msg("cannot read %s", path);
    struct reference r = {.spring = 1e-4 * 0.5};
    do
        assert_non_null(fgets(line, sizeof line, file));
    while (line[0] == '#');
    assert_int_equal(sscanf(line, "%d %d %d", &r.nvertices, &r.nfaces, &r.nedges), 3);
    assert_int_equal(fscanf(file, "%lf %lf %lf", &r.stretching, &r.bending, &r.springs), 3);
    r.rest = reference_array(r.nvertices, sizeof *r.rest);
    r.position = reference_array(r.nvertices, sizeof *r.position);
    r.face = reference_array(r.nfaces, sizeof *r.face);
    r.knit = reference_array(r.nfaces, sizeof *r.knit);
    r.angle = reference_array(r.nedges, sizeof *r.angle);
    for (int v = 0; v < r.nvertices; v++)
        assert_int_equal(fscanf(file, "%lf %lf %lf %lf %lf", &r.rest[v][0], &r.rest[v][1], &r.position[v][0],
                                &r.position[v][1], &r.position[v][2]), 5);
    for (int f = 0; f < r.nfaces; f++) {
        char stitch;
        assert_int_equal(fscanf(file, "%d %d %d %c", &r.face[f][0], &r.face[f][1], &r.face[f][2], &stitch), 4);
        r.knit[f] = stitch == 'k' ? 1 : -1;
    }
    for (int e = 0; e < r.nedges; e++)
        assert_int_equal(fscanf(file, "%lf", &r.angle[e]), 1);
    fclose(file);
    reference_check(&r);
    reference_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(compact_state)};
    return cmocka_run_group_tests_name("triangle: a state of another program", tests, NULL, NULL);
}
