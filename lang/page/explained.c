/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line in; whether all of it explains the name of a fabric out. */
#include "lang/page/explained.h"

#include <ctype.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

enum kind { NONE, GARTER, STOCKING };

/* Behind `Garter st`, `Stockinette stitch (St st)`, and the sign of what it means; or NULL. */
static const char *behind_name(const char *text, enum kind *kind)
{
    static const char *const garter[] = {"garter", "g"}, *const stocking[] = {"stocking", "stockinette", "stockinet", "st"}, *const stitch[] = {"st", "stitch"},
                             *const reverse[] = {"rev", "reverse"};
    size_t bracket;

    text = words_find(text, reverse, 2) >= 0 ? words_next(text) : text;
    *kind = words_find(text, garter, 2) >= 0 ? GARTER : words_find(text, stocking, 4) >= 0 ? STOCKING : NONE;
    text = words_next(text);
    if (!*kind || words_find(text, stitch, 2) < 0)
        return NULL;
    text = words_next(text);
    text += *text == '.';
    bracket = *(text = words_skip_blanks(text)) == '(' ? strcspn(text, ")\r\n") : 0;
    text = words_skip_blanks(text + bracket + (bracket && text[bracket] == ')'));
    return *text && strchr(":=-", *text) ? words_skip_blanks(text + 1) : NULL;
}

/* What the words of an explanation speak of. */
struct said { bool knit, purl, every, rows, one; };     /* one: `knit 1 row` */

/* One of its words: its bytes, or 0, where it is another. */
static size_t word_length(const char *text, struct said *said)
{
    static const char *const word[] = {"one", "the", "and", "then", "on", "right", "wrong", "side", "rs", "ws", "repeat", "rep", "throughout", "rows", "row", "these", "two", "is", "are"},
                             *const every[] = {"every", "each", "all", "alternate", "alternately", "odd", "even"}, *const stitch[] = {"sts", "stitches"};
    size_t n = words_length(text);

    if (!n)
        return *text == '1' && !isdigit((unsigned char)text[1]) ? 1 : strchr(" \t,;.&", *text) != NULL;
    if (words_are(text, WORDS_PLAIN)) {
        *(tolower((unsigned char)*text) == 'k' ? &said->knit : &said->purl) = true;
        said->one |= prose_rows_follow(words_next(text));
        return isdigit((unsigned char)text[n]) ? 0 : n;
    }
    said->rows |= words_are_rows(text);
    said->every |= words_find(text, every, 7) >= 0 || words_are(text, WORDS_AGAIN | WORDS_SIDE) || words_is(text, "side");
    return words_find(text, word, sizeof word / sizeof *word) >= 0 || words_find(text, every, 7) >= 0 || words_find(text, stitch, 2) >= 0 ? n : 0;
}

bool explained_fabric(const char *line, bool cast_on)
{
    enum kind kind;
    struct said said = {0};
    const char *text = strchr("gGsSrR", *line) && *line ? behind_name(line, &kind) : NULL;

    for (size_t n; text && *text && !words_ends_line(*text); text += n) {
        n = words_one_of("1 ridge =|one ridge =|1 ridge is|one ridge is|1 garter ridge =", text) ? strcspn(text, ".\r\n") : word_length(text, &said);
        if (!n)
            return false;
    }
    if (cast_on && said.one && !said.every)
        return false;
    return text && (kind == GARTER ? said.rows && said.every && said.knit != said.purl : (said.rows || said.every) && said.knit && said.purl);
}
