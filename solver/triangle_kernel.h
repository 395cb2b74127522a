/* SPDX-License-Identifier: GPL-3.0-or-later
 * Formulas of one triangle with mid-edge normals: corners, the corners across
 * its edges and edge angles in; energies, forces and the Hessian out.  Every
 * lane is a triangle of its own.
 *
 * Corners v_0 v_1 v_2 counter-clockwise, edge i from v_i to v_{i+1}, the corner
 * off it v_{i+2} (indices modulo 3).  The energy depends on six numbers:
 *   q_i      squared length of edge i,
 *   alpha_i  angle from the face's normal N to the edge's normal, about edge i,
 * and is, with the rest area A0 and the symmetric 2 x 2 tensors
 *   S = -Sum_i (q_i - q0_i) sym(g_i x g_{i+1})          first form minus identity,
 *   K = -2 Sum_i h_i sin(alpha_i) g_{i+2} x g_{i+2}     second form, b_xx = r_xx . n,
 *   U = A0 (h/8 |S|^2 + h^3/24 |K - K0|^2),   |X|^2 = c1 tr(X)^2 + c2 tr(X^2),
 *   c1 = nu/(1 - nu^2),   c2 = 1/(1 + nu)               (Young's modulus 1),
 * g_k the gradients of the barycentric coordinates at rest, h_i the current
 * height over edge i.  After Weischedel (2012) and van Rees, Vouga and
 * Mahadevan (2017). */
#ifndef WEFT_TRIANGLE_KERNEL_H
#define WEFT_TRIANGLE_KERNEL_H

#include "solver/lanes.h"

/* Tensors are listed xx, yy, xy. */
struct triangle_rest {
    lanes s[3][3];              /* 1/length^2: S_c = Sum_i s[c][i] (q_i - q0_i) */
    lanes b[3][3];              /* 1/length^2: K_c = Sum_i b[c][i] w_i */
    lanes q0[3];                /* length^2 */
    lanes area;                 /* length^2, A0 */
};

struct triangle_material {
    double c1, c2;
    double stretch;             /* length,   h/4 */
    double bend;                /* length^3, h^3/12 */
};

/* A state of eight triangles. */
struct triangle_state {
    struct vec v[3];            /* corners */
    struct vec o[3];            /* the corner across edge i; on the boundary any point off the edge */
    lanes      phi[3];          /* edge angles */
    lanes      side[3];         /* +1 where the triangle is the first of edge i, -1 where it is the second */
    lanes      inner[3];        /* 1 within the sheet, 0 on its boundary */
};

struct triangle_shape {
    struct vec e[3], normal;    /* edges, N */
    lanes      q[3], rq[3];     /* |e|^2, 1/|e|^2 */
    lanes      rl[3];           /* 1/|e| */
    lanes      twice, rtwice;   /* 2A, 1/2A */
    lanes      h[3], rh[3];     /* heights and their inverses, h_i = 2A/|e_i| */
    lanes      foot[3];         /* where the height over edge i meets it, from 0 at v_i to 1 at v_{i+1} */
};

/* What a triangle sees across an edge. */
struct triangle_across {
    struct vec normal;          /* N' of the neighbour; N on the boundary */
    lanes      rh, foot;        /* of its height over the edge; the foot counted from v_i */
};

struct triangle_angles { lanes sine[3], cosine[3]; };

struct triangle_response {
    lanes s[3], k[3];           /* S, K - K0 */
    lanes stretching, bending;  /* energies */
    lanes w[3], fw[3];          /* w_i = h_i sin(alpha_i), dU/dw */
    lanes fa[3];                /* dU/dalpha */
    lanes kappa[3];             /* dU/dq */
    lanes d[3];                 /* D_j = d ln (2A)^2 / dq_j */
};

/* e_i = v_{i+1} - v_i,  q_i = e_i . e_i,  2A N = e_2 x e_0,
 * foot_i = (q_i + q_{i+2} - q_{i+1}) / (2 q_i) */
LANES_INLINE void triangle_shape(const struct vec v[3], struct triangle_shape *t)
{
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        t->e[i] = vec_sub(v[(i + 1) % 3], v[i]);
        t->q[i] = vec_dot(t->e[i], t->e[i]);
    }
    struct vec n = vec_cross(t->e[2], t->e[0]);
    lanes nn = vec_dot(n, n);
    t->rtwice = lanes_rsqrt(nn);
    t->twice  = nn * t->rtwice;
    t->normal = vec_scale(t->rtwice, n);
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        t->rl[i]   = lanes_rsqrt(t->q[i]);
        t->rq[i]   = t->rl[i] * t->rl[i];
        t->h[i]    = t->twice * t->rl[i];
        t->rh[i]   = t->rtwice * t->q[i] * t->rl[i];
        t->foot[i] = 0.5 * (t->q[i] + t->q[(i + 2) % 3] - t->q[(i + 1) % 3]) * t->rq[i];
    }
}

/* 2A' N' = (o_i - v_i) x e_i,  h' = 2A'/|e_i|,  foot' = (o_i - v_i) . e_i / q_i */
LANES_INLINE void triangle_across(const struct triangle_state *x, const struct triangle_shape *t, int i,
                                  struct triangle_across *a)
{
    struct vec u = vec_sub(x->o[i], x->v[i]), n = vec_cross(u, t->e[i]);
    lanes rtwice = lanes_rsqrt(vec_dot(n, n));
    a->normal = vec_fma(t->normal, x->inner[i], vec_sub(vec_scale(rtwice, n), t->normal));
    a->rh     = rtwice * t->q[i] * t->rl[i];
    a->foot   = vec_dot(u, t->e[i]) * t->rq[i];
}

/* sin and cos: the argument less the nearest multiple of pi/2, then their series. */
LANES_INLINE void triangle_sincos(const lanes *phi, lanes *sine, lanes *cosine)
{
    const double shift = 0x1.8p52, half_pi = 0x1.921fb54442d18p0, rest = 0x1.1a62633145c07p-54;
    lanes turned = *phi * (2 / M_PI) + shift;
    lanes_mask quarter = (lanes_mask)turned;
    lanes k = turned - shift, r = (*phi - k * half_pi) - k * rest, z = r * r;

    lanes s = 1 - z * (1.0 / 272);
    s = 1 - z * (1.0 / 210) * s;
    s = 1 - z * (1.0 / 156) * s;
    s = 1 - z * (1.0 / 110) * s;
    s = 1 - z * (1.0 / 72) * s;
    s = 1 - z * (1.0 / 42) * s;
    s = 1 - z * (1.0 / 20) * s;
    s = r - r * z * (1.0 / 6) * s;
    lanes c = 1 - z * (1.0 / 240);
    c = 1 - z * (1.0 / 182) * c;
    c = 1 - z * (1.0 / 132) * c;
    c = 1 - z * (1.0 / 90) * c;
    c = 1 - z * (1.0 / 56) * c;
    c = 1 - z * (1.0 / 30) * c;
    c = 1 - z * (1.0 / 12) * c;
    c = 1 - z * 0.5 * c;

    /* Odd quarters exchange the two; signs follow the quarter. */
    lanes_mask swap = -(quarter & 1), sign_s = (quarter & 2) << 62, sign_c = ((quarter + 1) & 2) << 62;
    *sine   = (lanes)((((lanes_mask)s & ~swap) | ((lanes_mask)c & swap)) ^ sign_s);
    *cosine = (lanes)((((lanes_mask)c & ~swap) | ((lanes_mask)s & swap)) ^ sign_c);
}

/* theta, the angle from N to N' about the edge:
 *   cos(theta/2) = |N + N'|/2,   sin(theta/2) = (N x N').e_i / (2 |e_i| cos(theta/2)),
 * alpha_i = theta/2 + side phi. */
LANES_INLINE void triangle_angle(const struct triangle_state *x, const struct triangle_shape *t, int i,
                                 const struct triangle_across *a, struct triangle_angles *alpha)
{
    struct vec sum = vec_add(t->normal, a->normal);
    lanes cc = 0.25 * vec_dot(sum, sum) + 1e-280;       /* folded flat onto itself: still a number */
    lanes rch = lanes_rsqrt(cc), ch = cc * rch;
    lanes sh = 0.5 * vec_dot(vec_cross(t->normal, a->normal), t->e[i]) * t->rl[i] * rch;
    lanes sphi, cphi;
    triangle_sincos(&x->phi[i], &sphi, &cphi);
    sphi *= x->side[i];
    alpha->sine[i]   = sh * cphi + ch * sphi;
    alpha->cosine[i] = ch * cphi - sh * sphi;
}

/* X = C Y:  c1 tr(Y) I + c2 Y, its xy entry doubled: it stands for xy and yx. */
LANES_INLINE void triangle_stress(const struct triangle_material *m, const lanes y[3], lanes x[3])
{
    lanes trace = m->c1 * (y[0] + y[1]);
    x[0] = trace + m->c2 * y[0];
    x[1] = trace + m->c2 * y[1];
    x[2] = (2 * m->c2) * y[2];
}

/* Strains, energies and their first derivatives.  w_i = h_i sin(alpha_i),
 *   dU/dw_i = A0 h^3/12 Sum_c b_ci (C (K - K0))_c,   dU/dalpha_i = dU/dw_i h_i cos(alpha_i),
 *   kappa_j = dU/dq_j = A0 h/4 Sum_c s_cj (C S)_c + 1/2 (D_j Sum_i fw_i w_i - fw_j w_j/q_j),
 *   D_j = (q_{j+1} + q_{j+2} - q_j) / (2 (2A)^2) */
LANES_INLINE void triangle_respond(const struct triangle_material *m, const struct triangle_rest *rest,
                                   const lanes k0[3], const struct triangle_shape *t,
                                   const struct triangle_angles *alpha, struct triangle_response *r)
{
    lanes dq[3], ts[3], tk[3];
    lanes ms = m->stretch * rest->area, mb = m->bend * rest->area, rtt = 0.5 * t->rtwice * t->rtwice;
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        dq[i]   = t->q[i] - rest->q0[i];
        r->w[i] = t->h[i] * alpha->sine[i];
        r->d[i] = (t->q[(i + 1) % 3] + t->q[(i + 2) % 3] - t->q[i]) * rtt;
    }
    LANES_UNROLL
    for (int c = 0; c < 3; c++) {
        r->s[c] = rest->s[c][0] * dq[0] + rest->s[c][1] * dq[1] + rest->s[c][2] * dq[2];
        r->k[c] = rest->b[c][0] * r->w[0] + rest->b[c][1] * r->w[1] + rest->b[c][2] * r->w[2] - k0[c];
    }
    triangle_stress(m, r->s, ts);
    triangle_stress(m, r->k, tk);
    r->stretching = 0.5 * ms * (r->s[0] * ts[0] + r->s[1] * ts[1] + r->s[2] * ts[2]);
    r->bending    = 0.5 * mb * (r->k[0] * tk[0] + r->k[1] * tk[1] + r->k[2] * tk[2]);
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        r->fw[i] = mb * (rest->b[0][i] * tk[0] + rest->b[1][i] * tk[1] + rest->b[2][i] * tk[2]);
        r->fa[i] = r->fw[i] * t->h[i] * alpha->cosine[i];
    }
    lanes sum = r->fw[0] * r->w[0] + r->fw[1] * r->w[1] + r->fw[2] * r->w[2];
    LANES_UNROLL
    for (int j = 0; j < 3; j++)
        r->kappa[j] = ms * (rest->s[0][j] * ts[0] + rest->s[1][j] * ts[1] + rest->s[2][j] * ts[2]) +
                      0.5 * (r->d[j] * sum - r->fw[j] * r->w[j] * t->rq[j]);
}

/* Adds the forces through edge i.  Its length moves its ends by -+2 kappa_i e_i;
 * theta_i turns with both faces, dtheta_i = -Sum_k (g_k.y)(N.dv_k) over each, where
 * g_k.y is 1/h at the corner off the edge, -(1 - foot)/h at v_i, -foot/h at v_{i+1}.
 * M = 1/2 dU/dalpha_i within the sheet and nothing on its boundary. */
LANES_INLINE void triangle_edge_force(const struct triangle_state *x, const struct triangle_shape *t,
                                      const struct triangle_response *r, int i, const struct triangle_across *a,
                                      struct vec gv[3], struct vec go[3], lanes gphi[3])
{
    lanes moment = 0.5 * x->inner[i] * r->fa[i];
    lanes here = moment * t->rh[i], there = moment * a->rh;
    struct vec pull = vec_scale(2 * r->kappa[i], t->e[i]);
    struct vec n = vec_scale(here, t->normal), m = vec_scale(there, a->normal);
    struct vec end = vec_fma(vec_scale(t->foot[i], n), a->foot, m);     /* at v_{i+1} */
    gv[i]           = vec_add(gv[i], vec_sub(vec_sub(vec_add(n, m), end), pull));
    gv[(i + 1) % 3] = vec_add(gv[(i + 1) % 3], vec_add(end, pull));
    gv[(i + 2) % 3] = vec_sub(gv[(i + 2) % 3], n);
    go[i]           = vec_scale(-there, a->normal);
    gphi[i]         = x->side[i] * r->fa[i];
}

/* (g_k . y_i), the turn of N about edge i as corner k moves along N: row i, column k. */
LANES_INLINE void triangle_turn(const struct triangle_shape *t, lanes p[3][3])
{
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        p[i][(i + 1) % 3] = -t->foot[i] * t->rh[i];
        p[i][i]           = -t->rh[i] - p[i][(i + 1) % 3];
        p[i][(i + 2) % 3] = t->rh[i];
    }
}

/* The Hessian's blocks; the rest follows from symmetry.  Corners count x, y, z, angles as gamma (below). */
struct triangle_blocks {
    lanes vv[6][3][3];          /* corner pairs 00 11 22 01 02 12: rows of the first, columns of the second */
    lanes ve[3][3][3];          /* corner, edge, component */
    lanes ee[3][3];             /* i >= j only */
};

/* Weights of the edges' Laplacian Sum_i 2 kappa_i d_i d_i^T, d_i = (-1, +1) at the ends of edge i, with its negative
 * eigenvalues set to zero.  On the complement of (1, 1, 1), in the basis (1, -1, 0)/sqrt 2, (1, 1, -2)/sqrt 6, it is
 *   [[4 k_0 + k_1 + k_2, sqrt 3 (k_2 - k_1)], [., 3 (k_1 + k_2)]]. */
LANES_INLINE void triangle_clamp(lanes kappa[3])
{
    const double root3 = 1.7320508075688772;
    lanes a = 4 * kappa[0] + kappa[1] + kappa[2], c = 3 * (kappa[1] + kappa[2]), b = root3 * (kappa[2] - kappa[1]);
    lanes middle = 0.5 * (a + c), half = 0.5 * (a - c);
    lanes rr = half * half + b * b + 1e-280, rradius = lanes_rsqrt(rr), radius = rr * rradius;
    lanes high = lanes_positive(middle + radius), low = lanes_positive(middle - radius);
    lanes mean = 0.5 * (high + low), ratio = 0.5 * (high - low) * rradius;
    lanes sum = (mean - ratio * half) * (1.0 / 3), difference = ratio * b * (1 / root3);
    kappa[0] = 0.25 * (mean + ratio * half - sum);
    kappa[1] = 0.5 * (sum - difference);
    kappa[2] = 0.5 * (sum + difference);
}

/* Second derivatives by (q_0 q_1 q_2) and (alpha_0 alpha_1 alpha_2): fqq, fqa[j][i] by q_j and alpha_i, faa.
 * With C_m, C_b the elasticity in terms of q and w, and W the derivatives of w,
 *   dw_i/dq_j = w_i L_ij/2,   L_ij = D_j - delta_ij/q_i,   dw_i/dalpha_i = a_i = h_i cos(alpha_i),
 *   F = C_m + W^T C_b W + Sum_i fw_i hess w_i,
 *   d2w_i/dq_j dq_k = w_i (L_ij L_ik/4 + (D_jk - D_j D_k + delta_ij delta_ik/q_i^2)/2),
 *   D_jk = 1/(2 (2A)^2), its negative if j = k,
 *   d2w_i/dq_j dalpha_i = a_i L_ij/2,   d2w_i/dalpha_i^2 = -w_i;
 * the semidefinite version leaves the last sum out. */
LANES_INLINE void triangle_second(const struct triangle_material *m, const struct triangle_rest *rest,
                                  const struct triangle_shape *t, const struct triangle_angles *alpha,
                                  const struct triangle_response *r, int exact,
                                  lanes fqq[3][3], lanes fqa[3][3], lanes faa[3][3])
{
    lanes ms = m->stretch * rest->area, mb = m->bend * rest->area;
    lanes cm[3][3], cb[3][3], cbx[3][3], half[3][3], a[3];     /* cbx = C_b dw/dq, half = L/2 */
    LANES_UNROLL
    for (int j = 0; j < 3; j++) {
        lanes s[3] = { ms * rest->s[0][j], ms * rest->s[1][j], ms * rest->s[2][j] }, ts[3];
        lanes b[3] = { mb * rest->b[0][j], mb * rest->b[1][j], mb * rest->b[2][j] }, tb[3];
        triangle_stress(m, s, ts);
        triangle_stress(m, b, tb);
        LANES_UNROLL
        for (int i = 0; i < 3; i++) {
            cm[i][j]   = rest->s[0][i] * ts[0] + rest->s[1][i] * ts[1] + rest->s[2][i] * ts[2];
            cb[i][j]   = rest->b[0][i] * tb[0] + rest->b[1][i] * tb[1] + rest->b[2][i] * tb[2];
            half[i][j] = 0.5 * (i == j ? r->d[j] - t->rq[i] : r->d[j]);
        }
        a[j] = t->h[j] * alpha->cosine[j];
    }
    lanes sum = r->fw[0] * r->w[0] + r->fw[1] * r->w[1] + r->fw[2] * r->w[2];
    lanes rtt = 0.5 * t->rtwice * t->rtwice;
    LANES_UNROLL
    for (int i = 0; i < 3; i++)
        LANES_UNROLL
        for (int j = 0; j < 3; j++) {
            cbx[i][j] = cb[i][0] * r->w[0] * half[0][j] + cb[i][1] * r->w[1] * half[1][j] +
                        cb[i][2] * r->w[2] * half[2][j];
            fqa[j][i] = cbx[i][j] * a[i];
            faa[i][j] = a[i] * cb[i][j] * a[j];
            if (exact) {
                fqa[j][i] += r->fw[i] * half[i][j] * a[i];
                if (i == j)
                    faa[i][j] -= r->fw[i] * r->w[i];
            }
        }
    LANES_UNROLL
    for (int j = 0; j < 3; j++)
        LANES_UNROLL
        for (int k = 0; k < 3; k++) {
            lanes f = cm[j][k];
            LANES_UNROLL
            for (int i = 0; i < 3; i++) {
                f += r->w[i] * half[i][j] * cbx[i][k];
                if (exact)
                    f += r->fw[i] * r->w[i] * half[i][j] * half[i][k];
            }
            if (exact) {
                f += 0.5 * sum * ((j == k ? -rtt : rtt) - r->d[j] * r->d[k]);
                if (j == k)
                    f += 0.5 * r->fw[j] * r->w[j] * t->rq[j] * t->rq[j];
            }
            fqq[j][k] = f;
        }
}

/* The element's Hessian in increments of corners and of gamma_i, the angle of edge i's normal from a frame that
 * follows the edge without twist:  alpha_i = side_i gamma_i - psi_i,  psi_i the angle of N in that frame,
 *   grad_k psi_i = p_ik N,  p_ik = g_k . y_i  (triangle_turn),  y_i = N x e_i/|e_i|,
 *   hess_km psi_i = -p_im N g_k^T - p_ik g_m N^T - c_ik c_im/(2 q_i) (N y_i^T + y_i N^T),
 *   H = J^T F J + Sum_i 2 kappa_i (c_ik c_im) 1 - Sum_i dU/dalpha_i hess psi_i,   dq_i/dv_k = 2 c_ik e_i,
 *   c_ik = -1, +1, 0 for v_k at the start of edge i, at its end, off it.
 * In the face's own axes (e_0/|e_0|, N x e_0/|e_0|, N) edges and g are plane and psi moves along N only; each
 * block is made there and turned.  The semidefinite version clamps kappa and leaves hess psi out. */
LANES_INLINE void triangle_hessian(const struct triangle_material *m, const struct triangle_rest *rest,
                                   const struct triangle_shape *t, const struct triangle_angles *alpha,
                                   const struct triangle_response *r, const lanes side[3], int exact,
                                   struct triangle_blocks *out)
{
    static const int first[6] = { 0, 1, 2, 0, 0, 1 }, second[6] = { 0, 1, 2, 1, 2, 2 };
    lanes fqq[3][3], fqa[3][3], faa[3][3], p[3][3];
    triangle_second(m, rest, t, alpha, r, exact, fqq, fqa, faa);
    triangle_turn(t, p);
    lanes kappa[3] = { r->kappa[0], r->kappa[1], r->kappa[2] };
    if (!exact)
        triangle_clamp(kappa);

    /* Edges e, their inward normals y and the gradients g in the plane. */
    struct vec n = t->normal, ax = vec_scale(t->rl[0], t->e[0]), ay = vec_cross(n, ax);
    lanes e[3][2], y[3][2], g[3][2];
    LANES_UNROLL
    for (int i = 0; i < 3; i++) {
        e[i][0] = vec_dot(t->e[i], ax);
        e[i][1] = vec_dot(t->e[i], ay);
        y[i][0] = -e[i][1] * t->rl[i];
        y[i][1] = e[i][0] * t->rl[i];
    }
    LANES_UNROLL
    for (int k = 0; k < 3; k++) {
        g[k][0] = y[(k + 1) % 3][0] * t->rh[(k + 1) % 3];
        g[k][1] = y[(k + 1) % 3][1] * t->rh[(k + 1) % 3];
    }

    /* Rows of corner k: eq = Sum_i c_ik e_i fqq_ij, ea = Sum_i c_ik e_i fqa_ij, z_jk = Sum_i faa_ji p_ik,
     * u_k = Sum_i dU/dalpha_i p_ik. */
    lanes eq[3][3][2], ea[3][3][2], z[3][3], u[3];
    LANES_UNROLL
    for (int k = 0; k < 3; k++) {
        int into = (k + 2) % 3;
        LANES_UNROLL
        for (int j = 0; j < 3; j++) {
            LANES_UNROLL
            for (int c = 0; c < 2; c++) {
                eq[k][j][c] = e[into][c] * fqq[into][j] - e[k][c] * fqq[k][j];
                ea[k][j][c] = e[into][c] * fqa[into][j] - e[k][c] * fqa[k][j];
            }
            z[j][k] = faa[j][0] * p[0][k] + faa[j][1] * p[1][k] + faa[j][2] * p[2][k];
        }
        u[k] = r->fa[0] * p[0][k] + r->fa[1] * p[1][k] + r->fa[2] * p[2][k];
    }

    /* in[k][m]: in the plane at k, along N at m. */
    lanes in[3][3][2];
    LANES_UNROLL
    for (int k = 0; k < 3; k++)
        LANES_UNROLL
        for (int l = 0; l < 3; l++) {
            int into = (k + 2) % 3, common = l == (k + 1) % 3 ? k : into;  /* the edge of k and l */
            LANES_UNROLL
            for (int c = 0; c < 2; c++) {
                in[k][l][c] = -2 * (ea[k][0][c] * p[0][l] + ea[k][1][c] * p[1][l] + ea[k][2][c] * p[2][l]);
                if (exact) {
                    in[k][l][c] += u[k] * g[l][c];
                    if (k == l)
                        in[k][l][c] += 0.5 * (r->fa[k] * t->rq[k] * y[k][c] + r->fa[into] * t->rq[into] * y[into][c]);
                    else
                        in[k][l][c] -= 0.5 * r->fa[common] * t->rq[common] * y[common][c];
                }
            }
        }

    LANES_UNROLL
    for (int b = 0; b < 6; b++) {
        int k = first[b], l = second[b], into_k = (k + 2) % 3, into_l = (l + 2) % 3;
        int common = l == (k + 1) % 3 ? k : into_k;
        lanes pp[2][2], nn = z[0][l] * p[0][k] + z[1][l] * p[1][k] + z[2][l] * p[2][k];
        lanes tension = k == l ? 2 * (kappa[k] + kappa[into_k]) : -2 * kappa[common];
        LANES_UNROLL
        for (int c = 0; c < 2; c++)
            LANES_UNROLL
            for (int d = 0; d < 2; d++)
                pp[c][d] = 4 * (eq[k][into_l][c] * e[into_l][d] - eq[k][l][c] * e[l][d]);
        pp[0][0] += tension;
        pp[1][1] += tension;
        nn += tension;
        /* (ax ay n) block (ax ay n)^T */
        struct vec bx = vec_fma(vec_fma(vec_scale(pp[0][0], ax), pp[1][0], ay), in[l][k][0], n);
        struct vec by = vec_fma(vec_fma(vec_scale(pp[0][1], ax), pp[1][1], ay), in[l][k][1], n);
        struct vec bn = vec_fma(vec_fma(vec_scale(in[k][l][0], ax), in[k][l][1], ay), nn, n);
        struct vec cx = vec_fma(vec_fma(vec_scale(ax.x, bx), ay.x, by), n.x, bn);
        struct vec cy = vec_fma(vec_fma(vec_scale(ax.y, bx), ay.y, by), n.y, bn);
        struct vec cz = vec_fma(vec_fma(vec_scale(ax.z, bx), ay.z, by), n.z, bn);
        out->vv[b][0][0] = cx.x;
        out->vv[b][1][0] = cx.y;
        out->vv[b][2][0] = cx.z;
        out->vv[b][0][1] = cy.x;
        out->vv[b][1][1] = cy.y;
        out->vv[b][2][1] = cy.z;
        out->vv[b][0][2] = cz.x;
        out->vv[b][1][2] = cz.y;
        out->vv[b][2][2] = cz.z;
    }
    LANES_UNROLL
    for (int j = 0; j < 3; j++) {
        LANES_UNROLL
        for (int k = 0; k < 3; k++) {
            struct vec a = vec_fma(vec_scale(2 * ea[k][j][0], ax), 2 * ea[k][j][1], ay);
            a = vec_scale(side[j], vec_fma(a, -z[j][k], n));
            out->ve[k][j][0] = a.x;
            out->ve[k][j][1] = a.y;
            out->ve[k][j][2] = a.z;
            out->ee[k][j] = side[k] * side[j] * faa[k][j];
        }
    }
}

#endif
