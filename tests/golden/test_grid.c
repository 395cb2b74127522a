/* SPDX-License-Identifier: GPL-3.0-or-later
 * The algebra of grids: small ones drawn out, and laws on random ones. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lang/arena.h"
#include "lang/grid.h"

static const stitch_id ws[] = {STITCH_P, STITCH_K, 2};

/* "KP/PP": rows from the bottom up; T is stitch 2. */
static const struct grid *drawn(struct arena *arena, const char *text)
{
    int columns = (int)strcspn(text, "/"), rows = 1;
    stitch_id *cell;
    struct grid *g;

    for (const char *c = text; *c; c++)
        rows += *c == '/';
    g = grid_new(arena, columns, rows, &cell);
    for (; *text; text++)
        if (*text != '/')
            *cell++ = *text == 'K' ? STITCH_K : *text == 'P' ? STITCH_P : 2;
    return g;
}

static void assert_grid(struct arena *arena, const struct grid *g, const char *text)
{
    const struct grid *wanted = drawn(arena, text);

    assert_int_equal(g->columns, wanted->columns);
    assert_int_equal(g->rows, wanted->rows);
    assert_memory_equal(g->cell, wanted->cell, (size_t)g->columns * (size_t)g->rows);
}

static void test_drawn(void **state)
{
    struct arena a = {0};
    const struct grid *g = drawn(&a, "PKT/KKP");
    const struct grid *two[] = {g, drawn(&a, "P/T")}, *stack[] = {g, drawn(&a, "TTT")};

    (void)state;
    assert_grid(&a, grid_mirror(&a, g), "TKP/PKK");
    assert_grid(&a, grid_flip(&a, g), "KKP/PKT");
    assert_grid(&a, grid_invert(&a, g, ws), "KPT/PPK");
    assert_grid(&a, grid_turn(&a, g, ws), "TPK/KPP");
    assert_grid(&a, grid_rotate(&a, g), "PKK/TKP");
    assert_grid(&a, grid_tile(&a, g, 2, 2), "PKTPKT/KKPKKP/PKTPKT/KKPKKP");
    assert_grid(&a, grid_window(&a, g, 2, 1, 4, 1), "PKKP");
    assert_grid(&a, grid_window(&a, g, -1, -1, 2, 3), "PK/TP/PK");
    assert_grid(&a, grid_stretch(&a, g, 1, 1, 3), "PKKKT/KKKKP");
    assert_grid(&a, grid_stretch(&a, g, 0, 2, 2), "PKPKT/KKKKP");
    assert_grid(&a, grid_beside(&a, two, 2), "PKTP/KKPT");
    assert_grid(&a, grid_above(&a, stack, 2), "PKT/KKP/TTT");
    assert_grid(&a, grid_shift(&a, g, 1, 0), "TPK/PKK");
    assert_grid(&a, grid_shift(&a, g, 0, 1), "KKP/PKT");
    assert_grid(&a, grid_inset(&a, drawn(&a, "T"), g, 1, 0), "PTT/KKP");
    assert_int_equal(grid_count(g, STITCH_K), 3);
    assert_int_equal(grid_count(g, 2), 1);
    arena_free(&a);
}

/* A grid without symmetry, of a size that differs from run to run of the loop. */
static const struct grid *some(struct arena *arena, unsigned *seed)
{
    int columns = 2 + (int)(*seed % 7), rows = 2 + (int)(*seed / 7 % 5);
    stitch_id *cell;
    struct grid *g = grid_new(arena, columns, rows, &cell);

    for (int i = 0; i < columns * rows; i++) {
        *seed = *seed * 1664525u + 1013904223u;
        cell[i] = (stitch_id)(*seed >> 24) % 3;
    }
    return g;
}

static void test_laws(void **state)
{
    unsigned seed = 1;

    (void)state;
    for (int i = 0; i < 200; i++) {
        struct arena a = {0};
        const struct grid *g = some(&a, &seed);
        int dx = (int)(seed >> 8) % 20 - 10, dy = (int)(seed >> 16) % 20 - 10;

        assert_true(grid_equal(g, grid_mirror(&a, grid_mirror(&a, g))));
        assert_true(grid_equal(g, grid_flip(&a, grid_flip(&a, g))));
        assert_true(grid_equal(g, grid_turn(&a, grid_turn(&a, g, ws), ws)));
        assert_true(grid_equal(grid_rotate(&a, g), grid_mirror(&a, grid_flip(&a, g))));
        assert_true(grid_equal(g, grid_shift(&a, grid_shift(&a, g, dx, dy), -dx, -dy)));
        assert_true(
            grid_equal(grid_tile(&a, g, 3, 2), grid_window(&a, g, 0, 0, 3 * g->columns, 2 * g->rows)));
        assert_true(grid_equal(grid_tile(&a, g, 3, 1), grid_stretch(&a, g, 0, g->columns, 3)));
        arena_free(&a);
    }
}

static void test_arena(void **state)
{
    struct arena a = {0};
    unsigned char *small = arena_alloc(&a, 3), *large = arena_alloc(&a, 1 << 20), *next = arena_alloc(&a, 8);

    (void)state;
    for (int i = 0; i < 1 << 20; i++)
        assert_int_equal(large[i], 0);
    memset(small, 1, 3);
    memset(large, 2, 1 << 20);
    memset(next, 3, 8);
    assert_int_equal(small[2], 1);
    assert_int_equal(large[(1 << 20) - 1], 2);
    assert_int_equal((uintptr_t)next % 16, 0);
    assert_string_equal(arena_printf(&a, "%d-%s", 7, "x"), "7-x");
    arena_free(&a);
    assert_int_equal(a.bytes, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_drawn),
        cmocka_unit_test(test_laws),
        cmocka_unit_test(test_arena),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
