/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a row's text in; the pattern that is worked there, and how far, out. */
#include "lang/page/within.h"

#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* Behind `row 3 of the`; the text itself, where no row is named. */
static const char *behind_row(const char *text, int *row)
{
    const char *of;

    *row = words_row(text);
    of = words_ordinal_length(text) ? words_next(words_skip_blanks(text + words_ordinal_length(text))) : words_behind_number(words_next(text));
    if (!*row || !of || !words_is(of, "of"))
        *row = 0;
    return *row ? words_skip_any(of, "of|the") : text;
}

/* Behind `4 sts`, and how many they are; NULL: another text. */
static const char *behind_stitches(const char *text, int *n)
{
    const char *of = words_behind_number(text);

    *n = of ? words_number(text) : 1;
    of = of ? of : text;
    return words_are_stitches(of) ? of + words_length(of) : NULL;
}

/* Behind `to last 4 sts`, `over the next 20 sts`; NULL: another text. */
static const char *behind_reach(const char *text, struct within *within)
{
    if (words_one_of("to|until|till", text) && words_one_of("last|within", words_skip_any(text, "to|until|till|the"))) {
        text = behind_stitches(words_skip_any(text, "to|until|till|the|last|within"), &within->last);
        return text && words_one_of("of", words_skip_blanks(text)) ? words_skip_any(text, "of|the|end|row") : text;
    }
    if (words_one_of("over|across|on|for", text))
        return behind_stitches(words_skip_any(text, "over|across|on|for|the|next|following|center|centre|middle|these"), &within->over);
    return text;
}

size_t within_length(const char *text, struct within *within)
{
    const char *at = words_skip_any(text, "work|follow|in|across|as|the"), *pattern, *end;

    *within = (struct within){0};
    pattern = behind_row(at, &within->row);
    if (!words_one_of("pattern|patt|pat", pattern))
        return 0;
    pattern = words_skip_any(pattern, "pattern|patt|pat|stitch|st|as|set|established|est|before");
    if (words_is(pattern, "across") && words_one_of("to", words_next(pattern)))
        pattern = words_next(pattern);
    end = behind_reach(pattern, within);
    if (!end || (end == pattern && !within->row && !strchr(",;", *end)))
        return 0;
    while (end > text && end[-1] == ' ')
        end--;
    return prose_line_ends(end) || strchr(",.;)", *words_skip_blanks(end)) ? (size_t)(end - text) : 0;
}
