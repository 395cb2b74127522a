/* SPDX-License-Identifier: GPL-3.0-or-later
 * What could stand where something else stands: the grammar's tokens in, words
 * for a knitter out. */
#include "lang/expected.h"

#include <string.h>

#include "lang/parser.h"

enum { LISTED = 6 };    /* more alternatives than these are not listed */

/* Tokens that are one thing to a reader: where the first stands, all are
 * named by the phrase, or left out. */
static const struct family {
    const char *phrase;
    const char *token[20];
} families[] = {
    /* A value, and what any value may go on with. */
    {"a value", {"'each'", "a name", "a number", "a text in quotes", "'('", "'['", "'-'", "'!'"}},
    {NULL, {"'||'", "'&&'", "'=='", "'!='", "'<'", "'>'", "'<='", "'>='", "'+'", "'-'", "'*'", "'/'", "'mod'", "'?'", "'('", "'['", "'.'"}},

    /* What a row is made of, and what may stand behind a stitch or a group. */
    {"stitches", {"'knit the knits and purl the purls'", "'work in pattern to the last stitches'", "a name", "'('", "'['", "so many times", "a marker", "'*' in a row", "'as row'", "'as 3rd row'", "a fabric's name"}},
    {NULL, {"'to end'", "'to marker'", "'to end, ending'", "'ending last repeat'", "'to last'", "'until'", "'twice'", "'x' (times)", "a number", "'{' of a number",
            "'sts'", "'repeat'", "'('", "'['"}},
    {NULL, {"'--'", "'repeat' without a star", "RS or WS behind a row"}},

    {"a number", {"a number", "'{' of a number"}},
    {"the end of the line", {"the end of the line", "the end of the text"}},
};
enum { NFAMILIES = sizeof families / sizeof *families };

bool expected_has(const char *const *token, int n, const char *name)
{
    for (int i = 0; i < n; i++)
        if (strcmp(token[i], name) == 0)
            return true;
    return false;
}

static bool belongs(const struct family *family, const char *token)
{
    for (int i = 0; i < 20 && family->token[i]; i++)
        if (strcmp(family->token[i], token) == 0)
            return true;
    return false;
}

/* Puts the phrase in the place of the family's first token; the new length. */
static int gather(const struct family *family, const char *token[], int n)
{
    const char *phrase = family->phrase;
    int kept = 0;

    if (!expected_has(token, n, family->token[0]))
        return n;
    for (int i = 0; i < n; i++) {
        bool member = belongs(family, token[i]);

        if (!member || phrase)
            token[kept++] = member ? phrase : token[i];
        phrase = member ? NULL : phrase;
    }
    return kept;
}

const char *expected_list(struct arena *arena, const char *const *expected, int n)
{
    const char *token[EXPECTED_TOKENS], *list = "";
    int first;

    memcpy(token, expected, (size_t)n * sizeof *token);
    for (int i = 0; i < NFAMILIES; i++)
        n = gather(&families[i], token, n);
    if (n == 0 || n > LISTED)
        return NULL;

    /* The end of the line comes last. */
    first = n > 1 && strcmp(token[0], "the end of the line") == 0;
    for (int i = 0; i < n; i++)
        list = arena_printf(arena, "%s%s%s", list, i == 0 ? "" : i == n - 1 ? " or " : ", ", token[(i + first) % n]);
    return list;
}

const char *expected_form(int statement)
{
    static const struct {
        int statement;
        const char *form;
    } forms[] = {
        {TOKEN_USE, "`use seed from std`, or a file, in quotes: `use \"mine.knit\"`"},
        {TOKEN_PARAM, "`param n = 4 in 1..9 \"what it is\"`"},
        {TOKEN_STITCH, "`stitch T { kx = 1; ky = 0 }`"},
        {TOKEN_BLOCK, "`gauge { width = 1.4; height = 1.2 }`"},
        {TOKEN_MOTIF, "`motif name multiple of 4 + 2 { .. }`, or `motif name = ..`"},
        {TOKEN_OUTPUT, "`output \"x.vtp\"`, or with its kind: `output report \"x.json\"`"},
        {TOKEN_SWEEP, "`sweep n in 1..5 by 2`"},
        {TOKEN_FOR, "`for i in 1..4 { .. }`"},
        {TOKEN_CHART, "`chart (x = P, o = K) { .. }`"},
        {TOKEN_CAST_ON, "`Cast on 22 sts`"},
        {TOKEN_REPEAT_ROWS, "which rows, and how often: `Repeat rows 1-4 5 times`"},
        {TOKEN_WORK, "`Work 6 rows in garter st`; several fabrics side by side are rows of their own: `Row 1: k1, p1, knit to last 2 sts, p1, k1`"},
    };

    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
        if (forms[i].statement == statement)
            return forms[i].form;
    return NULL;
}
