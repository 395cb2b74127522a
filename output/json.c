/* SPDX-License-Identifier: GPL-3.0-or-later
 * What cJSON lacks: numbers that read back exactly and text that is always
 * valid, added to a cJSON object, and read back. */
#include "output/json.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/number.h"

void json_number(cJSON *object, const char *key, double value)
{
    char text[NUMBER_TEXT] = "null";
    if (isfinite(value))
        number_print(text, value);
    cJSON_AddRawToObject(object, key, text);
}

void json_integer(cJSON *object, const char *key, int64_t value)
{
    char text[NUMBER_TEXT];
    snprintf(text, sizeof text, "%" PRId64, value);
    cJSON_AddRawToObject(object, key, text);
}

void json_unsigned(cJSON *object, const char *key, uint64_t value)
{
    char text[NUMBER_TEXT];
    snprintf(text, sizeof text, "%" PRIu64, value);
    cJSON_AddRawToObject(object, key, text);
}

/* Length of the UTF-8 character at text, 0 if there is none. */
static int character_length(const unsigned char *text)
{
    static const struct { unsigned char mask, lead; unsigned least; } form[] = {
        {0x80, 0x00, 0x0}, {0xE0, 0xC0, 0x80}, {0xF0, 0xE0, 0x800}, {0xF8, 0xF0, 0x10000},
    };
    for (int n = 1; n <= 4; n++) {
        if ((text[0] & form[n - 1].mask) != form[n - 1].lead)
            continue;
        unsigned point = text[0] & (unsigned char)~form[n - 1].mask;
        for (int i = 1; i < n; i++) {
            if ((text[i] & 0xC0) != 0x80)
                return 0;
            point = point << 6 | (text[i] & 0x3F);
        }
        bool surrogate = point >= 0xD800 && point < 0xE000;
        return point >= form[n - 1].least && point <= 0x10FFFF && !surrogate ? n : 0;
    }
    return 0;
}

void json_text(cJSON *object, const char *key, const char *text)
{
    char *clean = malloc(3 * strlen(text) + 1), *to = clean;
    if (!clean)
        return;
    for (const char *from = text; *from;) {
        int n = character_length((const unsigned char *)from);
        memcpy(to, n ? from : "\xEF\xBF\xBD", n ? (size_t)n : 3);
        to += n ? n : 3;
        from += n ? n : 1;
    }
    *to = '\0';
    cJSON_AddStringToObject(object, key, clean);
    free(clean);
}

/* Where the next number begins, or the end. */
static const char *next_number(const char *at)
{
    for (; *at && !strchr("-0123456789", *at); at++)
        if (*at == '"')
            for (at++; *at != '"'; at++)
                at += *at == '\\';
    return at;
}

/* Gives each number in item its own text; at goes through what item was parsed from. */
static void keep_numbers(cJSON *item, const char **at)
{
    cJSON *child;
    if (cJSON_IsNumber(item)) {
        const char *from = next_number(*at);
        size_t length = strspn(from, "+-.0123456789eE");
        item->valuestring = strndup(from, length);
        item->type = cJSON_Raw;
        *at = from + length;
    }
    cJSON_ArrayForEach(child, item)
        keep_numbers(child, at);
}

cJSON *json_parse(const char *text, size_t size)
{
    cJSON *root = cJSON_ParseWithLengthOpts(text, size + 1, NULL, true);
    keep_numbers(root, &text);
    return root;
}

bool json_print(cJSON *root)
{
    char *text = cJSON_Print(root);
    bool done = text;
    if (done)
        printf("%s\n", text);
    cJSON_free(text);
    cJSON_Delete(root);
    return done;
}
