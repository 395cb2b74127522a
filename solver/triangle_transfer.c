/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solver/triangle_model.h"
void triangle_prolong(const struct discretisation *coarse, const double *x, const struct discretisation *fine,
                      double *x_fine)
{
(void)coarse,(void)x,(void)fine,(void)x_fine;
}
void triangle_sample(const struct discretisation *d, const double *x, double growth, struct surface *surface)
{
(void)d,(void)x,(void)growth,(void)surface;
}
