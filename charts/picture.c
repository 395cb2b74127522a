/* SPDX-License-Identifier: GPL-3.0-or-later
 * The pixels of a PNG file in, the pattern they show out; and the other way round. */
#include "charts/picture.h"

#include <png.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "lang/limits.h"

enum { BLACK = 0x000000, WHITE = 0xFFFFFF, SIGNATURE = 8, KEYS = 256 };

static const struct colour ink_and_paper[] = {{BLACK, STITCH_K}, {WHITE, STITCH_P}};
static const struct colour_key black_and_white = {2, ink_and_paper};

/* ---- the key ---- */

/* `#rrggbb`, or `#rgb` for short. */
static bool read_digits(const char **text, unsigned *colour)
{
    size_t n = **text == '#' ? strspn(*text + 1, "0123456789abcdefABCDEF") : 0;
    if (n != 3 && n != 6)
        return false;
    *colour = 0;
    for (const char *digit = *text + 1; digit <= *text + n; digit++) {
        unsigned value = (unsigned)(*digit <= '9' ? *digit - '0' : (*digit | 0x20) - 'a' + 10);
        *colour = n == 3 ? *colour << 8 | value << 4 | value : *colour << 4 | value;
    }
    *text += 1 + n;
    return true;
}

/* Which of the words a text begins with, and its value; the text moves behind it. */
struct word {
    const char *word;
    unsigned    value;
};

static bool read_word(const struct word *word, const char **text, unsigned *value)
{
    while (word->word && strncasecmp(*text, word->word, strlen(word->word)) != 0)
        word++;
    *value = word->value;
    *text += word->word ? strlen(word->word) : 0;
    return word->word != NULL;
}

/* The key's stitch for a colour; -1: it has none. */
static int stitch_of(const struct colour_key *key, unsigned colour)
{
    for (int i = 0; i < key->n; i++)
        if (key->colour[i].rgb == colour)
            return key->colour[i].stitch;
    return -1;
}

static const char *skip_blanks(const char *text)
{
    return text + strspn(text, " \t");
}

/* `#000000=k`, and what follows: a comma or the end. */
static const char *read_entry(struct arena *arena, const struct colour_key *key, struct colour *entry, const char **text)
{
    static const struct word colours[] = {{"black", BLACK}, {"white", WHITE}, {NULL, 0}};
    static const struct word stitches[] = {
        {"knit", STITCH_K}, {"k", STITCH_K}, {"purl", STITCH_P}, {"p", STITCH_P}, {NULL, 0}};
    const char *start = *text = skip_blanks(*text), *end;
    unsigned stitch;
    if (!read_word(colours, text, &entry->rgb) && !read_digits(text, &entry->rgb))
        return arena_printf(arena, "'%s' begins with no colour; one is #rrggbb, black or white", start);
    end = *text + 1;
    if (**text != '=' || !read_word(stitches, &end, &stitch) || (*(end = skip_blanks(end)) && *end != ','))
        return arena_printf(arena, "behind the colour of '%s' must stand =k or =p", start);
    if (key->n == KEYS)
        return arena_printf(arena, "a key may have %d colours", KEYS);
    if (stitch_of(key, entry->rgb) >= 0)
        return arena_printf(arena, "the colour #%06x has a meaning already", entry->rgb);
    entry->stitch = (stitch_id)stitch;
    *text = end;
    return NULL;
}

const struct colour_key *picture_key(struct arena *arena, const char *text, const char **why)
{
    struct colour_key *key = arena_new(arena, struct colour_key);
    struct colour *colour = arena_array(arena, struct colour, KEYS + 1);
    key->colour = colour;
    for (;; text++) {
        *why = read_entry(arena, key, &colour[key->n], &text);
        if (*why)
            return NULL;
        key->n++;
        if (!*text)
            return key;
    }
}

/* ---- the picture ---- */

bool picture_is_png(const struct source *source)
{
    return source->size >= SIGNATURE && memcmp(source->text, "\x89PNG\r\n\x1A\n", SIGNATURE) == 0;
}

/* The picture's name stands for it where there is no pixel to point at. */
static struct span whole(struct arena *arena, const struct source *source)
{
    struct source *picture = arena_new(arena, struct source);
    *picture = (struct source){.name = source->name, .text = ""};
    return (struct span){picture, 0, 0};
}

static bool check_size(struct diag *diag, const struct source *source, unsigned width, unsigned height)
{
    struct span span = whole(diag->arena, source);
    if (height > LIMIT_ROWS)
        diag_error(diag, CODE_LIMIT_ROWS, span, "the picture is %u pixels high; a fabric may have %d rows", height, LIMIT_ROWS);
    else if (width > LIMIT_STITCHES / height)
        diag_error(diag, CODE_LIMIT_STITCHES, span, "the picture is %u x %u pixels; a fabric may have %d stitches", width,
                   height, LIMIT_STITCHES);
    return !diag->nerrors;
}

/* Does every chunk (length, name, data, checksum) end within the file?  libpng makes room for what a length says
 * before it looks for the data. */
static bool chunks_are_there(const struct source *source)
{
    enum { AROUND = 12 };
    const unsigned char *byte = (const unsigned char *)source->text;
    size_t at = SIGNATURE;
    while (at + AROUND <= source->size) {
        size_t length = (size_t)byte[at] << 24 | (size_t)byte[at + 1] << 16 | (size_t)byte[at + 2] << 8 | byte[at + 3];
        if (length > source->size - at - AROUND)
            return false;
        if (memcmp(byte + at + 4, "IEND", 4) == 0)
            return true;
        at += length + AROUND;
    }
    return false;
}

/* A file being read: what libpng has had of it, what it says is wrong, and what comes out. */
struct reader {
    const struct source *source;
    size_t               at;
    char                 why[80];
    struct pixels {
        unsigned             width, height;
        const unsigned char *rgba;      /* four bytes each, red, green, blue, opacity; the top row first */
    } pixels;
};

static void take(png_structp png, png_bytep to, size_t n)
{
    struct reader *reader = png_get_io_ptr(png);
    if (n > reader->source->size - reader->at)
        png_error(png, "it ends too early");
    memcpy(to, reader->source->text + reader->at, n);
    reader->at += n;
}

static void give_up(png_structp png, const char *why)
{
    struct reader *reader = png_get_error_ptr(png);
    snprintf(reader->why, sizeof reader->why, "%s", why);
    png_longjmp(png, 1);
}

static void keep_quiet(png_structp png, const char *warning)
{
    (void)png, (void)warning;
}

/* Whatever the file has, as red, green, blue and opacity of eight bits: the file's own values, as a painting program
 * shows them.  libpng's simplified reading would bring all to one colour space, and mixes the rows of interlaced
 * pictures of 16 bits. */
static void ask_for_rgba(png_structp png, png_infop info)
{
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

/* From the signature to the last row; libpng leaves by setjmp where something is wrong. */
static void read_file(png_structp png, png_infop info, struct arena *arena, struct diag *diag, struct reader *reader)
{
    struct pixels *pixels = &reader->pixels;
    if (setjmp(png_jmpbuf(png)))
        return;
    png_set_read_fn(png, reader, take);
    png_read_info(png, info);
    pixels->width = png_get_image_width(png, info);
    pixels->height = png_get_image_height(png, info);
    if (!check_size(diag, reader->source, pixels->width, pixels->height))
        return;
    ask_for_rgba(png, info);
    unsigned char *rgba = arena_array(arena, unsigned char, (size_t)4 * pixels->width * pixels->height);
    unsigned char **row = arena_array(arena, unsigned char *, pixels->height);
    for (size_t y = 0; y < pixels->height; y++)
        row[y] = rgba + 4 * y * pixels->width;
    png_read_image(png, row);
    pixels->rgba = rgba;
}

/* The pixels of a file; none after an error. */
static struct pixels read_pixels(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct reader *reader = arena_new(arena, struct reader);
    *reader = (struct reader){.source = source, .why = "there is no memory left"};
    if (!picture_is_png(source))
        diag_error(diag, CODE_PICTURE, whole(arena, source), "this is no PNG picture");
    else if (!chunks_are_there(source))
        diag_error(diag, CODE_PICTURE, whole(arena, source), "this picture cannot be read: it ends too early");
    else {
        png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, reader, give_up, keep_quiet);
        png_infop info = png ? png_create_info_struct(png) : NULL;
        if (info)
            read_file(png, info, arena, diag, reader);
        png_destroy_read_struct(&png, &info, NULL);
    }
    if (!reader->pixels.rgba && !diag->nerrors)
        diag_error(diag, CODE_PICTURE, whole(arena, source), "this picture cannot be read: %s", reader->why);
    return reader->pixels;
}

/* ---- its stitches ---- */

enum { UNKNOWN = STITCH_MAX };

static stitch_id stitch_at(const struct colour_key *key, const unsigned char *p)
{
    int stitch = p[3] < 255 ? -1 : stitch_of(key, p[0] * 0x10000u + p[1] * 0x100u + p[2]);
    return (stitch_id)(stitch < 0 ? UNKNOWN : stitch);
}

/* A pixel as a place in the picture's chart, a line of letters for each of its
 * rows: so a message has a line and a column, and shows what is around. */
static struct span pixel_span(struct arena *arena, const char *name, const struct grid *picture, size_t at)
{
    size_t columns = (size_t)picture->columns, row = at / columns, first = row * columns;
    char *text = arena_array(arena, char, row + columns + 1);
    memset(text, '\n', row);
    for (size_t i = 0; i < columns; i++) {
        stitch_id stitch = picture->cell[first + i];
        text[row + i] = stitch == STITCH_K ? 'k' : stitch == STITCH_P ? 'p' : '?';
    }
    struct source *source = arena_new(arena, struct source);
    *source = (struct source){.name = name, .text = text, .size = row + columns};
    unsigned start = (unsigned)(row + at % columns);
    return (struct span){source, start, start + 1};
}

static unsigned rgb_at(const struct pixels *pixels, size_t at)
{
    const unsigned char *p = pixels->rgba + 4 * at;
    return p[0] * 0x10000u + p[1] * 0x100u + p[2];
}

/* How many colours a picture has, and the first but `one`, else white. */
static int count_colours(struct arena *arena, const struct pixels *pixels, unsigned one, unsigned *other)
{
    enum { ALL = 1 << 24 };
    unsigned char *seen = arena_array(arena, unsigned char, ALL / 8);
    int n = 0;
    bool found = false;
    *other = one == WHITE ? BLACK : WHITE;
    for (size_t at = 0; at < (size_t)pixels->width * pixels->height; at++) {
        unsigned rgb = rgb_at(pixels, at), bit = 1u << rgb % 8;
        if (seen[rgb / 8] & bit)
            continue;
        seen[rgb / 8] |= (unsigned char)bit;
        n++;
        if (rgb != one && !found)
            *other = rgb;
        found |= rgb != one;
    }
    return n;
}

/* What to do about a colour without a meaning: a key with this picture's colours, or another picture. */
static void hint_at_key(struct diag *diag, const struct pixels *pixels, size_t at, bool has_key)
{
    enum { MANY = 16 };
    unsigned other, rgb = rgb_at(pixels, at);
    int ncolours = count_colours(diag->arena, pixels, rgb, &other);
    if (ncolours > MANY)
        diag_hint(diag, "a chart has a pixel for each stitch and a colour for each kind of stitch; this picture has %d colours",
                  ncolours);
    else if (has_key)
        diag_hint(diag, "add it to the key: `#%06x=k` or `#%06x=p`", rgb, rgb);
    else
        diag_hint(diag, "`weft import` says what colours mean: `--key '#%06x=k,#%06x=p'`", rgb, other);
}

/* The first pixel the key does not know, and how many more there are. */
static void unknown_colour(struct diag *diag, struct span span, const struct pixels *pixels, size_t at, long long more,
                           bool has_key)
{
    size_t x = at % pixels->width, y = at / pixels->width;
    bool clear = pixels->rgba[4 * at + 3] < 255;
    if (clear)
        diag_error(diag, CODE_COLOUR, span, "the pixel at x = %zu, y = %zu is transparent", x, y);
    else
        diag_error(diag, CODE_COLOUR, span, "the pixel at x = %zu, y = %zu is #%06x, which the key does not have", x, y,
                   rgb_at(pixels, at));
    diag_note(diag, (struct span){0}, "x counts from 0 at the left, y from 0 at the top%s",
              more ? arena_printf(diag->arena, "; %lld more pixels are not in the key", more) : "");
    if (clear)
        diag_hint(diag, "fill what is transparent with a colour");
    else
        hint_at_key(diag, pixels, at, has_key);
}

struct pattern picture_read(struct arena *arena, struct diag *diag, const struct source *source,
                            const struct colour_key *key)
{
    struct pattern pattern = {.across = 1, .up = 1};
    struct pixels pixels = read_pixels(arena, diag, source);
    if (!pixels.rgba)
        return pattern;

    stitch_id *cell;
    const struct grid *picture = grid_new(arena, (int)pixels.width, (int)pixels.height, &cell);
    size_t n = (size_t)pixels.width * pixels.height, first = n;
    for (size_t i = 0; i < n; i++) {
        cell[i] = stitch_at(key ? key : &black_and_white, pixels.rgba + 4 * i);
        first = cell[i] == UNKNOWN && first == n ? i : first;
    }
    if (first < n)
        unknown_colour(diag, pixel_span(arena, source->name, picture, first), &pixels, first,
                       grid_count(picture, UNKNOWN) - 1, key != NULL);
    else
        pattern.grid = grid_flip(arena, picture);
    pattern.remark = key ? NULL : "black is taken as knit, white as purl";
    return pattern;
}

/* ---- writing ---- */

void picture_write(struct text *text, const struct grid *g)
{
    static const unsigned char map[] = {0, 255};
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (unsigned)g->columns,
                       .height = (unsigned)g->rows,
                       .format = PNG_FORMAT_GRAY | PNG_FORMAT_FLAG_COLORMAP,
                       .colormap_entries = 2};

    /* The table of colours is black and white, a stitch its own index; a negative stride starts at the top row. */
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    unsigned char *png = arena_array(text->arena, unsigned char, size);
    if (png_image_write_to_memory(&image, png, &size, 0, g->cell, -g->columns, map))
        text_bytes(text, (const char *)png, size);
    png_image_free(&image);
}
