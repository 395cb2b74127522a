/* SPDX-License-Identifier: GPL-3.0-or-later
 * Fields over a grid in, a short text out that a page can carry: quantised,
 * predicted from neighbours, deflated, in base64. */
#include "output/page_pack.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

void page_pack_no_room(void)
{
    fprintf(stderr, "weft: out of memory\n");
    exit(1);
}

void *page_pack_room(void *old, size_t size)
{
    void *memory = realloc(old, size ? size : 1);
    if (!memory)
        page_pack_no_room();
    return memory;
}

static unsigned char *add(struct page_pack *pack, size_t n)
{
    if (pack->room - pack->n < n) {
        pack->room = 2 * pack->room + n;
        pack->byte = page_pack_room(pack->byte, pack->room);
    }
    pack->n += n;
    return pack->byte + pack->n - n;
}

void page_pack_bytes(struct page_pack *pack, const unsigned char *byte, size_t n)
{
    memcpy(add(pack, n), byte, n);
}

static uint16_t level(const struct page_field *f, float value)
{
    double share = f->high > f->low ? (value - f->low) / (f->high - f->low) : 0;
    return (uint16_t)lrint(PAGE_LEVELS * (share > 0 ? fmin(share, 1) : 0));
}

void page_pack_field(struct page_pack *pack, const struct page_field *f, const float *value)
{
    size_t n = f->width * f->height * f->nlayers, i = 0;
    unsigned char *low = add(pack, 2 * n), *high = low + n;
    uint16_t *below = page_pack_room(NULL, f->width * sizeof *below);

    for (size_t row = 0; row < f->height * f->nlayers; row++) {
        uint16_t left = 0, between = 0;
        if (row % f->height == 0)
            memset(below, 0, f->width * sizeof *below);
        for (size_t x = 0; x < f->width; x++, i++) {
            uint16_t q = level(f, value[i]), rest = (uint16_t)(q - (left + below[x] - between));
            uint16_t folded = (uint16_t)(rest << 1 ^ (rest & 0x8000 ? 0xFFFF : 0));
            low[i] = (unsigned char)(folded & 0xFF);
            high[i] = (unsigned char)(folded >> 8);
            between = below[x];
            left = below[x] = q;
        }
    }
    free(below);
}

static char *base64(const unsigned char *byte, size_t n)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    char *text = page_pack_room(NULL, (n + 2) / 3 * 4 + 1), *to = text;
    for (size_t i = 0; i < n; i += 3, to += 4) {
        unsigned more = i + 1 < n ? byte[i + 1] : 0, most = i + 2 < n ? byte[i + 2] : 0;
        unsigned bits = (unsigned)byte[i] << 16 | more << 8 | most;
        for (int k = 0; k < 4; k++)
            to[k] = digit[bits >> (18 - 6 * k) & 63];
        if (i + 2 >= n)
            to[3] = '=';
        if (i + 1 >= n)
            to[2] = '=';
    }
    *to = '\0';
    return text;
}

char *page_pack_text(struct page_pack *pack)
{
    uLongf size = compressBound(pack->n);
    unsigned char *deflated = page_pack_room(NULL, size);
    if (compress2(deflated, &size, pack->byte, pack->n, Z_BEST_COMPRESSION) != Z_OK)
        abort();                /* the room suffices: a bug */
    char *text = base64(deflated, size);
    free(deflated);
    free(pack->byte);
    *pack = (struct page_pack){0};
    return text;
}
