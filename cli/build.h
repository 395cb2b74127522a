/* SPDX-License-Identifier: GPL-3.0-or-later
 * What this program was built from and runs on: nothing in, JSON out. */
#ifndef WEFT_BUILD_H
#define WEFT_BUILD_H

#include "output/file.h"
#include "output/json.h"

/* Adds "weft", "schema", "compiler", "flags", "libraries", "machine" to an object. */
void build_describe(cJSON *object);

/* SHA-256 of the running program; empty where the system does not show it. */
void build_hash(struct file_log *log, char sha256[FILE_HASH]);

#endif
