/* SPDX-License-Identifier: GPL-3.0-or-later
 * The key of a page's chart: which sign is which stitch. */
#ifndef WEFT_PAGE_KEY_H
#define WEFT_PAGE_KEY_H

#include "lang/diag.h"
#include "lang/grid.h"

enum { PAGE_SIGNS = 16 };

struct page_sign {
    const char *text;
    size_t      length;
    stitch_id   stitch;
    bool        letter;         /* K or P, which no key explains */
};

struct page_key {
    struct page_sign sign[PAGE_SIGNS];
    int              n;
    bool             figures;   /* a sign is one: lines have no numbers */
};

/* Reads the entries of all lines, `. = purl on RS, knit on WS`; the letters K and P are always known. */
void page_key_read(struct page_key *, const struct source *);

/* The sign that so many bytes are; or NULL. */
const struct page_sign *page_key_find(const struct page_key *, const char *text, size_t length);

/* Whether a line has entries of it and nothing else. */
bool page_key_is_line(const struct page_key *, struct span line);

/* The bytes of a character. */
size_t page_key_character(const char *text);

#endif
