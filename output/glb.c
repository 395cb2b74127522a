/* SPDX-License-Identifier: GPL-3.0-or-later
 * glTF 2.0: growth steps and the folded surface in, one binary .glb out. */
#include <config.h>

#include "output/glb.h"

#include <math.h>
#include <stdlib.h>

#include "drawing/colours.h"
#include "output/json.h"
#include "output/little.h"
#include "output/number.h"

static const double SECONDS = 4;        /* that the growth takes */

/* glTF's numbers for its types and targets. */
enum { BYTE_UNSIGNED = 5121, INT_UNSIGNED = 5125, FLOAT = 5126, VERTICES = 34962, INDICES = 34963 };
enum { MAGIC = 0x46546C67, GLTF_2 = 2, CHUNK_JSON = 0x4E4F534A, CHUNK_BINARY = 0x004E4942 };

/* ---- the steps ---- */

struct glb glb_begin(const struct scene *scene)
{
    return (struct glb){.scene = scene, .every = (scene->solve.steps + GLB_STEPS - 1) / GLB_STEPS};
}

/* The full growth comes as the folded surface. */
bool glb_wants(const struct glb *glb, double growth)
{
    return growth < 1 && glb->nseen % glb->every == 0;
}

static size_t npoints(const struct surface *s)
{
    return (size_t)(s->nx + 1) * (size_t)(s->ny + 1);
}

static float *floats_of(const double *value, size_t n)
{
    float *copy = malloc(n * sizeof *copy);
    for (size_t i = 0; copy && i < n; i++)
        copy[i] = (float)value[i];
    return copy;
}

static struct glb_step step_of(double growth, const struct surface *surface)
{
    size_t n = 3 * npoints(surface);
    return (struct glb_step){growth, floats_of(surface->position, n), floats_of(surface->normal, n)};
}

static bool is_whole(const struct glb_step *step)
{
    return step->position && step->normal;
}

static void free_step(struct glb_step *step)
{
    free(step->position);
    free(step->normal);
}

void glb_end(struct glb *glb)
{
    for (int i = 0; i < glb->nsteps; i++)
        free_step(&glb->step[i]);
    free(glb->step);
    *glb = (struct glb){0};
}

bool glb_step(struct glb *glb, double growth, const struct surface *surface)
{
    bool wanted = glb_wants(glb, growth);
    glb->nseen++;
    if (!wanted)
        return true;
    struct glb_step *steps = realloc(glb->step, (size_t)(glb->nsteps + 1) * sizeof *steps);
    if (!steps)
        return false;
    glb->step = steps;
    steps[glb->nsteps] = step_of(growth, surface);
    glb->size = (struct surface){.nx = surface->nx, .ny = surface->ny, .per_stitch = surface->per_stitch};
    return is_whole(&steps[glb->nsteps++]);
}

/* ---- vertices ---- */

/* The mesh as it goes out: a vertex for each point and each kind of stitch that meets there. */
struct split {
    size_t     nvertices, nindices;
    uint32_t  *point;       /* (nvertices) of the surface */
    stitch_id *stitch;      /* (nvertices) */
    uint32_t  *index;       /* (nindices) of vertices, three a triangle */
};

static void split_free(struct split *split)
{
    free(split->point);
    free(split->stitch);
    free(split->index);
}

/* The vertex of a point among those of one stitch; numbers (points) holds 1 + its number, 0: new. */
static uint32_t vertex_of(struct split *split, uint32_t *number, uint32_t point, stitch_id id)
{
    if (number[point] == 0) {
        split->point[split->nvertices] = point;
        split->stitch[split->nvertices] = id;
        number[point] = (uint32_t)++split->nvertices;
    }
    return number[point] - 1;
}

/* The cells of one stitch, two triangles each. */
static void split_stitch(struct split *split, uint32_t *number, const struct grid *grid, const struct surface *s, stitch_id id)
{
    static const int order[6] = {0, 1, 2, 0, 2, 3};
    const uint32_t up = (uint32_t)s->nx + 1;
    memset(number, 0, npoints(s) * sizeof *number);
    for (int j = 0; j < s->ny; j++) {
        for (int i = 0; i < s->nx; i++) {
            if (grid_at(grid, i / s->per_stitch, j / s->per_stitch) != id)
                continue;
            const uint32_t a = (uint32_t)j * up + (uint32_t)i, corner[4] = {a, a + 1, a + 1 + up, a + up};
            for (int k = 0; k < 6; k++)
                split->index[split->nindices++] = vertex_of(split, number, corner[order[k]], id);
        }
    }
}

/* false: out of memory. */
static bool split_surface(struct split *split, const struct scene *scene, const struct surface *s)
{
    size_t ncells = (size_t)s->nx * (size_t)s->ny;
    uint32_t *number = malloc(npoints(s) * sizeof *number);
    *split = (struct split){
        .point = malloc(4 * ncells * sizeof *split->point),
        .stitch = malloc(4 * ncells * sizeof *split->stitch),
        .index = malloc(6 * ncells * sizeof *split->index),
    };
    bool enough = number && split->point && split->stitch && split->index;
    for (int id = 0; enough && id < scene->nstitches; id++)
        if (grid_count(scene->grid, (stitch_id)id) > 0)
            split_stitch(split, number, scene->grid, s, (stitch_id)id);
    free(number);
    return enough;
}

/* ---- the description ---- */

/* All that is written, and how far the description of its bytes is. */
struct writing {
    const struct glb     *glb;
    int                   nsteps;               /* before the last one */
    struct glb_step       last;                 /* the folded surface, or how far its growth came */
    struct split          split;
    cJSON                *root, *views, *accessors;
    size_t                bytes;                /* of the binary chunk so far */
};

/* Declares the next array of the binary chunk; its accessor, and its number in *number. */
static cJSON *add_array(struct writing *w, int component, size_t size, size_t count, const char *type, int target, int *number)
{
    cJSON *view = cJSON_CreateObject(), *accessor = cJSON_CreateObject();
    json_integer(view, "buffer", 0);
    json_unsigned(view, "byteOffset", w->bytes);
    json_unsigned(view, "byteLength", size * count);
    if (target)
        json_integer(view, "target", target);
    json_integer(accessor, "bufferView", cJSON_GetArraySize(w->views));
    json_integer(accessor, "componentType", component);
    json_unsigned(accessor, "count", count);
    json_text(accessor, "type", type);
    *number = cJSON_GetArraySize(w->accessors);
    cJSON_AddItemToArray(w->views, view);
    cJSON_AddItemToArray(w->accessors, accessor);
    w->bytes += size * count;
    return accessor;
}

static void add_number(cJSON *array, double value)
{
    char text[NUMBER_TEXT];
    number_print(text, value);
    cJSON_AddItemToArray(array, cJSON_CreateRaw(text));
}

/* A coordinate of a vertex: that of the folded surface, or what a step differs from it by. */
static float coordinate(const struct writing *w, const float *folded, const float *step, size_t vertex, size_t k)
{
    size_t at = 3 * (size_t)w->split.point[vertex] + k;
    return step ? step[at] - folded[at] : folded[at];
}

static void add_bounds(const struct writing *w, cJSON *accessor, const float *folded, const float *step)
{
    cJSON *low = cJSON_AddArrayToObject(accessor, "min"), *high = cJSON_AddArrayToObject(accessor, "max");
    for (size_t k = 0; k < 3; k++) {
        float least = INFINITY, most = -INFINITY;
        for (size_t v = 0; v < w->split.nvertices; v++) {
            float c = coordinate(w, folded, step, v, k);
            least = fminf(least, c);
            most = fmaxf(most, c);
        }
        add_number(low, (double)least);
        add_number(high, (double)most);
    }
}

/* Positions and normals of the folded surface (step NULL), or of a step against them. */
static void add_shape(struct writing *w, cJSON *attributes, const struct glb_step *step)
{
    int number;
    cJSON *accessor = add_array(w, FLOAT, 12, w->split.nvertices, "VEC3", VERTICES, &number);
    add_bounds(w, accessor, w->last.position, step ? step->position : NULL);
    json_integer(attributes, "POSITION", number);
    add_array(w, FLOAT, 12, w->split.nvertices, "VEC3", VERTICES, &number);
    json_integer(attributes, "NORMAL", number);
}

static void add_primitive(struct writing *w, cJSON *mesh)
{
    cJSON *primitive = cJSON_CreateObject(), *attributes = cJSON_AddObjectToObject(primitive, "attributes");
    int number;
    cJSON_AddItemToArray(cJSON_AddArrayToObject(mesh, "primitives"), primitive);
    add_array(w, INT_UNSIGNED, 4, w->split.nindices, "SCALAR", INDICES, &number);
    json_integer(primitive, "indices", number);
    json_integer(primitive, "material", 0);
    add_shape(w, attributes, NULL);
    cJSON *colours = add_array(w, BYTE_UNSIGNED, 4, w->split.nvertices, "VEC4", VERTICES, &number);
    cJSON_AddBoolToObject(colours, "normalized", true);
    json_integer(attributes, "COLOR_0", number);
    if (w->nsteps == 0)
        return;
    cJSON *targets = cJSON_AddArrayToObject(primitive, "targets");
    for (int i = 0; i < w->nsteps; i++) {
        cJSON *target = cJSON_CreateObject();
        add_shape(w, target, &w->glb->step[i]);
        cJSON_AddItemToArray(targets, target);
    }
}

static void add_mesh(struct writing *w)
{
    cJSON *mesh = cJSON_CreateObject();
    cJSON_AddItemToArray(cJSON_AddArrayToObject(w->root, "meshes"), mesh);
    json_text(mesh, "name", "swatch");
    add_primitive(w, mesh);
    if (w->nsteps == 0)
        return;
    cJSON *weights = cJSON_AddArrayToObject(mesh, "weights");
    cJSON *names = cJSON_AddArrayToObject(cJSON_AddObjectToObject(mesh, "extras"), "targetNames");
    for (int i = 0; i < w->nsteps; i++) {
        char name[NUMBER_TEXT];
        snprintf(name, sizeof name, "growth %.6g", w->glb->step[i].growth);
        cJSON_AddItemToArray(names, cJSON_CreateString(name));
        add_number(weights, 0);
    }
}

/* The time of a step, as a 32-bit float. */
static double seconds(const struct glb_step *step)
{
    return (double)(float)(SECONDS * step->growth);
}

/* At each step's time its target has weight 1; at the end none has. */
static void add_animation(struct writing *w)
{
    size_t nkeys = (size_t)w->nsteps + 1;
    if (nkeys == 1)
        return;
    cJSON *animation = cJSON_CreateObject(), *sampler = cJSON_CreateObject(), *channel = cJSON_CreateObject();
    int number;
    cJSON_AddItemToArray(cJSON_AddArrayToObject(w->root, "animations"), animation);
    json_text(animation, "name", "growth");
    cJSON_AddItemToArray(cJSON_AddArrayToObject(animation, "samplers"), sampler);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(animation, "channels"), channel);
    cJSON *times = add_array(w, FLOAT, 4, nkeys, "SCALAR", 0, &number);
    add_number(cJSON_AddArrayToObject(times, "min"), seconds(&w->glb->step[0]));
    add_number(cJSON_AddArrayToObject(times, "max"), seconds(&w->last));
    json_integer(sampler, "input", number);
    add_array(w, FLOAT, 4, nkeys * (nkeys - 1), "SCALAR", 0, &number);
    json_integer(sampler, "output", number);
    json_text(sampler, "interpolation", "LINEAR");
    json_integer(channel, "sampler", 0);
    cJSON *target = cJSON_AddObjectToObject(channel, "target");
    json_integer(target, "node", 0);
    json_text(target, "path", "weights");
}

/* Cloth: no metal, dull, seen from both sides. */
static void add_material(cJSON *root)
{
    cJSON *material = cJSON_CreateObject(), *surface = cJSON_AddObjectToObject(material, "pbrMetallicRoughness");
    json_text(material, "name", "fabric");
    json_number(surface, "metallicFactor", 0);
    json_number(surface, "roughnessFactor", 0.9);
    cJSON_AddBoolToObject(material, "doubleSided", true);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(root, "materials"), material);
}

static void add_scene(cJSON *root)
{
    cJSON *scene = cJSON_CreateObject(), *node = cJSON_CreateObject();
    json_integer(root, "scene", 0);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(root, "scenes"), scene);
    add_number(cJSON_AddArrayToObject(scene, "nodes"), 0);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(root, "nodes"), node);
    json_text(node, "name", "swatch");
    json_integer(node, "mesh", 0);
}

/* The JSON chunk; its arrays in the order write_arrays writes them. */
static char *describe(struct writing *w)
{
    w->root = cJSON_CreateObject();
    w->views = cJSON_CreateArray();
    w->accessors = cJSON_CreateArray();
    cJSON *asset = cJSON_AddObjectToObject(w->root, "asset");
    json_text(asset, "version", "2.0");
    json_text(asset, "generator", PACKAGE_STRING);
    json_text(cJSON_AddObjectToObject(asset, "extras"), "lost",
              "rows, columns, curvatures, energies, digits beyond the seventh");
    add_scene(w->root);
    add_material(w->root);
    add_mesh(w);
    add_animation(w);
    cJSON *buffer = cJSON_CreateObject();
    json_unsigned(buffer, "byteLength", w->bytes);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(w->root, "buffers"), buffer);
    cJSON_AddItemToObject(w->root, "bufferViews", w->views);
    cJSON_AddItemToObject(w->root, "accessors", w->accessors);
    char *text = cJSON_PrintUnformatted(w->root);
    cJSON_Delete(w->root);
    return text;
}

/* ---- the bytes ---- */

static void write_vectors(struct file *file, const struct writing *w, const float *folded, const float *step)
{
    for (size_t v = 0; v < w->split.nvertices; v++)
        for (size_t k = 0; k < 3; k++)
            little_f32(file, coordinate(w, folded, step, v, k));
}

/* 0..255 of the linear intensity that sRGB's c in 0..1 stands for (IEC 61966-2-1). */
static uint8_t linear(double c)
{
    return (uint8_t)lround(255 * (c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4)));
}

static void write_colours(struct file *file, const struct writing *w)
{
    const struct palette *palette = colours_palette("paper");
    for (size_t v = 0; v < w->split.nvertices; v++) {
        const struct rgb c = colours_stitch(palette, w->split.stitch[v]);
        const uint8_t rgba[4] = {linear(c.red), linear(c.green), linear(c.blue), 255};
        file_write(file, rgba, sizeof rgba);
    }
}

static void write_animation(struct file *file, const struct writing *w)
{
    if (w->nsteps == 0)
        return;
    for (int i = 0; i < w->nsteps; i++)
        little_f32(file, (float)seconds(&w->glb->step[i]));
    little_f32(file, (float)seconds(&w->last));
    for (int key = 0; key <= w->nsteps; key++)
        for (int i = 0; i < w->nsteps; i++)
            little_f32(file, i == key);
}

static void write_arrays(struct file *file, const struct writing *w)
{
    for (size_t i = 0; i < w->split.nindices; i++)
        little_u32(file, w->split.index[i]);
    write_vectors(file, w, w->last.position, NULL);
    write_vectors(file, w, w->last.normal, NULL);
    write_colours(file, w);
    for (int i = 0; i < w->nsteps; i++) {
        const struct glb_step *step = &w->glb->step[i];
        write_vectors(file, w, w->last.position, step->position);
        write_vectors(file, w, w->last.normal, step->normal);
    }
    write_animation(file, w);
}

/* Header and both chunks; the JSON is filled up with blanks to a multiple of four. */
static bool write_file(struct file_log *log, const char *path, const struct writing *w, const char *json)
{
    size_t length = strlen(json), padded = (length + 3) / 4 * 4, total = 12 + 8 + padded + 8 + w->bytes;
    if (total > UINT32_MAX) {
        file_fail(log, "cannot write '%s': a .glb holds 4 GB at most", path);
        return false;
    }
    struct file *file = file_create(log, path);
    if (!file)
        return false;
    little_u32(file, MAGIC);
    little_u32(file, GLTF_2);
    little_u32(file, (uint32_t)total);
    little_u32(file, (uint32_t)padded);
    little_u32(file, CHUNK_JSON);
    file_write(file, json, length);
    file_write(file, "   ", padded - length);
    little_u32(file, (uint32_t)w->bytes);
    little_u32(file, CHUNK_BINARY);
    write_arrays(file, w);
    return file_commit(file);
}

bool glb_write(const struct glb *glb, struct file_log *log, const char *path, const struct surface *surface)
{
    struct writing w = {.glb = glb, .nsteps = surface ? glb->nsteps : glb->nsteps - 1,
                        .last = surface ? step_of(1, surface) : glb->step[glb->nsteps - 1]};
    bool enough = split_surface(&w.split, glb->scene, surface ? surface : &glb->size) && is_whole(&w.last);
    char *json = enough ? describe(&w) : NULL;
    if (!json)
        file_fail(log, "out of memory");
    bool done = json && write_file(log, path, &w, json);
    cJSON_free(json);
    split_free(&w.split);
    if (surface)
        free_step(&w.last);
    return done;
}
