/* SPDX-License-Identifier: GPL-3.0-or-later
 * A written pattern in, the fabric it makes and its words as a script out. */
#include "charts/words.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "charts/lines.h"
#include "charts/text.h"
#include "lang/compile.h"

enum { LOOK = 20 };     /* lines */

/* `Row 1`, `Rnds 2`, `R3`, `1st row`, `Cast on 20`, `CO 20`, `Multiple of 4`: a word, then a blank or a digit. */
static bool begins_like_a_row(struct span line)
{
    static const char *const words[] = {"row", "rows", "round", "rounds", "rnd", "rnds", "r", "co", "cast", "multiple"};
    const char *text = line.source->text + line.start;
    size_t length = line.end - line.start, n = 0;
    while (n < length && isdigit((unsigned char)text[n]))
        n++;
    if (n)
        return length > n + 2 && isalpha((unsigned char)text[n]) && isalpha((unsigned char)text[n + 1]) && text[n + 2] == ' ';
    while (n < length && isalpha((unsigned char)text[n]))
        n++;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (n == strlen(words[i]) && strncasecmp(text, words[i], n) == 0)
            return n < length && (isdigit((unsigned char)text[n]) || (text[n] == ' ' && n > 1));
    return false;
}

/* `motif dots {`: the rows behind it are the motif's own. */
static bool begins_a_motif(struct span line)
{
    const char *text = line.source->text + line.start;
    size_t length = line.end - line.start;
    return length > 6 && strncasecmp(text, "motif ", 6) == 0 && (memchr(text, '{', length) || memchr(text, '=', length));
}

bool words_is(const struct source *source)
{
    struct lines lines = lines_of(source);
    struct span line;
    for (int i = 0; i < LOOK && lines_next(&lines, &line) && !begins_a_motif(line); i++)
        if (begins_like_a_row(line))
            return true;
    return false;
}

/* The text without a byte order mark, its lines ending as on Unix. */
static const char *copy(struct arena *arena, const struct source *source, const char *before)
{
    struct text text = {.arena = arena};
    struct lines lines = lines_of(source);
    text_print(&text, "%s", before);
    for (size_t i = lines.at; i < source->size; i++)
        if (source->text[i] != '\r')
            text_bytes(&text, source->text + i, 1);
        else if (source->text[i + 1] != '\n')
            text_bytes(&text, "\n", 1);
    if (text.length && text.bytes[text.length - 1] != '\n')
        text_bytes(&text, "\n", 1);
    text_bytes(&text, "", 1);
    return text.bytes;
}

struct pattern words_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct pattern pattern = {.across = 1, .up = 1};
    struct compile_options least = {.least_width = true};
    const struct scene *scene = scene_compile(arena, diag, source, &least);
    if (!scene)
        return pattern;

    /* The same without the liberty taken: does the text say its width? */
    struct diag ignored;
    diag_init(&ignored, arena);
    const char *cast_on = "";
    pattern.grid = scene->grid;
    const struct scene *said = scene_compile(arena, &ignored, source, NULL);
    if (!said || said->grid->columns != scene->grid->columns) {
        int n = scene->grid->columns;
        cast_on = arena_printf(arena, "Cast on %d st%s.\n", n, n == 1 ? "" : "s");
        pattern.remark = arena_printf(arena, "how many stitches to cast on is not said; %d is the least the rows fit", n);
    }
    pattern.words = copy(arena, source, cast_on);
    return pattern;
}
