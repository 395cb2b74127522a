/* SPDX-License-Identifier: GPL-3.0-or-later
 * STL: a surface in, one binary .stl of triangles out. */
#include "output/stl.h"

#include <math.h>

#include "output/little.h"

/* Must not begin with "solid", by which readers know the ascii form. */
static const char header[80] = "weft: right side out. Lost: stitches, colours, curvatures, energies, steps.";

static void write_vector(struct file *file, const float v[3])
{
    for (int k = 0; k < 3; k++)
        little_f32(file, v[k]);
}

/* The unit normal of a triangle; 0 where it has no area. */
static void normal_of(const float *a, const float *b, const float *c, float normal[3])
{
    double u[3], v[3], n[3], length;
    for (int k = 0; k < 3; k++) {
        u[k] = (double)b[k] - (double)a[k];
        v[k] = (double)c[k] - (double)a[k];
    }
    for (int k = 0; k < 3; k++)
        n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++)
        normal[k] = length > 0 ? (float)(n[k] / length) : 0;
}

static void write_triangle(struct file *file, const double *position, size_t a, size_t b, size_t c)
{
    const size_t corner[3] = {a, b, c};
    float p[3][3], normal[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            p[i][k] = (float)position[3 * corner[i] + (size_t)k];
    normal_of(p[0], p[1], p[2], normal);
    write_vector(file, normal);
    for (int i = 0; i < 3; i++)
        write_vector(file, p[i]);
    little_u16(file, 0);
}

bool stl_write(struct file_log *log, const char *path, const struct surface *s)
{
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    file_write(file, header, sizeof header);
    little_u32(file, 2 * (uint32_t)s->nx * (uint32_t)s->ny);
    for (int j = 0; j < s->ny; j++) {
        for (int i = 0; i < s->nx; i++) {
            size_t a = (size_t)j * (size_t)(s->nx + 1) + (size_t)i, b = a + 1, c = b + (size_t)s->nx + 1, d = c - 1;
            write_triangle(file, s->position, a, b, c);
            write_triangle(file, s->position, a, c, d);
        }
    }
    return file_commit(file);
}
