/* SPDX-License-Identifier: GPL-3.0-or-later
 * What this program was built from and runs on: nothing in, JSON out. */
#ifndef WEFT_BUILD_H
#define WEFT_BUILD_H

#include "output/file.h"
#include "output/json.h"

/* Adds "weft", "schema", "compiler", "flags", "libraries", "machine" to an object. */
void build_describe(cJSON *object);

/* What tells the running program from any other build: its GNU build id, which the linker takes from all of it, in
 * hexadecimal; where it has none its SHA-256; empty where the system shows neither. */
void build_id(char id[FILE_HASH]);

#endif
