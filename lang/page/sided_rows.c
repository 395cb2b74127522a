/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sentence that works one row of a side in, the row in the language's words out. */
#include "lang/page/sided_rows.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* What the words read so far say. */
struct said {
    char stitch, side;      /* k or p, r or w; 0: not yet */
    bool one, row;          /* `1`, `a`, `the next`; `row` */
    bool begins;            /* `Start with`: where the work begins, or how the rows of another sentence do */
    bool facing;            /* `With WS facing` */
};

/* How long a word is that stands in such a sentence, and what it says; 0: another word. */
static size_t read_word(const char *text, struct said *said)
{
    size_t n;

    if ((n = words_one_of("knitting|knit|k|purling|purl|p", text)) > 0 && !said->stitch && !isdigit((unsigned char)text[n]))
        said->stitch = (char)tolower((unsigned char)*text);
    else if ((n = words_one_of("right side|right-side|wrong side|wrong-side|rs|ws", text)) > 0 && !said->side)
        said->side = (char)tolower((unsigned char)*text);
    else if ((n = words_one_of("row", text)) > 0 && !said->row && !words_behind_number(words_skip_blanks(text + n)))
        said->row = true;
    else if ((n = words_one_of("1|one|a|single|next", text)) > 0)
        said->one = true;
    else if ((n = words_one_of("begin|start|beginning|starting", text)) > 0)
        said->begins = true;
    else if ((n = words_one_of("facing you|facing", text)) > 0)
        said->facing = true;
    else if ((n = words_one_of("all sts|all stitches|across", text)) > 0 && said->stitch)
        said->row = said->one = true;
    else
        n = words_one_of("work|then|now|first|and|with|from|on|by|in|the", text);
    return n;
}

/* Where the sentence ends, or its part before another row; NULL: other words stand in it. */
static const char *read_said(const char *text, struct said *said)
{
    for (size_t n; !prose_line_ends(text) && !strchr(".;", *text); text = words_skip_blanks(text + n)) {
        bool all = said->stitch && said->side && said->row;

        if (all && (*text == ',' || words_is(text, "and")))
            return text;
        n = strchr(",:=", *text) ? 1 : read_word(text, said);
        if (!n)
            return NULL;
    }
    return text;
}

/* Whether the line above casts on. */
static bool is_below_cast_on(const char *text, size_t at)
{
    size_t line = words_line_start(text, at);

    while (line > 0 && words_ends_line(text[line - 1]))
        line--;
    return prose_begins_cast_on(text + words_line_start(text, line)) > 0;
}

size_t sided_rows_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    struct said said = {0};
    const char *end = strchr("\r\n.;", words_sign_before(text, at, " \t")) ? read_said(text + at, &said) : NULL;
    size_t more;

    if (!end || !said.stitch || !said.side || !said.row || !(said.one || said.facing || said.begins) || (said.begins && !is_below_cast_on(text, at)))
        return 0;
    more = words_one_of(", and then|, then|, and|,|and then|and", end);
    while (!more && end[-1] == ' ')
        end--;
    at = (size_t)(end - text) + more - at;
    if (at < strlen("k 1 row ws.") || at >= SIGNS_PLAIN)
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%c 1 row %cs%*s", said.stitch, said.side, (int)(at - strlen("k 1 row ws")), more ? "." : "");
    return at;
}
