/* SPDX-License-Identifier: GPL-3.0-or-later
 * A flat mesh in; numbered unknowns, the Hessian's pattern and batches of faces
 * in runs that threads may take at one time out. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "solver/memory.h"
#include "solver/triangle_model.h"

/* Nodes are vertices (three unknowns), then edges (one). */
static int node_at(const struct triangle *t, int node)
{
    return node < t->mesh->nvertices ? t->vertex_at[node] : t->edge_at[node - t->mesh->nvertices];
}

static int node_size(const struct triangle *t, int node)
{
    return node < t->mesh->nvertices ? 3 : 1;
}

/* The six nodes of a face: corners, then edges. */
static int face_node(const struct triangle_mesh *m, int f, int k)
{
    return k < 3 ? m->face[f][k] : m->nvertices + m->face_edge[f][k - 3];
}

/* Strips across the longer side, at least three cells thick: those one apart share no unknown, so two colours do. */
static void cut_strips(struct triangle *t, const int *cell, int *visit)
{
    const struct triangle_mesh *m = t->mesh;
    int nsplit = triangle_mesh_nsplit(m), cells = m->nx * m->ny, lines = m->nx > m->ny ? m->nx : m->ny;
    t->nchunks = lines / 3 < 1 ? 1 : lines / 3 > TRIANGLE_CHUNKS ? TRIANGLE_CHUNKS : lines / 3;
    int *next = MEMORY_ARRAY(int, t->nchunks + 1), *strip = MEMORY_ARRAY(int, cells);
    for (int c = 0; c < cells; c++) {
        int line = m->nx > m->ny ? cell[c] % m->nx : cell[c] / m->nx;
        strip[c] = (int)((long)line * t->nchunks / lines);
        next[strip[c] + 1] += nsplit;
    }
    for (int k = 0; k < t->nchunks; k++)
        t->chunk_start[k + 1] = next[k + 1] += next[k];
    for (int c = 0; c < cells; c++)
        for (int k = 0; k < nsplit; k++)
            visit[next[strip[c]]++] = cell[c] * nsplit + k;
    free(next);
    free(strip);
}

/* Runs of faces as they come. */
static void cut_runs(struct triangle *t, int *visit)
{
    int nfaces = t->mesh->nfaces, length = (nfaces + TRIANGLE_CHUNKS - 1) / TRIANGLE_CHUNKS;
    length = length < 128 ? 128 : length;
    t->nchunks = (nfaces + length - 1) / length;
    for (int f = 0; f < nfaces; f++)
        visit[f] = f;
    for (int c = 0; c < t->nchunks; c++)
        t->chunk_start[c + 1] = (c + 1) * length < nfaces ? (c + 1) * length : nfaces;
}

/* Order of elimination -> first unknown of each node.  visit, chunk_start: the faces as threads take them. */
static void number_unknowns(struct triangle *t, int *visit)
{
    const struct triangle_mesh *m = t->mesh;
    int nnodes = m->nvertices + m->nedges, parts[2] = {0, 0};
    int *order = MEMORY_ARRAY(int, nnodes);
    t->vertex_at = MEMORY_ARRAY(int, m->nvertices);
    t->edge_at   = MEMORY_ARRAY(int, m->nedges);
    if (m->nx > 0) {
        int *cell = MEMORY_ARRAY(int, m->nx * m->ny);
        triangle_mesh_dissect(m, order, cell, parts);
        cut_strips(t, cell, visit);
        free(cell);
    } else {
        for (int k = 0; k < nnodes; k++)
            order[k] = k;
        cut_runs(t, visit);
    }
    int n = 0;
    for (int k = 0; k < nnodes; k++) {
        if (order[k] < m->nvertices)
            t->vertex_at[order[k]] = n;
        else
            t->edge_at[order[k] - m->nvertices] = n;
        n += node_size(t, order[k]);
        for (int part = 0; part < 2; part++)
            if (k + 1 == parts[part])
                t->base.parts[part] = n;
    }
    free(order);
    t->base.n       = n;
    t->base.ordered = m->nx > 0;
    t->base.nnodes  = m->nvertices;
    t->base.node    = t->vertex_at;
}

/* Faces around each node: node k has list[start[k]..start[k + 1]). */
static void faces_of_nodes(const struct triangle_mesh *m, int **start, int **list)
{
    int nnodes = m->nvertices + m->nedges;
    int *s = memory_array((size_t)nnodes + 2, sizeof *s), *l = memory_array(6 * (size_t)m->nfaces, sizeof *l);
    for (int f = 0; f < m->nfaces; f++)
        for (int k = 0; k < 6; k++)
            s[face_node(m, f, k) + 2]++;
    for (int k = 0; k < nnodes; k++)
        s[k + 2] += s[k + 1];
    for (int f = 0; f < m->nfaces; f++)
        for (int k = 0; k < 6; k++)
            l[s[face_node(m, f, k) + 1]++] = f;
    *start = s;
    *list  = l;
}

/* The nodes that meet a node in some face and stand after it, ascending; returns their number. */
static int later_nodes(const struct triangle *t, int node, const int *start, const int *list, int *mark, int *later)
{
    int n = 0;
    mark[node] = node;
    for (int p = start[node]; p < start[node + 1]; p++)
        for (int k = 0; k < 6; k++) {
            int other = face_node(t->mesh, list[p], k), place = n;
            if (mark[other] == node || node_at(t, other) < node_at(t, node))
                continue;
            mark[other] = node;
            for (; place > 0 && node_at(t, later[place - 1]) > node_at(t, other); place--)
                later[place] = later[place - 1];
            later[place] = other;
            n++;
        }
    return n;
}

/* Columns of one node in the pattern; writes rows only where there is room for them. */
static void node_columns(const struct triangle *t, int node, const int *later, int nlater, struct pattern *pattern)
{
    int at = node_at(t, node), size = node_size(t, node);
    for (int a = 0; a < size; a++) {
        int p = pattern->start[at + a];
        for (int b = a; b < size; b++, p++)
            if (pattern->row)
                pattern->row[p] = at + b;
        for (int q = 0; q < nlater; q++)
            for (int b = 0; b < node_size(t, later[q]); b++, p++)
                if (pattern->row)
                    pattern->row[p] = node_at(t, later[q]) + b;
        pattern->start[at + a + 1] = p;
    }
}

/* Two rounds in the order of the unknowns: lengths of columns, then rows. */
static void make_pattern(struct triangle *t)
{
    const struct triangle_mesh *m = t->mesh;
    struct pattern *pattern = &t->base.pattern;
    int nnodes = m->nvertices + m->nedges, *start, *list, widest = 0;
    faces_of_nodes(m, &start, &list);
    int *mark = memory_array((size_t)nnodes, sizeof *mark), *node_of = memory_array((size_t)t->base.n, sizeof *node_of);
    memset(node_of, -1, (size_t)t->base.n * sizeof *node_of);
    for (int k = 0; k < nnodes; k++) {
        node_of[node_at(t, k)] = k;
        widest = start[k + 1] - start[k] > widest ? start[k + 1] - start[k] : widest;
    }
    int *later = memory_array(6 * (size_t)widest, sizeof *later);
    pattern->n     = t->base.n;
    pattern->start = memory_array((size_t)t->base.n + 1, sizeof *pattern->start);
    for (int round = 0; round < 2; round++) {
        memset(mark, -1, (size_t)nnodes * sizeof *mark);
        for (int i = 0; i < t->base.n; i++)
            if (node_of[i] >= 0)
                node_columns(t, node_of[i], later, later_nodes(t, node_of[i], start, list, mark, later), pattern);
        if (!round)
            pattern->row = memory_array((size_t)pattern->start[t->base.n], sizeof *pattern->row);
    }
    free(start);
    free(list);
    free(mark);
    free(node_of);
    free(later);
}

/* Place of the row of node b in the first column of node a, or the other way round. */
static int slot(const struct triangle *t, int a, int b)
{
    int p = node_at(t, a), q = node_at(t, b), column = p < q ? p : q, row = p < q ? q : p;
    const struct pattern *pattern = &t->base.pattern;
    int low = pattern->start[column], high = pattern->start[column + 1];
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (pattern->row[middle] <= row)
            low = middle;
        else
            high = middle;
    }
    assert(pattern->row[low] == row);
    return low - pattern->start[column];
}

static void face_slots(const struct triangle *t, int f, struct triangle_slots *slots, int lane)
{
    static const int pair[3][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 } };
    const struct triangle_mesh *m = t->mesh;
    for (int k = 0; k < 3; k++) {
        slots->at[k][lane]      = slot(t, face_node(m, f, pair[k][0]), face_node(m, f, pair[k][1]));
        slots->at[12 + k][lane] = slot(t, face_node(m, f, 3 + pair[k][0]), face_node(m, f, 3 + pair[k][1]));
        for (int j = 0; j < 3; j++)
            slots->at[3 + 3 * k + j][lane] = slot(t, face_node(m, f, k), face_node(m, f, 3 + j));
    }
}

/* Lane of a rest shape: barycentric gradients g_k = (-e_y, e_x)/2A of the edge e opposite corner k. */
static void face_rest(const struct triangle_mesh *m, int f, struct triangle_rest *rest, int lane)
{
    double e[3][2], g[3][2];
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 2; c++)
            e[i][c] = m->rest[m->face[f][(i + 1) % 3]][c] - m->rest[m->face[f][i]][c];
    double twice = e[2][0] * e[0][1] - e[2][1] * e[0][0];
    for (int k = 0; k < 3; k++) {
        g[k][0] = -e[(k + 1) % 3][1] / twice;
        g[k][1] = e[(k + 1) % 3][0] / twice;
    }
    for (int i = 0; i < 3; i++) {
        const double *a = g[i], *b = g[(i + 1) % 3], *o = g[(i + 2) % 3];
        rest->s[0][i][lane] = -a[0] * b[0];
        rest->s[1][i][lane] = -a[1] * b[1];
        rest->s[2][i][lane] = -(a[0] * b[1] + a[1] * b[0]) / 2;
        rest->b[0][i][lane] = -2 * o[0] * o[0];
        rest->b[1][i][lane] = -2 * o[1] * o[1];
        rest->b[2][i][lane] = -2 * o[0] * o[1];
        rest->q0[i][lane]   = e[i][0] * e[i][0] + e[i][1] * e[i][1];
    }
    rest->area[lane] = twice / 2;
}

/* The corner of the face across edge i, the face's own where there is none. */
static int corner_across(const struct triangle_mesh *m, int f, int i)
{
    int e = m->face_edge[f][i], other = m->edge_face[e][m->edge_face[e][0] == f];
    if (other < 0)
        return m->face[f][(i + 2) % 3];
    for (int k = 0; k < 3; k++)
        if (m->face_edge[other][k] == e)
            return m->face[other][(k + 2) % 3];
    assert(!"edges and faces disagree");
    return -1;
}

static void face_lane(const struct triangle *t, int f, struct triangle_batch *b, int lane)
{
    const struct triangle_mesh *m = t->mesh;
    b->face[lane] = f;
    for (int i = 0; i < 3; i++) {
        int e = m->face_edge[f][i];
        b->vertex[i][lane]   = t->vertex_at[m->face[f][i]];
        b->opposite[i][lane] = t->vertex_at[corner_across(m, f, i)];
        b->edge[i][lane]     = t->edge_at[e];
        b->share[i][lane]    = m->edge_face[e][1] < 0 ? 1 : m->edge_face[e][0] == f ? 0.5 : -0.5;
        b->natural[i][lane]  = m->natural[f][i];
    }
}

/* A batch of count faces; those of one shape share a rest shape, others have theirs beside them. */
static void fill_batch(struct triangle *t, const int *face, int count)
{
    struct triangle_batch *b = &t->batch[t->nbatches];
    b->count = count;
    b->rest  = t->mesh->nshapes ? t->mesh->shape[face[0]] : t->nbatches;
    for (int l = 0; l < LANES; l++) {
        int f = face[l < count ? l : 0];
        face_lane(t, f, b, l);
        face_slots(t, f, &t->slots[t->nbatches], l);
        face_rest(t->mesh, face[t->mesh->nshapes || l >= count ? 0 : l], &t->rest[b->rest], l);
    }
    t->nbatches++;
}

/* Chunks of faces -> batches of one shape each; chunk_start counts faces before, batches after. */
static void make_batches(struct triangle *t, const int *visit)
{
    const struct triangle_mesh *m = t->mesh;
    int nshapes = m->nshapes ? m->nshapes : 1, end = 0;
    size_t room = (size_t)(m->nfaces / LANES + nshapes * t->nchunks);
    t->batch = memory_array(room, sizeof *t->batch);
    t->slots = memory_array(room, sizeof *t->slots);
    t->nrest = m->nshapes ? m->nshapes : (int)room;
    t->rest  = MEMORY_ARRAY(struct triangle_rest, t->nrest);
    for (int c = 0; c < t->nchunks; c++) {
        int start = end;
        end = t->chunk_start[c + 1];
        t->chunk_start[c] = t->nbatches;
        for (int s = 0; s < nshapes; s++) {
            int face[LANES], count = 0;
            for (int p = start; p < end; p++) {
                if (m->nshapes && m->shape[visit[p]] != s)
                    continue;
                face[count++] = visit[p];
                if (count == LANES) {
                    fill_batch(t, face, count);
                    count = 0;
                }
            }
            if (count)
                fill_batch(t, face, count);
        }
    }
    t->chunk_start[t->nchunks] = t->nbatches;
    assert((size_t)t->nbatches <= room);
}

/* Marks which chunks share an unknown: clash (nchunks x nchunks). */
static void find_clashes(const struct triangle *t, unsigned char *clash)
{
    /* Chunks that touch each unknown, newest first: links in one pool. */
    struct link { int chunk, next; };
    size_t room = (size_t)t->nbatches * 9 * LANES + 1, used = 1;
    struct link *pool = memory_array(room, sizeof *pool);
    int *head = memory_array((size_t)t->base.n, sizeof *head);
    for (int c = 0; c < t->nchunks; c++)
        for (int b = t->chunk_start[c]; b < t->chunk_start[c + 1]; b++)
            for (int k = 0; k < 9 * LANES; k++) {
                const struct triangle_batch *batch = &t->batch[b];
                int i = k / LANES % 3, l = k % LANES;
                int at = (k < 3 * LANES ? batch->vertex : k < 6 * LANES ? batch->opposite : batch->edge)[i][l];
                if (head[at] && pool[head[at]].chunk == c)
                    continue;
                for (int p = head[at]; p; p = pool[p].next)
                    clash[c * t->nchunks + pool[p].chunk] = clash[pool[p].chunk * t->nchunks + c] = 1;
                pool[used] = (struct link){ c, head[at] };
                head[at] = (int)used++;
            }
    free(pool);
    free(head);
}

/* Each chunk takes the first colour none of its neighbours has. */
static void colour_chunks(struct triangle *t)
{
    int n = t->nchunks, colour[TRIANGLE_CHUNKS];
    unsigned char *clash = memory_array((size_t)n * (size_t)n, 1);
    find_clashes(t, clash);
    t->ncolours = 0;
    for (int c = 0; c < n; c++) {
        unsigned char taken[TRIANGLE_CHUNKS] = { 0 };
        for (int k = 0; k < c; k++)
            if (clash[c * n + k])
                taken[colour[k]] = 1;
        for (colour[c] = 0; taken[colour[c]];)
            colour[c]++;
        if (colour[c] >= t->ncolours)
            t->ncolours = colour[c] + 1;
    }
    int placed = 0;
    for (int k = 0; k < t->ncolours; k++) {
        t->colour_start[k] = placed;
        for (int c = 0; c < n; c++)
            if (colour[c] == k)
                t->chunk[placed++] = c;
    }
    t->colour_start[t->ncolours] = placed;
    free(clash);
}

void triangle_layout(struct triangle *t)
{
    int *visit = memory_array((size_t)t->mesh->nfaces, sizeof *visit);
    number_unknowns(t, visit);
    make_pattern(t);
    make_batches(t, visit);
    colour_chunks(t);
    free(visit);
}
