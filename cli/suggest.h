/* SPDX-License-Identifier: GPL-3.0-or-later
 * A mistyped word and the words there are in, the nearest one out. */
#ifndef WEFT_SUGGEST_H
#define WEFT_SUGGEST_H

struct suggestion {
    const char *wanted;
    const char *word;       /* the nearest so far, NULL: none is near */
    int         distance;
};

struct suggestion suggest_begin(const char *wanted);
void              suggest_word(struct suggestion *suggestion, const char *word);

#endif
