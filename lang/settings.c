/* SPDX-License-Identifier: GPL-3.0-or-later
 * The keys of gauge, material, springs, mesh and solve: values in, checked
 * against the table, the scene's fields out. */
#include "lang/settings.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

enum key_type {
    KEY_NUMBER,
    KEY_WHOLE,
    KEY_SEED, /* a whole number kept in 64 bits */
    KEY_WORD,
    KEY_EDGES,     /* all, none or a list of sides */
    KEY_PER_STITCH /* auto or a power of two */
};

struct key {
    const char *block, *name, *unit;
    enum key_type type;
    int dimension;            /* numbers: 1 for a length */
    double low, high;         /* numbers: allowed values, both included, */
    bool above_low;           /* unless low itself is not */
    double number;            /* the default */
    const char *word;         /* words: the default, */
    const char *const *words; /* and all of them, in the order of their enum */
    size_t offset;            /* in struct scene */
};

static const char *const discretisations[] = {"patch", "triangle", NULL};
static const char *const diagonals[] = {"uniform", "alternating", "crisscross", NULL};
static const char *const methods[] = {"auto", "newton", "plbfgs", "lbfgs", NULL};
static const char *const edges[] = {"all", "none", "left", "right", "top", "bottom", NULL};
static const char *const automatic[] = {"auto", NULL};

#define AT(field) offsetof(struct scene, field)

static const struct key keys[SETTINGS] = {
    {"gauge", "width", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 1.4, NULL, NULL, AT(gauge.width)},
    {"gauge", "height", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 1.2, NULL, NULL, AT(gauge.height)},
    {"material", "thickness", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 0.5, NULL, NULL,
     AT(material.thickness)},
    {"material", "young", "force/length^2", KEY_NUMBER, 0, 1e-9, 1e12, false, 1, NULL, NULL,
     AT(material.young)},
    {"material", "poisson", "", KEY_NUMBER, 0, -1, 0.5, true, 0.4, NULL, NULL, AT(material.poisson)},
    {"springs", "stiffness", "force/length^2", KEY_NUMBER, 0, 0, 1e12, false, 0, NULL, NULL,
     AT(springs.stiffness)},
    {"springs", "edges", "", KEY_EDGES, 0, 0, 0, false, 0, "all", edges, AT(springs.edges)},
    {"mesh", "discretisation", "", KEY_WORD, 0, 0, 0, false, 0, "patch", discretisations,
     AT(mesh.discretisation)},
    {"mesh", "per_stitch", "", KEY_PER_STITCH, 0, 1, 16, false, 0, "auto", automatic, AT(mesh.per_stitch)},
    {"mesh", "diagonals", "", KEY_WORD, 0, 0, 0, false, 0, "uniform", diagonals, AT(mesh.diagonals)},
    {"solve", "accuracy", "", KEY_NUMBER, 0, 1e-6, 0.5, false, 0.01, NULL, NULL, AT(solve.accuracy)},
    {"solve", "steps", "", KEY_WHOLE, 0, 1, 10000, false, 10, NULL, NULL, AT(solve.steps)},
    {"solve", "noise", "thickness", KEY_NUMBER, 0, 0, 10, false, 0.01, NULL, NULL, AT(solve.noise)},
    {"solve", "seed", "", KEY_SEED, 0, 0, 9007199254740992.0, false, 1, NULL, NULL, AT(solve.seed)},
    {"solve", "method", "", KEY_WORD, 0, 0, 0, false, 0, "auto", methods, AT(solve.method)},
    {"solve", "tolerance", "young*thickness^2", KEY_NUMBER, 0, 1e-15, 1, false, 1e-8, NULL, NULL,
     AT(solve.tolerance)},
    {"solve", "max_iterations", "", KEY_WHOLE, 0, 1, 1e9, false, 10000, NULL, NULL, AT(solve.max_iterations)},
};

void settings_default(struct settings *settings)
{
    *settings = (struct settings){0};
    for (int i = 0; i < SETTINGS; i++) {
        settings->value[i].number = keys[i].number;
        settings->value[i].text = keys[i].word;
    }
}

/* ---- words ---- */

static int word_index(const char *const *words, const char *word)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(words[i], word) == 0)
            return i;
    return -1;
}

static bool wrong_word(struct eval *eval, const struct key *key, struct span span, const char *word)
{
    struct nearest nearest = nearest_to(word);
    const char *list = "";

    for (int i = 0; key->words[i]; i++) {
        nearest_offer(&nearest, key->words[i]);
        list = arena_printf(eval->arena, "%s%s%s", list, i ? ", " : "", key->words[i]);
    }
    diag_error(eval->diag, CODE_WORD, span, "%s is not '%s'; it is one of: %s%s", key->name, word, list,
               key->type == KEY_PER_STITCH ? ", 1, 2, 4, 8, 16" : "");
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
        diag_error(eval->diag, CODE_TYPE, e->span, "%s is a word, not %s", key->name, value_type(value));
    return NULL;
}

static bool read_word(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                      struct setting_value *to)
{
    const char *word = word_of(eval, where, key, e);
    int i;

    if (!word)
        return false;
    i = word_index(key->words, word);
    if (i < 0)
        return wrong_word(eval, key, e->span, word);
    to->text = key->words[i];
    to->number = i;
    return true;
}

int settings_word(struct eval *eval, struct where where, const char *name, const char *const *words,
                  const struct expr *e)
{
    const struct key key = {.name = name, .type = KEY_WORD, .words = words};
    struct setting_value value;

    return read_word(eval, where, &key, e, &value) ? (int)value.number : -1;
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
    i = word_index(edges, word);
    if (i < 0 || (i < 2 && !alone))
        return wrong_word(eval, key, e->span, word);
    *set |= bits[i];
    return true;
}

static bool read_edges(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                       struct setting_value *to)
{
    static const enum edge bit[] = {EDGE_LEFT, EDGE_RIGHT, EDGE_TOP, EDGE_BOTTOM};
    unsigned set = 0;

    if (e->kind != EXPR_LIST && !add_edge(eval, where, key, e, true, &set))
        return false;
    for (const struct expr *side = e->kind == EXPR_LIST ? e->list.first : NULL; side; side = side->next)
        if (!add_edge(eval, where, key, side, false, &set))
            return false;
    to->number = set;
    to->text = set == EDGE_ALL ? "all" : set == 0 ? "none" : "";
    for (int i = 0; i < 4 && set != EDGE_ALL; i++)
        if (set & bit[i])
            to->text = *to->text ? arena_printf(eval->arena, "%s, %s", to->text, edges[i + 2]) : edges[i + 2];
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
                        struct setting_value *to)
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
    to->number = number;
    to->text = NULL;
    return true;
}

static bool read_per_stitch(struct eval *eval, struct where where, const struct key *key,
                            const struct expr *e, struct setting_value *to)
{
    int n;

    if (e->kind == EXPR_NAME && !module_find(where.module, e->text)) {
        if (!read_word(eval, where, key, e, to))
            return false;
        to->number = 0;
        return true;
    }
    if (!read_number(eval, where, key, e, to))
        return false;
    n = (int)to->number;
    if ((n & (n - 1)) == 0)
        return true;
    diag_error(eval->diag, CODE_RANGE, e->span, "per_stitch = %d is out of range: auto, 1, 2, 4, 8 or 16", n);
    return false;
}

static bool read_key(struct eval *eval, struct where where, const struct key *key, const struct expr *e,
                     struct setting_value *to)
{
    switch (key->type) {
    case KEY_WORD:
        return read_word(eval, where, key, e, to);
    case KEY_EDGES:
        return read_edges(eval, where, key, e, to);
    case KEY_PER_STITCH:
        return read_per_stitch(eval, where, key, e, to);
    default:
        return read_number(eval, where, key, e, to);
    }
}

/* ---- blocks ---- */

static int find_key(const char *block, size_t length, const char *name)
{
    for (int i = 0; i < SETTINGS; i++)
        if (strlen(keys[i].block) == length && strncmp(keys[i].block, block, length) == 0 &&
            strcmp(keys[i].name, name) == 0)
            return i;
    return -1;
}

static void unknown_key(struct eval *eval, const char *block, struct span span, const char *name)
{
    struct nearest nearest = nearest_to(name);
    const char *list = "";

    for (int i = 0; i < SETTINGS; i++)
        if (strcmp(keys[i].block, block) == 0) {
            nearest_offer(&nearest, keys[i].name);
            list = arena_printf(eval->arena, "%s%s%s", list, *list ? ", " : "", keys[i].name);
        }
    diag_error(eval->diag, CODE_UNKNOWN_KEY, span, "%s has no key '%s'", block, name);
    diag_did_you_mean(eval->diag, nearest.best);
    for (int i = 0; i < SETTINGS && !nearest.best; i++)
        if (strcmp(keys[i].name, name) == 0)
            diag_hint(eval->diag, "'%s' is a key of %s", name, keys[i].block);
    if (!nearest.best)
        diag_hint(eval->diag, "its keys are %s", list);
}

void settings_block(struct eval *eval, struct settings *settings, const struct stmt *stmt)
{
    const char *block = stmt->block.name.name;
    struct where where = {eval->main, NULL};

    for (const struct pair *pair = stmt->block.pair; pair; pair = pair->next) {
        int i = find_key(block, strlen(block), pair->key);
        struct setting_value *to;

        if (i < 0) {
            unknown_key(eval, block, pair->key_span, pair->key);
            continue;
        }
        to = &settings->value[i];
        if (to->span.source) {
            diag_error(eval->diag, CODE_TWICE, pair->key_span, "'%s' is given twice", pair->key);
            diag_note(eval->diag, to->span, "the first time");
            continue;
        }
        to->span = pair->key_span;
        if (read_key(eval, where, &keys[i], pair->value, to))
            to->from = FROM_FILE;
    }
}

bool settings_override(struct eval *eval, struct settings *settings, const char *name,
                       const struct expr *value)
{
    const char *dot = strchr(name, '.');
    int i = dot ? find_key(name, (size_t)(dot - name), dot + 1) : -1;

    if (i < 0)
        return false;
    if (read_key(eval, (struct where){eval->main, NULL}, &keys[i], value, &settings->value[i]))
        settings->value[i].from = FROM_COMMAND_LINE;
    return true;
}

/* Every key as the command line writes it. */
void settings_offer(struct arena *arena, struct nearest *nearest)
{
    for (int i = 0; i < SETTINGS; i++)
        nearest_offer(nearest, arena_printf(arena, "%s.%s", keys[i].block, keys[i].name));
}

/* ---- results ---- */

void settings_apply(const struct settings *settings, struct scene *scene)
{
    for (int i = 0; i < SETTINGS; i++) {
        void *field = (char *)scene + keys[i].offset;
        double number = settings->value[i].number;

        switch (keys[i].type) {
        case KEY_NUMBER:
            *(double *)field = number;
            break;
        case KEY_SEED:
            *(uint64_t *)field = (uint64_t)number;
            break;
        case KEY_EDGES:
            *(unsigned *)field = settings->value[i].from == FROM_DEFAULT ? EDGE_ALL : (unsigned)number;
            break;
        default:
            *(int *)field = (int)number;
        }
    }
}

int settings_list(const struct settings *settings, struct setting *setting)
{
    for (int i = 0; i < SETTINGS; i++)
        setting[i] = (struct setting){
            .name = keys[i].name,
            .unit = keys[i].unit,
            .text = settings->value[i].text,
            .number = settings->value[i].number,
            .from = settings->value[i].from,
            .low = 1,
        };
    return SETTINGS;
}
