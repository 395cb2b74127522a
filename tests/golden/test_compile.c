/* SPDX-License-Identifier: GPL-3.0-or-later
 * The compiler's interface as a caller uses it: options, failures, two at a
 * time, the library. */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lang/compile.h"

static const struct scene *compiled(struct arena *arena, struct diag *diag, const char *text,
                                    const struct compile_options *options)
{
    diag_init(diag, arena);
    return scene_compile(arena, diag, source_from_text(arena, "t.knit", text, strlen(text)), options);
}

static void test_scene(void **state)
{
    struct arena arena = {0};
    struct diag diag;
    const struct scene *scene =
        compiled(&arena, &diag,
                 "stitch T { kx = 1; twist = 2; symbol = \"t\"; ws = K }\n"
                 "chart { T K\nP T }\n"
                 "gauge { width = 2; height = 3 }\n"
                 "material { thickness = 0.25; young = 7; poisson = -0.5 }\n"
                 "springs { stiffness = 1e-4; edges = [bottom, right] }\n"
                 "mesh { discretisation = triangle; per_stitch = 4; diagonals = crisscross }\n"
                 "solve { accuracy = 2%; steps = 3; noise = 0; seed = 9007199254740991\n"
                 "        method = lbfgs; tolerance = 1e-6; max_iterations = 77 }\n",
                 NULL);

    (void)state;
    assert_non_null(scene);
    assert_string_equal(scene->file, "t.knit");
    assert_int_equal(scene->grid->columns, 2);
    assert_int_equal(grid_at(scene->grid, 0, 0), STITCH_P);
    assert_int_equal(grid_at(scene->grid, 1, 0), 2);
    assert_int_equal(grid_at(scene->grid, 0, 1), 2);
    assert_int_equal(scene->nstitches, 3);
    assert_string_equal(scene->stitch[2].name, "T");
    assert_int_equal(scene->stitch[2].ws, STITCH_K);
    assert_true(scene->stitch[2].kx == 1 && scene->stitch[2].ky == 0 && scene->stitch[2].twist == 2);
    assert_true(scene->stitch[STITCH_K].kx == -1 && scene->stitch[STITCH_K].ky == 1);
    assert_true(scene->stitch[STITCH_P].kx == 1 && scene->stitch[STITCH_P].ky == -1);
    assert_true(scene->gauge.width == 2 && scene->gauge.height == 3);
    assert_true(scene->material.thickness == 0.25 && scene->material.young == 7 &&
                scene->material.poisson == -0.5);
    assert_true(scene->springs.stiffness == 1e-4);
    assert_int_equal(scene->springs.edges, EDGE_BOTTOM | EDGE_RIGHT);
    assert_int_equal(scene->mesh.discretisation, DISCRETISATION_TRIANGLE);
    assert_int_equal(scene->mesh.per_stitch, 4);
    assert_int_equal(scene->mesh.diagonals, DIAGONALS_CRISSCROSS);
    assert_true(scene->solve.accuracy == 0.02 && scene->solve.noise == 0 && scene->solve.tolerance == 1e-6);
    assert_int_equal(scene->solve.steps, 3);
    assert_true(scene->solve.seed == 9007199254740991u);
    assert_int_equal(scene->solve.method, METHOD_LBFGS);
    assert_int_equal(scene->solve.max_iterations, 77);
    arena_free(&arena);
}

static void test_defaults(void **state)
{
    struct arena arena = {0};
    struct diag diag;
    const struct scene *scene = compiled(&arena, &diag, "swatch K", NULL);

    (void)state;
    assert_non_null(scene);
    assert_true(scene->gauge.width == 1.4 && scene->gauge.height == 1.2);
    assert_true(scene->material.thickness == 0.5 && scene->material.young == 1 &&
                scene->material.poisson == 0.4);
    assert_true(scene->springs.stiffness == 0);
    assert_int_equal(scene->springs.edges, EDGE_ALL);
    assert_int_equal(scene->mesh.discretisation, DISCRETISATION_PATCH);
    assert_int_equal(scene->mesh.per_stitch, 0);
    assert_true(scene->solve.accuracy == 0.01 && scene->solve.noise == 0.01 &&
                scene->solve.tolerance == 1e-8);
    assert_int_equal(scene->solve.steps, 10);
    assert_int_equal(scene->solve.seed, 1);
    assert_int_equal(scene->solve.method, METHOD_AUTO);
    assert_int_equal(scene->solve.max_iterations, 10000);
    for (int i = 0; i < scene->nsettings; i++)
        assert_int_equal(scene->setting[i].from, FROM_DEFAULT);
    arena_free(&arena);
}

static const struct setting *setting(const struct scene *scene, const char *name)
{
    for (int i = 0; i < scene->nsettings; i++)
        if (strcmp(scene->setting[i].name, name) == 0)
            return &scene->setting[i];
    fail_msg("no setting %s", name);
    return NULL;
}

static void test_overrides(void **state)
{
    static const struct compile_override define[] = {{"n", "2 + 1"}},
                                         set[] = {{"solve.steps", "4"}, {"P.ky", "-0.5"}};
    static const char *const output[] = {"report:a.json", "b-{n}.vtp"};
    const struct compile_options options = {
        .define = define, .ndefines = 1, .set = set, .nsets = 2, .output = output, .noutputs = 2};
    struct arena arena = {0};
    struct diag diag;
    const struct scene *scene = compiled(&arena, &diag,
                                         "param n = 5 in 1..9 \"how many\"\nswatch tile(K, n, 1)\n"
                                         "solve { steps = 2 }\noutput \"first.obj\"",
                                         &options);

    (void)state;
    assert_non_null(scene);
    assert_int_equal(scene->grid->columns, 3);
    assert_int_equal(scene->solve.steps, 4);
    assert_true(scene->stitch[STITCH_P].ky == -0.5 && scene->stitch[STITCH_P].kx == 1);
    assert_int_equal(setting(scene, "steps")->from, FROM_COMMAND_LINE);
    assert_int_equal(setting(scene, "P.ky")->from, FROM_COMMAND_LINE);
    assert_int_equal(setting(scene, "P.kx")->from, FROM_DEFAULT);
    assert_int_equal(setting(scene, "n")->from, FROM_COMMAND_LINE);
    assert_true(setting(scene, "n")->is_param && setting(scene, "n")->number == 3);
    assert_true(setting(scene, "n")->low == 1 && setting(scene, "n")->high == 9);
    assert_string_equal(setting(scene, "n")->about, "how many");
    assert_int_equal(scene->noutputs, 3);
    assert_int_equal(scene->output[0].kind, OUTPUT_OBJ);
    assert_int_equal(scene->output[0].line, 4);
    assert_int_equal(scene->output[1].kind, OUTPUT_REPORT);
    assert_string_equal(scene->output[1].path, "a.json");
    assert_int_equal(scene->output[2].kind, OUTPUT_VTP);
    assert_string_equal(scene->output[2].path, "b-3.vtp");
    assert_int_equal(scene->output[2].line, 0);
    arena_free(&arena);
}

static void test_failures(void **state)
{
    struct arena arena = {0};
    struct diag diag;
    const char *why = NULL;
    struct compile_options strict = {.warnings_are_errors = true};

    (void)state;
    assert_null(source_read(&arena, "/nonexistent/x.knit", &why));
    assert_non_null(why);
    why = NULL;
    assert_null(source_read(&arena, "/", &why));
    assert_non_null(why);
    assert_null(compiled(&arena, &diag, "swatch Q", NULL));
    assert_int_equal(diag.nerrors, 1);
    assert_non_null(compiled(&arena, &diag, "use moss from std\nswatch moss", NULL));
    assert_int_equal(diag.nwarnings, 1);
    assert_null(compiled(&arena, &diag, "use moss from std\nswatch moss", &strict));
    arena_free(&arena);
}

/* Folders of -I, then of WEFT_PATH; not the one of the file when it has none. */
static void test_include(void **state)
{
    char folder[] = "/tmp/weft-test-XXXXXX", path[64];
    const char *include[1];
    struct compile_options options = {.include = include, .nincludes = 1};
    struct arena arena = {0};
    struct diag diag;
    FILE *file;

    (void)state;
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/lib.txt", folder);
    file = fopen(path, "w");
    assert_non_null(file);
    fputs("let five = 5\nlet _own = 3\n", file);
    fclose(file);
    include[0] = folder;
    assert_null(compiled(&arena, &diag, "use \"lib.txt\"\nswatch tile(K, five, 1)", NULL));
    assert_non_null(compiled(&arena, &diag, "use \"lib.txt\"\nswatch tile(K, five, 1)", &options));
    assert_null(compiled(&arena, &diag, "use \"lib.txt\"\nswatch tile(K, _own, 1)", &options));
    setenv("WEFT_PATH", folder, 1);
    assert_non_null(compiled(&arena, &diag, "use five from \"lib.txt\"\nswatch tile(K, five, 1)", NULL));
    setenv("WEFT_PATH", "/nonexistent:", 1);
    assert_null(compiled(&arena, &diag, "use five from \"lib.txt\"\nswatch tile(K, five, 1)", NULL));
    unsetenv("WEFT_PATH");
    remove(path);
    remove(folder);
    arena_free(&arena);
}

/* The same text on several threads at once: nothing is shared. */
static void *compile_often(void *text)
{
    for (int i = 0; i < 20; i++) {
        struct arena arena = {0};
        struct diag diag;
        const struct scene *scene = compiled(&arena, &diag, text, NULL);
        long long purl = scene ? grid_count(scene->grid, STITCH_P) : -1;

        arena_free(&arena);
        if (purl != 2208)
            return text;
    }
    return NULL;
}

static void test_threads(void **state)
{
    static char text[] = "use miura from std\nswatch tile(miura, 4, 4)";
    pthread_t thread[4];

    (void)state;
    for (int i = 0; i < 4; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, compile_often, text), 0);
    for (int i = 0; i < 4; i++) {
        void *failed;

        pthread_join(thread[i], &failed);
        assert_null(failed);
    }
}

static void test_library(void **state)
{
    static const char *const wanted[] = {
        "bars",   "basketweave", "chains",  "checkerboard", "columns",
        "garter", "miura",       "moss_us", "peaks",        "reverse_stockinette",
        "rib",    "rib_2x2",     "seed",    "squiggles",    "stockinette",
        "weave"};
    struct arena arena = {0};
    int count, found = 0;
    const struct library_motif *motif = library_list(&arena, &count);

    (void)state;
    for (int i = 0; i < count; i++) {
        assert_true(i == 0 || strcmp(motif[i - 1].name, motif[i].name) < 0);
        assert_true(strlen(motif[i].about) > 10);
        assert_memory_equal(motif[i].file, "std/", 4);
        assert_int_equal(motif[i].multiple + motif[i].plus, motif[i].grid->columns);
        assert_int_equal(motif[i].rows, motif[i].grid->rows);
        assert_true(*motif[i].name != '_');
        for (size_t j = 0; j < sizeof wanted / sizeof *wanted; j++)
            found += strcmp(motif[i].name, wanted[j]) == 0;
        if (strcmp(motif[i].name, "basketweave") == 0) {
            assert_int_equal(motif[i].multiple, 8);
            assert_int_equal(motif[i].plus, 5);
            assert_int_equal(motif[i].rows, 8);
        }
        if (strcmp(motif[i].name, "miura") == 0)
            assert_string_equal(motif[i].arguments, "(half = 6)");
    }
    assert_int_equal(found, sizeof wanted / sizeof *wanted);
    arena_free(&arena);
}

/* What knitters call a motif elsewhere: a comment's names, in any case, blanks as _. */
static void test_other_names(void **state)
{
    static const struct {
        const char *name, *motif;
    } wanted[] = {
        {"spot", "dot"},           {"Irish moss", "moss_us"},       {"irish_moss", "moss_us"},  {"gansey ladder", "ladder"},
        {"accordion", "welt"},     {"Stocking_Stitch", "stockinette"}, {"st st", "stockinette"}, {"seed stitch", "seed"},
        {"2x2_rib", "rib_2x2"},    {"double moss", "moss_us or seed_2x1"}, {"American moss", "moss_us"},
        {"knit", NULL},            {"stitch", NULL},                {"", NULL},                 {"spots", NULL},
    };
    struct arena arena = {0};

    (void)state;
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        const char *motif = library_other_name(&arena, wanted[i].name);

        if (wanted[i].motif)
            assert_string_equal(motif ? motif : "none", wanted[i].motif);
        else
            assert_null(motif);
    }
    arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scene),    cmocka_unit_test(test_defaults), cmocka_unit_test(test_overrides),
        cmocka_unit_test(test_failures), cmocka_unit_test(test_include),  cmocka_unit_test(test_threads),
        cmocka_unit_test(test_other_names),
        cmocka_unit_test(test_library),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
