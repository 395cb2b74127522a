/* SPDX-License-Identifier: GPL-3.0-or-later
 * VTK PolyData: a surface in, one .vtp file out. */
#include "output/vtp.h"

#include <inttypes.h>
#include <stdint.h>

#include "output/number.h"

/* All that an array's values are computed from. */
struct mesh_view {
    const struct scene   *scene;
    const struct surface *surface;
};

enum scalar { FLOAT64, INT64, INT32, INT8 };

/* One value, as one of the scalars. */
union value {
    double  f64;
    int64_t i64;
    int32_t i32;
    int8_t  i8;
};

static const struct { const char *name; size_t size; } scalar_of[] = {
    [FLOAT64] = {"Float64", 8}, [INT64] = {"Int64", 8}, [INT32] = {"Int32", 4}, [INT8] = {"Int8", 1},
};

/* ---- where a value comes from ---- */

static const struct stitch *stitch_at(const struct mesh_view *m, size_t cell)
{
    const struct surface *s = m->surface;
    int i = (int)(cell % (size_t)s->nx) / s->per_stitch, j = (int)(cell / (size_t)s->nx) / s->per_stitch;
    return &m->scene->stitch[grid_at(m->scene->grid, i, j)];
}

static int column_at(const struct mesh_view *m, size_t cell)
{
    return (int)(cell % (size_t)m->surface->nx) / m->surface->per_stitch;
}

static int row_at(const struct mesh_view *m, size_t cell)
{
    return (int)(cell / (size_t)m->surface->nx) / m->surface->per_stitch;
}

static union value position(const struct mesh_view *m, size_t i)
{
    return (union value){.f64 = m->surface->position[i]};
}

static union value normal(const struct mesh_view *m, size_t i)
{
    return (union value){.f64 = m->surface->normal[i]};
}

static union value displacement(const struct mesh_view *m, size_t i)
{
    return (union value){.f64 = m->surface->displacement[i]};
}

/* Corners of a cell, counter-clockwise seen from the right side. */
static union value connectivity(const struct mesh_view *m, size_t i)
{
    static const int along[4] = {0, 1, 1, 0}, up[4] = {0, 0, 1, 1};
    int64_t nx = m->surface->nx, cell = (int64_t)(i / 4);
    return (union value){.i64 = (cell / nx + up[i % 4]) * (nx + 1) + cell % nx + along[i % 4]};
}

static union value offset(const struct mesh_view *m, size_t cell)
{
    (void)m;
    return (union value){.i64 = 4 * ((int64_t)cell + 1)};
}

static union value stitch_number(const struct mesh_view *m, size_t cell)
{
    return (union value){.i32 = row_at(m, cell) * m->surface->columns + column_at(m, cell)};
}

static union value row(const struct mesh_view *m, size_t cell)
{
    return (union value){.i32 = row_at(m, cell) + 1};
}

static union value column(const struct mesh_view *m, size_t cell)
{
    return (union value){.i32 = column_at(m, cell) + 1};
}

static union value knit_sign(const struct mesh_view *m, size_t cell)
{
    ptrdiff_t id = stitch_at(m, cell) - m->scene->stitch;
    return (union value){.i8 = id == STITCH_K ? 1 : id == STITCH_P ? -1 : 0};
}

static union value kx(const struct mesh_view *m, size_t cell)
{
    return (union value){.f64 = stitch_at(m, cell)->kx};
}

static union value ky(const struct mesh_view *m, size_t cell)
{
    return (union value){.f64 = stitch_at(m, cell)->ky};
}

static union value mean(const struct mesh_view *m, size_t cell)
{
    return (union value){.f64 = m->surface->mean[cell]};
}

static union value gauss(const struct mesh_view *m, size_t cell)
{
    return (union value){.f64 = m->surface->gauss[cell]};
}

static union value stretching(const struct mesh_view *m, size_t cell)
{
    return (union value){.f64 = m->surface->stretching[cell]};
}

static union value bending(const struct mesh_view *m, size_t cell)
{
    return (union value){.f64 = m->surface->bending[cell]};
}

/* ---- the arrays of a file, in its order ---- */

enum section { POINT_DATA, CELL_DATA, POINTS, POLYS, NSECTIONS };

static const struct { const char *open, *close; } tag_of[NSECTIONS] = {
    [POINT_DATA] = {"PointData Normals=\"normal\" Vectors=\"displacement\"", "PointData"},
    [CELL_DATA]  = {"CellData Scalars=\"knit_sign\"", "CellData"},
    [POINTS]     = {"Points", "Points"},
    [POLYS]      = {"Polys", "Polys"},
};

static const struct array {
    enum section section;
    const char  *name;
    enum scalar  scalar;
    int          components;    /* as declared */
    bool         per_point;     /* else per cell */
    int          values;        /* per point or cell */
    union value (*value)(const struct mesh_view *m, size_t index);
} arrays[] = {
    {POINT_DATA, "normal",             FLOAT64, 3, true,  3, normal},
    {POINT_DATA, "displacement",       FLOAT64, 3, true,  3, displacement},
    {CELL_DATA,  "stitch_id",          INT32,   1, false, 1, stitch_number},
    {CELL_DATA,  "row",                INT32,   1, false, 1, row},
    {CELL_DATA,  "column",             INT32,   1, false, 1, column},
    {CELL_DATA,  "knit_sign",          INT8,    1, false, 1, knit_sign},
    {CELL_DATA,  "kx",                 FLOAT64, 1, false, 1, kx},
    {CELL_DATA,  "ky",                 FLOAT64, 1, false, 1, ky},
    {CELL_DATA,  "mean_curvature",     FLOAT64, 1, false, 1, mean},
    {CELL_DATA,  "gaussian_curvature", FLOAT64, 1, false, 1, gauss},
    {CELL_DATA,  "stretching_density", FLOAT64, 1, false, 1, stretching},
    {CELL_DATA,  "bending_density",    FLOAT64, 1, false, 1, bending},
    {POINTS,     "position",           FLOAT64, 3, true,  3, position},
    {POLYS,      "connectivity",       INT64,   1, false, 4, connectivity},
    {POLYS,      "offsets",            INT64,   1, false, 1, offset},
};
enum { NARRAYS = sizeof arrays / sizeof arrays[0] };

static size_t npoints(const struct surface *s)
{
    return (size_t)(s->nx + 1) * (size_t)(s->ny + 1);
}

static size_t ncells(const struct surface *s)
{
    return (size_t)s->nx * (size_t)s->ny;
}

static size_t nvalues(const struct array *a, const struct surface *s)
{
    return (a->per_point ? npoints(s) : ncells(s)) * (size_t)a->values;
}

static uint64_t nbytes(const struct array *a, const struct surface *s)
{
    return nvalues(a, s) * scalar_of[a->scalar].size;
}

/* ---- the file ---- */

/* An array's numbers as text, twelve a line. */
static void print_values(struct file *file, const struct array *a, const struct mesh_view *m)
{
    size_t n = nvalues(a, m->surface);
    for (size_t i = 0; i < n; i++) {
        union value v = a->value(m, i);
        char text[NUMBER_TEXT];
        switch (a->scalar) {
        case FLOAT64: number_print(text, v.f64); break;
        case INT64:   snprintf(text, sizeof text, "%" PRId64, v.i64); break;
        case INT32:   snprintf(text, sizeof text, "%" PRId32, v.i32); break;
        case INT8:    snprintf(text, sizeof text, "%d", v.i8); break;
        }
        file_print(file, "%s%c", text, i % 12 == 11 || i + 1 == n ? '\n' : ' ');
    }
}

/* An array's bytes after their count. */
static void append_values(struct file *file, const struct array *a, const struct mesh_view *m)
{
    uint64_t bytes = nbytes(a, m->surface);
    size_t n = nvalues(a, m->surface);
    file_write(file, &bytes, sizeof bytes);
    for (size_t i = 0; i < n; i++) {
        union value v = a->value(m, i);
        file_write(file, &v, scalar_of[a->scalar].size);
    }
}

/* Declares all arrays; binary ones name their place after the XML, ascii ones follow at once. */
static void print_piece(struct file *file, const struct mesh_view *m, enum output_format format)
{
    uint64_t at = 0;
    for (enum section section = 0; section < NSECTIONS; section++) {
        file_print(file, "<%s>\n", tag_of[section].open);
        for (const struct array *a = arrays; a < arrays + NARRAYS; a++) {
            if (a->section != section)
                continue;
            file_print(file, "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" ",
                       scalar_of[a->scalar].name, a->name, a->components);
            if (format == FORMAT_ASCII) {
                file_print(file, "format=\"ascii\">\n");
                print_values(file, a, m);
                file_print(file, "</DataArray>\n");
            } else {
                file_print(file, "format=\"appended\" offset=\"%" PRIu64 "\"/>\n", at);
                at += sizeof at + nbytes(a, m->surface);
            }
        }
        file_print(file, "</%s>\n", tag_of[section].close);
    }
}

static void append_arrays(struct file *file, const struct mesh_view *m)
{
    file_print(file, "<AppendedData encoding=\"raw\">\n_");
    for (const struct array *a = arrays; a < arrays + NARRAYS; a++)
        append_values(file, a, m);
    file_print(file, "\n</AppendedData>\n");
}

bool vtp_write(struct file_log *log, const char *path, const struct scene *scene, const struct surface *surface,
               enum output_format format)
{
    const struct mesh_view m = {scene, surface};
    const char *order = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? "LittleEndian" : "BigEndian";
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    file_print(file, "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n"
                     "<PolyData>\n<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
                     "NumberOfStrips=\"0\" NumberOfPolys=\"%zu\">\n",
               order, npoints(surface), ncells(surface));
    print_piece(file, &m, format);
    file_print(file, "</Piece>\n</PolyData>\n");
    if (format == FORMAT_BINARY)
        append_arrays(file, &m);
    file_print(file, "</VTKFile>\n");
    return file_commit(file);
}
