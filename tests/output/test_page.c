/* SPDX-License-Identifier: GPL-3.0-or-later
 * The page's data, unpacked as a browser would and compared with what went in;
 * the template is the test's own. */
#include <config.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "drawing/colours.h"
#include "output/field.h"
#include "output/page.h"
#include "output/page_pack.h"
#include "tests/output/sample.h"

extern const char *const page_template[];
const char *const page_template[] = {"<title>", "@title@", "<data>", "@data@", "</data>", NULL};

enum { PER_STITCH = 2, NX = 3 * PER_STITCH, NY = 2 * PER_STITCH, STEPS = 2, FIELDS = 7 };

/* ---- a page, written and read ---- */

static const struct fold_step steps[STEPS] = {{.growth = 0.5, .energy = {3, 1, 2, 0}}, {.growth = 1, .energy = {7, 3, 4, 0}}};
static const struct fold_record record = {.energy = {7, 3, 4, 0}, .status = FOLD_CONVERGED, .energy_error = 0.01,
                                          .extent_x = 0.5, .extent_y = 0.25, .extent_z = 8, .max_normal_curvature = 2};

/* The sample surface; the second step is the first one grown, moved and bent the other way. */
static struct surface surface_at(int step)
{
    struct surface s = sample_surface(PER_STITCH);
    for (int i = 0; step > 0 && i < 3 * (NX + 1) * (NY + 1); i++)
        s.position[i] = 40 - 3 * s.position[i];
    for (int i = 0; step > 0 && i < NX * NY; i++) {
        s.mean[i] *= -7;
        s.gauss[i] = 5;
        s.bending[i] += 1e6;
    }
    return s;
}

/* The file's text of a page of the two steps, or of the first alone. */
static char *write_page(const struct scene *scene, int nsteps, const struct fold_record *r)
{
    char path[PATH_MAX + 8];
    struct file_log log = {0};
    struct page *page = page_begin(scene);
    for (int k = 0; k < nsteps; k++) {
        struct surface s = surface_at(k);
        assert_true(page_wants(page, &steps[k]));
        page_add(page, &steps[k], &s);
        surface_free(&s);
    }
    assert_int_equal(page_nsteps(page), nsteps);
    snprintf(path, sizeof path, "%s/x.html", sample_shared);
    assert_true(page_write(page, &log, path, r));
    assert_null(log.error);
    page_end(page);
    file_log_free(&log);
    size_t size;
    return sample_read(path, &size);
}

static cJSON *data_of(const char *text)
{
    const char *begin = strstr(text, "<data>\n");
    assert_non_null(begin);
    cJSON *data = cJSON_Parse(begin + 7);
    assert_non_null(data);
    return data;
}

static const cJSON *item(const cJSON *object, const char *name)
{
    const cJSON *found = cJSON_GetObjectItemCaseSensitive(object, name);
    assert_non_null(found);
    return found;
}

static double number(const cJSON *object, const char *name)
{
    assert_true(cJSON_IsNumber(item(object, name)));
    return item(object, name)->valuedouble;
}

static const char *word(const cJSON *object, const char *name)
{
    assert_true(cJSON_IsString(item(object, name)));
    return item(object, name)->valuestring;
}

/* ---- unpacking ---- */

static unsigned digit_of(char c)
{
    return c >= 'A' && c <= 'Z' ? (unsigned)(c - 'A') : c >= 'a' && c <= 'z' ? (unsigned)(c - 'a' + 26)
         : c >= '0' && c <= '9' ? (unsigned)(c - '0' + 52) : c == '+' ? 62 : 63;
}

/* The bytes of a blob, of which there must be n; free it. */
static unsigned char *unpack(const char *text, size_t n)
{
    size_t length = strlen(text), size = 0;
    unsigned char *deflated = calloc(length, 1), *bytes = calloc(n, 1);
    assert_int_equal(length % 4, 0);
    for (size_t i = 0; i < length; i += 4) {
        unsigned bits = digit_of(text[i]) << 18 | digit_of(text[i + 1]) << 12 | digit_of(text[i + 2]) << 6 | digit_of(text[i + 3]);
        deflated[size++] = (unsigned char)(bits >> 16);
        if (text[i + 2] != '=')
            deflated[size++] = (unsigned char)(bits >> 8);
        if (text[i + 3] != '=')
            deflated[size++] = (unsigned char)bits;
    }
    uLongf got = n;
    assert_int_equal(uncompress(bytes, &got, deflated, size), Z_OK);
    assert_int_equal(got, n);
    free(deflated);
    return bytes;
}

/* Levels of nlayers grids, each value from its left, lower and lower left neighbours; free them. */
static uint16_t *levels_of(const unsigned char *bytes, size_t width, size_t height, size_t nlayers)
{
    size_t n = width * height * nlayers;
    uint16_t *level = calloc(n, sizeof *level);
    for (size_t i = 0; i < n; i++) {
        size_t x = i % width, y = i / width % height;
        unsigned coded = bytes[i] | (unsigned)bytes[n + i] << 8;
        int rest = coded & 1 ? -(int)(coded + 1) / 2 : (int)coded / 2;
        int left = x ? level[i - 1] : 0, below = y ? level[i - width] : 0, between = x && y ? level[i - width - 1] : 0;
        level[i] = (uint16_t)(left + below - between + rest);
    }
    return level;
}

/* ---- what the page keeps ---- */

static const struct { const char *name; bool points; } fields[FIELDS] = {
    {"x", true}, {"y", true}, {"z", true}, {"mean", false}, {"gauss", false}, {"bending", false}, {"stretching", false},
};

static double value_of(const struct surface *s, int field, size_t i)
{
    const double *const cells[FIELDS] = {[3] = s->mean, [4] = s->gauss, [5] = s->bending, [6] = s->stretching};
    return fields[field].points ? s->position[3 * i + (size_t)field] : cells[field][i];
}

static void check_field(const cJSON *entry, int field, const unsigned char *bytes, const struct surface s[STEPS])
{
    size_t width = NX + fields[field].points, height = NY + fields[field].points, layer = width * height;
    double low = number(entry, "low"), high = number(entry, "high"), quantum = (high - low) / PAGE_LEVELS;
    double least = INFINITY, most = -INFINITY;
    uint16_t *level = levels_of(bytes, width, height, STEPS);
    assert_string_equal(word(entry, "name"), fields[field].name);
    assert_true(number(entry, "width") == (double)width && number(entry, "height") == (double)height);
    for (size_t i = 0; i < STEPS * layer; i++) {
        double value = value_of(&s[i / layer], field, i % layer);
        double rounding = fabs(value) * 0x1p-23;        /* fields are kept as 32-bit floats until then */
        assert_true(fabs(low + level[i] * quantum - value) <= quantum / 2 + rounding);
        least = fmin(least, value), most = fmax(most, value);
    }
    assert_true(low == (double)(float)least && high == (double)(float)most);     /* no step is wasted */
    free(level);
}

static void every_value_is_kept_to_half_a_step(void **state)
{
    (void)state;
    char *text = write_page(&sample_scene, STEPS, &record);
    cJSON *data = data_of(text);
    struct surface s[STEPS] = {surface_at(0), surface_at(1)};
    size_t points = (NX + 1) * (NY + 1), cells = NX * NY, at = 6;
    unsigned char *bytes = unpack(word(data, "blob"), at + 2 * STEPS * (3 * points + 4 * cells));
    assert_memory_equal(bytes, sample_scene.grid->cell, 6);     /* row 1 first, column 1 first */
    assert_int_equal(cJSON_GetArraySize(item(data, "fields")), FIELDS);
    for (int f = 0; f < FIELDS; f++) {
        check_field(cJSON_GetArrayItem(item(data, "fields"), f), f, bytes + at, s);
        at += 2 * STEPS * (fields[f].points ? points : cells);
    }
    assert_true(number(data, "columns") == 3 && number(data, "rows") == 2 && number(data, "per_stitch") == PER_STITCH);
    for (int k = 0; k < STEPS; k++)
        surface_free(&s[k]);
    free(bytes);
    cJSON_Delete(data);
    free(text);
}

/* All the same: no division by nothing. Outside the range: its end. */
static void odd_ranges_pack(void **state)
{
    (void)state;
    static const float same[4] = {3, 3, 3, 3}, wide[4] = {-9, 0, 1, 9};
    static const uint16_t wanted[8] = {0, 0, 0, 0, 0, 0, PAGE_LEVELS, PAGE_LEVELS};
    struct page_pack pack = {0};
    page_pack_field(&pack, &(struct page_field){2, 2, 1, 3, 3}, same);
    page_pack_field(&pack, &(struct page_field){2, 2, 1, 0, 1}, wide);
    char *text = page_pack_text(&pack);
    unsigned char *bytes = unpack(text, 16);
    uint16_t *one = levels_of(bytes, 2, 2, 1), *two = levels_of(bytes + 8, 2, 2, 1);
    assert_memory_equal(one, wanted, 8);
    assert_memory_equal(two, wanted + 4, 8);
    free(one);
    free(two);
    free(bytes);
    free(text);
}

/* ---- colours ---- */

static void check_color(const cJSON *text, struct rgb c)
{
    unsigned char byte[3];
    char wanted[8];
    colours_bytes(c, byte);
    snprintf(wanted, sizeof wanted, "#%02x%02x%02x", byte[0], byte[1], byte[2]);
    assert_string_equal(cJSON_GetStringValue(text), wanted);
}

static void colours_and_ranges_are_those_of_pictures(void **state)
{
    (void)state;
    char *text = write_page(&sample_scene, STEPS, &record);
    cJSON *data = data_of(text);
    for (int id = 0; id < 3; id++) {
        check_color(cJSON_GetArrayItem(item(item(data, "palettes"), "paper"), id), colours_stitch(colours_palette("paper"), id));
        check_color(cJSON_GetArrayItem(item(item(data, "palettes"), "safe"), id), colours_stitch(colours_palette("safe"), id));
    }
    const cJSON *scale = item(item(data, "scales"), "diverging");
    for (int i = 0; i < cJSON_GetArraySize(scale); i++)
        check_color(cJSON_GetArrayItem(scale, i), colours_at(COLOURS_DIVERGING, i / (cJSON_GetArraySize(scale) - 1.)));
    struct surface s = surface_at(1);
    for (enum coloring c = COLOR_HEIGHT; c <= COLOR_STRETCHING; c++) {
        const cJSON *entry = cJSON_GetArrayItem(item(data, "colorings"), (int)c - COLOR_HEIGHT);
        struct field field = field_of(&s, c);
        assert_true(number(entry, "low") == field.low && number(entry, "high") == field.high);
        assert_string_equal(word(entry, "title"), field.title);
        assert_string_equal(word(entry, "ends"), field.ends);
        assert_string_equal(word(entry, "scale"), field.diverging ? "diverging" : "sequential");
        field_free(&field);
    }
    surface_free(&s);
    cJSON_Delete(data);
    free(text);
}

/* ---- words ---- */

static void the_record_is_there(void **state)
{
    (void)state;
    char *text = write_page(&sample_scene, STEPS, &record);
    cJSON *data = data_of(text);
    const cJSON *result = item(data, "result"), *step = cJSON_GetArrayItem(item(data, "steps"), 1);
    assert_string_equal(word(result, "status"), "converged");
    assert_true(number(result, "total") == 7 && number(result, "extent_z") == 8 && number(result, "error_estimate") == 0.01);
    assert_true(number(step, "growth") == 1 && number(step, "bending") == 4);
    assert_int_equal(cJSON_GetArraySize(item(data, "steps")), STEPS);
    assert_int_equal(cJSON_GetArraySize(item(data, "parameters")), sample_scene.nsettings);
    assert_string_equal(word(cJSON_GetArrayItem(item(data, "parameters"), 1), "value"), "auto");
    assert_true(number(cJSON_GetArrayItem(item(data, "stitches"), 0), "ws") == STITCH_P);
    cJSON_Delete(data);
    free(text);
}

static void a_stopped_run_says_so(void **state)
{
    (void)state;
    char *text = write_page(&sample_scene, 1, NULL);
    cJSON *data = data_of(text);
    const cJSON *result = item(data, "result");
    assert_string_equal(word(result, "status"), "stopped");
    assert_true(number(result, "total") == 3);
    assert_true(cJSON_IsNull(item(result, "extent_x")) && cJSON_IsNull(item(result, "error_estimate")));
    cJSON_Delete(data);
    free(text);
}

/* A name may hold what HTML takes for its own, and bytes that are no UTF-8. */
static void names_do_no_harm(void **state)
{
    (void)state;
    struct scene scene = sample_scene;
    scene.file = "folder/</script>&\xFF.knit";     /* no folder in the title */
    char *text = write_page(&scene, 1, &record);
    assert_non_null(strstr(text, "script>&#38;"));
    assert_null(strstr(text, "</script"));
    assert_null(strchr(text, '\xFF'));
    cJSON *data = data_of(text);
    assert_memory_equal(word(data, "title"), "script>&", 8);
    cJSON_Delete(data);
    free(text);
}

/* ---- how much ---- */

static void many_steps_are_thinned(void **state)
{
    (void)state;
    static const int total[] = {1, 50, 51, 120, 1000};
    for (size_t k = 0; k < sizeof total / sizeof *total; k++) {
        struct scene scene = sample_scene;
        int kept = 0;
        scene.solve.steps = total[k];
        struct page *page = page_begin(&scene);
        assert_true(page_wants(page, &(struct fold_step){.growth = 0}));
        for (int i = 1; i < total[k]; i++)
            kept += page_wants(page, &(struct fold_step){.growth = (double)i / total[k]});
        assert_true(page_wants(page, &(struct fold_step){.growth = 1}));
        assert_true(kept < PAGE_STEPS && kept >= (total[k] < PAGE_STEPS ? total[k] : PAGE_STEPS / 2) - 1);
        page_end(page);
    }
}

static void large_swatches_are_sampled_less(void **state)
{
    (void)state;
    struct scene scene = sample_scene;
    struct grid grid = *sample_scene.grid;
    scene.grid = &grid;
    assert_int_equal(page_per_stitch(&scene), 6);
    grid.columns = 48, grid.rows = 92, scene.solve.steps = 10;
    assert_int_equal(page_per_stitch(&scene), 2);
    grid.columns = grid.rows = 1000;
    assert_int_equal(page_per_stitch(&scene), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_is_kept_to_half_a_step),
        cmocka_unit_test(odd_ranges_pack),
        cmocka_unit_test(colours_and_ranges_are_those_of_pictures),
        cmocka_unit_test(the_record_is_there),
        cmocka_unit_test(a_stopped_run_says_so),
        cmocka_unit_test(names_do_no_harm),
        cmocka_unit_test(many_steps_are_thinned),
        cmocka_unit_test(large_swatches_are_sampled_less),
    };
    return cmocka_run_group_tests(tests, sample_shared_begin, sample_shared_end);
}
