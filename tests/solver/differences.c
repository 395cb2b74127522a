/* SPDX-License-Identifier: GPL-3.0-or-later
 * Central differences along random directions. */
#include "tests/solver/differences.h"

#include <math.h>
#include <stdlib.h>

#include "solver/memory.h"
#include "solver/vector.h"
#include "tests/solver/scenes.h"

/* y = x + step v */
static double *moved(int n, const double *x, double step, const double *v)
{
    double *y = MEMORY_ARRAY(double, n);
    for (int i = 0; i < n; i++)
        y[i] = x[i] + step * v[i];
    return y;
}

/* (U(x + s v) - U(x - s v)) / 2 s against g . v; energies of the parts add up to the total. */
double difference_gradient_error(const struct discretisation *d, const double *x)
{
    double *g = MEMORY_ARRAY(double, d->n), *v = scene_vector(d->n, 1), least = 1;
    d->op->energy(d, x, 1, g);
    double slope = vector_dot(d->n, g, v);
    for (double step = 1e-3; step > 1e-8; step /= 3) {
        double *plus = moved(d->n, x, step, v), *minus = moved(d->n, x, -step, v);
        double difference = d->op->energy(d, plus, 1, NULL).total - d->op->energy(d, minus, 1, NULL).total;
        least = fmin(least, fabs(difference / (2 * step) / slope - 1));
        free(plus);
        free(minus);
    }
    free(g);
    free(v);
    return least;
}

/* T(x)^T of the gradient, T the identity where there is none. */
static double *gradient_in_increments(const struct discretisation *d, const double *x)
{
    double *g = MEMORY_ARRAY(double, d->n), *z = MEMORY_ARRAY(double, d->n);
    d->op->energy(d, x, 1, g);
    if (!d->op->cotangent)
        return free(z), g;
    d->op->cotangent(d, x, g, z);
    free(g);
    return z;
}

/* v . (g_z(x + s T u) - g_z(x - s T u)) / 2 s */
static double bilinear_difference(const struct discretisation *d, const double *x, const double *u, const double *v,
                                  double step)
{
    double *move = MEMORY_ARRAY(double, d->n);
    if (d->op->tangent)
        d->op->tangent(d, x, u, move);
    else
        for (int i = 0; i < d->n; i++)
            move[i] = u[i];
    double *plus = moved(d->n, x, step, move), *minus = moved(d->n, x, -step, move);
    double *gp = gradient_in_increments(d, plus), *gm = gradient_in_increments(d, minus);
    double result = (vector_dot(d->n, v, gp) - vector_dot(d->n, v, gm)) / (2 * step);
    free(move);
    free(plus);
    free(minus);
    free(gp);
    free(gm);
    return result;
}

static double bilinear(const struct pattern *p, const double *value, const double *u, const double *v)
{
    double s = 0;
    for (int j = 0; j < p->n; j++)
        for (int k = p->start[j]; k < p->start[j + 1]; k++) {
            int i = p->row[k];
            s += value[k] * (i == j ? u[i] * v[i] : u[i] * v[j] + u[j] * v[i]);
        }
    return s;
}

/* Where T turns with x the differences are not symmetric, but for that the Hessian is their symmetric part. */
double difference_hessian_error(const struct discretisation *d, const double *x)
{
    double *u = scene_vector(d->n, 1), *v = scene_vector(d->n, 1), least = 1;
    double *value = MEMORY_ARRAY(double, d->pattern.start[d->n]);
    d->op->hessian(d, x, 1, HESSIAN_EXACT, value);
    double exact = bilinear(&d->pattern, value, u, v);
    double scale = fabs(exact) + 1e-3 * fabs(bilinear(&d->pattern, value, u, u));
    for (double step = 1e-3; step > 1e-8; step /= 3) {
        double difference = bilinear_difference(d, x, u, v, step) + bilinear_difference(d, x, v, u, step);
        least = fmin(least, fabs(difference / 2 - exact) / scale);
    }
    free(u);
    free(v);
    free(value);
    return least;
}

double difference_cholesky(const struct pattern *p, const double *value, double shift)
{
    size_t n = (size_t)p->n;
    double *a = MEMORY_ARRAY(double, n * n), smallest = INFINITY;
    for (int j = 0; j < p->n; j++)
        for (int k = p->start[j]; k < p->start[j + 1]; k++)
            a[(size_t)p->row[k] * n + (size_t)j] = value[k];
    for (size_t j = 0; j < n; j++) {
        double pivot = a[j * n + j] + shift - vector_dot((int)j, a + j * n, a + j * n);
        if (!(pivot > 0)) {
            smallest = -1;
            break;
        }
        smallest = fmin(smallest, pivot);
        a[j * n + j] = sqrt(pivot);
        for (size_t i = j + 1; i < n; i++)
            a[i * n + j] = (a[i * n + j] - vector_dot((int)j, a + i * n, a + j * n)) / a[j * n + j];
    }
    free(a);
    return smallest;
}
