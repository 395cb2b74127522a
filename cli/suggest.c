/* SPDX-License-Identifier: GPL-3.0-or-later
 * A mistyped word and the words there are in, the nearest one out. */
#include <config.h>

#include "cli/suggest.h"

#include <stddef.h>
#include <string.h>

enum { LENGTH_MAX = 63 };

/* Letters to change, add, drop or swap with their neighbour to get from a to b. */
static int distance(const char *a, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    if (n > LENGTH_MAX || m > LENGTH_MAX)
        return LENGTH_MAX;
    int row[3][LENGTH_MAX + 1] = {0};       /* the last two rows of the table and the new one */
    int *before = row[0], *last = row[1], *now = row[2];
    for (size_t j = 0; j <= m; j++)
        last[j] = (int)j;
    for (size_t i = 1; i <= n; i++) {
        now[0] = (int)i;
        for (size_t j = 1; j <= m; j++) {
            int best = last[j - 1] + (a[i - 1] != b[j - 1]);
            best = last[j] + 1 < best ? last[j] + 1 : best;
            best = now[j - 1] + 1 < best ? now[j - 1] + 1 : best;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && before[j - 2] + 1 < best)
                best = before[j - 2] + 1;
            now[j] = best;
        }
        int *free_row = before;
        before = last;
        last = now;
        now = free_row;
    }
    return last[m];
}

struct suggestion suggest_begin(const char *wanted)
{
    /* At most a third of the letters may be wrong. */
    return (struct suggestion){.wanted = wanted, .distance = (int)(strlen(wanted) + 2) / 3 + 1};
}

void suggest_word(struct suggestion *s, const char *word)
{
    int d = distance(s->wanted, word);
    if (d < s->distance) {
        s->distance = d;
        s->word = word;
    }
}
