/* SPDX-License-Identifier: GPL-3.0-or-later
 * A minimised state of another program on its own mesh, and the check that the
 * triangles give the same energies there. */
#ifndef WEFT_TEST_REFERENCE_H
#define WEFT_TEST_REFERENCE_H

#include <stddef.h>

/* A state as read, in the unknowns' terms of our own mesh. */
struct reference {
    int      nvertices, nfaces, nedges;
    double (*rest)[2], (*position)[3];
    int    (*face)[3];
    double  *knit;              /* +1 knit, -1 purl (nfaces) */
    double  *angle;             /* (nedges) as the first face sees it */
    double (*face_energy)[2];   /* stretching, bending (nfaces), or NULL */
    double   stretching, bending, springs;
    double   spring;            /* on each vertex of the boundary */
};

/* Room for count zeroed elements. */
void *reference_array(int count, size_t size);
void  reference_free(struct reference *r);

/* Fails the test unless all energies agree to 1e-9 of themselves and no force is left. */
void reference_check(const struct reference *r);

#endif
