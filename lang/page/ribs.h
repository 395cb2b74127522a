/* SPDX-License-Identifier: GPL-3.0-or-later
 * Ribs that a page describes in words, `(k2, p2) rib`, `Rib: *k2, p2; rep from *`, and calls by that word alone later on. */
#ifndef WEFT_RIBS_H
#define WEFT_RIBS_H

#include <stdbool.h>
#include <stddef.h>

/* What is known of a text up to a place of it; zero at first. */
struct ribs {
    size_t at;              /* it was read up to here */
    int knit, purl;         /* of the first rib described, */
    int n;                  /* of so many that differ: 0, 1, 2 or more */
    bool looked;
    size_t last;            /* where `in rib`, `work rib` stands last; 0: nowhere */
};

/* Reads on up to a place. */
void ribs_read(struct ribs *, const char *text, size_t at);

/* Whether a line that begins there only describes a rib that is worked later. */
bool ribs_describes(struct ribs *, const char *text, size_t at);

/* How long `Rib: *k2, p2* around` or `Rib 2 and 2` is before `for` or `until`, and the rib plainly; or 0. */
enum { RIBS_PLAIN = 32 };
size_t ribs_length(const char *text, char plain[static RIBS_PLAIN]);

/* `k2, p2`, `2 x 2`, `double`: its bytes and numbers; 0: another text. */
size_t ribs_pair(const char *text, int *knit, int *purl);

#endif
