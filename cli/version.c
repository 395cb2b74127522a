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
    return json_print(root) ? STATUS_DONE : STATUS_FAILED;
}
