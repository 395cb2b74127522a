/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place in the unit square in, shape functions and their derivatives out. */
#include "solver/patch_basis.h"

const struct basis basis_hermite = {BASIS_HERMITE, 2, 4, 16};
const struct basis basis_spline = {BASIS_SPLINE, 3, 1, 9};

/* Cubic Hermite functions f[node][value or slope][derivative]. */
static void hermite_line(double t, double f[2][2][3])
{
    const double line[2][2][3] = {
        {{1 - t * t * (3 - 2 * t), 6 * t * (t - 1), 12 * t - 6},
         {t * (1 - t) * (1 - t), 1 - t * (4 - 3 * t), 6 * t - 4}},
        {{t * t * (3 - 2 * t), 6 * t * (1 - t), 6 - 12 * t},
         {t * t * (t - 1), t * (3 * t - 2), 6 * t - 2}},
    };
    for (int e = 0; e < 12; e++)
        (&f[0][0][0])[e] = (&line[0][0][0])[e];
}

static void hermite_at(double s, double t, double N[3][3][BASIS_MAX])
{
    double f[2][2][3], g[2][2][3];
    hermite_line(s, f);
    hermite_line(t, g);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int a = 0; a < 16; a++) {
                int node = a / 4, k = a % 4;
                N[i][j][a] = f[node % 2][k % 2][i] * g[node / 2][k / 2][j];
            }
}

/* The three uniform quadratic B-splines that reach an element, and their derivatives. */
static void spline_line(double t, double f[3][3])
{
    const double line[3][3] = {
        {(1 - t) * (1 - t) / 2, t - 1, 1}, {0.5 + t * (1 - t), 1 - 2 * t, -2}, {t * t / 2, t, 1}};
    for (int e = 0; e < 9; e++)
        (&f[0][0])[e] = (&line[0][0])[e];
}

static void spline_at(double s, double t, double N[3][3][BASIS_MAX])
{
    double f[3][3], g[3][3];
    spline_line(s, f);
    spline_line(t, g);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int a = 0; a < 9; a++)
                N[i][j][a] = f[a % 3][i] * g[a / 3][j];
}

int basis_line(const struct basis *basis, double t, double f[BASIS_LINE][3])
{
    if (basis->kind == BASIS_HERMITE)
        hermite_line(t, (double(*)[2][3])f);
    else
        spline_line(t, f);
    return basis->kind == BASIS_HERMITE ? 4 : 3;
}

void basis_at(const struct basis *basis, double s, double t, double N[3][3][BASIS_MAX])
{
    if (basis->kind == BASIS_HERMITE)
        hermite_at(s, t, N);
    else
        spline_at(s, t, N);
}

void basis_gauss(int n, double *point, double *weight)
{
    static const double x[GAUSS_MAX][GAUSS_MAX] = {
        {0},
        {-0.57735026918962576451, 0.57735026918962576451},
        {-0.77459666924148337704, 0, 0.77459666924148337704},
        {-0.86113631159405257522, -0.33998104358485626480, 0.33998104358485626480, 0.86113631159405257522}};
    static const double w[GAUSS_MAX][GAUSS_MAX] = {
        {2},
        {1, 1},
        {5.0 / 9, 8.0 / 9, 5.0 / 9},
        {0.34785484513745385737, 0.65214515486254614263, 0.65214515486254614263, 0.34785484513745385737}};
    for (int i = 0; i < n; i++) {
        point[i] = 0.5 + 0.5 * x[n - 1][i];
        weight[i] = 0.5 * w[n - 1][i];
    }
}
