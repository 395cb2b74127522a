/* SPDX-License-Identifier: GPL-3.0-or-later
 * What this program was built from and runs on: nothing in, JSON out. */
#include <config.h>

#include "cli/build.h"

#ifdef HAVE_LINK_H
#include <elf.h>
#include <link.h>
#endif
#include <stdio.h>
#include <string.h>
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

#ifdef WEFT_CLONES
/* Kernels are there for several instruction sets; the processor decides which run. */
static const char *kernels(void)
{
    bool widest = __builtin_cpu_supports("avx512f"), wide = __builtin_cpu_supports("avx2");
    return widest ? "avx512" : wide ? "avx2" : "baseline";
}
#endif

static void add_machine(cJSON *object)
{
    struct utsname name;
    cJSON *machine = cJSON_AddObjectToObject(object, "machine");
    if (uname(&name) == 0) {
        json_text(machine, "system", name.sysname);
        json_text(machine, "processor", name.machine);
    }
#ifdef WEFT_CLONES
    json_text(machine, "kernels", kernels());
#endif
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

/* ---- which program ---- */

#ifdef HAVE_LINK_H
enum { NOTE_ALIGNMENT = 4 };

static size_t aligned(size_t size)
{
    return (size + NOTE_ALIGNMENT - 1) / NOTE_ALIGNMENT * NOTE_ALIGNMENT;
}

/* Writes the build id among these notes; false if it is not there. */
static bool find_id(const char *note, size_t size, char id[FILE_HASH])
{
    static const char owner[] = "GNU";
    ElfW(Nhdr) head;
    while (size >= sizeof head) {
        memcpy(&head, note, sizeof head);
        const char *name = note + sizeof head;
        const unsigned char *bytes = (const unsigned char *)name + aligned(head.n_namesz);
        if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == sizeof owner && memcmp(name, owner, sizeof owner) == 0) {
            for (size_t i = 0; i < head.n_descsz && 2 * i + 2 < FILE_HASH; i++)
                snprintf(id + 2 * i, 3, "%02x", bytes[i]);
            return true;
        }
        size_t whole = sizeof head + aligned(head.n_namesz) + aligned(head.n_descsz);
        if (whole > size)
            break;
        note += whole;
        size -= whole;
    }
    return false;
}

/* For dl_iterate_phdr, whose first object is the program: looks at no other. */
static int see_program(struct dl_phdr_info *info, size_t size, void *id)
{
    (void)size;
    for (int i = 0; i < info->dlpi_phnum; i++) {
        const ElfW(Phdr) *part = &info->dlpi_phdr[i];
        if (part->p_type == PT_NOTE && find_id((const char *)(info->dlpi_addr + part->p_vaddr), part->p_memsz, id))
            break;
    }
    return 1;
}
#endif

void build_id(char id[FILE_HASH])
{
    id[0] = '\0';
#ifdef HAVE_LINK_H
    dl_iterate_phdr(see_program, id);
#endif
    if (!id[0] && !file_hash_path("/proc/self/exe", id))
        id[0] = '\0';
}
