/* SPDX-License-Identifier: GPL-3.0-or-later
 * The blocks' keys: gauge, material, springs, mesh, solve. One table holds
 * every key with its default, unit and range. */
#ifndef WEFT_SETTINGS_H
#define WEFT_SETTINGS_H

#include "lang/keys.h"

enum { SETTINGS = 17 };

/* A key's value and where it comes from. */
struct setting_value {
    struct key_value value;
    enum origin      from;
    struct span      span;      /* of the key in the file */
};

struct settings {
    struct setting_value value[SETTINGS];
};

void settings_default(struct settings *);

/* Whether one of the blocks has a key of this name. */
bool settings_is_key(const char *name, size_t length);

/* Reads a block of the file. Errors are in diag. */
void settings_block(struct eval *, struct settings *, const struct stmt *);

/* Sets "block.key" from the command line; false where there is no such key. */
bool settings_override(struct eval *, struct settings *, const char *name, const struct expr *value);

void settings_offer(struct arena *, struct nearest *);

/* Puts the values where the scene has them, and lists them. */
void settings_apply(const struct settings *, struct scene *);
int settings_list(const struct settings *, struct setting *);

#endif
