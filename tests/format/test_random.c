/* SPDX-License-Identifier: GPL-3.0-or-later
 * Random scripts are formatted: the fabric, the settings and the errors stay,
 * every comment stays in its order, and formatting again changes nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "lang/compile.h"
#include "lang/format/format.h"
#include "lang/grid.h"
#include "tests/format/program.h"

enum { PROGRAMS = 600 };

struct compiled {
    struct diag diag;
    const struct scene *scene;
};

static struct compiled compile(struct arena *arena, const char *text, size_t length)
{
    struct compiled c;

    diag_init(&c.diag, arena);
    c.scene = scene_compile(arena, &c.diag, source_from_text(arena, "random.knit", text, length), NULL);
    return c;
}

static void same_text(const char *a, const char *b)
{
    assert_int_equal(!a, !b);
    if (a)
        assert_string_equal(a, b);
}

/* ---- what must stay ---- */

static void same_settings(const struct scene *a, const struct scene *b)
{
    assert_int_equal(a->nsettings, b->nsettings);
    for (int i = 0; i < a->nsettings; i++) {
        assert_string_equal(a->setting[i].name, b->setting[i].name);
        same_text(a->setting[i].text, b->setting[i].text);
        same_text(a->setting[i].about, b->setting[i].about);
        assert_true(a->setting[i].number == b->setting[i].number);
        assert_int_equal(a->setting[i].from, b->setting[i].from);
    }
    assert_int_equal(a->noutputs, b->noutputs);
    for (int i = 0; i < a->noutputs; i++) {
        assert_int_equal(a->output[i].kind, b->output[i].kind);
        assert_int_equal(a->output[i].per_stitch, b->output[i].per_stitch);
        assert_string_equal(a->output[i].path, b->output[i].path);
    }
    assert_int_equal(a->naxes, b->naxes);
    for (int i = 0; i < a->naxes; i++)
        assert_int_equal(a->axis[i].npoints, b->axis[i].npoints);
}

static void same_messages(const struct diag *a, const struct diag *b)
{
    const struct message *m = a->first, *n = b->first;

    for (; m && n; m = m->next, n = n->next)
        assert_int_equal(m->code, n->code);
    assert_true(!m && !n);
}

/* Comments in their order, blanks at their ends aside. No generated text in
 * quotes has a #. */
static void same_comments(const char *a, const char *b)
{
    for (;;) {
        size_t n, m;

        a = strchr(a, '#');
        b = strchr(b, '#');
        assert_int_equal(!a, !b);
        if (!a)
            return;
        for (n = strcspn(a, "\r\n"); strchr(" \t", a[n - 1]); n--)
            ;
        m = strcspn(b, "\r\n");
        assert_int_equal(n, m);
        assert_memory_equal(a, b, n);
        a += n;
        b += m;
    }
}

/* ---- one program ---- */

static bool try(unsigned seed, char *text)
{
    struct arena arena = {0};
    size_t length = program_write(seed, text), once, twice;
    struct compiled before = compile(&arena, text, length), after;
    struct diag diag;
    const struct source *source;
    const char *first, *second;
    bool whole = before.scene != NULL;

    diag_init(&diag, &arena);
    source = source_from_text(&arena, "random.knit", text, length);
    first = format_script(&arena, &diag, source, NULL, &once);
    if (!first) {
        fprintf(stderr, "seed %u:\n%s\n", seed, text);
        diag_print(&diag, stderr, DIAG_HUMAN, false);
        fail();
    }
    assert_ptr_not_equal(first, source->text);
    second = format_script(&arena, &diag, source_from_text(&arena, "random.knit", first, once), NULL, &twice);
    after = compile(&arena, first, once);
    if (getenv("WEFT_SHOW") && atoi(getenv("WEFT_SHOW")) == (int)seed) {
        fprintf(stderr, "%s\n----\n%s----\n%s", text, first, second ? second : "?\n");
        diag_print(&before.diag, stderr, DIAG_HUMAN, false);
        diag_print(&after.diag, stderr, DIAG_HUMAN, false);
    }
    assert_non_null(second);
    assert_string_equal(first, second);
    assert_null(strchr(first, '\r'));
    same_comments(text, first);
    same_messages(&before.diag, &after.diag);
    assert_int_equal(!before.scene, !after.scene);
    if (before.scene) {
        assert_true(grid_equal(before.scene->grid, after.scene->grid));
        same_settings(before.scene, after.scene);
    }
    arena_free(&arena);
    return whole;
}

static unsigned failing;

static void test_programs(void **state)
{
    static char text[PROGRAM_MOST];
    int whole = 0;

    (void)state;
    for (failing = 1; failing <= PROGRAMS; failing++)
        whole += try(failing, text);
    print_message("%d of %d programs compile\n", whole, PROGRAMS);
    assert_true(whole > PROGRAMS * 4 / 5);
}

static int say_seed(void **state)
{
    (void)state;
    if (failing <= PROGRAMS)
        print_message("the program of seed %u (see it with WEFT_SHOW=%u)\n", failing, failing);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(test_programs, say_seed)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
