/* SPDX-License-Identifier: GPL-3.0-or-later
 * A grid in, instructions for a knitting machine out. */
#include <stdio.h>

#include "charts/knitout.h"

/* The yarn; the first of the carriers the header names. */
#define CARRIER "1"
#define CARRIERS "1 2 3 4 5 6 7 8 9 10"

enum { LEFTWARD = -1, RIGHTWARD = 1 };

static char bed(const struct grid *g, int column, int row)
{
    return grid_at(g, column, row) == STITCH_K ? 'f' : 'b';
}

/* `knit - f12 1` */
static void stitch(struct text *text, const char *operation, int direction, char where, int column)
{
    char line[64];
    int n = snprintf(line, sizeof line, "%s %c %c%d " CARRIER "\n", operation, direction < 0 ? '-' : '+', where, column + 1);
    text_bytes(text, line, (size_t)n);
}

/* Every other needle leftward to the first, then those between: the loops lie on the beds the first row wants. The
 * carrier ends to the right of all; of an odd number, past the last, which has its loop. */
static void cast_on(struct text *text, const struct grid *g)
{
    int last = g->columns - 1;
    text_print(text, "\n; cast on %d\ninhook " CARRIER "\n", g->columns);
    for (int i = last - last % 2; i >= 0; i -= 2)
        stitch(text, "tuck", LEFTWARD, bed(g, i, 0), i);
    for (int i = 1; i <= last; i += 2)
        stitch(text, "tuck", RIGHTWARD, bed(g, i, 0), i);
    if (last % 2 == 0)
        stitch(text, "miss", RIGHTWARD, bed(g, last, 0), last);
}

static void transfer(struct text *text, const struct grid *g, int row)
{
    for (int i = 0; row > 0 && i < g->columns; i++)
        if (bed(g, i, row - 1) != bed(g, i, row)) {
            char line[64];
            int n = snprintf(line, sizeof line, "xfer %c%d %c%d\n", bed(g, i, row - 1), i + 1, bed(g, i, row), i + 1);
            text_bytes(text, line, (size_t)n);
        }
}

static void knit_row(struct text *text, const struct grid *g, int row)
{
    int direction = row % 2 == 0 ? LEFTWARD : RIGHTWARD;
    for (int i = direction < 0 ? g->columns - 1 : 0; i >= 0 && i < g->columns; i += direction)
        stitch(text, "knit", direction, bed(g, i, row), i);
}

static void drop_off(struct text *text, const struct grid *g)
{
    text_print(text, "\n; off the machine\nouthook " CARRIER "\n");
    for (int i = 0; i < g->columns; i++)
        text_print(text, "drop %c%d\n", bed(g, i, g->rows - 1), i + 1);
}

void knitout_write(struct text *text, const struct grid *g)
{
    text_print(text, ";!knitout-2\n;;Carriers: " CARRIERS "\n");
    cast_on(text, g);
    for (int row = 0; row < g->rows; row++) {
        text_print(text, "\n; row %d\n", row + 1);
        transfer(text, g, row);
        knit_row(text, g, row);
        if (row == 0)
            text_print(text, "releasehook " CARRIER "\n");
    }
    drop_off(text, g);
}
