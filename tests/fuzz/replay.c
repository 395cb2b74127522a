/* SPDX-License-Identifier: GPL-3.0-or-later
 * Inputs that once broke a reader, or were made to, again: each file is a test, its target being
 * its name up to the first dash. That it comes back is all it must do. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lang/compile.h"
#include "tests/fuzz/target.h"

static void replay(const char *folder, const char *name, int n)
{
    struct arena arena = {0};
    const char *why;
    char *path = arena_printf(&arena, "%s/%s", folder, name);
    char *target = arena_copy(&arena, name, strcspn(name, "-"));
    const struct source *source = source_read(&arena, path, &why);

    printf("# %s\n", path);
    fflush(stdout);
    if (source)
        target_run(target, source->text, source->size);
    printf("%s %d - %s\n", source ? "ok" : "not ok", n, name);
    fflush(stdout);
    arena_free(&arena);
}

int main(int argc, char **argv)
{
    const char *top = getenv("WEFT_SOURCE");
    char folder[4096];
    struct dirent **entry;
    int count, n = 0;

    snprintf(folder, sizeof folder, "%s/tests/fuzz/found", argc > 1 ? argv[1] : top ? top : ".");
    count = scandir(folder, &entry, NULL, alphasort);
    for (int i = 0; i < count; i++) {
        if (entry[i]->d_name[0] != '.')
            replay(folder, entry[i]->d_name, ++n);
        free(entry[i]);
    }
    if (count >= 0)
        free(entry);
    printf("1..%d\n", n);
    return n == 0;
}
