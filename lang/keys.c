/* SPDX-License-Identifier: GPL-3.0-or-later
 * A key's row of its table and an expression in, a checked value out. */
#include "lang/keys.h"

#include <math.h>
#include <string.h>

const char *const key_edges[] = {"all", "none", "left", "right", "top", "bottom", NULL};

static int word_index(const char *const *words, const char *word)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(words[i], word) == 0)
            return i;
    return -1;
}

struct key_value key_default(const struct key *key)
{
    struct key_value value = {.number = {key->number}, .text = key->word};

    if (key->type == KEY_EDGES)
        value.number[0] = EDGE_ALL;
    else if (key->words)
        value.number[0] = word_index(key->words, key->word);
    if (key->type == KEY_ANGLES)
        memcpy(value.number, key->angles[(int)value.number[0]], sizeof value.number);
    return value;
}

/* ---- words ---- */

static bool wrong_word(struct eval *eval, const struct key *key, struct span span, const char *word)
{
    struct nearest nearest = nearest_to(word);
    const char *list = "";

    for (int i = 0; key->words[i]; i++) {
        nearest_offer(&nearest, key->words[i]);
        list = arena_printf(eval->arena, "%s%s%s", list, i ? ", " : "", key->words[i]);
    }
    diag_error(eval->diag, CODE_WORD, span, "%s is not '%s'; it is one of: %s%s", key->name, word, list,
               key->type == KEY_PER_STITCH ? ", 1, 2, 4, 8, 16"
               : key->type == KEY_ANGLES   ? ", (azimuth, elevation)"
                                           : "");
    diag_did_you_mean(eval->diag, nearest.best);
    return false;
}

/* The word an expression stands for: a bare one of the key's, or a text. */
static const char *word_of(struct eval *eval, struct where where, const struct key *key, const struct expr *e)
{
    struct value value;

    if (e->kind == EXPR_NAME && (word_index(key->words, e->text) >= 0 || !module_find(where.module, e->text)))
        return e->text;
    value = eval_expr(eval, where, e);
    if (value.kind == VALUE_STRING)
        return value.text;
    if (value.kind != VALUE_BAD)
        diag_error(eval->diag, CODE_TYPE, e->span, "%s is a word%s, not %s", key->name,
                   key->type == KEY_ANGLES ? " or (azimuth, elevation)" : "", value_type(value));
    return NULL;
}

static bool read_text(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                      struct key_value *to)
{
    struct value value = eval_expr(eval, where, e);

    if (value.kind == VALUE_STRING)
        to->text = value.text;
    else if (value.kind != VALUE_BAD)
        diag_error(eval->diag, CODE_TYPE, e->span, "%s is a text in quotes, not %s", key->name, value_type(value));
    return value.kind == VALUE_STRING;
}

static bool read_word(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                      struct key_value *to)
{
    const char *word = word_of(eval, where, key, e);
    int i;

    if (!word)
        return false;
    i = word_index(key->words, word);
    if (i < 0)
        return wrong_word(eval, key, e->span, word);
    to->text = key->words[i];
    to->number[0] = i;
    return true;
}

/* One side adds itself to the set; `all` and `none` stand alone. */
static bool add_edge(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                     bool alone, unsigned *set)
{
    static const unsigned bits[] = {EDGE_ALL, 0, EDGE_LEFT, EDGE_RIGHT, EDGE_TOP, EDGE_BOTTOM};
    const char *word = word_of(eval, where, key, e);
    int i;

    if (!word)
        return false;
    i = word_index(key_edges, word);
    if (i < 0 || (i < 2 && !alone))
        return wrong_word(eval, key, e->span, word);
    *set |= bits[i];
    return true;
}

static bool read_edges(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                       struct key_value *to)
{
    static const enum edge bit[] = {EDGE_LEFT, EDGE_RIGHT, EDGE_TOP, EDGE_BOTTOM};
    unsigned set = 0;

    if (e->kind != EXPR_LIST && !add_edge(eval, where, key, e, true, &set))
        return false;
    for (const struct expr *side = e->kind == EXPR_LIST ? e->list.first : NULL; side; side = side->next)
        if (!add_edge(eval, where, key, side, false, &set))
            return false;
    to->number[0] = set;
    to->text = set == EDGE_ALL ? "all" : set == 0 ? "none" : "";
    for (int i = 0; i < 4 && set != EDGE_ALL; i++)
        if (set & bit[i])
            to->text = *to->text ? arena_printf(eval->arena, "%s, %s", to->text, key_edges[i + 2])
                                 : key_edges[i + 2];
    return true;
}

/* ---- numbers ---- */

static bool in_range(struct eval *eval, const struct key *key, struct span span, double number)
{
    if (number <= key->high && (key->above_low ? number > key->low : number >= key->low))
        return true;
    diag_error(eval->diag, CODE_RANGE, span, "%s = %.15g is out of range: %s %g and at most %g", key->name,
               number, key->above_low ? "greater than" : "at least", key->low, key->high);
    if (strcmp(key->name, "accuracy") == 0 && number >= 1)
        diag_hint(eval->diag, "one percent is written 1%% or 0.01");
    return false;
}

static bool read_number(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                        struct key_value *to)
{
    double number;

    /* Without this a mistyped number would read "nothing here is called". */
    if (e->kind == EXPR_STRING) {
        diag_error(eval->diag, CODE_TYPE, e->span, "%s is a number, not a text", key->name);
        return false;
    }
    if (!eval_number(eval, where, e, key->dimension, &number))
        return false;
    if (key->type != KEY_NUMBER && number != floor(number)) {
        diag_error(eval->diag, CODE_WHOLE, e->span, "%s must be a whole number, not %g", key->name, number);
        return false;
    }
    if (!in_range(eval, key, e->span, number))
        return false;
    to->number[0] = number;
    to->text = NULL;
    return true;
}

static bool read_per_stitch(struct eval *eval, struct where where, const struct key *key,
                            const struct expr *e, struct key_value *to)
{
    int n;

    if (e->kind == EXPR_NAME && !module_find(where.module, e->text)) {
        if (!read_word(eval, where, key, e, to))
            return false;
        to->number[0] = 0;
        return true;
    }
    if (!read_number(eval, where, key, e, to))
        return false;
    n = (int)to->number[0];
    if ((n & (n - 1)) == 0)
        return true;
    diag_error(eval->diag, CODE_RANGE, e->span, "per_stitch = %d is out of range: auto, 1, 2, 4, 8 or 16", n);
    return false;
}

/* One of two angles, in degrees. */
static bool read_angle(struct eval *eval, struct where where, const struct expr *e, const char *what,
                       double limit, double *angle)
{
    if (!eval_number(eval, where, e, 0, angle))
        return false;
    if (fabs(*angle) <= limit)
        return true;
    diag_error(eval->diag, CODE_RANGE, e->span,
               "%s = %.15g is out of range: at least -%g and at most %g degrees", what, *angle, limit, limit);
    return false;
}

static bool read_angles(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                        struct key_value *to)
{
    if (e->kind != EXPR_LIST) {
        if (!read_word(eval, where, key, e, to))
            return false;
        memcpy(to->number, key->angles[(int)to->number[0]], sizeof to->number);
        return true;
    }
    if (e->list.n != 2) {
        diag_error(eval->diag, CODE_TYPE, e->span, "%s takes two angles, (azimuth, elevation), not %d",
                   key->name, e->list.n);
        return false;
    }
    to->text = NULL;
    return read_angle(eval, where, e->list.first, "azimuth", 360, &to->number[0]) &&
           read_angle(eval, where, e->list.first->next, "elevation", 90, &to->number[1]);
}

bool key_read(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
              struct key_value *to)
{
    switch (key->type) {
    case KEY_WORD:
    case KEY_SWITCH:
        return read_word(eval, where, key, e, to);
    case KEY_EDGES:
        return read_edges(eval, where, key, e, to);
    case KEY_PER_STITCH:
        return read_per_stitch(eval, where, key, e, to);
    case KEY_TEXT:
        return read_text(eval, where, key, e, to);
    case KEY_ANGLES:
        return read_angles(eval, where, key, e, to);
    default:
        return read_number(eval, where, key, e, to);
    }
}

/* ---- results ---- */

size_t key_size(const struct key *key)
{
    switch (key->type) {
    case KEY_NUMBER: return sizeof(double);
    case KEY_SEED: return sizeof(uint64_t);
    case KEY_EDGES: return sizeof(unsigned);
    case KEY_SWITCH: return sizeof(bool);
    case KEY_TEXT: return sizeof(char *);
    case KEY_ANGLES: return 2 * sizeof(double);
    default: return sizeof(int);
    }
}

void key_store(const struct key *key, const struct key_value *value, void *structure)
{
    void *field = (char *)structure + key->offset;

    switch (key->type) {
    case KEY_NUMBER:
        *(double *)field = value->number[0];
        break;
    case KEY_SEED:
        *(uint64_t *)field = (uint64_t)value->number[0];
        break;
    case KEY_EDGES:
        *(unsigned *)field = (unsigned)value->number[0];
        break;
    case KEY_SWITCH:
        *(bool *)field = value->number[0] != 0;
        break;
    case KEY_TEXT:
        *(const char **)field = value->text;
        break;
    case KEY_ANGLES:
        memcpy(field, value->number, sizeof value->number);
        break;
    default:
        *(int *)field = (int)value->number[0];
    }
}
