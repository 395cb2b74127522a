/* SPDX-License-Identifier: GPL-3.0-or-later
 * An orthographic view: angles in, the picture's axes out. */
#include "output/view.h"

#include <math.h>

struct view view_make(const double angles[2])
{
    double a = angles[0] * M_PI / 180, e = angles[1] * M_PI / 180;
    return (struct view){
        .right = {cos(a), sin(a), 0},
        .up = {-sin(a) * sin(e), cos(a) * sin(e), cos(e)},
        .eye = {sin(a) * cos(e), -cos(a) * cos(e), sin(e)},
    };
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void view_project(const struct view *view, const double point[3], double seen[3])
{
    seen[0] = dot(view->right, point);
    seen[1] = dot(view->up, point);
    seen[2] = dot(view->eye, point);
}

void view_direction(const struct view *view, const double angles[2], double direction[3])
{
    double a = angles[0] * M_PI / 180, e = angles[1] * M_PI / 180;
    for (int c = 0; c < 3; c++)
        direction[c] = sin(a) * cos(e) * view->right[c] + sin(e) * view->up[c] + cos(a) * cos(e) * view->eye[c];
}
