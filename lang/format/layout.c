/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lines of a formatted text: words in, lines under each other out. */
#include "lang/format/layout.h"

#include <stdarg.h>
#include <string.h>

enum { LAYOUT_WIDTH = 100, GOES_ON = 4 };       /* columns of a line; what a broken one is indented by */

/* Row texts stand under each other unless one's head is longer by more than this. */
enum { HEADS_DIFFER = 16 };

struct piece {
    char  *bytes;
    size_t length, room;
};

struct line {
    int              indent;
    bool             gap;           /* an empty line before it */
    bool             whole;         /* it is not broken */
    enum layout_kind kind;
    size_t           column;        /* the byte before which blanks go; 0: the line only goes with its neighbours */
    int              pad[2];        /* blanks before the column, before the comment */
    struct piece     text, comment;
};

struct layout {
    struct arena *arena;
    int           n, room;
    struct line  *line;
};

struct layout *layout_new(struct arena *arena)
{
    struct layout *layout = arena_new(arena, struct layout);

    layout->arena = arena;
    return layout;
}

int layout_characters(const char *text, size_t length)
{
    int n = 0;

    for (size_t i = 0; i < length; i++)
        n += ((unsigned char)text[i] & 0xC0) != 0x80;
    return n;
}

/* ---- filling lines ---- */

static void append(struct arena *arena, struct piece *piece, const char *text, size_t length)
{
    if (piece->length + length + 1 > piece->room) {
        size_t room = 2 * (piece->length + length) + 64;
        char *larger = arena_alloc(arena, room);

        if (piece->length)
            memcpy(larger, piece->bytes, piece->length);
        piece->bytes = larger;
        piece->room = room;
    }
    if (length)
        memcpy(piece->bytes + piece->length, text, length);
    piece->length += length;
    piece->bytes[piece->length] = '\0';
}

static struct line *last(const struct layout *layout)
{
    return &layout->line[layout->n - 1];
}

void layout_line(struct layout *layout, int indent, bool gap)
{
    if (layout->n == layout->room)
        layout->line = arena_larger(layout->arena, layout->line, &layout->room, sizeof *layout->line);
    layout->line[layout->n++] = (struct line){.indent = indent, .gap = gap};
}

void layout_add(struct layout *layout, const char *text, size_t length)
{
    append(layout->arena, &last(layout)->text, text, length);
}

void layout_print(struct layout *layout, const char *format, ...)
{
    va_list arguments;
    const char *text;

    va_start(arguments, format);
    text = arena_vprintf(layout->arena, format, arguments);
    va_end(arguments);
    layout_add(layout, text, strlen(text));
}

void layout_column(struct layout *layout, enum layout_kind kind)
{
    struct line *line = last(layout);

    if (!line->kind)
        line->column = line->text.length;
    line->kind = kind;
}

void layout_whole(struct layout *layout)
{
    last(layout)->whole = true;
}

void layout_comment(struct layout *layout, const char *text, size_t length)
{
    append(layout->arena, &last(layout)->comment, text, length);
}

int layout_width(const struct layout *layout)
{
    const struct line *line = last(layout);

    return line->indent + (line->text.length ? layout_characters(line->text.bytes, line->text.length) : 0);
}

bool layout_empty(const struct layout *layout)
{
    return layout->n == 0;
}

/* ---- columns ---- */

static int head_width(const struct line *line)
{
    return layout_characters(line->text.bytes, line->column);
}

static int whole_width(const struct line *line)
{
    return line->indent + layout_characters(line->text.bytes, line->text.length) + line->pad[0];
}

/* Rows outside of motifs stay as a knitter writes them. */
static bool has_column(const struct line *a, const struct line *b)
{
    return a->kind && a->kind == b->kind && a->indent == b->indent && (a->kind != LAYOUT_ROW || a->indent > 0);
}

static bool has_comment(const struct line *a, const struct line *b)
{
    return a->comment.length && b->comment.length;
}

/* Pads the lines first .. end-1 to the widest of them; heads of rows that
 * differ too much are left as they are. */
static void pad_run(struct line *first, struct line *end, int which, int (*width)(const struct line *))
{
    int most = 0, least = 1 << 30;

    for (struct line *line = first; line < end; line++) {
        if (which == 0 && !line->column)
            continue;
        most = width(line) > most ? width(line) : most;
        least = width(line) < least ? width(line) : least;
    }
    if (which == 0 && first->kind == LAYOUT_ROW && most - least > HEADS_DIFFER)
        return;
    for (struct line *line = first; line < end; line++)
        line->pad[which] = which == 0 && !line->column ? 0 : most - width(line);
}

/* Runs of neighbouring lines, without an empty one between, that go together. */
static void pad_runs(struct layout *layout, int which, bool (*together)(const struct line *, const struct line *),
                     int (*width)(const struct line *))
{
    struct line *end = layout->line + layout->n;

    for (struct line *first = layout->line, *next; first < end; first = next) {
        for (next = first + 1; next < end && !next->gap && together(first, next); next++)
            ;
        if (together(first, first))
            pad_run(first, next, which, width);
    }
}

/* ---- the text ---- */

static void blanks(struct arena *arena, struct piece *all, int n)
{
    for (; n > 0; n--)
        append(arena, all, " ", 1);
}

/* Fills lines up to their width, breaking where the text may be. */
static void write_filled(struct arena *arena, struct piece *all, const char *text, int column, int indent, bool whole)
{
    for (size_t length; *text; text += length) {
        int width;

        length = strcspn(text + 1, "\n") + 1;
        width = layout_characters(text, length);
        if (*text == '\n' && column + width > LAYOUT_WIDTH && !whole) {
            append(arena, all, "\n", 1);
            blanks(arena, all, indent);
            column = indent - 1;
        } else if (*text == '\n') {
            blanks(arena, all, 1);
        } else {
            append(arena, all, text, 1);
        }
        append(arena, all, text + 1, length - 1);
        column += width;
    }
}

static void write_line(struct arena *arena, struct piece *all, const struct line *line)
{
    const struct piece *text = &line->text;

    if (line->gap)
        append(arena, all, "\n", 1);
    blanks(arena, all, line->indent);
    append(arena, all, text->bytes, line->column);
    blanks(arena, all, line->pad[0]);
    if (text->length)
        write_filled(arena, all, text->bytes + line->column,
                     line->indent + line->pad[0] + layout_characters(text->bytes, line->column),
                     line->indent + GOES_ON, line->whole);
    if (line->comment.length) {
        blanks(arena, all, line->pad[1] + 2);
        append(arena, all, line->comment.bytes, line->comment.length);
    }
    append(arena, all, "\n", 1);
}

char *layout_text(struct layout *layout, size_t *length)
{
    struct piece all = {0};

    pad_runs(layout, 0, has_column, head_width);
    pad_runs(layout, 1, has_comment, whole_width);
    append(layout->arena, &all, "", 0);
    for (int i = 0; i < layout->n; i++)
        write_line(layout->arena, &all, &layout->line[i]);
    *length = all.length;
    return all.bytes;
}
