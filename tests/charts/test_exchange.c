/* SPDX-License-Identifier: GPL-3.0-or-later
 * Grids sent through every format and back, in one process: each motif of the
 * library, hundreds of random grids, and grids that equal none of their images. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "charts/csv.h"
#include "charts/import.h"
#include "charts/knitout.h"
#include "charts/kp.h"
#include "charts/picture.h"
#include "charts/written.h"
#include "lang/compile.h"

enum { RANDOM = 300 };

/* ---- formats ---- */

/* The letters of a grid, the bottom row first. */
static void kp_write(struct text *text, const struct grid *g)
{
    for (int row = 0; row < g->rows; row++)
        for (int i = 0; i < g->columns; i++)
            text_print(text, "%c%s", "KP"[grid_at(g, i, row)], i + 1 < g->columns ? " " : "\n");
}

static void table_write(struct text *text, const struct grid *g)
{
    csv_write(text, &(struct scene){.grid = g});
}

static void flat_write(struct text *text, const struct grid *g)
{
    written_pattern(text, g, &(struct written_style){.words = &dictionary_plain, .indent = ""});
}

static void round_write(struct text *text, const struct grid *g)
{
    written_pattern(text, g, &(struct written_style){.words = &dictionary_plain, .round = true, .indent = ""});
}

static struct pattern pixels_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    return picture_read(arena, diag, source, NULL);
}

/* A script, as the language itself reads it. */
static struct pattern script_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    const struct scene *scene = scene_compile(arena, diag, source, NULL);
    return (struct pattern){.grid = scene ? scene->grid : NULL, .across = 1, .up = 1};
}

typedef struct pattern reader(struct arena *arena, struct diag *diag, const struct source *source);

static const struct format {
    const char *name;
    void      (*write)(struct text *text, const struct grid *grid);
    reader     *read;
} formats[] = {
    {"letters", kp_write, kp_read},        {"table", table_write, csv_read},     {"pixels", picture_write, pixels_read},
    {"knitout", knitout_write, knitout_read}, {"written flat", flat_write, script_read},
    {"written in the round", round_write, script_read},
};
enum { NFORMATS = sizeof formats / sizeof *formats };

/* ---- there and back ---- */

static void print_grid(const struct grid *g)
{
    for (int row = g->rows - 1; row >= 0; row--) {
        for (int i = 0; i < g->columns; i++)
            fputc("KP"[grid_at(g, i, row)], stderr);
        fputc('\n', stderr);
    }
}

static void check_same(const struct grid *wanted, const struct pattern *got, const char *name, const struct diag *diag)
{
    if (got->grid && grid_equal(wanted, got->grid))
        return;
    fprintf(stderr, "%s gives another grid than this one:\n", name);
    print_grid(wanted);
    diag_print(diag, stderr, DIAG_HUMAN, false);
    fail();
}

/* The script weft import makes of a pattern shows the same grid. */
static void check_import(const struct pattern *pattern, const char *name)
{
    struct arena arena = {0};
    struct diag diag;
    struct text text = {.arena = &arena};
    diag_init(&diag, &arena);
    import_script(&text, pattern, "a file.txt", "Something");
    const struct pattern again = script_read(&arena, &diag, source_from_text(&arena, name, text.bytes, text.length));
    check_same(pattern->grid, &again, name, &diag);
    arena_free(&arena);
}

/* What a format makes of the grid. */
static const struct source *sent(struct arena *arena, const struct format *format, const struct grid *grid)
{
    struct text text = {.arena = arena};
    format->write(&text, grid);
    return source_from_text(arena, format->name, text.bytes, text.length);
}

static void check_round_trips(const struct grid *grid)
{
    for (const struct format *format = formats; format < formats + NFORMATS; format++) {
        struct arena arena = {0};
        struct diag diag;
        diag_init(&diag, &arena);
        const struct pattern back = format->read(&arena, &diag, sent(&arena, format, grid));
        check_same(grid, &back, format->name, &diag);
        if (format == formats)
            check_import(&back, "the imported script");
        arena_free(&arena);
    }
}

static void test_library(void **state)
{
    (void)state;
    struct arena arena = {0};
    int n;
    const struct library_motif *motif = library_list(&arena, &n);
    assert_true(n > 50);
    for (int i = 0; i < n; i++) {
        check_round_trips(motif[i].grid);
        check_round_trips(grid_tile(&arena, motif[i].grid, 2, 3));
    }
    arena_free(&arena);
}

/* ---- random grids ---- */

static unsigned below(uint64_t *seed, unsigned n)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(*seed >> 33) % n;
}

/* Noise, or noise that repeats across and up with a stitch out of order. */
static const struct grid *random_grid(struct arena *arena, uint64_t seed)
{
    stitch_id *cell;
    int columns = 1 + (int)below(&seed, seed % 3 ? 12 : 50), rows = 1 + (int)below(&seed, seed % 4 ? 9 : 30);
    int across = seed % 2 ? columns : 1 + (int)below(&seed, (unsigned)columns);
    int up = seed % 5 ? 1 + (int)below(&seed, (unsigned)rows) : rows;
    for (unsigned burn = 0; burn < 5; burn++)
        below(&seed, 2);
    grid_new(arena, across, up, &cell);
    for (int i = 0; i < across * up; i++)
        cell[i] = (stitch_id)below(&seed, 2);
    struct grid *part = arena_new(arena, struct grid);
    *part = (struct grid){across, up, cell};
    struct grid *whole = grid_window(arena, part, 0, 0, columns, rows);
    if (below(&seed, 3) == 0)
        ((stitch_id *)whole->cell)[below(&seed, (unsigned)(columns * rows))] ^= 1;
    return whole;
}

static void test_random(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= RANDOM; seed++) {
        struct arena arena = {0};
        check_round_trips(random_grid(&arena, seed));
        arena_free(&arena);
    }
}

/* ---- which way up and round ---- */

static const struct grid *grid_of(struct arena *arena, const char *script)
{
    struct diag diag;
    diag_init(&diag, arena);
    const struct pattern pattern = script_read(arena, &diag, source_from_text(arena, "script", script, strlen(script)));
    if (!pattern.grid)
        diag_print(&diag, stderr, DIAG_HUMAN, false);
    assert_non_null(pattern.grid);
    return pattern.grid;
}

/* A format that mirrored, turned or inverted both ways would come back; so each is compared with what it must say. */
static void test_orientation(void **state)
{
    (void)state;
    static const char *const wanted[NFORMATS] = {
        "K P P\nK K P\n",
        "k,k,p\nk,p,p\n",
        NULL,
        NULL,
        "Cast on 3 sts.\nRows 1 and 2: p2, k1. (3 sts)\nBind off.\n",
        "Cast on 3 sts; join to work in the round.\nRnd 1: p2, k1. (3 sts)\nRnd 2: p1, k2. (3 sts)\nBind off.\n",
    };
    struct arena arena = {0};
    const struct grid *flag = grid_of(&arena, "motif flag { chart {\nkkp\nkpp\n} }\nswatch flag");
    for (int i = 0; i < NFORMATS; i++)
        if (wanted[i]) {
            const struct source *text = sent(&arena, &formats[i], flag);
            assert_string_equal(text->text, wanted[i]);
        }
    assert_non_null(strstr(sent(&arena, &formats[3], flag)->text,
                           "; row 1\nknit - b3 1\nknit - b2 1\nknit - f1 1\n"));
    assert_non_null(strstr(sent(&arena, &formats[3], flag)->text,
                           "; row 2\nxfer b2 f2\nknit + f1 1\nknit + f2 1\nknit + b3 1\n"));
    arena_free(&arena);
}

static void test_peaks(void **state)
{
    (void)state;
    struct arena arena = {0};
    static const char *const images[] = {"mirror(peaks)", "flip(peaks)", "invert(peaks)", "turn(peaks)", "rotate(peaks)"};
    const struct grid *peaks = grid_of(&arena, "use peaks from std\nswatch peaks");
    for (size_t i = 0; i < sizeof images / sizeof *images; i++) {
        const struct grid *image = grid_of(&arena, arena_printf(&arena, "use peaks from std\nswatch %s", images[i]));
        assert_false(grid_equal(peaks, image));
        check_round_trips(image);
    }
    arena_free(&arena);
}

/* ---- one motif in four registers ---- */

static void test_registers(void **state)
{
    (void)state;
    static const char *const scripts[] = {
        "motif m multiple of 4 {\nRow 1 (RS): *p1, k3; rep from * to end\nRow 2 (WS): *p2, k2; rep from * to end\n"
        "Row 3 (RS): *p3, k1; rep from * to end\nRow 4 (WS): knit\n}\nswatch tile(m, 1, 2)",
        "motif m multiple of 4 {\nRnd 1: *p1, k3; rep from * to end\nRnd 2: *p2, k2; rep from * to end\n"
        "Rnd 3: *p3, k1; rep from * to end\nRnd 4: purl\n}\nswatch tile(m, 1, 2)",
        "motif m {\nchart {\npppp\nkppp\nkkpp\nkkkp\n}\n}\nswatch tile(m, 1, 2)",
        "motif m = each (x, y) in 4 by 4 : x + y < 3 ? K : P\nswatch tile(m, 1, 2)",
    };
    struct arena arena = {0};
    const struct grid *first = grid_of(&arena, scripts[2]);
    for (size_t i = 0; i < sizeof scripts / sizeof *scripts; i++) {
        const struct grid *other = grid_of(&arena, scripts[i]);
        if (!grid_equal(first, other))
            print_grid(other);
        assert_true(grid_equal(first, other));
    }
    arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_library),     cmocka_unit_test(test_random), cmocka_unit_test(test_orientation),
        cmocka_unit_test(test_peaks),       cmocka_unit_test(test_registers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
