/* SPDX-License-Identifier: GPL-3.0-or-later
 * A scene's kinds of stitches in, their words and their definitions out. */
#include "charts/dictionary.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

const struct dictionary dictionary_plain = {
    .entry = {[STITCH_K] = {"k", "knit", false, STITCH_P}, [STITCH_P] = {"p", "purl", false, STITCH_K}},
};

/* ---- words ---- */

/* Does a stitch of the script's own go by this word, in any case? */
static bool is_own(const struct stitch *stitch, int n, const char *word)
{
    for (int id = STITCH_P + 1; id < n; id++)
        if (strcasecmp(stitch[id].name, word) == 0 || strcmp(stitch[id].symbol, word) == 0)
            return true;
    return false;
}

/* What shows itself is worked as itself; else the first that shows it. */
static int worked_on_ws(const struct stitch *stitch, int n, int shown)
{
    int id = 0;
    if (stitch[shown].ws == shown)
        return shown;
    while (id < n && stitch[id].ws != shown)
        id++;
    return id < n ? id : -1;
}

struct dictionary dictionary_of(const struct stitch *stitch, int n)
{
    struct dictionary dictionary = dictionary_plain;
    for (int id = 0; id < n; id++) {
        struct entry *entry = &dictionary.entry[id];
        if (id > STITCH_P)
            *entry = (struct entry){stitch[id].name, stitch[id].name, true, -1};
        else if (is_own(stitch, n, entry->name))
            *entry = (struct entry){entry->row, entry->row, true, -1};
        else if (is_own(stitch, n, entry->row))
            entry->row = entry->name;
        entry->on_ws = worked_on_ws(stitch, n, id);
    }
    return dictionary;
}

int dictionary_unshown(const struct dictionary *dictionary, const struct grid *grid)
{
    for (int row = 1; row < grid->rows; row += 2)
        for (int i = 0; i < grid->columns; i++)
            if (dictionary->entry[grid_at(grid, i, row)].on_ws < 0)
                return grid_at(grid, i, row);
    return -1;
}

/* ---- definitions ---- */

/* With as few digits as give the number again. */
static void write_number(struct text *text, const char *before, double value)
{
    char digits[32];
    int precision = 15;
    do
        snprintf(digits, sizeof digits, "%.*g", precision, value);
    while (strtod(digits, NULL) != value && precision++ < 17);
    text_print(text, "%s = %s", before, digits);
}

/* What a purl is where nothing is said of it: the knit stitch turned over. */
static struct stitch unsaid(const struct stitch *stitch, int id)
{
    const struct stitch *k = &stitch[STITCH_K];

    if (id == STITCH_K)
        return (struct stitch){.symbol = "k", .kx = -1, .ky = 1, .ws = STITCH_P};
    if (id == STITCH_P)
        return (struct stitch){.symbol = "p", .kx = 0 - k->kx, .ky = 0 - k->ky, .twist = 0 - k->twist, .ws = STITCH_K};
    return (struct stitch){.symbol = stitch[id].name, .ws = id};
}

bool dictionary_defines(const struct stitch *stitch, int id)
{
    struct stitch u = unsaid(stitch, id), s = stitch[id];

    return id > STITCH_P || s.kx != u.kx || s.ky != u.ky || s.twist != u.twist || s.ws != u.ws || strcmp(s.symbol, u.symbol) != 0;
}

static void define(struct text *text, const struct stitch *stitch, int id)
{
    const struct stitch *s = &stitch[id], u = unsaid(stitch, id);
    text_print(text, "stitch %s {", s->name);
    write_number(text, " kx", s->kx);
    write_number(text, "; ky", s->ky);
    if (s->twist != u.twist)
        write_number(text, "; twist", s->twist);
    if (strcmp(s->symbol, u.symbol) != 0)
        text_print(text, "; symbol = \"%s\"", s->symbol);
    if (s->ws != u.ws)
        text_print(text, "; ws = %s", stitch[s->ws].name);
    text_print(text, " }\n");
}

void dictionary_define(struct text *text, const struct stitch *stitch, int n)
{
    for (int id = 0; id < n; id++)
        if (dictionary_defines(stitch, id))
            define(text, stitch, id);
}
