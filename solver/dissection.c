/* SPDX-License-Identifier: GPL-3.0-or-later
 * A grid's extent in, the place of each node in the elimination order out. */
#include "solver/dissection.h"

enum { LEAF = 3 };      /* boxes this many reaches wide are eliminated as they stand */

struct box {
    int x0, x1, y0, y1;     /* half open */
};

struct dissection {
    int  nx, reach, next;
    int  half[2];           /* ends of the two halves of the cut being closed: in the end, of the first */
    int *place;
};

static void number_box(struct dissection *d, struct box b)
{
    for (int y = b.y0; y < b.y1; y++)
        for (int x = b.x0; x < b.x1; x++)
            d->place[y * d->nx + x] = d->next++;
}

/* Both halves first, then the separating lines across the longer side; the
 * depth is the logarithm of the grid's size. */
static void dissect(struct dissection *d, struct box b)
{
    int w = b.x1 - b.x0, h = b.y1 - b.y0, longer = w > h ? w : h;
    if (longer <= LEAF * d->reach) {
        number_box(d, b);
        return;
    }
    struct box low = b, middle = b, high = b;
    int cut = (longer - d->reach) / 2;
    if (w > h) {
        low.x1 = middle.x0 = b.x0 + cut;
        middle.x1 = high.x0 = middle.x0 + d->reach;
    } else {
        low.y1 = middle.y0 = b.y0 + cut;
        middle.y1 = high.y0 = middle.y0 + d->reach;
    }
    dissect(d, low);
    int first = d->next;
    dissect(d, high);
    d->half[0] = first;
    d->half[1] = d->next;
    number_box(d, middle);
}

void dissection_order(int nx, int ny, int reach, int *place, int parts[2])
{
    struct dissection d = {.nx = nx, .reach = reach, .place = place};
    dissect(&d, (struct box){0, nx, 0, ny});
    parts[0] = d.half[0];
    parts[1] = d.half[1];
}
