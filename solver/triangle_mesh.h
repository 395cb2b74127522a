/* SPDX-License-Identifier: GPL-3.0-or-later
 * A flat triangle mesh: a sheet of stitches in, vertices, edges and faces that
 * keep to the stitches' lines out; or any mesh a caller has. */
#ifndef WEFT_TRIANGLE_MESH_H
#define WEFT_TRIANGLE_MESH_H

#include "solver/sheet.h"

/* An entry of the boundary's spring matrix, between vertices a and b: stiffness of the pull to rest / young. */
struct triangle_spring {
    int    a, b;
    double stiffness;           /* length */
};

struct triangle_mesh {
    int       nvertices, nedges, nfaces;
    double  (*rest)[2];         /* length    (nvertices) flat position */
    int     (*face)[3];         /* vertices  (nfaces) v0 v1 v2, counter-clockwise seen from the RS */
    int     (*face_edge)[3];    /* edges     (nfaces) v0v1, v1v2, v2v0 */
    int     (*edge)[2];         /* vertices  (nedges) in the direction its first face runs along it */
    int     (*edge_face)[2];    /* faces     (nedges) the two beside it; the second is -1 on the boundary */
    double  (*natural)[3];      /* 1/length  (nfaces) kx, ky, twist */
    int       nsprings;
    struct triangle_spring *spring; /* (nsprings) owned */

    /* Of a mesh made from stitches only; all 0 and NULL otherwise. */
    int              per_stitch;
    int              nx, ny;            /* cells */
    double           dx, dy;            /* length, one cell */
    enum diagonals   diagonals;
    int              nshapes;           /* of faces that are translates of each other */
    unsigned char   *shape;             /* (nfaces) */
};

/* per_stitch x per_stitch cells a stitch, split as the sheet's mesh says.
 * Vertices: the cells' corners, x fastest, then their centres (criss-cross);
 * edges along x, along y, then within cells; faces cell by cell. */
struct triangle_mesh *triangle_mesh_make(const struct sheet *sheet, int per_stitch);

/* Any mesh of counter-clockwise faces: copies rest (nvertices) and face (nfaces), numbers the edges as
 * the faces meet them, leaves natural at zero.  NULL where three faces share an edge or two run along it
 * in one direction. */
struct triangle_mesh *triangle_mesh_of_faces(int nvertices, const double (*rest)[2], int nfaces, const int (*face)[3]);

void triangle_mesh_free(struct triangle_mesh *mesh);

/* Numbers in a mesh made from stitches; i counts along x, j along y. */
int triangle_mesh_corner(const struct triangle_mesh *mesh, int i, int j);
int triangle_mesh_centre(const struct triangle_mesh *mesh, int i, int j);
int triangle_mesh_edge_x(const struct triangle_mesh *mesh, int i, int j);  /* from corner i, j to i + 1, j */
int triangle_mesh_edge_y(const struct triangle_mesh *mesh, int i, int j);  /* from corner i, j to i, j + 1 */
int triangle_mesh_inner(const struct triangle_mesh *mesh, int i, int j);   /* first edge within a cell */
int triangle_mesh_ninner(const struct triangle_mesh *mesh);                /* edges within a cell: 1 or 4 */
int triangle_mesh_nsplit(const struct triangle_mesh *mesh);                /* faces of a cell: 2 or 4 */

/* Nodes are vertices, then edges (nvertices + e).  Fills order (nvertices + nedges): the nodes in an
 * order of elimination by nested dissection along grid lines, and cell (nx * ny): the cells as that
 * order first meets them, neighbours in the fabric close together.  parts: the first parts[0] nodes and those
 * from there to parts[1] meet in no face. */
void triangle_mesh_dissect(const struct triangle_mesh *mesh, int *order, int *cell, int parts[2]);

#endif
