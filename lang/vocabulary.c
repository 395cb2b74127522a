/* SPDX-License-Identifier: GPL-3.0-or-later
 * A word of row text in, a stitch and a count out; stitches that version 1
 * cannot knit are refused by their names. */
#include "lang/vocabulary.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* '#' stands for digits, '*' for anything to the end. */
static const struct refused {
    const char *word;
    const char *what;
} refused[] = {
    {"k#tog*", "a decrease"},
    {"p#tog*", "a decrease"},
    {"ssk", "a decrease"},
    {"sssk", "a decrease"},
    {"ssp", "a decrease"},
    {"skp*", "a decrease"},
    {"sk#p*", "a decrease"},
    {"s#kp*", "a decrease"},
    {"cdd", "a decrease"},
    {"dec*", "a decrease"},
    {"tog", "a decrease"},
    {"psso*", "a decrease"},
    {"yo", "an increase"},
    {"yo#", "an increase"},
    {"yfwd", "an increase"},
    {"yf", "an increase"},
    {"yrn", "an increase"},
    {"yon", "an increase"},
    {"m#", "an increase"},
    {"m#l", "an increase"},
    {"m#r", "an increase"},
    {"m#p*", "an increase"},
    {"kfb", "an increase"},
    {"kf&b", "an increase"},
    {"pfb", "an increase"},
    {"kfbf", "an increase"},
    {"inc*", "an increase"},
    {"lli", "an increase"},
    {"rli", "an increase"},
    {"sl", "a slipped stitch"},
    {"sl#*", "a slipped stitch"},
    {"slip*", "a slipped stitch"},
    {"s#", "a slipped stitch"},
    {"wyif", "a slipped stitch"},
    {"wyib", "a slipped stitch"},
    {"ktbl", "a twisted stitch"},
    {"k#tbl", "a twisted stitch"},
    {"k#-tbl", "a twisted stitch"},
    {"ptbl", "a twisted stitch"},
    {"p#tbl", "a twisted stitch"},
    {"tbl", "a twisted stitch"},
    {"k#b", "a stitch into the row below"},
    {"c#f*", "a cable"},
    {"c#b*", "a cable"},
    {"c#l*", "a cable"},
    {"c#r*", "a cable"},
    {"t#f*", "a cable"},
    {"t#b*", "a cable"},
    {"t#l", "a cable"},
    {"t#r", "a cable"},
    {"tw#*", "a cable"},
    {"cr#*", "a cable"},
    {"rt", "a cable"},
    {"lt", "a cable"},
    {"cable*", "a cable"},
    {"cn", "a cable"},
    {"#/#*", "a cable"},
    {"mb", "a bobble"},
    {"bobble*", "a bobble"},
    {"bo", "binding off"},
    {"bo#", "binding off"},
    {"bind", "binding off"},
    {"cast", "casting on or off"},
    {"drop*", "a dropped stitch"},
    {"w&t", "a short row"},
    {"wrap*", "a short row"},
};

static bool matches(const char *pattern, const char *word)
{
    for (; *pattern; pattern++) {
        if (*pattern == '*')
            return true;
        if (*pattern == '#') {
            if (!isdigit((unsigned char)*word))
                return false;
            word += strspn(word, "0123456789");
        } else if (tolower((unsigned char)*word++) != *pattern) {
            return false;
        }
    }
    return !*word;
}

static const char *refused_as(const char *word)
{
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        if (matches(refused[i].word, word))
            return refused[i].what;
    return NULL;
}

/* Knit and purl in all the ways they are written. */
static const struct {
    const char *word;
    stitch_id stitch;
} plain[] = {
    {"k", STITCH_K},
    {"knit", STITCH_K},
    {"p", STITCH_P},
    {"purl", STITCH_P},
};
enum { PLAIN = sizeof plain / sizeof *plain };

/* Own stitches by their name, then by their symbol, then in any case; then the
 * plain ones. */
static bool find(const struct eval *eval, const struct module *module, const char *word, size_t length,
                 stitch_id *id)
{
    for (int pass = 0; pass < 3; pass++)
        for (const struct binding *b = module->first; b; b = b->after) {
            const struct binding *stitch = binding_target((struct binding *)b);
            const char *name = b->name;

            if (!stitch || stitch->kind != BINDING_STITCH || stitch->value.kind != VALUE_STITCH)
                continue;
            if (pass == 1)
                name = eval->stitch[stitch->value.stitch].symbol;
            if (!name || strlen(name) != length ||
                (pass < 2 ? strncmp(name, word, length) : strncasecmp(name, word, length)))
                continue;
            *id = stitch->value.stitch;
            return true;
        }
    for (int i = 0; i < PLAIN; i++)
        if (strlen(plain[i].word) == length && strncasecmp(plain[i].word, word, length) == 0) {
            *id = plain[i].stitch;
            return true;
        }
    return false;
}

static void unknown(struct eval *eval, const struct module *module, const char *word, struct span span)
{
    const char *what = refused_as(word);
    struct nearest nearest = nearest_to(word);

    span.end = span.start + (unsigned)strlen(word);
    if (what) {
        diag_error(eval->diag, CODE_SHAPING, span,
                   "'%s' (%s) changes the stitch count or the topology; version 1 handles knit and purl (and "
                   "your own "
                   "plain stitches)",
                   word, what);
        return;
    }
    for (int i = 0; i < PLAIN; i++)
        nearest_offer(&nearest, plain[i].word);
    for (const struct binding *b = module->first; b; b = b->after)
        if (binding_target((struct binding *)b) &&
            binding_target((struct binding *)b)->kind == BINDING_STITCH)
            nearest_offer(&nearest, b->name);
    diag_error(eval->diag, CODE_STITCH, span, "'%s' is no stitch", word);
    diag_did_you_mean(eval->diag, nearest.best);
    if (!nearest.best)
        diag_hint(eval->diag, "stitches are k, p, and your own: `stitch T { kx = .. }`");
}

bool vocabulary_stitch(struct eval *eval, const struct module *module, const char *word, struct span span,
                       stitch_id *id, long long *count)
{
    size_t length = strlen(word), digits = 0;

    *count = -1;
    if (find(eval, module, word, length, id))
        return true;
    while (digits < length && isdigit((unsigned char)word[length - 1 - digits]))
        digits++;

    /* A name, then how many. */
    if (digits && digits < length && find(eval, module, word, length - digits, id)) {
        *count = digits > 9 ? 999999999 : strtoll(word + length - digits, NULL, 10);
        return true;
    }
    unknown(eval, module, word, span);
    return false;
}
