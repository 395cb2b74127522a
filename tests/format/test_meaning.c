/* SPDX-License-Identifier: GPL-3.0-or-later
 * Two texts of one script: which of them `weft fmt` may take for the other. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "lang/format/meaning.h"

#define TEXT "Cast on 3\n"

static const struct pair {
    const char *about, *was, *is;
    bool same;
} pairs[] = {
    {"another spelling", TEXT "Row 1: K1, P2", TEXT "Row 1: knit 1, purl 2", true},
    {"another stitch", TEXT "Row 1: k1, p2", TEXT "Row 1: p1, k2", false},
    {"the row's side is lost", TEXT "Row 1 (WS): k1, p2", TEXT "Row 1: k1, p2", false},
    {"a row is lost", TEXT "Row 1: k3\nRow 2: k3", TEXT "Row 1: k3", false},
    {"a row is worked as often", TEXT "Row 1: p3\nRow 2: p3", TEXT "Rows 1-2: p3", true},
    {"its times are lost", TEXT "Row 1: p3\nRow 2: k3\nRepeat these 2 rows 3 times", TEXT "Row 1: p3\nRow 2: k3", false},
    {"rounds became rows", TEXT "Rnd 1: k3\nRnd 2: k3", TEXT "Row 1: k3\nRow 2: p3", false},
    {"a stitch became another", "stitch a { kx = 1 }\nstitch b { kx = 1 }\nswatch a", "stitch b { kx = 1 }\nstitch a { kx = 1 }\nswatch b", false},
    {"an error now", TEXT "Row 1: k3", TEXT "Row 1: k4", false},
    {"the same error", TEXT "Row 1: k4", TEXT "Row 1: knit 4", true},
    {"an error no more", TEXT "Row 1: k4", TEXT "Row 1: k3", false},
    {"another error", TEXT "Row 1: k4", TEXT "Row 1: k2tog, k1", false},
};

static void test_pairs(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct arena arena = {0};
        const struct source *was = source_from_text(&arena, "was", pairs[i].was, strlen(pairs[i].was));
        const struct source *is = source_from_text(&arena, "is", pairs[i].is, strlen(pairs[i].is));

        if (meaning_same(was, is, NULL) != pairs[i].same)
            fail_msg("%s", pairs[i].about);
        arena_free(&arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pairs)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
