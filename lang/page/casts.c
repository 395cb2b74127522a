/* SPDX-License-Identifier: GPL-3.0-or-later
 * The words behind `cast on` in, how many of them only say that the number is free out. */
#include "lang/page/casts.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "lang/page/words.h"

enum { SENTENCE = 150 };    /* bytes */

/* Whether words can tell of any number: no figures, no stop, and nothing to work. */
static bool may_be_said(const char *text)
{
    return !isdigit((unsigned char)*text) && !strchr(".;:{}", *text) && !words_are(text, WORDS_PLAIN | WORDS_ROW);
}

size_t casts_many(const char *text, size_t *close)
{
    static const char multiple[] = "multiple of|multiples of|mult of|mult. of|divisible by|evenly divisible by", parity[] = "even number|odd number|uneven number";
    size_t open = 0, at = 0, words = 0, lines = 0;

    *close = 0;
    for (size_t n; at < SENTENCE; at += n) {
        size_t found = words_one_of(multiple, text + at);

        if (found || words_one_of(parity, text + at))
            break;
        n = words_length(text + at) + (words_length(text + at) == 0);
        lines += text[at] == '\n';
        words += isalpha((unsigned char)text[at]) && !words_one_of("a|an", text + at);
        open = text[at] == '(' ? at : text[at] == ')' ? 0 : open;
        if (!text[at] || lines > 1 || !may_be_said(text + at))
            return 0;
    }
    if (at >= SENTENCE || (!words && !open))
        return 0;
    *close = open ? at + strcspn(text + at, ")\r\n") : 0;
    *close = *close && text[*close] == ')' ? *close : 0;
    return at;
}
