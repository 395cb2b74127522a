/* SPDX-License-Identifier: GPL-3.0-or-later
 * A manifest that stands beside a run's outputs: its path in, what it says of
 * that run out. */
#include <config.h>

#include "cli/recorded.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/manifest.h"

__attribute__((format(printf, 2, 3)))
static bool refuse(struct recorded *r, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->why, sizeof r->why, format, arguments);
    va_end(arguments);
    return false;
}

/* ---- its members ---- */

const char *recorded_text(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    return cJSON_IsString(item) ? item->valuestring : "";
}

int recorded_integer(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    return cJSON_IsRaw(item) && item->valuestring ? atoi(item->valuestring) : 0;
}

const cJSON *recorded_command(const struct recorded *r)
{
    return cJSON_GetObjectItemCaseSensitive(r->root, "command");
}

bool recorded_same(const cJSON *output, const struct file_entry *entry)
{
    const char *lasting = recorded_text(output, "lasting_sha256");
    return *lasting ? strcmp(entry->lasting, lasting) == 0
                    : strcmp(entry->sha256, recorded_text(output, "sha256")) == 0;
}

/* ---- the whole ---- */

bool recorded_read(struct recorded *r, const char *path)
{
    struct arena arena = {0};
    const char *why = "";
    const struct source *source = source_read(&arena, path, &why);
    if (source)
        r->root = json_parse(source->text, source->size);
    else
        refuse(r, "cannot be read: %s", why);
    bool read = source;
    arena_free(&arena);
    if (!read)
        return false;
    const cJSON *schema = cJSON_GetObjectItemCaseSensitive(r->root, "manifest");
    if (!cJSON_IsRaw(schema) || !cJSON_IsArray(cJSON_GetObjectItemCaseSensitive(recorded_command(r), "arguments")))
        return refuse(r, "this is no manifest of weft");
    if (recorded_integer(r->root, "manifest") != MANIFEST_SCHEMA)
        return refuse(r, "this manifest is of another form (%d) than this weft reads (%d)",
                      recorded_integer(r->root, "manifest"), MANIFEST_SCHEMA);
    return true;
}

bool recorded_parse(struct recorded *r, char *program)
{
    const cJSON *arguments = cJSON_GetObjectItemCaseSensitive(recorded_command(r), "arguments"), *word;
    int argc = 0;
    r->argv = calloc((size_t)cJSON_GetArraySize(arguments) + 2, sizeof *r->argv);
    if (!r->argv)
        return refuse(r, "out of memory");
    r->argv[argc++] = program;
    cJSON_ArrayForEach(word, arguments) {
        if (!cJSON_IsString(word))
            return refuse(r, "its command is damaged");
        r->argv[argc++] = word->valuestring;
    }
    enum status status = options_parse(&r->options, argc, r->argv);
    if (status != STATUS_DONE || r->options.noperands != 1 || r->options.from)
        return refuse(r, "its command is damaged");
    r->options.threads = recorded_integer(recorded_command(r), "threads");
    return true;
}

void recorded_free(struct recorded *r)
{
    options_free(&r->options);
    free(r->argv);
    cJSON_Delete(r->root);
}
