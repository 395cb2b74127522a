/* SPDX-License-Identifier: GPL-3.0-or-later
 * Places of spans in texts of every kind of line end and character; messages
 * in both forms; the nearest name. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lang/compile.h"
#include "lang/diag.h"
#include "lang/limits.h"
#include "lang/names.h"

static void assert_place(const char *text, unsigned start, unsigned end, int line, int column, int last)
{
    struct source source = {"x", text, strlen(text), false};
    struct place place = diag_place((struct span){&source, start, end});

    assert_int_equal(place.line, line);
    assert_int_equal(place.column, column);
    assert_int_equal(place.end, last);
}

static void test_places(void **state)
{
    (void)state;
    assert_place("abc\ndef\n", 0, 3, 1, 1, 4);
    assert_place("abc\ndef\n", 5, 6, 2, 2, 3);
    assert_place("abc\r\ndef\r\n", 5, 8, 2, 1, 4);
    assert_place("abc\rdef\r", 4, 5, 2, 1, 2);
    assert_place("a\r\r\nb", 4, 5, 3, 1, 2);
    assert_place("abc\ndef", 1, 6, 1, 2, 4); /* over a line end: to the end of the first line */
    assert_place("abc", 3, 3, 1, 4, 4);      /* the end of the text */
    assert_place("", 0, 0, 1, 1, 1);
    assert_place("\tab", 1, 2, 1, 2, 3);                  /* a tab is one column */
    assert_place("\xC3\xA9\xE2\x80\xA6x", 5, 6, 1, 3, 4); /* two characters of five bytes */
    assert_place("\xEF\xBB\xBFxy", 4, 5, 1, 2, 3);        /* a byte order mark is none */
}

/* What diag_print writes; the caller frees it. */
static char *printed(const struct diag *diag, enum diag_style style, bool color)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    diag_print(diag, out, style, color);
    fclose(out);
    return text;
}

static void assert_printed(const struct diag *diag, enum diag_style style, bool color, const char *wanted)
{
    char *text = printed(diag, style, color);

    assert_string_equal(text, wanted);
    free(text);
}

static void test_messages(void **state)
{
    struct arena arena = {0};
    struct diag diag;
    const struct source *source = source_from_text(&arena, "a \"b\".knit", "one\ttwo\n\x01\xFFx", 11);

    (void)state;
    diag_init(&diag, &arena);
    diag_error(&diag, CODE_SYNTAX, (struct span){source, 4, 7}, "no %s", "two");
    diag_hint(&diag, "try %d", 3);
    diag_note(&diag, (struct span){source, 0, 3}, "here");
    assert_printed(&diag, DIAG_HUMAN, false,
                   "a \"b\".knit:1:5: error: no two [E0101]\n   1 | one two\n     |     ^~~\nhint: try 3\n"
                   "a \"b\".knit:1:1: note: here\n   1 | one two\n     | ^~~\n");
    assert_printed(
        &diag, DIAG_JSON, false,
        "{\"file\": \"a \\\"b\\\".knit\", \"line\": 1, \"column\": 5, \"end\": 8, \"severity\": \"error\", "
        "\"code\": \"E0101\", \"text\": \"no two\", \"notes\": [{\"file\": \"a \\\"b\\\".knit\", \"line\": "
        "1, "
        "\"column\": 1, \"end\": 4, \"text\": \"here\"}], \"hints\": [\"try 3\"]}\n");
    arena_free(&arena);
}

/* What a terminal must not be given is shown as a mark. */
static void test_unprintable(void **state)
{
    struct arena arena = {0};
    struct diag diag;
    const struct source *source = source_from_text(&arena, "x", "a\x1B[31m\xFF\xC2\x9Bz", 10);

    (void)state;
    diag_init(&diag, &arena);
    diag_warning(&diag, CODE_AMBIGUOUS_NAME, (struct span){source, 9, 10}, "\x01\xFF");
    assert_printed(
        &diag, DIAG_JSON, false,
        "{\"file\": \"x\", \"line\": 1, \"column\": 9, \"end\": 10, \"severity\": \"warning\", \"code\": "
        "\"W0901\", \"text\": \"\\u0001\\ufffd\", \"notes\": [], \"hints\": []}\n");
    diag_init(&diag, &arena);
    diag_warning(&diag, CODE_AMBIGUOUS_NAME, (struct span){source, 9, 10}, "w");
    assert_printed(&diag, DIAG_HUMAN, true,
                   "\033[1mx:1:9: \033[1;35mwarning\033[0m: w [W0901]\n   1 | a?[31m??z\n     | \033[1;35m   "
                   "     ^\033[0m\n");
    arena_free(&arena);
}

static void test_counting(void **state)
{
    struct arena arena = {0};
    struct diag diag;
    const struct source *source =
        source_from_text(&arena, "x", "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz", 52);
    char *text;

    (void)state;
    diag_init(&diag, &arena);
    for (unsigned i = 0; i < 30; i++) {
        diag_error(&diag, CODE_TYPE, (struct span){source, i, i + 1}, "m");
        diag_error(&diag, CODE_TYPE, (struct span){source, i, i + 1}, "the same again");
    }
    assert_int_equal(diag.nerrors, 40); /* of the last ten each counts, unread */
    text = printed(&diag, DIAG_HUMAN, false);
    assert_null(strstr(text, "the same again"));
    assert_non_null(strstr(text, "20 more not shown\n"));
    free(text);

    diag_init(&diag, &arena);
    diag.warnings_are_errors = true;
    diag_warning(&diag, CODE_AMBIGUOUS_NAME, (struct span){source, 0, 1}, "m");
    assert_int_equal(diag.nerrors, 1);
    assert_int_equal(diag.nwarnings, 0);
    arena_free(&arena);
}

static void test_codes(void **state)
{
    char a[6], b[6];

    (void)state;
    for (int i = 1; i < diag_ncodes; i++) {
        diag_code_name(diag_codes[i - 1].code, a);
        diag_code_name(diag_codes[i].code, b);
        assert_true(diag_codes[i - 1].code < diag_codes[i].code);
        assert_true(strlen(diag_codes[i].about) > 10);
    }
    assert_string_equal(diag_code_name(CODE_SYNTAX, a), "E0101");
    assert_string_equal(diag_code_name(CODE_AMBIGUOUS_NAME, a), "W0901");
}

static void test_nearest(void **state)
{
    static const char *const words[] = {"swatch", "stitch", "springs", "solve", "K", "tile", "basketweave"};
    const int n = sizeof words / sizeof *words;

    (void)state;
    assert_string_equal(nearest_in("swach", words, n), "swatch");
    assert_string_equal(nearest_in("SOLVE", words, n), "solve");
    assert_string_equal(nearest_in("tiel", words, n), "tile");
    assert_string_equal(nearest_in("k", words, n), "K");
    assert_string_equal(nearest_in("basket", words, n), "basketweave");
    assert_null(nearest_in("gauge", words, n));
    assert_null(nearest_in("x", words, n));

    /* A third of the letters may be wrong; of two, their order. */
    assert_null(nearest_in("foo", (const char *const[]){"fmt", "from"}, 2));
    assert_null(nearest_in("kz", (const char *const[]){"kx", "ky"}, 2));
    assert_string_equal(nearest_in("xk", (const char *const[]){"ky", "kx"}, 2), "kx");
    assert_string_equal(nearest_in("fom", (const char *const[]){"fmt", "from", "fro"}, 3), "from");
    assert_null(nearest_in("", words, n));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_places),   cmocka_unit_test(test_messages), cmocka_unit_test(test_unprintable),
        cmocka_unit_test(test_counting), cmocka_unit_test(test_codes),    cmocka_unit_test(test_nearest),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
