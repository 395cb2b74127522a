/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft version`: what this program is. */
#include <config.h>

#include <stdio.h>

#include "cli/build.h"
#include "cli/command.h"

enum status command_version(const struct options *options)
{
    if (!options->json) {
        printf("weft %s\n", PACKAGE_VERSION);
        return STATUS_DONE;
    }
    cJSON *root = cJSON_CreateObject();
    build_describe(root);
    char *text = cJSON_Print(root);
    cJSON_Delete(root);
    if (!text)
        return STATUS_FAILED;
    printf("%s\n", text);
    cJSON_free(text);
    return STATUS_DONE;
}
