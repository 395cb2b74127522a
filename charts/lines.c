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
    return c == ' ' || c == '\t';
}

bool lines_next(struct lines *lines, struct span *line)
{
    const char *text = lines->source->text;
    size_t start = lines->at, size = lines->source->size;
    if (start >= size)
        return false;
    size_t end = start;
    while (end < size && text[end] != '\n' && text[end] != '\r')
        end++;
    lines->at = end + 1 + (end + 1 < size && text[end] == '\r' && text[end + 1] == '\n');
    while (end > start && lines_is_blank(text[end - 1]))
        end--;
    while (start < end && lines_is_blank(text[start]))
        start++;
    *line = (struct span){lines->source, (unsigned)start, (unsigned)end};
    return true;
}
