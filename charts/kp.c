/* SPDX-License-Identifier: GPL-3.0-or-later
 * A text of K and P in, the pattern it shows out. */
#include "charts/kp.h"

#include <ctype.h>

#include "charts/lines.h"
#include "charts/raster.h"
#include "lang/limits.h"

/* ---- the header ---- */

/* A whole number at *at, which moves behind it; -1: none, more than the limit: too large. */
static long long read_number(const char *text, size_t *at, size_t end)
{
    long long n = 0;
    size_t start = *at;
    for (; *at < end && isdigit((unsigned char)text[*at]); (*at)++)
        n = n > LIMIT_STITCHES ? n : 10 * n + (text[*at] - '0');
    return *at > start ? n : -1;
}

static size_t skip_blanks(const char *text, size_t at, size_t end)
{
    while (at < end && lines_is_blank(text[at]))
        at++;
    return at;
}

/* `# 4 2`: four repeats up, two across. */
static void read_header(struct diag *diag, struct span line, struct pattern *pattern)
{
    const char *text = line.source->text;
    size_t at = skip_blanks(text, line.start + 1, line.end);
    long long up = read_number(text, &at, line.end);
    size_t gap = skip_blanks(text, at, line.end);
    long long across = gap > at ? read_number(text, &gap, line.end) : -1;
    if (up < 0 || across < 0 || gap < line.end) {
        diag_error(diag, CODE_CHART_HEADER, line, "a header is two numbers: how often the rows and the stitches repeat");
        diag_hint(diag, "`# 4 2` repeats four times up and two times across; without a header it is once");
    } else if (up < 1 || across < 1) {
        diag_error(diag, CODE_CHART_HEADER, line, "a repeat is at least 1");
    } else if (up > LIMIT_STITCHES || across > LIMIT_STITCHES) {
        diag_error(diag, CODE_LIMIT_STITCHES, line, "a fabric may have %d stitches", LIMIT_STITCHES);
    } else {
        pattern->up = (int)up;
        pattern->across = (int)across;
    }
}

static void check_size(struct diag *diag, struct span header, const struct pattern *p)
{
    long long rows = (long long)p->grid->rows * p->up, columns = (long long)p->grid->columns * p->across;
    if (rows > LIMIT_ROWS)
        diag_error(diag, CODE_LIMIT_ROWS, header, "this makes %lld rows; a fabric may have %d", rows, LIMIT_ROWS);
    else if (columns > LIMIT_STITCHES / rows)
        diag_error(diag, CODE_LIMIT_STITCHES, header, "this makes %lld x %lld stitches; a fabric may have %d", columns,
                   rows, LIMIT_STITCHES);
}

/* ---- rows ---- */

static void wrong_letter(struct raster *raster, struct span span)
{
    const char *text = raster_mark(raster->arena, span);
    char c = span.source->text[span.start];
    if (c == 'k' || c == 'p') {
        diag_error(raster->diag, CODE_LOWER_CASE, span, "the small letter %s: stitches are K and P here", text);
        return;
    }
    diag_error(raster->diag, CODE_CHART_MARK, span, "%s stands for no stitch; stitches are K and P", text);
    if (!raster->width && isalpha((unsigned char)c))
        diag_hint(raster->diag, "a written pattern needs no import: try `weft check`");
}

/* False: no use to read on. */
static bool read_row(struct raster *raster, struct span line)
{
    const char *text = line.source->text;
    raster_row_follows(raster);
    for (size_t at = line.start; at < line.end; at++) {
        struct span mark = raster_character(line.source, at, line.end);
        if (lines_is_blank(text[at]))
            continue;
        if (text[at] != 'K' && text[at] != 'P') {
            wrong_letter(raster, mark);
            raster_give_up(raster);
            return true;
        }
        if (!raster_stitch(raster, text[at] == 'K' ? STITCH_K : STITCH_P, mark))
            return false;
    }
    raster_row(raster, line);
    return raster->rows <= LIMIT_ROWS;
}

struct pattern kp_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct pattern pattern = {.across = 1, .up = 1};
    struct raster raster = {.arena = arena, .diag = diag};
    struct lines lines = lines_of(source);
    struct span line, header = {0};
    bool going_on = true;

    for (bool first = true; going_on && lines_next(&lines, &line); first = false) {
        if (line.start == line.end) {
            raster_blank(&raster, line);
        } else if (source->text[line.start] != '#') {
            going_on = read_row(&raster, line);
        } else if (first) {
            header = line;
            read_header(diag, line, &pattern);
        } else {
            diag_error(diag, CODE_CHART_HEADER, line, "a header stands in the first line alone");
        }
    }
    pattern.grid = raster_grid(&raster, source, RASTER_BOTTOM_FIRST);
    if (pattern.grid)
        check_size(diag, header, &pattern);
    return pattern;
}
