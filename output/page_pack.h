/* SPDX-License-Identifier: GPL-3.0-or-later
 * Fields over a grid in, a short text out that a page can carry: quantised,
 * predicted from neighbours, deflated, in base64. */
#ifndef WEFT_PAGE_PACK_H
#define WEFT_PAGE_PACK_H

#include <stddef.h>

enum { PAGE_LEVELS = 65535 };

/* nlayers grids of height x width values, x fastest. */
struct page_field {
    size_t width, height, nlayers;
    double low, high;           /* the values' range: level q stands for low + q * (high - low) / PAGE_LEVELS */
};

/* Bytes that grow. */
struct page_pack {
    unsigned char *byte;        /* (n) owned */
    size_t         n, room;
};

/* realloc that does not return without memory, and what it does then. */
void          *page_pack_room(void *old, size_t size);
_Noreturn void page_pack_no_room(void);

/* Adds a field: a value's level less what its neighbours let expect (left +
 * below - the one between, 0 outside the grid), modulo 2^16, a small one of
 * either sign as a small number (0, -1, 1, -2, ...).  All low bytes go first,
 * then all high bytes: the latter are mostly 0.  Values outside the range are
 * taken to its end. */
void page_pack_field(struct page_pack *pack, const struct page_field *field, const float *value);
void page_pack_bytes(struct page_pack *pack, const unsigned char *byte, size_t n);

/* The bytes in zlib's format as base64; free it.  Empties the pack. */
char *page_pack_text(struct page_pack *pack);

#endif
