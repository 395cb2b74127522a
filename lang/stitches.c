/* SPDX-License-Identifier: GPL-3.0-or-later
 * Kinds of stitches: `stitch NAME { .. }` statements in, the scene's table of
 * stitches out. */
#include <math.h>
#include <string.h>

#include "lang/eval.h"
#include "lang/limits.h"

static bool is_knit_or_purl(const struct eval *eval, const char *name)
{
    return name == eval->word_K || name == eval->word_P;
}

/* Gives every stitch of a file its place in the table; K and P have theirs. */
void stitches_declare(struct eval *eval, struct module *module)
{
    for (struct binding *b = module->first; b; b = b->after) {
        if (b->kind != BINDING_STITCH)
            continue;
        b->state = DONE;
        if (is_knit_or_purl(eval, b->name)) {
            b->value =
                (struct value){.kind = VALUE_STITCH, .stitch = b->name == eval->word_K ? STITCH_K : STITCH_P};
            if (module != eval->main) {
                diag_error(eval->diag, CODE_PLACE, b->span, "a file that is used cannot change %s", b->name);
                continue;
            }
            eval->stitch_binding[b->value.stitch] = b;
            continue;
        }
        if (eval->nstitches == STITCH_MAX) {
            diag_error(eval->diag, CODE_LIMIT_STITCHDEF, b->span, "there can be %d kinds of stitches",
                       STITCH_MAX);
            b->value = (struct value){.kind = VALUE_BAD};
            continue;
        }
        for (int i = 0; i < eval->nstitches; i++)
            if (strcmp(eval->stitch[i].name, b->name) == 0) {
                diag_error(eval->diag, CODE_TWICE, b->span, "there is a stitch '%s' in another file already",
                           b->name);
                diag_note(eval->diag, eval->stitch_binding[i]->span, "here");
            }
        b->value = (struct value){.kind = VALUE_STITCH, .stitch = (stitch_id)eval->nstitches};
        eval->stitch_binding[eval->nstitches] = b;
        eval->stitch[eval->nstitches] = (struct stitch){.name = b->name, .ws = (stitch_id)eval->nstitches};
        eval->ws[eval->nstitches] = (stitch_id)eval->nstitches;
        eval->nstitches++;
    }
}

/* ---- the keys of a stitch ---- */

static const char *const stitch_key[] = {"kx", "ky", "twist", "symbol", "ws"};
enum { NUMBERS = 3, NKEYS = STITCH_KEYS };
static const double largest = 1e6;

static bool number_key(struct eval *eval, struct where where, const struct expr *value, const char *key,
                       double *to)
{
    double number;

    if (!eval_number(eval, where, value, -1, &number))
        return false;
    if (fabs(number) > largest) {
        diag_error(eval->diag, CODE_RANGE, value->span, "%s = %g is out of range: from -1e6 to 1e6", key,
                   number);
        return false;
    }
    *to = number;
    return true;
}

static bool symbol_key(struct eval *eval, struct where where, const struct expr *value, const char **to)
{
    struct value text = eval_expr(eval, where, value);

    if (text.kind == VALUE_BAD)
        return false;
    if (text.kind != VALUE_STRING || !*text.text || strpbrk(text.text, " \t")) {
        diag_error(eval->diag, CODE_TYPE, value->span, "symbol is a character in quotes, such as \"t\"");
        return false;
    }
    *to = text.text;
    return true;
}

static bool ws_key(struct eval *eval, struct where where, const struct expr *value, stitch_id *to)
{
    struct value stitch = eval_expr(eval, where, value);

    if (stitch.kind == VALUE_STITCH)
        *to = stitch.stitch;
    else if (stitch.kind != VALUE_BAD)
        diag_error(eval->diag, CODE_TYPE, value->span,
                   "ws is the stitch it shows when worked on the wrong side, this is %s", value_type(stitch));
    return stitch.kind == VALUE_STITCH;
}

/* One key = value, from the file or the command line. */
static bool set_key(struct eval *eval, struct where where, int id, int key, const struct expr *value)
{
    struct stitch *stitch = &eval->stitch[id];
    double *number[NUMBERS] = {&stitch->kx, &stitch->ky, &stitch->twist};

    if (key < NUMBERS)
        return number_key(eval, where, value, stitch_key[key], number[key]);
    if (key == NUMBERS)
        return symbol_key(eval, where, value, &stitch->symbol);
    return ws_key(eval, where, value, &stitch->ws);
}

static int find_key(const char *name)
{
    for (int i = 0; i < NKEYS; i++)
        if (strcmp(stitch_key[i], name) == 0)
            return i;
    return -1;
}

static void unknown_key(struct eval *eval, struct span span, const char *key)
{
    diag_error(eval->diag, CODE_UNKNOWN_KEY, span, "a stitch has no key '%s'", key);
    diag_did_you_mean(eval->diag, nearest_in(key, stitch_key, NKEYS));
    if (!nearest_in(key, stitch_key, NKEYS))
        diag_hint(eval->diag, "its keys are kx, ky, twist, symbol and ws");
}

/* ---- the whole table ---- */

static void file_keys(struct eval *eval, int id, enum origin from[NKEYS])
{
    const struct binding *b = eval->stitch_binding[id];
    struct span seen[NKEYS] = {{0}};

    if (!b)
        return;
    for (const struct pair *pair = b->stmt->stitch.pair; pair; pair = pair->next) {
        int key = find_key(pair->key);

        if (key < 0) {
            unknown_key(eval, pair->key_span, pair->key);
            continue;
        }
        if (seen[key].source) {
            diag_error(eval->diag, CODE_TWICE, pair->key_span, "'%s' is given twice", pair->key);
            diag_note(eval->diag, seen[key], "the first time");
            continue;
        }
        seen[key] = pair->key_span;
        if (set_key(eval, (struct where){b->module, NULL}, id, key, pair->value))
            from[key] = FROM_FILE;
    }
}

bool stitches_override(struct eval *eval, const char *name, const char *key, struct span span,
                       const struct expr *value)
{
    for (int id = 0; id < eval->nstitches; id++)
        if (strcmp(eval->stitch[id].name, name) == 0) {
            int k = find_key(key);

            if (k < 0)
                unknown_key(eval, span, key);
            else if (set_key(eval, (struct where){eval->main, NULL}, id, k, value))
                eval->stitch_from[id][k] = FROM_COMMAND_LINE;
            return true;
        }
    return false;
}

/* P is K turned over, in every key it was not given. */
static void turn_over(struct eval *eval)
{
    struct stitch *k = &eval->stitch[STITCH_K], *p = &eval->stitch[STITCH_P];
    const double from_k[NUMBERS] = {0 - k->kx, 0 - k->ky, 0 - k->twist};
    double *to_p[NUMBERS] = {&p->kx, &p->ky, &p->twist};

    for (int i = 0; i < NUMBERS; i++)
        if (eval->stitch_from[STITCH_P][i] == FROM_DEFAULT) {
            *to_p[i] = from_k[i];
            eval->stitch_from[STITCH_P][i] = eval->stitch_from[STITCH_K][i];
        }
}

void stitches_evaluate(struct eval *eval)
{
    for (int id = 0; id < eval->nstitches; id++)
        file_keys(eval, id, eval->stitch_from[id]);
}

/* Where the script gives a stitch its symbol; or NULL. */
static const struct pair *symbol_pair(const struct eval *eval, int id)
{
    const struct binding *b = eval->stitch_binding[id];
    const struct pair *pair = b ? b->stmt->stitch.pair : NULL;

    while (pair && find_key(pair->key) != NUMBERS)
        pair = pair->next;
    return pair;
}

/* One symbol is one stitch's: charts know them by it. */
static void shared_symbols(struct eval *eval)
{
    for (int id = 0; id < eval->nstitches; id++)
        for (int other = 0; other < id; other++) {
            const struct pair *first = symbol_pair(eval, other), *second = symbol_pair(eval, id);

            if (!first || !second || strcmp(eval->stitch[id].symbol, eval->stitch[other].symbol) != 0)
                continue;
            diag_error(eval->diag, CODE_TWICE, second->value->span, "this is the symbol of '%s' already", eval->stitch[other].name);
            diag_note(eval->diag, first->value->span, "here");
        }
}

void stitches_finish(struct eval *eval)
{
    turn_over(eval);
    for (int id = 0; id < eval->nstitches; id++) {
        struct stitch *stitch = &eval->stitch[id];

        if (!stitch->symbol)
            stitch->symbol = stitch->name;
        eval->ws[id] = stitch->ws;
    }
    shared_symbols(eval);
}

/* The stitches' lines of the report. */
int stitches_settings(struct eval *eval, struct setting *setting)
{
    int n = 0;

    for (int id = 0; id < eval->nstitches; id++) {
        const struct stitch *stitch = &eval->stitch[id];
        const double number[NUMBERS] = {stitch->kx, stitch->ky, stitch->twist};

        for (int key = 0; key < NKEYS; key++)
            setting[n++] = (struct setting){
                .name = arena_printf(eval->arena, "%s.%s", stitch->name, stitch_key[key]),
                .unit = key < NUMBERS ? "1/length" : "",
                .text = key < NUMBERS    ? NULL
                        : key == NUMBERS ? stitch->symbol
                                         : eval->stitch[stitch->ws].name,
                .number = key < NUMBERS ? number[key] : 0,
                .from = eval->stitch_from[id][key],
                .low = 1,
            };
    }
    return n;
}
