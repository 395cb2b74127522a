/* SPDX-License-Identifier: GPL-3.0-or-later
 * The plate at one Gauss point of eight patches: from the derivatives
 * d = (p, q, r_xx, r_yy, r_xy), p = r_x, q = r_y, to the energy density, its
 * gradient and its Hessian in d.  Formulas only. */
#ifndef WEFT_PATCH_KERNEL_H
#define WEFT_PATCH_KERNEL_H

#include "solver/lanes.h"

enum { D_P, D_Q, D_XX, D_YY, D_XY, D_COUNT };

/* C(X) = c1 tr(X) I + c2 X, c1 = nu/(1-nu^2), c2 = 1/(1+nu), times h/4 for
 * stretching (S = s1 tr(E) I + s2 E) and h^3/12 for bending (M likewise). */
struct plate {
    double s1, s2, b1, b2;
};

static inline struct plate plate_make(double thickness, double poisson)
{
    double c1 = poisson / (1 - poisson * poisson), c2 = 1 / (1 + poisson);
    double s = thickness / 4, b = thickness * thickness * thickness / 12;
    return (struct plate){s * c1, s * c2, b * c1, b * c2};
}

/* Symmetric 2x2 tensors of the eight patches. */
struct tensor {
    lanes xx, yy, xy;
};

/* What energy, gradient and Hessian share. */
struct point {
    lanes         J;                /* |p x q| */
    struct vec    n;                /* unit normal */
    struct tensor E, B;             /* a - I, b - b0 */
    struct tensor S, M;             /* h/4 C(E), h^3/12 C(B) */
};

LANES_INLINE struct tensor tensor_law(double c1, double c2, struct tensor e)
{
    lanes t = c1 * (e.xx + e.yy);
    return (struct tensor){t + c2 * e.xx, t + c2 * e.yy, c2 * e.xy};
}

LANES_INLINE lanes tensor_dot(struct tensor a, struct tensor b)
{
    return a.xx * b.xx + a.yy * b.yy + 2 * a.xy * b.xy;
}

/* m = p x q, J = |m|, n = m/J; E = a - I with a_xx = p.p ..; B = b - b0 with b_xx = r_xx.n .. */
LANES_INLINE struct point point_forms(const struct plate *plate, const struct vec d[D_COUNT], const struct tensor *b0)
{
    struct point g;
    struct vec m = vec_cross(d[D_P], d[D_Q]);
    g.J = lanes_sqrt(vec_dot(m, m));
    g.n = vec_scale(1 / g.J, m);
    g.E = (struct tensor){vec_dot(d[D_P], d[D_P]) - 1, vec_dot(d[D_Q], d[D_Q]) - 1, vec_dot(d[D_P], d[D_Q])};
    g.B = (struct tensor){vec_dot(d[D_XX], g.n) - b0->xx, vec_dot(d[D_YY], g.n) - b0->yy,
                          vec_dot(d[D_XY], g.n) - b0->xy};
    g.S = tensor_law(plate->s1, plate->s2, g.E);
    g.M = tensor_law(plate->b1, plate->b2, g.B);
    return g;
}

/* e = 1/2 S:E + 1/2 M:B, and its gradient in d:
 * w = M_xx r_xx + M_yy r_yy + 2 M_xy r_xy,  v = (I - n n^T) w / J,
 * de/dp = 2(S_xx p + S_xy q) + q x v,  de/dq = 2(S_yy q + S_xy p) + v x p,
 * de/dr_xx = M_xx n, de/dr_yy = M_yy n, de/dr_xy = 2 M_xy n. */
LANES_INLINE void point_gradient(const struct point *g, const struct vec d[D_COUNT], struct vec f[D_COUNT])
{
    struct vec w = vec_scale(g->M.xx, d[D_XX]);
    w = vec_fma(w, g->M.yy, d[D_YY]);
    w = vec_fma(w, 2 * g->M.xy, d[D_XY]);
    struct vec v = vec_scale(1 / g->J, vec_fma(w, -vec_dot(w, g->n), g->n));
    f[D_P] = vec_fma(vec_fma(vec_cross(d[D_Q], v), 2 * g->S.xx, d[D_P]), 2 * g->S.xy, d[D_Q]);
    f[D_Q] = vec_fma(vec_fma(vec_cross(v, d[D_P]), 2 * g->S.yy, d[D_Q]), 2 * g->S.xy, d[D_P]);
    f[D_XX] = vec_scale(g->M.xx, g->n);
    f[D_YY] = vec_scale(g->M.yy, g->n);
    f[D_XY] = vec_scale(2 * g->M.xy, g->n);
}

/* 3x3 matrices of the eight patches, row by row. */
typedef lanes mat3[3][3];

LANES_INLINE void mat3_outer(mat3 K, lanes s, struct vec a, struct vec b)
{
    lanes A[3] = {s * a.x, s * a.y, s * a.z}, B[3] = {b.x, b.y, b.z};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            K[i][j] += A[i] * B[j];
}

LANES_INLINE void mat3_diagonal(mat3 K, lanes s)
{
    for (int i = 0; i < 3; i++)
        K[i][i] += s;
}

/* K += sign [v]x, with [v]x u = v x u */
LANES_INLINE void mat3_skew(mat3 K, double sign, struct vec v)
{
    K[0][1] -= sign * v.z, K[0][2] += sign * v.y;
    K[1][0] += sign * v.z, K[1][2] -= sign * v.x;
    K[2][0] -= sign * v.y, K[2][1] += sign * v.x;
}

/* The Hessian of e in d, by 3x3 blocks; the rest follows by symmetry. */
struct point_hessian {
    mat3 pp, pq, qq;
    mat3 kp[3], kq[3];          /* rows r_xx, r_yy, r_xy */
    lanes nn[6];                /* n n^T: xx xy xz yy yz zz; block (k, l) is Cb_kl n n^T */
};

/* S with its negative eigenvalues set to zero: S+ = l- I + (l+ - l-)/(2r) (S - (m - r) I),
 * eigenvalues m +- r, l their positive parts. */
LANES_INLINE struct tensor tensor_positive(struct tensor S)
{
    lanes m = 0.5 * (S.xx + S.yy), a = 0.5 * (S.xx - S.yy);
    lanes r = lanes_sqrt(a * a + S.xy * S.xy) + 1e-300;
    lanes lo = lanes_positive(m - r), hi = lanes_positive(m + r), c = (hi - lo) / (2 * r);
    return (struct tensor){lo + c * (S.xx - m + r), lo + c * (S.yy - m + r), c * S.xy};
}

/* Second derivatives of b contracted with M, in p and q:
 * u = dm = dp x q + p x dq, Q = -(n (Pw)^T + (Pw) n^T + (w.n) P)/J^2,
 * u.Q u' + v.(dp x dq' + dp' x dq); and dr_k.dn' with dn = P u/J. */
LANES_INLINE void point_curving(const struct point *g, const struct vec d[D_COUNT], struct point_hessian *K)
{
    lanes iJ = 1 / g->J, Mk[3] = {g->M.xx, g->M.yy, 2 * g->M.xy};
    struct vec p = d[D_P], q = d[D_Q], n = g->n, w = {{0}, {0}, {0}};
    for (int k = 0; k < 3; k++)
        w = vec_fma(w, Mk[k], d[D_XX + k]);
    lanes wn = vec_dot(w, n);
    struct vec Pw = vec_fma(w, -wn, n);
    mat3 Q = {{{0}}}, P = {{{0}}};
    mat3_diagonal(P, lanes_set(1));
    mat3_outer(P, lanes_set(-1), n, n);
    mat3_outer(Q, -iJ * iJ, n, Pw);
    mat3_outer(Q, -iJ * iJ, Pw, n);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            Q[i][j] -= iJ * iJ * wn * P[i][j];

    /* Columns of u as a function of dp and dq: e_j x q and p x e_j. */
    lanes z = {0};
    lanes Lp[3][3] = {{z, q.z, -q.y}, {-q.z, z, q.x}, {q.y, -q.x, z}};
    lanes Lq[3][3] = {{z, -p.z, p.y}, {p.z, z, -p.x}, {-p.y, p.x, z}};
    mat3 QLp, QLq, PLp, PLq;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            QLp[i][j] = Q[i][0] * Lp[0][j] + Q[i][1] * Lp[1][j] + Q[i][2] * Lp[2][j];
            QLq[i][j] = Q[i][0] * Lq[0][j] + Q[i][1] * Lq[1][j] + Q[i][2] * Lq[2][j];
            PLp[i][j] = iJ * (P[i][0] * Lp[0][j] + P[i][1] * Lp[1][j] + P[i][2] * Lp[2][j]);
            PLq[i][j] = iJ * (P[i][0] * Lq[0][j] + P[i][1] * Lq[1][j] + P[i][2] * Lq[2][j]);
        }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            K->pp[i][j] += Lp[0][i] * QLp[0][j] + Lp[1][i] * QLp[1][j] + Lp[2][i] * QLp[2][j];
            K->pq[i][j] += Lp[0][i] * QLq[0][j] + Lp[1][i] * QLq[1][j] + Lp[2][i] * QLq[2][j];
            K->qq[i][j] += Lq[0][i] * QLq[0][j] + Lq[1][i] * QLq[1][j] + Lq[2][i] * QLq[2][j];
            for (int k = 0; k < 3; k++) {
                K->kp[k][i][j] += Mk[k] * PLp[i][j];
                K->kq[k][i][j] += Mk[k] * PLq[i][j];
            }
        }
    mat3_skew(K->pq, -1, vec_scale(iJ, Pw));
}

/* da^T C da h/4 + db^T C db h^3/12 + S : d2a (+ M : d2b when exact; else S clamped). */
LANES_INLINE void point_second(const struct plate *plate, const struct point *g, const struct vec d[D_COUNT],
                               int exact, struct point_hessian *K)
{
    struct vec p = d[D_P], q = d[D_Q], n = g->n;
    *K = (struct point_hessian){0};

    /* Stretching: da_xx = 2 p.dp, da_yy = 2 q.dq, da_xy = q.dp + p.dq. */
    lanes diagonal = lanes_set(4 * (plate->s1 + plate->s2)), coupling = lanes_set(4 * plate->s1);
    lanes shear = lanes_set(2 * plate->s2);
    mat3_outer(K->pp, diagonal, p, p);
    mat3_outer(K->pp, shear, q, q);
    mat3_outer(K->qq, diagonal, q, q);
    mat3_outer(K->qq, shear, p, p);
    mat3_outer(K->pq, coupling, p, q);
    mat3_outer(K->pq, shear, q, p);
    struct tensor S = exact ? g->S : tensor_positive(g->S);
    mat3_diagonal(K->pp, 2 * S.xx);
    mat3_diagonal(K->qq, 2 * S.yy);
    mat3_diagonal(K->pq, 2 * S.xy);

    /* Bending: db_k = U_k.dp + V_k.dq + n.dr_k, t_k = P r_k/J, U_k = q x t_k, V_k = t_k x p. */
    struct vec U[3], V[3], CU[3], CV[3];
    for (int k = 0; k < 3; k++) {
        struct vec t = vec_scale(1 / g->J, vec_fma(d[D_XX + k], -vec_dot(d[D_XX + k], n), n));
        U[k] = vec_cross(q, t);
        V[k] = vec_cross(t, p);
    }
    lanes b11 = lanes_set(plate->b1 + plate->b2), b12 = lanes_set(plate->b1), b33 = lanes_set(2 * plate->b2);
    CU[0] = vec_fma(vec_scale(b11, U[0]), b12, U[1]), CV[0] = vec_fma(vec_scale(b11, V[0]), b12, V[1]);
    CU[1] = vec_fma(vec_scale(b11, U[1]), b12, U[0]), CV[1] = vec_fma(vec_scale(b11, V[1]), b12, V[0]);
    CU[2] = vec_scale(b33, U[2]), CV[2] = vec_scale(b33, V[2]);
    for (int k = 0; k < 3; k++) {
        mat3_outer(K->pp, lanes_set(1), U[k], CU[k]);
        mat3_outer(K->pq, lanes_set(1), U[k], CV[k]);
        mat3_outer(K->qq, lanes_set(1), V[k], CV[k]);
        mat3_outer(K->kp[k], lanes_set(1), n, CU[k]);
        mat3_outer(K->kq[k], lanes_set(1), n, CV[k]);
    }
    K->nn[0] = n.x * n.x, K->nn[1] = n.x * n.y, K->nn[2] = n.x * n.z;
    K->nn[3] = n.y * n.y, K->nn[4] = n.y * n.z, K->nn[5] = n.z * n.z;
    if (exact)
        point_curving(g, d, K);
}

#endif
