/* SPDX-License-Identifier: GPL-3.0-or-later
 * ParaView's collection: growth steps in as they are reached, one .pvd and one
 * .vtp a step out. */
#include "output/pvd.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/number.h"

struct pvd pvd_begin(struct file_log *log, const char *path, const struct scene *scene,
                     enum output_format format)
{
    char last[NUMBER_TEXT];
    int digits = snprintf(last, sizeof last, "%d", scene->solve.steps);
    return (struct pvd){.log = log, .path = path, .scene = scene, .format = format,
                        .digits = digits < 2 ? 2 : digits};
}

void pvd_end(struct pvd *pvd)
{
    free(pvd->growth);
    *pvd = (struct pvd){0};
}

/* Length of a path without its extension. */
static int stem_length(const char *path)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    bool has_extension = dot && dot > (slash ? slash + 1 : path);
    return (int)(has_extension ? (size_t)(dot - path) : strlen(path));
}

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Text as the value of an XML attribute. */
static void print_escaped(struct file *file, const char *text, int length)
{
    for (int i = 0; i < length; i++) {
        const char *entity = text[i] == '&' ? "&amp;" : text[i] == '<' ? "&lt;" : text[i] == '"' ? "&quot;" : NULL;
        if (entity)
            file_write(file, entity, strlen(entity));
        else
            file_write(file, text + i, 1);
    }
}

static bool write_collection(const struct pvd *pvd)
{
    struct file *file = file_create(pvd->log, pvd->path);
    if (!file)
        return false;
    const char *name = file_name(pvd->path);
    file_print(file, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n");
    for (int i = 0; i < pvd->nsteps; i++) {
        char growth[NUMBER_TEXT];
        number_print(growth, pvd->growth[i]);
        file_print(file, "<DataSet timestep=\"%s\" part=\"0\" file=\"", growth);
        print_escaped(file, name, stem_length(name));
        file_print(file, "_%0*d.vtp\"/>\n", pvd->digits, i);
    }
    file_print(file, "</Collection>\n</VTKFile>\n");
    return file_commit(file);
}

bool pvd_step(struct pvd *pvd, double growth, const struct surface *surface)
{
    char path[PATH_MAX];
    int length = snprintf(path, sizeof path, "%.*s_%0*d.vtp", stem_length(pvd->path), pvd->path, pvd->digits, pvd->nsteps);
    if (!file_is_plain(pvd->path) || length >= PATH_MAX) {
        file_fail(pvd->log, "cannot write '%s': a .pvd names files beside it and must be a plain file", pvd->path);
        return false;
    }
    double *times = realloc(pvd->growth, (size_t)(pvd->nsteps + 1) * sizeof *times);
    if (!times) {
        file_fail(pvd->log, "out of memory");
        return false;
    }
    pvd->growth = times;
    if (!vtp_write(pvd->log, path, pvd->scene, surface, pvd->format))
        return false;
    times[pvd->nsteps++] = growth;
    return write_collection(pvd);
}
