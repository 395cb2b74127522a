/* SPDX-License-Identifier: GPL-3.0-or-later
 * Brackets of a page that are none of the language: how many bytes each is; 0 where it is another. */
#ifndef WEFT_GROUPS_H
#define WEFT_GROUPS_H

#include <stdbool.h>
#include <stddef.h>

struct page_facts;

/* Of "(K2. P2) ribbing", whose brackets go; of `{k1, p1}`, more than one stitch and no more, `{RS}` or `{8mm}`. */
size_t groups_rib(const char *text);
size_t groups_braces(const char *text);

/* Of `(5, 6)` behind a number, where the cast-on names as many further sizes; of `(k3)` behind `knit 3`. */
size_t groups_sizes(const char *text, size_t at, const struct page_facts *);
size_t groups_said_again(const char *text, size_t at);

/* Where the bracket is closed that a text begins with, on its line; whether `{(k1, p1) to last st, k1}`, closed there,
 * fills a row by itself. */
size_t groups_close(const char *text);
size_t groups_close_below(const char *text);    /* on its line, or on one of the next */
bool groups_fill_row(const char *text, size_t close);

/* Of `(k1, p1 to last 2 sts)`, `(k1, p1; rep 3 times)`, closed there, how far it groups what is repeated: behind p1. */
size_t groups_repeated(const char *text, size_t close);

/* Of `*k2, p2 (rep from * to last 2 sts)`, opened there, where the bracket is closed; 0: it groups stitches. */
size_t groups_of_star(const char *text, size_t at);

#endif
