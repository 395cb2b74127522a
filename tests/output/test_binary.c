/* SPDX-License-Identifier: GPL-3.0-or-later
 * Binary meshes read back byte by byte by a reader of the test's own: PLY, STL
 * and glTF with its growth steps. */
#include <config.h>

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cjson/cJSON.h>
#include <cmocka.h>

#include "output/glb.h"
#include "output/ply.h"
#include "output/stl.h"
#include "tests/output/sample.h"

enum { NX = 6, NY = 4, POINTS = (NX + 1) * (NY + 1), CELLS = NX * NY };

/* ---- numbers, the lowest byte first ---- */

static uint64_t take(const char **at, size_t size)
{
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++)
        value |= (uint64_t)(uint8_t)(*at)[i] << 8 * i;
    *at += size;
    return value;
}

static double take_f64(const char **at)
{
    uint64_t bits = take(at, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static float take_f32(const char **at)
{
    uint32_t bits = (uint32_t)take(at, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static const uint8_t knit[3] = {200, 53, 43}, purl[3] = {47, 95, 168}, slip[3] = {224, 165, 38};
static const uint8_t *const colour_of[2][3] = {{knit, purl, knit}, {purl, knit, slip}};

static size_t corner(size_t cell, int k)
{
    static const size_t along[4] = {0, 1, 1, 0}, up[4] = {0, 0, 1, 1};
    return (cell / NX + up[k]) * (NX + 1) + cell % NX + along[k];
}

/* ---- PLY ---- */

/* The properties, in their order: 57 and 80 bytes. */
static const char ply_header[] =
    "element vertex 35\n"
    "property double x\nproperty double y\nproperty double z\n"
    "property double nx\nproperty double ny\nproperty double nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 24\nproperty list uchar int vertex_indices\n"
    "property int stitch_id\nproperty int row\nproperty int column\nproperty char knit_sign\n"
    "property double kx\nproperty double ky\nproperty double mean_curvature\nproperty double gaussian_curvature\n"
    "property double stretching_density\nproperty double bending_density\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";

static void ply_vertices_read_back(const struct place *p, const char **at)
{
    for (size_t i = 0; i < POINTS; i++) {
        for (size_t k = 0; k < 3; k++)
            assert_true(take_f64(at) == p->surface.position[3 * i + k]);
        for (size_t k = 0; k < 3; k++)
            assert_true(take_f64(at) == p->surface.normal[3 * i + k]);
        if (i == 0)
            assert_memory_equal(*at, knit, 3);
        if (i == 2)             /* between a knit and a purl of row 1 */
            assert_memory_equal(*at, ((uint8_t[]){124, 74, 106}), 3);
        if (i == POINTS - 1)
            assert_memory_equal(*at, slip, 3);
        *at += 3;
    }
}

static void ply_reads_back(void **state)
{
    static const int sign[2][3] = {{1, -1, 1}, {-1, 1, 0}};
    static const double kx[2][3] = {{-1, 1, -1}, {1, -1, 0.1}}, ky[2][3] = {{1, -1, 1}, {-1, 1, 1. / 3}};
    struct place *p = *state;
    const struct surface *s = &p->surface;
    assert_true(ply_write(&p->log, p->path, &sample_scene, s));
    assert_non_null(sample_read_back(p));
    assert_memory_equal(p->bytes, "ply\nformat binary_little_endian 1.0\n", 36);
    assert_non_null(strstr(p->bytes, "\ncomment lost in this format: displacements, growth steps\n"));
    const char *at = strstr(p->bytes, ply_header);
    assert_non_null(at);
    at += sizeof ply_header - 1;
    ply_vertices_read_back(p, &at);
    for (size_t c = 0; c < CELLS; c++) {
        size_t row = c / NX / 2, column = c % NX / 2;
        assert_int_equal(take(&at, 1), 4);
        for (int k = 0; k < 4; k++)
            assert_int_equal(take(&at, 4), corner(c, k));
        assert_int_equal(take(&at, 4), row * 3 + column);
        assert_int_equal(take(&at, 4), row + 1);
        assert_int_equal(take(&at, 4), column + 1);
        assert_int_equal((int8_t)take(&at, 1), sign[row][column]);
        assert_true(take_f64(&at) == kx[row][column] && take_f64(&at) == ky[row][column]);
        assert_true(take_f64(&at) == s->mean[c] && take_f64(&at) == s->gauss[c]);
        assert_true(take_f64(&at) == s->stretching[c] && take_f64(&at) == s->bending[c]);
        assert_memory_equal(at, colour_of[row][column], 3);
        at += 3;
    }
    assert_ptr_equal(at, p->bytes + p->size);
}

/* ---- STL ---- */

static void stl_reads_back(void **state)
{
    static const int order[2][3] = {{0, 1, 2}, {0, 2, 3}};
    struct place *p = *state;
    assert_true(stl_write(&p->log, p->path, &p->surface));
    assert_non_null(sample_read_back(p));
    assert_int_equal(p->size, 84 + 50 * 2 * CELLS);
    assert_true(memcmp(p->bytes, "solid", 5) != 0 && strstr(p->bytes, "Lost: "));
    const char *at = p->bytes + 80;
    assert_int_equal(take(&at, 4), 2 * CELLS);
    for (size_t t = 0; t < 2 * CELLS; t++) {
        float normal[3], v[3][3];
        for (int k = 0; k < 3; k++)
            normal[k] = take_f32(&at);
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++) {
                v[i][k] = take_f32(&at);
                size_t point = corner(t / 2, order[t % 2][i]);
                assert_true(v[i][k] == (float)p->surface.position[3 * point + (size_t)k]);
            }
        /* unit, and square to both sides on the side the corners run around */
        double length = 0, along[2] = {0};
        for (int k = 0; k < 3; k++) {
            length += (double)normal[k] * (double)normal[k];
            for (int i = 0; i < 2; i++)
                along[i] += (double)normal[k] * (double)(v[i + 1][k] - v[0][k]);
        }
        assert_true(fabs(length - 1) < 1e-6 && fabs(along[0]) < 1e-6 && fabs(along[1]) < 1e-6);
        assert_int_equal(take(&at, 2), 0);
    }
}

/* ---- glTF ---- */

struct gltf {
    cJSON      *root;
    const char *binary;
};

static struct gltf gltf_read(struct place *p)
{
    assert_non_null(sample_read_back(p));
    const char *at = p->bytes;
    assert_int_equal(take(&at, 4), 0x46546C67);
    assert_int_equal(take(&at, 4), 2);
    assert_int_equal(take(&at, 4), p->size);
    size_t length = take(&at, 4);
    assert_int_equal(take(&at, 4), 0x4E4F534A);
    assert_int_equal(length % 4, 0);
    struct gltf gltf = {.root = cJSON_ParseWithLength(at, length), .binary = at + length + 8};
    assert_non_null(gltf.root);
    at += length;
    assert_int_equal(take(&at, 4), p->bytes + p->size - gltf.binary);
    assert_int_equal(take(&at, 4), 0x004E4942);
    return gltf;
}

static int number(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItem(object, key);
    assert_true(cJSON_IsNumber(item));
    return item->valueint;
}

/* The bytes of accessor index, which must have this type and count. */
static const char *accessor(const struct gltf *gltf, int index, int component, const char *type, int count)
{
    const cJSON *a = cJSON_GetArrayItem(cJSON_GetObjectItem(gltf->root, "accessors"), index);
    assert_int_equal(number(a, "componentType"), component);
    assert_int_equal(number(a, "count"), count);
    assert_string_equal(cJSON_GetObjectItem(a, "type")->valuestring, type);
    const cJSON *view = cJSON_GetArrayItem(cJSON_GetObjectItem(gltf->root, "bufferViews"), number(a, "bufferView"));
    return gltf->binary + number(view, "byteOffset");
}

static const cJSON *first(const struct gltf *gltf, const char *list)
{
    const cJSON *item = cJSON_GetArrayItem(cJSON_GetObjectItem(gltf->root, list), 0);
    assert_non_null(item);
    return item;
}

/* Three knits, two purls and a slip of nine points each; those that touch at a corner share it. */
enum { VERTICES = 27 - 2 + 18 - 1 + 9 };

/* The surface at step i: every coordinate a little elsewhere, on a grid that floats hold. */
static void move(struct surface *s, int i)
{
    for (size_t k = 0; k < 3 * POINTS; k++)
        s->position[k] = (double)(k % 64) / 8 + i;
}

/* Corner k of triangle t in the file's order: stitch by stitch, cell by cell; its cell in *cell. */
static size_t point_of(size_t t, int k, size_t *cell)
{
    static const int order[2][3] = {{0, 1, 2}, {0, 2, 3}}, stitch[2][3] = {{0, 1, 0}, {1, 0, 2}};
    size_t seen = 0;
    for (int id = 0; id < 3; id++)
        for (size_t c = 0; c < CELLS; c++)
            if (stitch[c / NX / 2][c % NX / 2] == id && seen++ == t / 2) {
                *cell = c;
                return corner(c, order[t % 2][k]);
            }
    return (size_t)-1;
}

/* Linear 0..255 of the three colours. */
static const uint8_t linear[3][4] = {{147, 9, 6, 255}, {7, 29, 100, 255}, {190, 96, 5, 255}};

static void assert_triangles(const struct place *p, const struct gltf *gltf, const cJSON *primitive)
{
    static const int stitch[2][3] = {{0, 1, 0}, {1, 0, 2}};
    const cJSON *attributes = cJSON_GetObjectItem(primitive, "attributes");
    const char *index = accessor(gltf, number(primitive, "indices"), 5125, "SCALAR", 6 * CELLS);
    const char *position = accessor(gltf, number(attributes, "POSITION"), 5126, "VEC3", VERTICES);
    const char *normal = accessor(gltf, number(attributes, "NORMAL"), 5126, "VEC3", VERTICES);
    const char *colour = accessor(gltf, number(attributes, "COLOR_0"), 5121, "VEC4", VERTICES);
    for (size_t t = 0; t < 2 * CELLS; t++) {
        for (int c = 0; c < 3; c++) {
            size_t cell = 0, vertex = take(&index, 4), point = point_of(t, c, &cell);
            assert_true(vertex < VERTICES);
            for (size_t k = 0; k < 3; k++) {
                const char *x = position + 12 * vertex + 4 * k, *n = normal + 12 * vertex + 4 * k;
                assert_true(take_f32(&x) == (float)p->surface.position[3 * point + k]);
                assert_true(take_f32(&n) == (float)p->surface.normal[3 * point + k]);
            }
            assert_memory_equal(colour + 4 * vertex, linear[stitch[cell / NX / 2][cell % NX / 2]], 4);
        }
    }
}

/* Target i takes every vertex to where step i was; its time is when it alone counts.  growth (n + 1). */
static void assert_growth(const struct gltf *gltf, const cJSON *primitive, int n, const double *growth)
{
    const cJSON *sampler = cJSON_GetArrayItem(cJSON_GetObjectItem(first(gltf, "animations"), "samplers"), 0);
    const char *time = accessor(gltf, number(sampler, "input"), 5126, "SCALAR", n + 1);
    const char *weight = accessor(gltf, number(sampler, "output"), 5126, "SCALAR", n * (n + 1));
    const cJSON *targets = cJSON_GetObjectItem(primitive, "targets");
    assert_int_equal(cJSON_GetArraySize(targets), n);
    for (int i = 0; i < n; i++) {
        int at = number(cJSON_GetArrayItem(targets, i), "POSITION");
        const char *delta = accessor(gltf, at, 5126, "VEC3", VERTICES);
        for (int k = 0; k < 3 * VERTICES; k++)
            assert_true(take_f32(&delta) == (float)(i - n));
        assert_true(take_f32(&time) == (float)(4 * growth[i]));
    }
    assert_true(take_f32(&time) == (float)(4 * growth[n]));
    for (int key = 0; key <= n; key++)
        for (int i = 0; i < n; i++)
            assert_true(take_f32(&weight) == (float)(key == i));
}

/* Three steps, the first of the flat sheet, read back; whole: the run came to its end. */
static void check_glb(struct place *p, const double growth[3], bool whole)
{
    struct glb glb = glb_begin(&sample_scene);
    for (int i = 0; i < 3; i++) {
        move(&p->surface, i);
        assert_true(glb_step(&glb, growth[i], &p->surface));
    }
    assert_int_equal(glb.nsteps, whole ? 2 : 3);    /* the end of a whole run comes with glb_write */
    assert_true(glb_write(&glb, &p->log, p->path, whole ? &p->surface : NULL));
    struct gltf gltf = gltf_read(p);
    const cJSON *primitive = cJSON_GetArrayItem(cJSON_GetObjectItem(first(&gltf, "meshes"), "primitives"), 0);
    assert_triangles(p, &gltf, primitive);
    assert_growth(&gltf, primitive, 2, growth);
    cJSON_Delete(gltf.root);
    glb_end(&glb);
}

static void glb_reads_back(void **state)
{
    check_glb(*state, (double[]){0, 0.5, 1}, true);
}

/* Of a run that was stopped the last step is what shows. */
static void glb_stops_at_the_last_step(void **state)
{
    check_glb(*state, (double[]){0, 0.25, 0.5}, false);
}

/* Nothing grew: no targets, no animation, but a mesh. */
static void glb_without_steps(void **state)
{
    struct place *p = *state;
    struct glb glb = glb_begin(&sample_scene);
    assert_true(glb_step(&glb, 1, &p->surface));
    assert_true(glb_write(&glb, &p->log, p->path, &p->surface));
    struct gltf gltf = gltf_read(p);
    assert_null(cJSON_GetObjectItem(gltf.root, "animations"));
    const cJSON *primitive = cJSON_GetArrayItem(cJSON_GetObjectItem(first(&gltf, "meshes"), "primitives"), 0);
    assert_null(cJSON_GetObjectItem(primitive, "targets"));
    assert_triangles(p, &gltf, primitive);
    cJSON_Delete(gltf.root);
    glb_end(&glb);
}

static void glb_keeps_some_of_many_steps(void **state)
{
    struct place *p = *state;
    struct scene scene = sample_scene;
    scene.solve.steps = 1000;
    struct glb glb = glb_begin(&scene);
    for (int i = 0; i <= 1000; i++) {
        double growth = i / 1000.;
        assert_true(glb_step(&glb, growth, glb_wants(&glb, growth) ? &p->surface : NULL));
    }
    assert_int_equal(glb.nsteps, GLB_STEPS);
    assert_true(glb.step[0].growth == 0 && glb.step[1].growth == 0.02 && glb.step[49].growth == 0.98);
    glb_end(&glb);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, sample_begin, sample_end)
    const struct CMUnitTest tests[] = {
        TEST(ply_reads_back), TEST(stl_reads_back), TEST(glb_reads_back),
        TEST(glb_stops_at_the_last_step), TEST(glb_without_steps), TEST(glb_keeps_some_of_many_steps),
    };
    return cmocka_run_group_tests_name("binary meshes", tests, NULL, NULL);
}
