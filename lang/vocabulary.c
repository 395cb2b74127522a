/* SPDX-License-Identifier: GPL-3.0-or-later
 * A word of row text in, a stitch and a count out. */
#include "lang/vocabulary.h"

#include "lang/page/words.h"
#include "lang/refused.h"
#include "lang/rows/rows.h"
#include "lang/typos.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Knit and purl in all the ways they are written; fabrics of which a row may have some stitches, `moss 5`. */
static const struct {
    const char *word;
    stitch_id stitch;
} plain[] = {
    {"k", STITCH_K},
    {"knit", STITCH_K},
    {"p", STITCH_P},
    {"purl", STITCH_P},
    {"seed", STITCH_SEED},
    {"moss", STITCH_SEED},
    {"garter", STITCH_GARTER},
    {"stockinette", STITCH_STOCKINETTE},
    {"reverse", STITCH_REVERSE},
};
enum { PLAIN = sizeof plain / sizeof *plain };

/* Own stitches by their name, then by their symbol, then in any case. */
static bool find_own(const struct eval *eval, const struct module *module, const char *word, size_t length, stitch_id *id)
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
    return false;
}

static bool find_plain(const char *word, size_t length, stitch_id *id)
{
    char first = (char)tolower((unsigned char)*word);

    for (int i = 0; i < PLAIN; i++)
        if (*plain[i].word == first && strncasecmp(plain[i].word, word, length) == 0 && !plain[i].word[length]) {
            *id = plain[i].stitch;
            return true;
        }
    return false;
}

/* Once for all of them. */
static void warn_moss(struct eval *eval, const struct module *module, const char *word, unsigned start)
{
    if (strncasecmp(word, "moss", 4) != 0 || eval->moss)
        return;
    eval->moss = true;
    diag_warning(eval->diag, CODE_AMBIGUOUS_NAME, (struct span){module->source, start, start + 4},
                 "'moss' is two patterns: in Britain what others call seed, in America a pattern of four rows");
    diag_hint(eval->diag, "taken as 'seed' (British moss)");
}

static struct nearest nearest_stitch(const struct module *module, const char *word)
{
    struct nearest nearest = nearest_to(word);

    for (int i = 0; i < PLAIN; i++)
        nearest_offer(&nearest, plain[i].word);
    for (const struct binding *b = module->first; b; b = b->after)
        if (binding_target((struct binding *)b) &&
            binding_target((struct binding *)b)->kind == BINDING_STITCH)
            nearest_offer(&nearest, b->name);
    return nearest;
}

/* `kk2`, `xp2`: a letter too many before a stitch with its number. */
static bool is_doubled(const char *word)
{
    size_t stitch = isalpha((unsigned char)*word) ? words_stitch_length(word + 1) : 0;

    return stitch && !word[1 + stitch] && (!strchr("kKpP", *word) || tolower((unsigned char)*word) == tolower((unsigned char)word[1]));
}

/* A word that is neither a stitch nor one of rows, nor nearly so. */
static bool is_foreign(struct eval *eval, const struct module *module, const char *word, size_t length)
{
    const char *copy = arena_copy(eval->arena, word, length);
    stitch_id id;

    return length > 1 && !isdigit((unsigned char)word[length]) && !find_own(eval, module, word, length, &id) && !find_plain(word, length, &id) &&
           !typos_is_word(copy) && !typos_meant(copy) && !nearest_stitch(module, copy).best;
}

/* `see the picture here`: two foreign words from a place on, or one behind another on the line, are a sentence, not a slip. */
static bool is_sentence(struct eval *eval, const struct module *module, unsigned start, bool told)
{
    const char *text = module->source->text;
    int n = told;

    for (unsigned at = start, length; n < 2 && at < start + WORDS_REACH && text[at] && !words_ends_line(text[at]) && text[at] != '#'; at += length ? length : 1) {
        length = (unsigned)words_length(text + at);
        n += length && is_foreign(eval, module, text + at, length);
    }
    return n > 1;
}

/* What was meant by a word that is no stitch: a stitch, or a word of rows.  Where the word is
 * one of those (`to edn`) the slip may stand behind it; the span becomes the slip's. */
static const char *meant_by(struct eval *eval, const struct module *module, struct span *span, const char *word, bool *of_rows)
{
    struct nearest stitch = nearest_stitch(module, word);
    const char *meant;

    *of_rows = false;
    if (is_doubled(word))
        return word + 1;
    meant = typos_is_word(word) ? typos_in_line(eval->arena, span) : typos_meant(word);

    *of_rows = meant && !(stitch.best && stitch.distance <= 1);
    return *of_rows ? meant : stitch.best;
}

/* `kl`, `PI`: a letter for the figure. */
static bool is_scanned(const char *word)
{
    return strchr("kKpP", word[0]) && word[0] && strchr("lI|", word[1]) && word[1] && !word[2];
}

/* `K l`: the same apart. */
static bool is_scanned_figure(const char *word)
{
    return strchr("lI", *word) && !word[1];
}

/* `B-K2`, `edge-p1`: what stands before the dash is where; or NULL. */
static const char *stitches_behind_dash(const char *word)
{
    const char *dash = strrchr(word, '-');

    return dash && dash > word && strchr("kKpP", dash[1]) && isdigit((unsigned char)dash[2]) && !dash[2 + strspn(dash + 2, "0123456789")] ? dash + 1 : NULL;
}

static void unknown(struct eval *eval, const struct module *module, const char *word, unsigned start)
{
    struct span span = {module->source, start, start + (unsigned)strlen(word)};
    bool told = eval->refused.source == span.source && start >= eval->refused.start && start < eval->refused.end, of_rows = false, sentence;
    const char *meant;

    /* What it was to be takes its time to find: past the messages that are shown a line is one error. */
    if (!diag_takes_more(eval->diag)) {
        if (!told)
            diag_error(eval->diag, CODE_STITCH, span, "'%s' is no stitch", word);
        eval->refused = told ? eval->refused : diag_line_around(span);
        return;
    }
    if (refused_word(eval->diag, word, span)) {
        eval->refused = told ? eval->refused : diag_line_around(span);
        return;
    }

    /* What else stands in a row that cannot be knitted goes with it. */
    if (told && typos_is_word(word))
        return;
    sentence = !is_doubled(word) && is_sentence(eval, module, start, told);
    meant = sentence ? NULL : meant_by(eval, module, &span, word, &of_rows);
    if (!told && (is_scanned(word) || is_scanned_figure(word))) {
        diag_error(eval->diag, CODE_STITCH, span, "'%s' is no stitch", word);
        diag_hint(eval->diag, "in a scanned text the letter l may stand for 1: '%.*s1'", is_scanned(word), word);
        return;
    }
    if (!told && stitches_behind_dash(word)) {
        diag_error(eval->diag, CODE_STITCH, span, "'%s' is no stitch", word);
        diag_hint(eval->diag, "`%s`, where what stands before it only says where: `(edge) k2`", stitches_behind_dash(word));
        return;
    }
    if (!told && strcasecmp(word, "x") == 0) {
        diag_error(eval->diag, CODE_STITCH, span, "what is worked so many times is not marked");
        diag_hint(eval->diag, "brackets hold it: `(k2, p2) x 2`");
        return;
    }
    if (told && !meant)
        return;
    diag_error(eval->diag, CODE_STITCH, span, "'%.*s' is no stitch", (int)(span.end - span.start), span.source->text + span.start);
    diag_did_you_mean(eval->diag, meant);
    if (!meant)
        diag_hint(eval->diag, sentence ? "a sentence stands on a line of its own, or behind `#`"
                                       : "stitches are k, p, and your own: `stitch T { kx = .. }`");
    if (!told && (of_rows || !meant))
        eval->refused = diag_line_around(span);
}

/* A name, or a name and behind it how many: only own ones have digits in them. */
static bool find_counted(const struct eval *eval, const struct module *module, const char *word, size_t length, stitch_id *id, long long *count)
{
    size_t digits = 0;

    *count = -1;
    if (find_own(eval, module, word, length, id))
        return true;
    while (digits < length && isdigit((unsigned char)word[length - 1 - digits]))
        digits++;
    if (digits == length || (digits && !find_own(eval, module, word, length - digits, id) && !find_plain(word, length - digits, id)))
        return false;
    if (!digits)
        return find_plain(word, length, id);
    *count = digits > 9 ? 999999999 : strtoll(word + length - digits, NULL, 10);
    return true;
}

bool vocabulary_has(const struct eval *eval, const struct module *module, const char *word, size_t length)
{
    stitch_id id;

    return find_own(eval, module, word, length, &id);
}

/* The place where a word is kept once it is known. */
static struct known_word *known_at(struct eval *eval, const char *word, size_t length)
{
    unsigned hash = (unsigned)length;

    for (size_t i = 0; i < length; i++)
        hash = 31 * hash + (unsigned char)word[i];
    return &eval->known[hash % KNOWN_WORDS];
}

bool vocabulary_stitch(struct eval *eval, const struct module *module, const char *word, size_t length, unsigned start,
                       stitch_id *id, long long *count)
{
    struct known_word *known = known_at(eval, word, length);

    if (known->module != module || known->length != length || memcmp(known->word, word, length) != 0) {
        if (!find_counted(eval, module, word, length, id, count)) {
            unknown(eval, module, arena_copy(eval->arena, word, length), start);
            return false;
        }
        *known = (struct known_word){module, word, length, *id, *count};
        if (*id == STITCH_SEED)
            warn_moss(eval, module, word, start);
    }
    *id = known->stitch;
    *count = known->count;
    return true;
}
