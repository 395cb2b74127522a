/* SPDX-License-Identifier: GPL-3.0-or-later
 * What this program was built from and runs on: nothing in, JSON out. */
#include <config.h>

#include "cli/build.h"

#include <stdio.h>
#include <sys/utsname.h>

#include "output/report.h"
#include "solver/factor.h"

/* OpenBLAS says at run time which kernels it picked; another BLAS does not. */
extern char *openblas_get_config(void) __attribute__((weak));

/* Versions as they were when weft was built; those whose rounding counts as they are now. */
static void add_libraries(cJSON *object)
{
    cJSON *libraries = cJSON_AddObjectToObject(object, "libraries");
    char cholmod[FACTOR_VERSION];
    factor_version(cholmod);
    json_text(libraries, "built_with", BUILT_WITH);
    json_text(libraries, "cjson", cJSON_Version());
    json_text(libraries, "cholmod", cholmod);
    if (openblas_get_config)
        json_text(libraries, "blas", openblas_get_config());
}

static void add_machine(cJSON *object)
{
    struct utsname name;
    cJSON *machine = cJSON_AddObjectToObject(object, "machine");
    if (uname(&name) == 0) {
        json_text(machine, "system", name.sysname);
        json_text(machine, "processor", name.machine);
    }
}

void build_describe(cJSON *object)
{
    json_text(object, "weft", PACKAGE_VERSION);
    json_integer(object, "schema", REPORT_SCHEMA);
    json_text(object, "compiler", __VERSION__);
    json_text(object, "flags", BUILT_FLAGS);
    add_libraries(object);
    add_machine(object);
}

void build_hash(struct file_log *log, char sha256[FILE_HASH])
{
    FILE *program = fopen("/proc/self/exe", "rb");
    struct file *hasher = program ? file_hasher(log) : NULL;
    char buffer[1 << 15];
    sha256[0] = '\0';
    for (size_t n; hasher && (n = fread(buffer, 1, sizeof buffer, program)) > 0;)
        file_write(hasher, buffer, n);
    if (hasher)
        file_hash(hasher, sha256);
    if (program)
        fclose(program);
}
