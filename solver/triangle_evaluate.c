/* SPDX-License-Identifier: GPL-3.0-or-later
 * A state of the triangles in; energy, gradient, Hessian and what each face
 * holds out.  Threads take chunks of batches, colour by colour; chunks of one
 * colour share no unknown and sums keep their order, so that results do not
 * depend on the number of threads. */
#include <math.h>
#include <string.h>

#include "solver/triangle_model.h"

/* One pass over all batches. */
struct job {
    const double         *x, *in;
    double                growth;
    enum hessian_kind     kind;
    double               *out;
    double              (*energy)[2];   /* (nchunks) stretching, bending */
    struct triangle_face *face;
};

typedef void chunk_work(const struct triangle *t, int chunk, const struct job *job);

enum { FEW = 1024 };    /* faces not worth a second thread */

/* What is summed into unknowns goes by colour, what each chunk keeps to itself all at once.  Who takes which chunk
 * of a colour makes no difference to the sums, so whoever is free takes the next. */
static void each_chunk(const struct triangle *t, chunk_work *work, const struct job *job)
{
    bool sums = job->out;
#pragma omp parallel num_threads(t->base.threads) if (t->base.threads > 1 && t->base.elements > FEW)
    for (int c = 0; c < (sums ? t->ncolours : 1); c++) {
#pragma omp for schedule(dynamic)
        for (int k = t->colour_start[c]; k < (sums ? t->colour_start[c + 1] : t->nchunks); k++)
            work(t, t->chunk[k], job);
    }
}

/* ---- Gather and scatter ---------------------------------------------------- */

LANES_INLINE struct lanes_one gather(const double *x, const int at[LANES])
{
    return (struct lanes_one){{x[at[0]], x[at[1]], x[at[2]], x[at[3]], x[at[4]], x[at[5]], x[at[6]], x[at[7]]}};
}

LANES_INLINE struct vec gather_vec(const double *x, const int at[LANES])
{
    return (struct vec){gather(x, at).v, gather(x + 1, at).v, gather(x + 2, at).v};
}

LANES_INLINE void scatter(struct lanes_one a, const int at[LANES], double *out)
{
    LANES_UNROLL
    for (int l = 0; l < LANES; l++)
        out[at[l]] += a.v[l];
}

LANES_INLINE void scatter_vec(struct vec a, const int at[LANES], double *out)
{
    LANES_UNROLL
    for (int l = 0; l < LANES; l++) {
        out[at[l]] += a.x[l];
        out[at[l] + 1] += a.y[l];
        out[at[l] + 2] += a.z[l];
    }
}

LANES_INLINE void gather_state(const struct triangle_batch *b, const double *x, struct triangle_state *s)
{
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        s->v[i] = gather_vec(x, b->vertex[i]);
        s->o[i] = gather_vec(x, b->opposite[i]);
        s->phi[i] = gather(x, b->edge[i]).v;
        lanes twice = 2 * (lanes)((lanes_mask)b->share[i] & 0x7fffffffffffffff);
        s->inner[i] = 2 - twice;
        s->side[i]  = (3 - twice) * b->share[i];
    }
}

/* Zeros in the lanes that repeat the first. */
LANES_INLINE struct lanes_one alive(struct lanes_one a, int count)
{
    const lanes_mask lane = {0, 1, 2, 3, 4, 5, 6, 7};
    return (struct lanes_one){(lanes)((lanes_mask)a.v & (lane < count))};
}

#define ALIVE(a, count) (alive((struct lanes_one){a}, count).v)

/* Everything about a batch's faces. */
struct faces {
    struct triangle_state    s;
    struct triangle_shape    shape;
    struct triangle_across   across[3];
    struct triangle_angles   alpha;
    struct triangle_response r;
};

/* State -> shape, angles and response of a batch. */
LANES_INLINE void respond(const struct triangle *t, const struct triangle_batch *b, const struct job *job,
                          struct faces *f)
{
    gather_state(b, job->x, &f->s);
    triangle_shape(f->s.v, &f->shape);
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        triangle_across(&f->s, &f->shape, i, &f->across[i]);
        triangle_angle(&f->s, &f->shape, i, &f->across[i], &f->alpha);
    }
    lanes k0[3] = { job->growth * b->natural[0], job->growth * b->natural[1], job->growth * b->natural[2] };
    triangle_respond(&t->material, &t->rest[b->rest], k0, &f->shape, &f->alpha, &f->r);
}

/* ---- Energy and gradient --------------------------------------------------- */

LANES_KERNEL static void chunk_energy(const struct triangle *t, int chunk, const struct job *job)
{
    lanes stretching = {0}, bending = {0};
    for (int k = t->chunk_start[chunk]; k < t->chunk_start[chunk + 1]; k++) {
        const struct triangle_batch *b = &t->batch[k];
        struct faces f;
        respond(t, b, job, &f);
        stretching += ALIVE(f.r.stretching, b->count);
        bending += ALIVE(f.r.bending, b->count);
        if (!job->out)
            continue;
        LANES_UNROLL
        for (int i = 0; i < 3; i++) {
            f.r.kappa[i] = ALIVE(f.r.kappa[i], b->count);
            f.r.fa[i]    = ALIVE(f.r.fa[i], b->count);
        }
        struct vec gv[3] = { 0 }, go[3];
        lanes gphi[3];
        LANES_UNROLL
        for (int i = 0; i < 3; i++)
            triangle_edge_force(&f.s, &f.shape, &f.r, i, &f.across[i], gv, go, gphi);
        LANES_UNROLL
        for (int i = 0; i < 3; i++) {
            scatter_vec(gv[i], b->vertex[i], job->out);
            scatter_vec(go[i], b->opposite[i], job->out);
            scatter((struct lanes_one){gphi[i]}, b->edge[i], job->out);
        }
    }
    job->energy[chunk][0] = job->energy[chunk][1] = 0;
    for (int l = 0; l < LANES; l++) {
        job->energy[chunk][0] += stretching[l];
        job->energy[chunk][1] += bending[l];
    }
}

struct fold_energy triangle_energy(const struct discretisation *d, const double *restrict x, double growth,
                                   double *restrict gradient)
{
    const struct triangle *t = (const struct triangle *)d;
    double part[TRIANGLE_CHUNKS][2];
    each_chunk(t, chunk_energy, &(struct job){ .x = x, .growth = growth, .out = gradient, .energy = part });
    struct fold_energy e = { 0 };
    for (int c = 0; c < t->nchunks; c++) {
        e.stretching += part[c][0];
        e.bending += part[c][1];
    }
    if (t->springs.count)
        e.springs = springs_energy(&t->springs, x, gradient);
    e.total   = e.stretching + e.bending + e.springs;
    return e;
}

/* ---- Hessian --------------------------------------------------------------- */

/* Adds the block of nodes p (np rows) and q (nq columns), whichever stands first. */
LANES_INLINE void add_block(const struct pattern *pattern, int p, int np, int q, int nq, int slot,
                            const double *block, int stride, double *value)
{
    if (p > q) {
        for (int c = 0; c < nq; c++)
            for (int r = 0; r < np; r++)
                value[pattern->start[q + c] + slot - c + r] += block[(r * nq + c) * stride];
    } else {
        for (int r = 0; r < np; r++)
            for (int c = 0; c < nq; c++)
                value[pattern->start[p + r] + slot - r + c] += block[(r * nq + c) * stride];
    }
}

/* Adds one face's blocks. */
LANES_INLINE void add_face(const struct triangle *t, const struct triangle_batch *b, const struct triangle_slots *s,
                           int l, const struct triangle_blocks *h, double *value)
{
    static const int pair[3][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 } };
    const struct pattern *pattern = &t->base.pattern;
    for (int k = 0; k < 3; k++) {
        int at = b->vertex[k][l];
        for (int c = 0; c < 3; c++)
            for (int r = c; r < 3; r++)
                value[pattern->start[at + c] + r - c] += h->vv[k][r][c][l];
        value[pattern->start[b->edge[k][l]]] += h->ee[k][k][l];
        int i = pair[k][0], j = pair[k][1];
        add_block(pattern, b->vertex[i][l], 3, b->vertex[j][l], 3, s->at[k][l],
                  (const double *)h->vv[3 + k] + l, LANES, value);
        add_block(pattern, b->edge[i][l], 1, b->edge[j][l], 1, s->at[12 + k][l],
                  (const double *)&h->ee[j][i] + l, LANES, value);
        for (int e = 0; e < 3; e++)
            add_block(pattern, at, 3, b->edge[e][l], 1, s->at[3 + 3 * k + e][l],
                      (const double *)h->ve[k][e] + l, LANES, value);
    }
}

LANES_INLINE void batch_hessian(const struct triangle *t, int k, const struct job *job, int exact)
{
    const struct triangle_batch *b = &t->batch[k];
    struct faces f;
    struct triangle_blocks h;
    respond(t, b, job, &f);
    triangle_hessian(&t->material, &t->rest[b->rest], &f.shape, &f.alpha, &f.r, f.s.side, exact, &h);
    for (int l = 0; l < b->count; l++)
        add_face(t, b, &t->slots[k], l, &h, job->out);
}

LANES_KERNEL static void chunk_hessian(const struct triangle *t, int chunk, const struct job *job)
{
    if (job->kind == HESSIAN_EXACT)
        for (int k = t->chunk_start[chunk]; k < t->chunk_start[chunk + 1]; k++)
            batch_hessian(t, k, job, 1);
    else
        for (int k = t->chunk_start[chunk]; k < t->chunk_start[chunk + 1]; k++)
            batch_hessian(t, k, job, 0);
}

void triangle_hessian_values(const struct discretisation *d, const double *restrict x, double growth,
                             enum hessian_kind kind, double *restrict value)
{
    const struct triangle *t = (const struct triangle *)d;
    memset(value, 0, (size_t)d->pattern.start[d->n] * sizeof *value);
    each_chunk(t, chunk_hessian, &(struct job){ .x = x, .growth = growth, .kind = kind, .out = value });
    if (t->springs.count)
        springs_hessian(&t->springs, value);
}

/* ---- Increments -------------------------------------------------------------
 * The Hessian counts an edge's angle as gamma, from a frame that follows the edge;
 * phi counts it from the mean of the faces' normals:
 *   dphi_e = dgamma_e - Sum_faces share_i Sum_k p_ik N.dv_k. */

LANES_INLINE void normal_turn(const struct triangle_batch *b, const double *x, struct triangle_shape *shape,
                              lanes p[3][3])
{
    struct vec v[3];
    LANES_UNROLL
    for (int i = 0; i < 3; i++)
        v[i] = gather_vec(x, b->vertex[i]);
    triangle_shape(v, shape);
    triangle_turn(shape, p);
}

LANES_KERNEL static void chunk_tangent(const struct triangle *t, int chunk, const struct job *job)
{
    for (int k = t->chunk_start[chunk]; k < t->chunk_start[chunk + 1]; k++) {
        const struct triangle_batch *b = &t->batch[k];
        struct triangle_shape shape;
        lanes p[3][3], along[3];
        normal_turn(b, job->x, &shape, p);
        LANES_UNROLL
        for (int i = 0; i < 3; i++) {
            along[i] = vec_dot(shape.normal, gather_vec(job->in, b->vertex[i]));
        }
        LANES_UNROLL
        for (int i = 0; i < 3; i++) {
            lanes turn = b->share[i] * (p[i][0] * along[0] + p[i][1] * along[1] + p[i][2] * along[2]);
            scatter((struct lanes_one){ALIVE(-turn, b->count)}, b->edge[i], job->out);
        }
    }
}

LANES_KERNEL static void chunk_cotangent(const struct triangle *t, int chunk, const struct job *job)
{
    for (int k = t->chunk_start[chunk]; k < t->chunk_start[chunk + 1]; k++) {
        const struct triangle_batch *b = &t->batch[k];
        struct triangle_shape shape;
        lanes p[3][3], g[3];
        normal_turn(b, job->x, &shape, p);
        LANES_UNROLL
        for (int i = 0; i < 3; i++)
            g[i] = ALIVE(b->share[i] * gather(job->in, b->edge[i]).v, b->count);
        LANES_UNROLL
        for (int c = 0; c < 3; c++)
            scatter_vec(vec_scale(-(p[0][c] * g[0] + p[1][c] * g[1] + p[2][c] * g[2]), shape.normal), b->vertex[c],
                        job->out);
    }
}

void triangle_tangent(const struct discretisation *d, const double *x, const double *dz, double *dx)
{
    memcpy(dx, dz, (size_t)d->n * sizeof *dx);
    each_chunk((const struct triangle *)d, chunk_tangent, &(struct job){ .x = x, .in = dz, .out = dx });
}

void triangle_cotangent(const struct discretisation *d, const double *x, const double *gx, double *gz)
{
    memcpy(gz, gx, (size_t)d->n * sizeof *gz);
    each_chunk((const struct triangle *)d, chunk_cotangent, &(struct job){ .x = x, .in = gx, .out = gz });
}

/* ---- What the faces hold --------------------------------------------------- */

LANES_KERNEL static void chunk_faces(const struct triangle *t, int chunk, const struct job *job)
{
    for (int k = t->chunk_start[chunk]; k < t->chunk_start[chunk + 1]; k++) {
        const struct triangle_batch *b = &t->batch[k];
        struct faces f;
        respond(t, b, job, &f);
        for (int l = 0; l < b->count; l++) {
            struct triangle_face *face = &job->face[b->face[l]];
            face->stretching = f.r.stretching[l];
            face->bending    = f.r.bending[l];
            face->angle      = 0;
            for (int c = 0; c < 3; c++) {
                face->metric[c]    = f.r.s[c][l] + (c < 2);
                face->curvature[c] = f.r.k[c][l] + job->growth * b->natural[c][l];
                double angle = atan2(fabs(f.alpha.sine[c][l]), f.alpha.cosine[c][l]);
                face->angle  = angle <= face->angle ? face->angle : angle;  /* nan wins */
            }
        }
    }
}

void triangle_faces(const struct discretisation *d, const double *x, double growth, struct triangle_face *face)
{
    each_chunk((const struct triangle *)d, chunk_faces, &(struct job){ .x = x, .growth = growth, .face = face });
}
