/* SPDX-License-Identifier: GPL-3.0-or-later
 * Fabrics as pages write them: `st.st.`, `rib (k2, p2)`, `4 rows of k2, p2`. */
#ifndef WEFT_FABRICS_H
#define WEFT_FABRICS_H

#include <stddef.h>

#include "lang/page/signs.h"

/* Each: the bytes at a place, and the plain text for them; 0: something else stands there. */
size_t fabrics_short(const char *text, size_t at, char plain[static SIGNS_PLAIN]);     /* `st.st.`, `g.st`: `st st`, `g st` */
size_t fabrics_rib(const char *text, size_t at, char plain[static SIGNS_PLAIN]);       /* `rib (k2, p2)`: `k2 p2 rib` */
size_t fabrics_rows(const char *text, size_t at, char plain[static SIGNS_PLAIN]);      /* `Work 4 rows of k2, p2`: `k2 p2 rib 4 rows` */

size_t fabrics_alternate(const char *text, size_t at, char plain[static SIGNS_PLAIN]); /* `knit 1 row, purl 1 row, for 6 rows`: `st st 6 rows beg on k row` */
size_t fabrics_changed(const char *text, size_t at, char plain[static SIGNS_PLAIN]);   /* `Change to seed st. Work 6 rows`: `seed st 6 rows` */
size_t fabrics_of_rows(const char *text, size_t at, char plain[static SIGNS_PLAIN]);   /* `Rows 7-10: work 4 rows in st st`: the count is the head's */
size_t fabrics_begun(const char *text, size_t at, char plain[static SIGNS_PLAIN]);     /* `Starting with k1, work 4 rows of k1, p1`: it begins so */

/* Of `*k1, p1* for 4 rows` at a line's beginning the bytes of the stitches; 0: something else. *length: those of the rest. */
size_t fabrics_repeated(const char *text, size_t *length);

#endif
