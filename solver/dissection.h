/* SPDX-License-Identifier: GPL-3.0-or-later
 * Geometric nested dissection of a rectangular grid of nodes: an elimination
 * order with little fill (A. George, SIAM J. Numer. Anal. 10, 1973). */
#ifndef WEFT_DISSECTION_H
#define WEFT_DISSECTION_H

/* place (ny x nx, x fastest): the position of each node in the order.  Nodes
 * couple to others up to `reach` lines away, so separators are that wide.
 * parts: where the first and the second half of the first cut end in the order
 * (the separator follows); 0, 0 for a grid too small to cut. */
void dissection_order(int nx, int ny, int reach, int *place, int parts[2]);

#endif
