/* SPDX-License-Identifier: GPL-3.0-or-later
 * The keys of gauge, material, springs, mesh and solve: values in, checked
 * against the table, the scene's fields out. */
#include "lang/settings.h"

#include <stddef.h>
#include <string.h>
#include <strings.h>

static const char *const discretisations[] = {"patch", "triangle", NULL};
static const char *const diagonals[] = {"uniform", "alternating", "crisscross", NULL};
static const char *const methods[] = {"auto", "newton", "plbfgs", "lbfgs", NULL};
static const char *const automatic[] = {"auto", NULL};

#define AT(field) offsetof(struct scene, field)

static const struct key keys[SETTINGS] = {
    {"gauge", "width", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 1.4, NULL, NULL, AT(gauge.width), NULL},
    {"gauge", "height", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 1.2, NULL, NULL, AT(gauge.height), NULL},
    {"material", "thickness", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 0.5, NULL, NULL,
     AT(material.thickness), NULL},
    {"material", "young", "force/length^2", KEY_NUMBER, 0, 1e-9, 1e12, false, 1, NULL, NULL,
     AT(material.young), NULL},
    {"material", "poisson", "", KEY_NUMBER, 0, -1, 0.5, true, 0.4, NULL, NULL, AT(material.poisson), NULL},
    {"springs", "stiffness", "force/length^2", KEY_NUMBER, 0, 0, 1e12, false, 0, NULL, NULL,
     AT(springs.stiffness), NULL},
    {"springs", "edges", "", KEY_EDGES, 0, 0, 0, false, 0, "all", key_edges, AT(springs.edges), NULL},
    {"mesh", "discretisation", "", KEY_WORD, 0, 0, 0, false, 0, "patch", discretisations,
     AT(mesh.discretisation), NULL},
    {"mesh", "per_stitch", "", KEY_PER_STITCH, 0, 1, 16, false, 0, "auto", automatic, AT(mesh.per_stitch),
     NULL},
    {"mesh", "diagonals", "", KEY_WORD, 0, 0, 0, false, 0, "uniform", diagonals, AT(mesh.diagonals), NULL},
    {"solve", "accuracy", "", KEY_NUMBER, 0, 1e-6, 0.5, false, 0.01, NULL, NULL, AT(solve.accuracy), NULL},
    {"solve", "steps", "", KEY_WHOLE, 0, 1, 10000, false, 10, NULL, NULL, AT(solve.steps), NULL},
    {"solve", "noise", "thickness", KEY_NUMBER, 0, 0, 10, false, 0.01, NULL, NULL, AT(solve.noise), NULL},
    {"solve", "seed", "", KEY_SEED, 0, 0, 9007199254740992.0, false, 1, NULL, NULL, AT(solve.seed), NULL},
    {"solve", "method", "", KEY_WORD, 0, 0, 0, false, 0, "auto", methods, AT(solve.method), NULL},
    {"solve", "tolerance", "young*thickness^2", KEY_NUMBER, 0, 1e-15, 1, false, 1e-8, NULL, NULL,
     AT(solve.tolerance), NULL},
    {"solve", "max_iterations", "", KEY_WHOLE, 0, 1, 1e9, false, 10000, NULL, NULL, AT(solve.max_iterations),
     NULL},
};

void settings_default(struct settings *settings)
{
    *settings = (struct settings){0};
    for (int i = 0; i < SETTINGS; i++)
        settings->value[i].value = key_default(&keys[i]);
}

bool settings_is_key(const char *name, size_t length)
{
    for (int i = 0; i < SETTINGS; i++)
        if (strlen(keys[i].name) == length && strncasecmp(keys[i].name, name, length) == 0)
            return true;
    return false;
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
        if (key_read(eval, where, &keys[i], pair->value, &to->value))
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
    if (key_read(eval, (struct where){eval->main, NULL}, &keys[i], value, &settings->value[i].value))
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
    for (int i = 0; i < SETTINGS; i++)
        key_store(&keys[i], &settings->value[i].value, scene);
}

int settings_list(const struct settings *settings, struct setting *setting)
{
    for (int i = 0; i < SETTINGS; i++)
        setting[i] = (struct setting){
            .name = keys[i].name,
            .unit = keys[i].unit,
            .text = settings->value[i].value.text,
            .number = settings->value[i].value.number[0],
            .from = settings->value[i].from,
            .low = 1,
        };
    return SETTINGS;
}
