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

/* What the wrong side of a stitch shows where nothing is said. */
static int turned(int id)
{
    return id == STITCH_K ? STITCH_P : id == STITCH_P ? STITCH_K : id;
}

static void define(struct text *text, const struct stitch *stitch, int id)
{
    const struct stitch *s = &stitch[id];
    text_print(text, "stitch %s {", s->name);
    write_number(text, " kx", s->kx);
    write_number(text, "; ky", s->ky);
    if (s->twist != 0)
        write_number(text, "; twist", s->twist);
    if (id > STITCH_P && strcmp(s->symbol, s->name) != 0)
        text_print(text, "; symbol = \"%s\"", s->symbol);
    if (s->ws != turned(id))
        text_print(text, "; ws = %s", stitch[s->ws].name);
    text_print(text, " }\n");
}

/* Knit and purl only where they show something else on the wrong side. */
void dictionary_define(struct text *text, const struct stitch *stitch, int n)
{
    for (int id = 0; id < n; id++)
        if (id > STITCH_P || stitch[id].ws != turned(id))
            define(text, stitch, id);
}
