/* SPDX-License-Identifier: GPL-3.0-or-later
 * The built-in files, as the build puts them into the binary. */
#ifndef WEFT_LIBRARY_H
#define WEFT_LIBRARY_H

struct library_file {
    const char *name;               /* "std/rib.knit" */
    const char *const *line;        /* its lines, NULL behind the last */
};

struct library_name {
    const char *name;               /* of a motif */
    const char *arguments;          /* "(k = 2, p = 2)" or "" */
    const char *about;              /* the comment above it, lines ended by a line feed but the last */
    int         file;               /* its place among the files */
};

extern const struct library_file library_files[];
extern const int library_nfiles;
extern const struct library_name library_names[];
extern const int library_nnames;

#endif
