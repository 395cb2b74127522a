/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text that grows at its end: pieces in, one array of bytes out. */
#include "charts/text.h"

#include <stdarg.h>
#include <string.h>

void text_bytes(struct text *text, const char *bytes, size_t n)
{
    if (text->room - text->length < n) {
        size_t room = text->room ? text->room : 256;
        while (room - text->length < n)
            room *= 2;
        char *larger = arena_array(text->arena, char, room);
        if (text->length)
            memcpy(larger, text->bytes, text->length);
        text->bytes = larger;
        text->room = room;
    }
    if (n)
        memcpy(text->bytes + text->length, bytes, n);
    text->length += n;
}

void text_print(struct text *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *piece = arena_vprintf(text->arena, format, arguments);
    va_end(arguments);
    text_bytes(text, piece, strlen(piece));
}
