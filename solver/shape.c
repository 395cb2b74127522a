/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sampled surface in; its best alignment with the flat sheet, extents, height
 * and curvature out. */
#include "solver/shape.h"

#include <math.h>

/* Means of folded and flat points, and H = Sum folded flat^T about them (3 x 2; flat has no z). */
static void correlate(const struct surface *s, double folded[3], double flat[3], double H[3][2])
{
    size_t points = (size_t)(s->nx + 1) * (size_t)(s->ny + 1);
    for (int c = 0; c < 3; c++) {
        folded[c] = flat[c] = 0;
        for (size_t i = 0; i < points; i++) {
            folded[c] += s->position[3 * i + c] / (double)points;
            flat[c] += (s->position[3 * i + c] - s->displacement[3 * i + c]) / (double)points;
        }
    }
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 2; c++) {
            H[r][c] = 0;
            for (size_t i = 0; i < points; i++)
                H[r][c] += (s->position[3 * i + r] - folded[r]) *
                           (s->position[3 * i + c] - s->displacement[3 * i + c] - flat[c]);
        }
}

/* R = polar factor of H: H (H^T H)^(-1/2), the square root of a 2x2 matrix A
 * being (A + sqrt(det A) I)/sqrt(tr A + 2 sqrt(det A)).  false: H has no rank 2. */
static bool polar(double H[3][2], double R[3][3])
{
    double a = 0, b = 0, d = 0;
    for (int r = 0; r < 3; r++)
        a += H[r][0] * H[r][0], b += H[r][0] * H[r][1], d += H[r][1] * H[r][1];
    double det = a * d - b * b;
    if (!(det > 1e-20 * (a + d) * (a + d)))
        return false;
    double root = sqrt(det), t = sqrt(a + d + 2 * root);
    double ra = (a + root) / t, rb = b / t, rd = (d + root) / t;
    for (int r = 0; r < 3; r++) {
        R[0][r] = (H[r][0] * rd - H[r][1] * rb) / root;
        R[1][r] = (H[r][1] * ra - H[r][0] * rb) / root;
    }
    R[2][0] = R[0][1] * R[1][2] - R[0][2] * R[1][1];
    R[2][1] = R[0][2] * R[1][0] - R[0][0] * R[1][2];
    R[2][2] = R[0][0] * R[1][1] - R[0][1] * R[1][0];
    return true;
}

static void turn(double R[3][3], const double *v, double *turned)
{
    for (int r = 0; r < 3; r++)
        turned[r] = R[r][0] * v[0] + R[r][1] * v[1] + R[r][2] * v[2];
}

void shape_align(struct surface *s)
{
    double folded[3], flat[3], H[3][2], R[3][3];
    correlate(s, folded, flat, H);
    if (!polar(H, R))
        return;
    size_t points = (size_t)(s->nx + 1) * (size_t)(s->ny + 1);
    for (size_t i = 0; i < points; i++) {
        double *r = s->position + 3 * i, *n = s->normal + 3 * i, *u = s->displacement + 3 * i;
        double rest[3], moved[3], normal[3] = {n[0], n[1], n[2]};
        for (int c = 0; c < 3; c++) {
            rest[c] = r[c] - u[c];
            moved[c] = r[c] - folded[c];
        }
        turn(R, moved, r);
        turn(R, normal, n);
        for (int c = 0; c < 3; c++) {
            r[c] += flat[c];
            u[c] = r[c] - rest[c];
        }
    }
}

void shape_measure(const struct surface *s, double width, double height, struct fold_record *record)
{
    size_t points = (size_t)(s->nx + 1) * (size_t)(s->ny + 1), cells = (size_t)s->nx * (size_t)s->ny;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, mean = 0, square = 0;
    for (size_t i = 0; i < points; i++) {
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], s->position[3 * i + c]);
            high[c] = fmax(high[c], s->position[3 * i + c]);
        }
        mean += s->position[3 * i + 2] / (double)points;
    }
    for (size_t i = 0; i < points; i++)
        square += (s->position[3 * i + 2] - mean) * (s->position[3 * i + 2] - mean) / (double)points;
    record->extent_x = (high[0] - low[0]) / width;
    record->extent_y = (high[1] - low[1]) / height;
    record->extent_z = high[2] - low[2];
    record->rms_height = sqrt(square);
    record->max_normal_curvature = 0;
    for (size_t i = 0; i < cells; i++) {    /* |k1|, |k2| = | |H| +- sqrt(H^2 - K) | */
        double spread = sqrt(fmax(s->mean[i] * s->mean[i] - s->gauss[i], 0));
        record->max_normal_curvature = fmax(record->max_normal_curvature, fabs(s->mean[i]) + spread);
    }
}
