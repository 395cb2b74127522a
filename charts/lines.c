/* SPDX-License-Identifier: GPL-3.0-or-later
 * A source in, the spans of its lines out. */
#include "charts/lines.h"

#include <string.h>

struct lines lines_of(const struct source *source)
{
    bool mark = source->size >= 3 && memcmp(source->text, "\xEF\xBB\xBF", 3) == 0;
    return (struct lines){source, mark ? 3 : 0};
}

bool lines_is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

bool lines_next(struct lines *lines, struct span *line)
{
    const char *text = lines->source->text;
    size_t start = lines->at, size = lines->source->size;
    if (start >= size)
        return false;
    const char *newline = memchr(text + start, '\n', size - start);
    size_t end = newline ? (size_t)(newline - text) : size;
    lines->at = end + 1;
    while (end > start && lines_is_blank(text[end - 1]))
        end--;
    while (start < end && lines_is_blank(text[start]))
        start++;
    *line = (struct span){lines->source, (unsigned)start, (unsigned)end};
    return true;
}
