/* SPDX-License-Identifier: GPL-3.0-or-later
 * Both texts are compiled, and what they come to is compared. */
#include "lang/format/meaning.h"

#include <string.h>

static bool same_scene(const struct scene *a, const struct scene *b)
{
    if (a->round != b->round || a->nstitches != b->nstitches || !grid_equal(a->grid, b->grid))
        return false;
    for (int i = 0; i < a->nstitches; i++)
        if (strcmp(a->stitch[i].name, b->stitch[i].name) != 0)
            return false;
    return true;
}

/* The errors, one by one, of the same kinds; a warning about the spelling goes with it. */
static bool same_errors(const struct diag *a, const struct diag *b)
{
    const struct message *m = a->first, *n = b->first;

    for (;; m = m->next, n = n->next) {
        while (m && m->severity != SEVERITY_ERROR)
            m = m->next;
        while (n && n->severity != SEVERITY_ERROR)
            n = n->next;
        if (!m || !n || m->code != n->code)
            return !m && !n;
    }
}

bool meaning_same(const struct source *first, const struct source *second, const struct compile_options *options)
{
    struct arena arena = {0};
    struct diag was, is;
    const struct scene *a, *b;
    bool same;

    diag_init(&was, &arena);
    diag_init(&is, &arena);
    a = scene_compile(&arena, &was, first, options);
    b = scene_compile(&arena, &is, second, options);
    same = same_errors(&was, &is) && !a == !b && (!a || same_scene(a, b));
    arena_free(&arena);
    return same;
}
