/* SPDX-License-Identifier: GPL-3.0-or-later
 * What cJSON lacks: numbers that read back exactly and text that is always
 * valid, added to a cJSON object. */
#ifndef WEFT_JSON_H
#define WEFT_JSON_H

#include <cjson/cJSON.h>
#include <stdint.h>

/* The number as the shortest text that reads back the same; null if not finite. */
void json_number(cJSON *object, const char *key, double value);

void json_integer(cJSON *object, const char *key, int64_t value);
void json_unsigned(cJSON *object, const char *key, uint64_t value);

/* Bytes that are not UTF-8 become U+FFFD. */
void json_text(cJSON *object, const char *key, const char *text);

#endif
