/* SPDX-License-Identifier: GPL-3.0-or-later
 * PLY: a surface in, one binary .ply of quads out. */
#include "output/ply.h"

#include "drawing/colours.h"
#include "output/little.h"

static stitch_id stitch_at(const struct scene *scene, const struct surface *s, int i, int j)
{
    return grid_at(scene->grid, i / s->per_stitch, j / s->per_stitch);
}

static void write_header(struct file *file, const struct surface *s)
{
    file_print(file, "ply\nformat binary_little_endian 1.0\n"
                     "comment weft: quads seen from the right side of the fabric\n"
                     "comment lost in this format: displacements, growth steps\n");
    file_print(file, "element vertex %zu\n", (size_t)(s->nx + 1) * (size_t)(s->ny + 1));
    file_print(file, "property double x\nproperty double y\nproperty double z\n"
                     "property double nx\nproperty double ny\nproperty double nz\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\n");
    file_print(file, "element face %zu\n", (size_t)s->nx * (size_t)s->ny);
    file_print(file, "property list uchar int vertex_indices\n"
                     "property int stitch_id\nproperty int row\nproperty int column\nproperty char knit_sign\n"
                     "property double kx\nproperty double ky\n"
                     "property double mean_curvature\nproperty double gaussian_curvature\n"
                     "property double stretching_density\nproperty double bending_density\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n");
}

/* The mean colour of the one, two or four cells that meet at point (i, j). */
static void point_colour(const struct scene *scene, const struct surface *s, int i, int j, uint8_t mean[3])
{
    const struct palette *palette = colours_palette("paper");
    unsigned sum[3] = {0}, n = 0;
    for (int q = 0; q < 4; q++) {
        int at = i - q % 2, up = j - q / 2;
        uint8_t rgb[3];
        if (at < 0 || up < 0 || at >= s->nx || up >= s->ny)
            continue;
        colours_bytes(colours_stitch(palette, stitch_at(scene, s, at, up)), rgb);
        for (int k = 0; k < 3; k++)
            sum[k] += rgb[k];
        n++;
    }
    for (int k = 0; k < 3; k++)
        mean[k] = (uint8_t)((sum[k] + n / 2) / n);
}

static void write_vertex(struct file *file, const struct scene *scene, const struct surface *s, int i, int j)
{
    size_t at = 3 * ((size_t)j * (size_t)(s->nx + 1) + (size_t)i);
    uint8_t rgb[3];
    for (size_t k = 0; k < 3; k++)
        little_f64(file, s->position[at + k]);
    for (size_t k = 0; k < 3; k++)
        little_f64(file, s->normal[at + k]);
    point_colour(scene, s, i, j, rgb);
    file_write(file, rgb, 3);
}

static void write_face(struct file *file, const struct scene *scene, const struct surface *s, int i, int j)
{
    size_t cell = (size_t)j * (size_t)s->nx + (size_t)i;
    uint32_t a = (uint32_t)j * (uint32_t)(s->nx + 1) + (uint32_t)i, up = (uint32_t)s->nx + 1;
    const uint32_t corner[4] = {a, a + 1, a + 1 + up, a + up};
    int column = i / s->per_stitch, row = j / s->per_stitch;
    stitch_id id = stitch_at(scene, s, i, j);
    const struct stitch *stitch = &scene->stitch[id];
    const double field[] = {stitch->kx,     stitch->ky,          s->mean[cell],
                            s->gauss[cell], s->stretching[cell], s->bending[cell]};
    const struct palette *palette = colours_palette("paper");
    uint8_t rgb[3], sign = id == STITCH_K ? 1 : id == STITCH_P ? (uint8_t)-1 : 0;
    file_write(file, &(uint8_t){4}, 1);
    for (int k = 0; k < 4; k++)
        little_u32(file, corner[k]);
    little_u32(file, (uint32_t)(row * s->columns + column));
    little_u32(file, (uint32_t)row + 1);
    little_u32(file, (uint32_t)column + 1);
    file_write(file, &sign, 1);
    for (size_t k = 0; k < sizeof field / sizeof field[0]; k++)
        little_f64(file, field[k]);
    colours_bytes(colours_stitch(palette, id), rgb);
    file_write(file, rgb, 3);
}

bool ply_write(struct file_log *log, const char *path, const struct scene *scene, const struct surface *s)
{
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    write_header(file, s);
    for (int j = 0; j <= s->ny; j++)
        for (int i = 0; i <= s->nx; i++)
            write_vertex(file, scene, s, i, j);
    for (int j = 0; j < s->ny; j++)
        for (int i = 0; i < s->nx; i++)
            write_face(file, scene, s, i, j);
    return file_commit(file);
}
