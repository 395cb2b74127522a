/* SPDX-License-Identifier: GPL-3.0-or-later
 * Operations on two needle beds in, the rows of a plain fabric out. */
#include "charts/beds.h"

#include <stdarg.h>
#include <stddef.h>

enum { NEEDLES = 2 * NEEDLE_MOST + 1, PAGE = 1024, PAGES = NEEDLES / PAGE + 1, FEW = 4 };

/* A needle of each bed that face each other unracked. */
struct slot {
    int           loops[2];
    unsigned char knitted;      /* the bed its stitch of this pass was worked on */
};

/* Until a row has worked every loop there is, loops are cast on.  Behind the
 * first operation that is not plain there may only be a bind-off. */
enum phase { CASTING_ON, KNITTING, CLOSING };

struct beds {
    struct arena *arena;
    struct diag  *diag;
    struct raster raster;
    enum phase    phase;
    double        rack;
    struct slot  *page[PAGES];  /* of PAGE needles each, from the left; NULL: never used */
    int           nfilled;      /* needles that hold any */

    /* The pass of the carrier: stitches one behind the other in one direction. */
    int         direction, last, worked;
    bool        fresh;          /* it put loops on empty needles: still the cast-on */
    struct span begin, end;

    /* The fabric: the numbers of its stitches, from the left. */
    int        *column;         /* (ncolumns) */
    int         ncolumns, turned;       /* the direction of the last whole row */
    struct span first_row, last_row, dropped;

    /* What would be an error unless it begins a bind-off. */
    struct span where;
    const char *what;
    int         closed, longest;        /* loops drawn together; stitches of the longest pass since */
};

struct beds *beds_new(struct arena *arena, struct diag *diag)
{
    struct beds *beds = arena_new(arena, struct beds);
    *beds = (struct beds){.arena = arena, .diag = diag, .raster = {.arena = arena, .diag = diag}};
    return beds;
}

/* ---- loops ---- */

static struct slot *slot_at(struct beds *b, int number)
{
    struct slot **page = &b->page[(number + NEEDLE_MOST) / PAGE];
    if (!*page)
        *page = arena_array(b->arena, struct slot, PAGE);
    return *page + (number + NEEDLE_MOST) % PAGE;
}

/* The first needle from the i-th on that may ever have been used; PAGES * PAGE: none. */
static int next_used(const struct beds *b, int i)
{
    while (i < PAGES * PAGE && !b->page[i / PAGE])
        i += PAGE - i % PAGE;
    return i;
}

static int *loops_at(struct beds *b, struct needle n)
{
    return &slot_at(b, n.number)->loops[n.bed];
}

static void set_loops(struct beds *b, struct needle n, int loops)
{
    int *at = loops_at(b, n);
    b->nfilled += (loops > 0) - (*at > 0);
    *at = loops;
}

static const char *needle_name(struct beds *b, struct needle n)
{
    return arena_printf(b->arena, "%c%d", n.bed == BED_FRONT ? 'f' : 'b', n.number);
}

/* ---- what is not plain ---- */

__attribute__((format(printf, 3, 4)))
static void not_plain(struct beds *b, struct span span, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *what = arena_vprintf(b->arena, format, arguments);
    va_end(arguments);
    if (b->phase == CLOSING)
        return;
    b->phase = CLOSING;
    b->longest = b->worked;
    b->where = span;
    b->what = what;
}

/* A bind-off draws all loops together, a few at a time. */
static bool is_bind_off(const struct beds *b)
{
    int few = (b->ncolumns + 1) / 2 > FEW ? (b->ncolumns + 1) / 2 : FEW;
    return b->ncolumns > 0 && b->closed > 0 && b->closed >= b->ncolumns - 1 && b->longest < few;
}

static void part_of_a_row(struct beds *b, struct span span)
{
    not_plain(b, span, "this row works %d of %d stitches; short rows and slipped stitches are not plain knit and purl",
              b->worked, b->ncolumns);
}

/* ---- rows ---- */

/* The needles with loops become the fabric's columns. */
static void find_columns(struct beds *b)
{
    b->column = arena_array(b->arena, int, (size_t)b->nfilled);
    for (int i = next_used(b, 0); i < PAGES * PAGE; i = next_used(b, i + 1)) {
        const struct slot *slot = &b->page[i / PAGE][i % PAGE];
        if (slot->loops[BED_FRONT] || slot->loops[BED_BACK])
            b->column[b->ncolumns++] = i - NEEDLE_MOST;
    }
    b->first_row = b->begin;
    b->phase = KNITTING;
}

static void end_row(struct beds *b, struct span span)
{
    if (!b->ncolumns)
        find_columns(b);
    bool room = true;
    for (int i = 0; i < b->ncolumns && room; i++)
        room = raster_stitch(&b->raster, slot_at(b, b->column[i])->knitted == BED_FRONT ? STITCH_K : STITCH_P, span);
    raster_row(&b->raster, span);
    b->turned = b->direction;
    b->last_row = span;
    b->worked = 0;
}

/* One stitch more in the pass, or the first of another. */
static void step(struct beds *b, int direction, struct needle n, struct span span)
{
    bool on = b->worked > 0 && direction == b->direction && direction * (n.number - b->last) > 0;
    if (!on) {
        b->worked = 0;
        b->fresh = false;
        b->begin = span;
    }
    b->direction = direction;
    b->last = n.number;
    b->worked++;
    b->end = span;
    slot_at(b, n.number)->knitted = (unsigned char)n.bed;
    if (b->phase == CLOSING && b->worked > b->longest)
        b->longest = b->worked;
}

/* In the fabric: is this the next stitch of a plain row? Each needle has one loop
 * or none then, and none behind it: only a racked transfer could put two together. */
static void check_stitch(struct beds *b, int direction, struct needle n, struct span span)
{
    if (b->dropped.source)
        not_plain(b, span, "stitches were dropped before this one; a plain fabric keeps all of them to its last row");
    else if (b->worked > 0 && (direction != b->direction || direction * (n.number - b->last) <= 0))
        part_of_a_row(b, b->end);
    else if (b->worked == 0 && direction == b->turned)
        not_plain(b, span, "this row goes in the direction of the one below; plain rows take turns");
    else if (b->rack != 0)
        not_plain(b, span, "the beds are racked by %g here; a plain fabric is knitted unracked", b->rack);
    else if (*loops_at(b, n) == 0)
        not_plain(b, n.span, "needle %s holds no stitch: a new one would be an increase", needle_name(b, n));
}

void beds_knit(struct beds *b, int direction, struct needle n, struct span span)
{
    int loops = *loops_at(b, n);
    if (b->phase == KNITTING)
        check_stitch(b, direction, n, span);
    if (b->phase == CLOSING)
        b->closed += loops > 1 ? loops - 1 : 0;
    step(b, direction, n, span);
    b->fresh |= loops == 0;
    set_loops(b, n, 1);
    if (b->phase == KNITTING ? b->worked == b->ncolumns : b->phase == CASTING_ON && !b->fresh && b->worked == b->nfilled)
        end_row(b, span);
}

/* ---- loops that come, move and go ---- */

void beds_rack(struct beds *b, double rack)
{
    b->rack = rack;
}

void beds_tuck(struct beds *b, struct needle n, struct span span)
{
    if (b->phase == KNITTING)
        not_plain(b, span, "a tuck puts a second loop on a needle; that is not plain knit and purl");
    b->worked = 0;
    set_loops(b, n, *loops_at(b, n) + 1);
}

/* False after an error: the needles do not face each other. */
static bool facing(struct beds *b, struct needle n, struct needle to, struct span span)
{
    struct needle front = n.bed == BED_FRONT ? n : to, back = n.bed == BED_FRONT ? to : n;
    if (n.bed != to.bed && front.number == back.number + b->rack)
        return true;
    diag_error(b->diag, CODE_KNITOUT, span, "%s does not face %s%s", needle_name(b, n), needle_name(b, to),
               b->rack != 0 ? arena_printf(b->arena, " at a racking of %g", b->rack) : "");
    return false;
}

static void move(struct beds *b, struct needle n, struct needle to)
{
    set_loops(b, to, *loops_at(b, to) + *loops_at(b, n));
    set_loops(b, n, 0);
}

void beds_transfer(struct beds *b, struct needle n, struct needle to, struct span span)
{
    if (!facing(b, n, to, span) || !*loops_at(b, n))
        return;
    if (b->phase == KNITTING && b->rack != 0)
        not_plain(b, span, "a transfer while the beds are racked moves a stitch aside: cables and lace are not plain");
    if (b->phase == CLOSING)
        b->worked = 0;
    move(b, n, to);
}

void beds_split(struct beds *b, struct needle n, struct needle to, struct span span)
{
    if (!facing(b, n, to, span))
        return;
    if (b->phase != CLOSING)
        not_plain(b, span, "a split makes two stitches of one: an increase is not plain knit and purl");
    move(b, n, to);
    set_loops(b, n, 1);
}

void beds_drop(struct beds *b, struct needle n, struct span span)
{
    if (b->phase == KNITTING && b->worked > 0)
        part_of_a_row(b, b->end);
    if (b->phase == KNITTING)
        b->dropped = span;
    set_loops(b, n, 0);
}

/* ---- the whole ---- */

/* Loops, but no row over all of them. */
static void no_row(struct beds *b)
{
    int both = 0;
    for (int i = next_used(b, 0); i < PAGES * PAGE; i = next_used(b, i + 1))
        both += b->page[i / PAGE][i % PAGE].loops[BED_FRONT] && b->page[i / PAGE][i % PAGE].loops[BED_BACK];
    if (both)
        not_plain(b, b->end, "%d needles of the front bed and those that face them both hold stitches: a tube or a double "
                  "fabric is not one sheet of knit and purl", both);
    else
        not_plain(b, b->end, "no row works all of the stitches that are cast on");
}

const struct grid *beds_fabric(struct beds *b, const struct source *source, const char **remark)
{
    if (b->phase == CASTING_ON && b->end.source)
        no_row(b);
    if (b->phase == KNITTING && b->worked > 0)
        part_of_a_row(b, b->end);
    if (b->phase == CLOSING && !is_bind_off(b) && !b->diag->nerrors)
        diag_error(b->diag, CODE_NOT_PLAIN, b->where, "%s", b->what);
    const struct grid *grid = raster_grid(&b->raster, source, RASTER_BOTTOM_FIRST);
    if (grid)
        *remark = arena_printf(b->arena, "the front bed is taken as knit, the back bed as purl; rows from line %d to line %d%s",
                               diag_place(b->first_row).line, diag_place(b->last_row).line,
                               b->phase == CLOSING ? ", bound off behind them" : "");
    return grid;
}
