/* SPDX-License-Identifier: GPL-3.0-or-later
 * The report read back: every key of its schema, every number to the last bit;
 * and the text charts. */
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

#include "output/chart.h"
#include "output/number.h"
#include "output/report.h"
#include "tests/output/sample.h"

static struct fold_step steps[] = {
    {.growth = 0.1 + 0.2, .energy = {1. / 3, 1e-300, 5e300, 0}, .iterations = 7, .gradient_max = 1e-9},
    {.growth = 1, .energy = {2. / 3, 0.1, 0.2, 0.3}, .iterations = 8, .gradient_max = 2e-9},
};

static struct fold_record record = {
    .kind = "patch", .per_stitch = 2, .unknowns = 123456789012, .elements = 17664,
    .energy = {0.1 + 0.2, 1. / 3, 2. / 3, 1e-5}, .energy_flat = 10, .energy_error = 0.004,
    .status = FOLD_SADDLE, .method = "plbfgs+newton", .growth_steps = 2, .iterations = 120, .evaluations = 150,
    .factorisations = 9, .gradient_max = 1e-10, .positive_definite = true, .threads = 2,
    .extent_x = 0.72, .extent_y = 0.99, .extent_z = 10, .rms_height = NAN, .max_normal_curvature = INFINITY,
    .shape_error = -1, .nsteps = 2, .step = steps, .assemble_s = 0.5,
};

struct reported {
    char            folder[PATH_MAX];
    char            path[PATH_MAX + 16];
    struct file_log log;
    cJSON          *root;
};

static int set_up(void **state)
{
    struct reported *p = calloc(1, sizeof *p);
    sample_folder(p->folder);
    snprintf(p->path, sizeof p->path, "%s/x.json", p->folder);
    struct report report = {
        .scene = &sample_scene, .record = &record, .kept_seed = UINT64_MAX, .source = "abc", .source_size = 3,
        .total_s = 1.5, .compile_s = 0.25, .write_s = 0.125, .peak_bytes = 1 << 20,
    };
    struct file *file = file_create(&p->log, "/dev/null");
    file_commit(file);
    if (!report_write(&p->log, p->path, &report))
        return -1;
    size_t size;
    char *text = sample_read(p->path, &size);
    p->root = cJSON_Parse(text);
    free(text);
    *state = p;
    return p->root ? 0 : -1;
}

static int tear_down(void **state)
{
    struct reported *p = *state;
    cJSON_Delete(p->root);
    sample_remove(p->folder);
    file_log_free(&p->log);
    free(p);
    return 0;
}

/* "energy.total" -> its value; a number is an index: "steps.1.growth". */
static const cJSON *at(const cJSON *node, const char *dotted)
{
    char path[128], *rest = path;
    snprintf(path, sizeof path, "%s", dotted);
    for (char *key; node && (key = strsep(&rest, "."));)
        node = cJSON_IsArray(node) ? cJSON_GetArrayItem(node, atoi(key)) : cJSON_GetObjectItemCaseSensitive(node, key);
    if (!node)
        fail_msg("the report has no %s", dotted);
    return node;
}

static void every_number_is_exact(void **state)
{
    struct reported *p = *state;
    const struct { const char *key; double value; } wanted[] = {
        {"schema", 1}, {"scene.rows", 2}, {"scene.columns", 3}, {"scene.knit", 3}, {"scene.purl", 2}, {"scene.other", 1},
        {"parameters.thickness.value", 0.5}, {"parameters.half.value", 1. / 3},
        {"discretisation.per_stitch", 2}, {"discretisation.unknowns", 123456789012}, {"discretisation.elements", 17664},
        {"energy.total", 0.1 + 0.2}, {"energy.stretching", 1. / 3}, {"energy.bending", 2. / 3}, {"energy.springs", 1e-5},
        {"energy.flat", 10}, {"energy.error_estimate", 0.004},
        {"solve.growth_steps", 2}, {"solve.iterations", 120}, {"solve.evaluations", 150}, {"solve.factorisations", 9},
        {"solve.gradient_max", 1e-10}, {"solve.threads", 2},
        {"shape.extent_x", 0.72}, {"shape.extent_y", 0.99}, {"shape.extent_z", 10},
        {"steps.0.growth", 0.1 + 0.2}, {"steps.0.energy", 1. / 3}, {"steps.0.stretching", 1e-300},
        {"steps.0.bending", 5e300}, {"steps.0.springs", 0}, {"steps.0.iterations", 7}, {"steps.0.gradient_max", 1e-9},
        {"steps.1.growth", 1},
        {"time.total_s", 1.5}, {"time.compile_s", 0.25}, {"time.solve_s", 0}, {"time.assemble_s", 0.5},
        {"time.factor_s", 0}, {"time.evaluate_s", 0}, {"time.write_s", 0.125}, {"memory.peak_bytes", 1 << 20},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++) {
        const cJSON *node = at(p->root, wanted[i].key);
        if (!cJSON_IsNumber(node) || node->valuedouble != wanted[i].value)
            fail_msg("%s is not %.17g", wanted[i].key, wanted[i].value);
    }
}

static void every_text_is_there(void **state)
{
    struct reported *p = *state;
    static const struct { const char *key, *value; } wanted[] = {
        {"weft", PACKAGE_VERSION}, {"scene.file", "a \"quoted\" \xEF\xBF\xBD name.knit"},
        {"scene.sha256", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"parameters.thickness.unit", "length"}, {"parameters.thickness.from", "default"},
        {"parameters.method.value", "auto"}, {"parameters.method.from", "file"},
        {"parameters.half.from", "command line"},
        {"discretisation.kind", "patch"}, {"solve.status", "saddle"}, {"solve.method", "plbfgs+newton"},
        {"outputs.0.path", "/dev/null"},
        {"outputs.0.sha256", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
        assert_string_equal(cJSON_GetStringValue(at(p->root, wanted[i].key)), wanted[i].value);
    assert_true(cJSON_IsTrue(at(p->root, "solve.positive_definite")));
}

static void what_is_not_known_is_null(void **state)
{
    struct reported *p = *state;
    static const char *const keys[] = {"shape.error_estimate", "shape.rms_height", "shape.max_normal_curvature", "solve.remark"};
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        assert_true(cJSON_IsNull(at(p->root, keys[i])));
}

/* A double could not hold it. */
static void seed_keeps_all_its_digits(void **state)
{
    struct reported *p = *state;
    size_t size;
    char *text = sample_read(p->path, &size);
    assert_non_null(strstr(text, "18446744073709551615"));
    free(text);
}

static void numbers_are_short_and_exact(void **state)
{
    (void)state;
    char text[NUMBER_TEXT];
    number_print(text, 0.1);
    assert_string_equal(text, "0.1");
    number_print(text, -0.);
    assert_string_equal(text, "-0");
    double hard[] = {0.1 + 0.2, 5e-324, 1.7976931348623157e308, 1. / 3, 123456789.123456789};
    for (size_t i = 0; i < sizeof hard / sizeof hard[0]; i++) {
        number_print(text, hard[i]);
        assert_true(strtod(text, NULL) == hard[i]);
    }
}

static void assert_chart(struct reported *p, void (*print)(struct file *, const struct scene *), const char *wanted)
{
    struct file *file = file_create(&p->log, p->path);
    print(file, &sample_scene);
    assert_true(file_commit(file));
    size_t size;
    char *text = sample_read(p->path, &size);
    assert_string_equal(text, wanted);
    free(text);
}

static void charts_are_the_right_way_round(void **state)
{
    assert_chart(*state, chart_grid, "# 1 1\nK P K\nP K Slip\n");
    assert_chart(*state, chart_text, "2  p  k <>\n   k  p  k  1\n");
}

static void grid_hash_is_that_of_the_grid(void **state)
{
    struct reported *p = *state;
    const char *reported = cJSON_GetStringValue(at(p->root, "scene.grid_sha256"));
    struct file *file = file_create(&p->log, p->path);
    chart_grid(file, &sample_scene);
    assert_true(file_commit(file));
    assert_string_equal(file_log_find(&p->log, p->path)->sha256, reported);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(every_number_is_exact),
        TEST(every_text_is_there),
        TEST(what_is_not_known_is_null),
        TEST(seed_keeps_all_its_digits),
        TEST(numbers_are_short_and_exact),
        TEST(charts_are_the_right_way_round),
        TEST(grid_hash_is_that_of_the_grid),
    };
    return cmocka_run_group_tests_name("report", tests, NULL, NULL);
}
