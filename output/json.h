/* SPDX-License-Identifier: GPL-3.0-or-later
 * What cJSON lacks: numbers that read back exactly and text that is always
 * valid, added to a cJSON object, and read back. */
#ifndef WEFT_JSON_H
#define WEFT_JSON_H

#include <cjson/cJSON.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The number as the shortest text that reads back the same; null if not finite. */
void json_number(cJSON *object, const char *key, double value);

void json_integer(cJSON *object, const char *key, int64_t value);
void json_unsigned(cJSON *object, const char *key, uint64_t value);

/* Bytes that are not UTF-8 become U+FFFD. */
void json_text(cJSON *object, const char *key, const char *text);

/* A JSON text (size bytes, then a zero) with nothing behind it; NULL otherwise.  Numbers stay the raw text they are
 * (cJSON_IsRaw), so that what is printed of it has the same digits. */
cJSON *json_parse(const char *text, size_t size);

/* Prints it, indented and with a line end, to standard output and deletes it; false: out of memory. */
bool json_print(cJSON *);

#endif
