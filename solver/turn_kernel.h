/* SPDX-License-Identifier: GPL-3.0-or-later
 * How a small piece of a surface turns under an increment, at one point of
 * eight patches: the turned derivatives, and the adjoint.  Formulas only. */
#ifndef WEFT_TURN_KERNEL_H
#define WEFT_TURN_KERNEL_H

#include "solver/lanes.h"

/* exp([w]x) v = v + c1 w x v + c2 w x (w x v), t = |w|: c1 = sin t/t, c2 = (1 - cos t)/t^2;
 * its derivative in w needs c3 = (t - sin t)/t^3. */
struct turn {
    struct vec w;
    lanes      c1, c2, c3;
};

/* Cosine and sinc of t/32 by their series (|t| <= 32 to 1e-13), doubled four times to t/2:
 * sinc 2a = sinc a cos a, cos 2a = 2 cos^2 a - 1. */
LANES_INLINE struct turn turn_of(struct vec w)
{
    enum { TERMS = 7, DOUBLINGS = 4 };
    lanes square = vec_dot(w, w), a = square / 1024, cosine = {0}, sinc = {0};
    LANES_UNROLL
    for (int k = TERMS; k >= 0; k--) {
        cosine = 1 - cosine * a / ((2 * k + 1) * (2 * k + 2));
        sinc = 1 - sinc * a / ((2 * k + 2) * (2 * k + 3));
    }
    LANES_UNROLL
    for (int k = 0; k < DOUBLINGS; k++) {
        sinc *= cosine;
        cosine = 2 * cosine * cosine - 1;
    }
    lanes c1 = sinc * cosine;
    return (struct turn){w, c1, 0.5 * sinc * sinc, (1 - c1) / (square + 1e-300)};
}

/* v + sign c1 w x v + c2 w x (w x v) */
LANES_INLINE struct vec turn_apply(const struct turn *R, double sign, struct vec v)
{
    struct vec c = vec_cross(R->w, v);
    return vec_fma(vec_fma(v, sign * R->c1, c), R->c2, vec_cross(R->w, c));
}

/* The transpose of d(exp w) = [J dw]x exp w, J = 1 + c2 [w]x + c3 [w]x^2. */
LANES_INLINE struct vec turn_pull(const struct turn *R, struct vec u)
{
    struct vec c = vec_cross(R->w, u);
    return vec_fma(vec_fma(u, -R->c2, c), R->c3, vec_cross(R->w, c));
}

/* A surface's frame at a point, p = r_x, q = r_y, and how an increment turns it. */
struct frame {
    struct vec p, q, n;         /* n the unit normal */
    struct vec pd, qd;          /* the duals of p and q: q x n/J, n x p/J */
    struct turn turn;
    struct vec a, b;            /* p and q strained but not turned: p + dp - w x p, q + dq - w x q */
};

/* w = 1/2 (pd x dp + qd x dq + n x dn), dn = -(n.dp) pd - (n.dq) qd: half the axis of the antisymmetric part
 * of dF F^-1, F = [p q n]. */
LANES_INLINE struct frame frame_of(struct vec p, struct vec q, struct vec dp, struct vec dq)
{
    struct frame f = {.p = p, .q = q};
    struct vec m = vec_cross(p, q);
    lanes iJ = lanes_rsqrt(vec_dot(m, m));
    f.n = vec_scale(iJ, m);
    f.pd = vec_scale(iJ, vec_cross(q, f.n));
    f.qd = vec_scale(iJ, vec_cross(f.n, p));
    struct vec dn = vec_scale(-vec_dot(f.n, dp), f.pd);
    dn = vec_fma(dn, -vec_dot(f.n, dq), f.qd);
    struct vec w = vec_add(vec_add(vec_cross(f.pd, dp), vec_cross(f.qd, dq)), vec_cross(f.n, dn));
    f.turn = turn_of(vec_scale(lanes_set(0.5), w));
    f.a = vec_sub(vec_add(p, dp), vec_cross(f.turn.w, p));
    f.b = vec_sub(vec_add(q, dq), vec_cross(f.turn.w, q));
    return f;
}

/* e = (exp(w) a - p - dp, exp(w) b - q - dq): what turning adds to the increment, of its second order. */
LANES_INLINE void frame_excess(const struct frame *f, struct vec dp, struct vec dq, struct vec e[2])
{
    e[0] = vec_sub(vec_sub(turn_apply(&f->turn, 1, f->a), f->p), dp);
    e[1] = vec_sub(vec_sub(turn_apply(&f->turn, 1, f->b), f->q), dq);
}

/* The adjoint: u.de = g.d(dp, dq) for given u. */
LANES_INLINE void frame_pull(const struct frame *f, const struct vec u[2], struct vec g[2])
{
    const struct turn *R = &f->turn;
    struct vec ta = turn_apply(R, 1, f->a), tb = turn_apply(R, 1, f->b);
    struct vec ua = turn_apply(R, -1, u[0]), ub = turn_apply(R, -1, u[1]);  /* exp(-w) u: the pull on a and b */
    struct vec w = turn_pull(R, vec_add(vec_cross(ta, u[0]), vec_cross(tb, u[1])));
    w = vec_sub(w, vec_add(vec_cross(f->p, ua), vec_cross(f->q, ub)));
    w = vec_scale(lanes_set(0.5), w);
    struct vec dn = vec_cross(w, f->n);
    g[0] = vec_add(vec_sub(ua, u[0]), vec_cross(w, f->pd));
    g[1] = vec_add(vec_sub(ub, u[1]), vec_cross(w, f->qd));
    g[0] = vec_fma(g[0], -vec_dot(dn, f->pd), f->n);
    g[1] = vec_fma(g[1], -vec_dot(dn, f->qd), f->n);
}

#endif
