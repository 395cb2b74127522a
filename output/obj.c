/* SPDX-License-Identifier: GPL-3.0-or-later
 * Wavefront OBJ: a surface in, one .obj of quads with normals and one .mtl with
 * a colour for each kind of stitch out. */
#include "output/obj.h"

#include <ctype.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "drawing/colours.h"
#include "output/number.h"

enum { NAME_SIZE = 128 };

static void stitch_name(char name[NAME_SIZE], const struct scene *scene, int id)
{
    const char *full = id == STITCH_K ? "knit" : id == STITCH_P ? "purl" : scene->stitch[id].name;
    snprintf(name, NAME_SIZE, "%s", full);
    for (char *c = name; *c; c++)
        *c = (char)tolower((unsigned char)*c);
}

static bool is_used(const struct scene *scene, int id)
{
    const struct grid *g = scene->grid;
    return memchr(g->cell, id, (size_t)g->columns * (size_t)g->rows);
}

/* path with its extension replaced by .mtl; devices have no file beside them. */
static bool material_path(char path[PATH_MAX], const char *obj)
{
    const char *slash = strrchr(obj, '/'), *dot = strrchr(obj, '.');
    size_t stem = dot && dot > (slash ? slash + 1 : obj) ? (size_t)(dot - obj) : strlen(obj);
    return file_is_plain(obj) && snprintf(path, PATH_MAX, "%.*s.mtl", (int)stem, obj) < PATH_MAX;
}

static bool write_materials(struct file_log *log, const char *path, const struct scene *scene)
{
    const struct palette *palette = colours_palette("paper");
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    for (int id = 0; id < scene->nstitches; id++) {
        const struct rgb c = colours_stitch(palette, id);
        char name[NAME_SIZE];
        if (!is_used(scene, id))
            continue;
        stitch_name(name, scene, id);
        file_print(file, "newmtl %s\nKd %g %g %g\nKs 0 0 0\nillum 1\n", name, c.red, c.green, c.blue);
    }
    return file_commit(file);
}

/* One line a point: a keyword and three numbers. */
static void print_points(struct file *file, const char *keyword, const double *value, size_t n)
{
    for (size_t i = 0; i < n; i++, value += 3) {
        char x[NUMBER_TEXT], y[NUMBER_TEXT], z[NUMBER_TEXT];
        number_print(x, value[0]);
        number_print(y, value[1]);
        number_print(z, value[2]);
        file_print(file, "%s %s %s %s\n", keyword, x, y, z);
    }
}

/* The quads of one stitch, counter-clockwise seen from the right side. */
static void print_faces(struct file *file, const struct scene *scene, const struct surface *s, int id)
{
    for (int j = 0; j < s->ny; j++) {
        for (int i = 0; i < s->nx; i++) {
            if (grid_at(scene->grid, i / s->per_stitch, j / s->per_stitch) != id)
                continue;
            long a = (long)j * (s->nx + 1) + i + 1, b = a + 1, c = b + s->nx + 1, d = c - 1;
            file_print(file, "f %ld//%ld %ld//%ld %ld//%ld %ld//%ld\n", a, a, b, b, c, c, d, d);
        }
    }
}

bool obj_write(struct file_log *log, const char *path, const struct scene *scene, const struct surface *surface)
{
    char materials[PATH_MAX];
    bool coloured = material_path(materials, path);
    size_t n = (size_t)(surface->nx + 1) * (size_t)(surface->ny + 1);
    if (coloured && !write_materials(log, materials, scene))
        return false;
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    file_print(file, "# weft: quads with normals, grouped by stitch.\n"
                     "# Lost in this format: curvatures, energy densities, displacements, growth steps.\n");
    if (coloured) {
        const char *slash = strrchr(materials, '/');
        const char *name = slash ? slash + 1 : materials;
        file_print(file, "mtllib ");
        file_write(file, name, strlen(name));
        file_print(file, "\n");
    }
    print_points(file, "v", surface->position, n);
    print_points(file, "vn", surface->normal, n);
    for (int id = 0; id < scene->nstitches; id++) {
        char name[NAME_SIZE];
        if (!is_used(scene, id))
            continue;
        stitch_name(name, scene, id);
        file_print(file, "g %s\nusemtl %s\n", name, name);
        print_faces(file, scene, surface, id);
    }
    return file_commit(file);
}
