/* SPDX-License-Identifier: GPL-3.0-or-later
 * For the scripts beside it: a JSON file and a dotted path in, the value there
 * out; fails if the file is not JSON or has no such value.
 *     json x.json outputs.0.path        no path: the whole, on one line */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cjson/cJSON.h>

enum { SIZE_MAX_READ = 1 << 24 };

static cJSON *read_json(const char *path)
{
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return NULL;
    char *text = calloc(SIZE_MAX_READ, 1);
    if (!text)
        abort();
    size_t size = fread(text, 1, SIZE_MAX_READ - 1, stream);
    const char *end;
    cJSON *root = cJSON_ParseWithLengthOpts(text, size + 1, &end, 1);
    free(text);
    fclose(stream);
    return root;
}

static const cJSON *find(const cJSON *node, char *path)
{
    for (char *key; node && (key = strsep(&path, "."));)
        node = cJSON_IsArray(node) ? cJSON_GetArrayItem(node, atoi(key)) : cJSON_GetObjectItemCaseSensitive(node, key);
    return node;
}

int main(int argc, char **argv)
{
    cJSON *root = argc > 1 ? read_json(argv[1]) : NULL;
    const cJSON *node = argc > 2 ? find(root, argv[2]) : root;
    if (!node) {
        fprintf(stderr, "%s: %s\n", argc > 1 ? argv[1] : "json", root ? "no such value" : "not JSON");
        cJSON_Delete(root);
        return 1;
    }
    char *text = cJSON_PrintUnformatted(node);
    puts(cJSON_IsString(node) ? node->valuestring : text);
    cJSON_free(text);
    cJSON_Delete(root);
    return 0;
}
