/* SPDX-License-Identifier: GPL-3.0-or-later
 * Meshes read back by a reader of the test's own: every array of a VTP, every
 * step of a PVD, every vertex and face of an OBJ. */
#include <config.h>

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>

#include "output/obj.h"
#include "output/pvd.h"
#include "output/vtp.h"
#include "tests/output/sample.h"

/* A whole file of the folder; free it. */
static char *read_in(struct place *p, const char *name, size_t *size)
{
    char *text = sample_read(sample_path(p, name), size);
    assert_non_null(text);
    return text;
}

/* ---- a reader of VTP ---- */

enum { POINTS = 7 * 5, CELLS = 6 * 4 };

struct vtp {
    char  *text;
    size_t size;
    bool   ascii;
};

/* The value of an attribute in the tag that starts at tag, copied. */
static void attribute(const char *tag, const char *name, char value[64])
{
    char key[64];
    snprintf(key, sizeof key, " %s=\"", name);
    const char *end = strchr(tag, '>'), *at = strstr(tag, key);
    assert_true(at && at < end);
    at += strlen(key);
    size_t length = strcspn(at, "\"");
    assert_true(length < 64);
    memcpy(value, at, length);
    value[length] = '\0';
}

static const char *array_tag(const struct vtp *vtp, const char *name)
{
    char key[64];
    snprintf(key, sizeof key, "Name=\"%s\"", name);
    const char *at = strstr(vtp->text, key);
    assert_non_null(at);
    while (*at != '<')
        at--;
    return at;
}

/* Reads n numbers of an array as doubles, whatever they are stored as. */
static void read_array(const struct vtp *vtp, const char *name, size_t n, double *out)
{
    const char *tag = array_tag(vtp, name);
    char type[64], format[64], offset[64];
    attribute(tag, "type", type);
    attribute(tag, "format", format);
    if (vtp->ascii) {
        assert_string_equal(format, "ascii");
        const char *at = strchr(tag, '>') + 1;
        for (size_t i = 0; i < n; i++) {
            char *end;
            out[i] = strtod(at, &end);
            assert_true(end > at);
            at = end;
        }
        assert_memory_equal(at + strspn(at, " \n"), "</DataArray>", 12);
        return;
    }
    assert_string_equal(format, "appended");
    attribute(tag, "offset", offset);
    const char *data = strstr(vtp->text, "<AppendedData encoding=\"raw\">");
    assert_non_null(data);
    data = strchr(data, '_') + 1 + strtoull(offset, NULL, 10);
    uint64_t bytes;
    memcpy(&bytes, data, sizeof bytes);
    data += sizeof bytes;
    assert_true(data + bytes <= vtp->text + vtp->size);
    size_t width = bytes / n;
    assert_int_equal(bytes % n, 0);
    for (size_t i = 0; i < n; i++, data += width) {
        double f64;
        int64_t i64;
        int32_t i32;
        int8_t i8;
        if (strcmp(type, "Float64") == 0 && width == 8)
            memcpy(&f64, data, 8), out[i] = f64;
        else if (strcmp(type, "Int64") == 0 && width == 8)
            memcpy(&i64, data, 8), out[i] = (double)i64;
        else if (strcmp(type, "Int32") == 0 && width == 4)
            memcpy(&i32, data, 4), out[i] = i32;
        else if (strcmp(type, "Int8") == 0 && width == 1)
            memcpy(&i8, data, 1), out[i] = i8;
        else
            fail_msg("array %s: %s of %zu bytes", name, type, width);
    }
}

static void assert_array(const struct vtp *vtp, const char *name, size_t n, const double *wanted)
{
    double *got = calloc(n, sizeof *got);
    read_array(vtp, name, n, got);
    assert_memory_equal(got, wanted, n * sizeof *got);
    free(got);
}

static int column(int cell)
{
    return cell % 6 / 2;
}

static int row(int cell)
{
    return cell / 6 / 2;
}

/* Everything a VTP of the sample must hold. */
static void assert_vtp(struct place *p, enum output_format format)
{
    assert_true(vtp_write(&p->log, sample_path(p, "x.vtp"), &sample_scene, &p->surface, format));
    struct vtp vtp = {.ascii = format == FORMAT_ASCII};
    vtp.text = read_in(p, "x.vtp", &vtp.size);
    char value[64];
    attribute(strstr(vtp.text, "<VTKFile"), "header_type", value);
    assert_string_equal(value, "UInt64");
    attribute(strstr(vtp.text, "<Piece"), "NumberOfPoints", value);
    assert_int_equal(atoi(value), POINTS);
    attribute(strstr(vtp.text, "<Piece"), "NumberOfPolys", value);
    assert_int_equal(atoi(value), CELLS);
    assert_memory_equal(vtp.text + vtp.size - 11, "</VTKFile>\n", 11);

    assert_array(&vtp, "position", 3 * POINTS, p->surface.position);
    assert_array(&vtp, "normal", 3 * POINTS, p->surface.normal);
    assert_array(&vtp, "displacement", 3 * POINTS, p->surface.displacement);
    assert_array(&vtp, "mean_curvature", CELLS, p->surface.mean);
    assert_array(&vtp, "gaussian_curvature", CELLS, p->surface.gauss);
    assert_array(&vtp, "stretching_density", CELLS, p->surface.stretching);
    assert_array(&vtp, "bending_density", CELLS, p->surface.bending);

    double id[CELLS], rows[CELLS], columns[CELLS], sign[CELLS], kx[CELLS], ky[CELLS], corner[4 * CELLS], end[CELLS];
    read_array(&vtp, "stitch_id", CELLS, id);
    read_array(&vtp, "row", CELLS, rows);
    read_array(&vtp, "column", CELLS, columns);
    read_array(&vtp, "knit_sign", CELLS, sign);
    read_array(&vtp, "kx", CELLS, kx);
    read_array(&vtp, "ky", CELLS, ky);
    read_array(&vtp, "connectivity", 4 * CELLS, corner);
    read_array(&vtp, "offsets", CELLS, end);
    static const double wanted_sign[2][3] = {{1, -1, 1}, {-1, 1, 0}}, wanted_kx[2][3] = {{-1, 1, -1}, {1, -1, 0.1}};
    static const double wanted_ky[2][3] = {{1, -1, 1}, {-1, 1, 1. / 3}};
    for (int c = 0; c < CELLS; c++) {
        int first = c / 6 * 7 + c % 6;
        assert_true(id[c] == row(c) * 3 + column(c) && rows[c] == row(c) + 1 && columns[c] == column(c) + 1);
        assert_true(sign[c] == wanted_sign[row(c)][column(c)]);
        assert_true(kx[c] == wanted_kx[row(c)][column(c)] && ky[c] == wanted_ky[row(c)][column(c)]);
        assert_true(corner[4 * c] == first && corner[4 * c + 1] == first + 1);
        assert_true(corner[4 * c + 2] == first + 8 && corner[4 * c + 3] == first + 7);
        assert_true(end[c] == 4 * (c + 1));
    }
    free(vtp.text);
}

static void binary_vtp_reads_back(void **state)
{
    assert_vtp(*state, FORMAT_BINARY);
}

static void ascii_vtp_reads_back(void **state)
{
    assert_vtp(*state, FORMAT_ASCII);
}

static void vtp_is_the_same_twice(void **state)
{
    struct place *p = *state;
    assert_true(vtp_write(&p->log, sample_path(p, "a.vtp"), &sample_scene, &p->surface, FORMAT_BINARY));
    assert_true(vtp_write(&p->log, sample_path(p, "b.vtp"), &sample_scene, &p->surface, FORMAT_BINARY));
    assert_string_equal(p->log.entry[0].sha256, p->log.entry[1].sha256);
}

/* ---- PVD ---- */

/* After each step, the collection names as many files as there are, all complete. */
static void collection_is_valid_after_each_step(void **state)
{
    struct place *p = *state;
    char path[PATH_MAX + 64];
    snprintf(path, sizeof path, "%s/my & rib.v1.pvd", p->folder);
    struct pvd pvd = pvd_begin(&p->log, path, &sample_scene, FORMAT_BINARY);
    static const char *const entry[] = {
        "<DataSet timestep=\"0\" part=\"0\" file=\"my &amp; rib.v1_00.vtp\"/>",
        "<DataSet timestep=\"0.3333333333333333\" part=\"0\" file=\"my &amp; rib.v1_01.vtp\"/>",
        "<DataSet timestep=\"1\" part=\"0\" file=\"my &amp; rib.v1_02.vtp\"/>",
    };
    static const double growth[] = {0, 1. / 3, 1};
    for (int i = 0; i < 3; i++) {
        assert_true(pvd_step(&pvd, growth[i], &p->surface));
        char name[64];
        size_t size;
        char *text = read_in(p, "my & rib.v1.pvd", &size);
        for (int j = 0; j < 3; j++)
            assert_int_equal(strstr(text, entry[j]) != NULL, j <= i);
        assert_non_null(strstr(text, "</VTKFile>"));
        free(text);
        snprintf(name, sizeof name, "my & rib.v1_0%d.vtp", i);
        text = read_in(p, name, &size);
        assert_memory_equal(text + size - 11, "</VTKFile>\n", 11);
        free(text);
        assert_int_equal(sample_count(p->folder), i + 2);
    }
    assert_int_equal(p->log.nentries, 4);
    pvd_end(&pvd);
}

static void many_steps_sort_by_name(void **state)
{
    struct place *p = *state;
    struct scene scene = sample_scene;
    scene.solve.steps = 100;
    struct pvd pvd = pvd_begin(&p->log, sample_path(p, "x.pvd"), &scene, FORMAT_BINARY);
    assert_true(pvd_step(&pvd, 0, &p->surface));
    assert_int_equal(access(sample_path(p, "x_000.vtp"), R_OK), 0);
    pvd_end(&pvd);
}

static void collection_on_a_device_is_refused(void **state)
{
    struct place *p = *state;
    struct pvd pvd = pvd_begin(&p->log, "/dev/null", &sample_scene, FORMAT_BINARY);
    assert_false(pvd_step(&pvd, 0, &p->surface));
    assert_non_null(p->log.error);
    pvd_end(&pvd);
}

/* ---- OBJ ---- */

static void obj_reads_back(void **state)
{
    struct place *p = *state;
    size_t size;
    assert_true(obj_write(&p->log, sample_path(p, "x.obj"), &sample_scene, &p->surface));
    char *text = read_in(p, "x.obj", &size), *rest = text;
    int vertices = 0, normals = 0, faces = 0, group = -1, per_group[3] = {0};
    static const char *const materials[] = {"usemtl knit", "usemtl purl", "usemtl slip"};
    for (char *line; (line = strsep(&rest, "\n"));) {
        double v[3];
        int f[8];
        if (sscanf(line, "v %lf %lf %lf", v, v + 1, v + 2) == 3)
            assert_memory_equal(v, p->surface.position + 3 * vertices++, sizeof v);
        else if (sscanf(line, "vn %lf %lf %lf", v, v + 1, v + 2) == 3)
            assert_memory_equal(v, p->surface.normal + 3 * normals++, sizeof v);
        else if (sscanf(line, "f %d//%d %d//%d %d//%d %d//%d", f, f + 1, f + 2, f + 3, f + 4, f + 5, f + 6, f + 7) == 8) {
            assert_true(f[0] == f[1] && f[2] == f[0] + 1 && f[4] == f[0] + 8 && f[6] == f[0] + 7);
            int cell = (f[0] - 1) / 7 * 6 + (f[0] - 1) % 7;
            assert_int_equal(grid_at(sample_scene.grid, column(cell), row(cell)), group);
            per_group[group]++;
            faces++;
        }
        for (int i = 0; i < 3; i++)
            if (strcmp(line, materials[i]) == 0)
                group = i;
    }
    assert_int_equal(vertices, POINTS);
    assert_int_equal(normals, POINTS);
    assert_int_equal(faces, CELLS);
    assert_int_equal(per_group[0], 12);
    assert_int_equal(per_group[1], 8);
    assert_int_equal(per_group[2], 4);
    free(text);
}

static void obj_names_materials_that_exist(void **state)
{
    struct place *p = *state;
    size_t size;
    assert_true(obj_write(&p->log, sample_path(p, "x.obj"), &sample_scene, &p->surface));
    char *obj = read_in(p, "x.obj", &size), *mtl = read_in(p, "x.mtl", &size);
    assert_non_null(strstr(obj, "\nmtllib x.mtl\n"));
    assert_non_null(strstr(mtl, "newmtl knit\n"));
    assert_non_null(strstr(mtl, "newmtl purl\n"));
    assert_non_null(strstr(mtl, "newmtl slip\n"));
    assert_int_equal(sample_count(p->folder), 2);
    free(obj);
    free(mtl);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, sample_begin, sample_end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(binary_vtp_reads_back),
        TEST(ascii_vtp_reads_back),
        TEST(vtp_is_the_same_twice),
        TEST(collection_is_valid_after_each_step),
        TEST(many_steps_sort_by_name),
        TEST(collection_on_a_device_is_refused),
        TEST(obj_reads_back),
        TEST(obj_names_materials_that_exist),
    };
    return cmocka_run_group_tests_name("mesh", tests, NULL, NULL);
}
