/* SPDX-License-Identifier: GPL-3.0-or-later
 * The pixels of a PNG file in, the pattern they show out; and the other way round. */
#include "charts/picture.h"

#include <png.h>
#include <string.h>
#include <strings.h>

#include "lang/limits.h"

enum { BLACK = 0x000000, WHITE = 0xFFFFFF, SIGNATURE = 8, KEYS = 256 };

static const struct colour ink_and_paper[] = {{BLACK, STITCH_K}, {WHITE, STITCH_P}};
static const struct colour_key black_and_white = {2, ink_and_paper};

/* ---- the key ---- */

/* The colour a text begins with, which moves behind it. */
static bool read_colour(const char **text, unsigned *colour)
{
    static const struct {
        const char *word;
        unsigned    colour;
    } words[] = {{"black", BLACK}, {"white", WHITE}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strncasecmp(*text, words[i].word, strlen(words[i].word)) == 0) {
            *colour = words[i].colour;
            *text += strlen(words[i].word);
            return true;
        }
    if (**text != '#' || strspn(*text + 1, "0123456789abcdefABCDEF") != 6)
        return false;
    *colour = 0;
    for (const char *digit = *text + 1; digit < *text + 7; digit++)
        *colour = 16 * *colour + (unsigned)(*digit <= '9' ? *digit - '0' : (*digit | 0x20) - 'a' + 10);
    *text += 7;
    return true;
}

/* The key's stitch for a colour; -1: it has none. */
static int stitch_of(const struct colour_key *key, unsigned colour)
{
    for (int i = 0; i < key->n; i++)
        if (key->colour[i].rgb == colour)
            return key->colour[i].stitch;
    return -1;
}

/* `#000000=k`, and what follows: a comma or the end. */
static const char *read_entry(struct arena *arena, const struct colour_key *key, struct colour *entry, const char **text)
{
    const char *start = *text;
    if (!read_colour(text, &entry->rgb))
        return arena_printf(arena, "'%s' begins with no colour; one is #rrggbb, black or white", start);
    if (**text != '=' || !(*text)[1] || !strchr("kKpP", (*text)[1]) || ((*text)[2] && (*text)[2] != ','))
        return arena_printf(arena, "behind the colour of '%s' must stand =k or =p", start);
    if (key->n == KEYS)
        return arena_printf(arena, "a key may have %d colours", KEYS);
    if (stitch_of(key, entry->rgb) >= 0)
        return arena_printf(arena, "the colour #%06x has a meaning already", entry->rgb);
    entry->stitch = strchr("kK", (*text)[1]) ? STITCH_K : STITCH_P;
    *text += 2;
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

static bool check_size(struct diag *diag, const struct source *source, const png_image *image)
{
    struct span span = whole(diag->arena, source);
    if (image->height > LIMIT_ROWS)
        diag_error(diag, CODE_LIMIT_ROWS, span, "the picture is %u pixels high; a fabric may have %d rows", image->height,
                   LIMIT_ROWS);
    else if (image->width > LIMIT_STITCHES / image->height)
        diag_error(diag, CODE_LIMIT_STITCHES, span, "the picture is %u x %u pixels; a fabric may have %d stitches",
                   image->width, image->height, LIMIT_STITCHES);
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

/* The pixels, four bytes each: red, green, blue, opacity; the top row first. NULL after an error. */
static const unsigned char *read_pixels(struct arena *arena, struct diag *diag, const struct source *source,
                                        png_image *image)
{
    const unsigned char *pixel = NULL;
    if (!picture_is_png(source))
        diag_error(diag, CODE_PICTURE, whole(arena, source), "this is no PNG picture");
    else if (!chunks_are_there(source))
        diag_error(diag, CODE_PICTURE, whole(arena, source), "this picture cannot be read: it ends too early");
    else if (png_image_begin_read_from_memory(image, source->text, source->size)) {
        image->format = PNG_FORMAT_RGBA;
        image->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;      /* where the file does not say otherwise, as with 8 bits */
        if (check_size(diag, source, image)) {
            unsigned char *room = arena_array(arena, unsigned char, PNG_IMAGE_SIZE(*image));
            pixel = png_image_finish_read(image, NULL, room, 0, NULL) ? room : NULL;
        }
    }
    if (!pixel && !diag->nerrors)
        diag_error(diag, CODE_PICTURE, whole(arena, source), "this picture cannot be read: %s", image->message);
    png_image_free(image);
    return pixel;
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

/* The first pixel the key does not know, and how many more there are. */
static void unknown_colour(struct diag *diag, struct span span, const unsigned char *p, size_t at, size_t columns,
                           long long more)
{
    size_t x = at % columns, y = at / columns;
    unsigned rgb = p[0] * 0x10000u + p[1] * 0x100u + p[2];
    if (p[3] < 255)
        diag_error(diag, CODE_COLOUR, span, "the pixel at x = %zu, y = %zu is transparent", x, y);
    else
        diag_error(diag, CODE_COLOUR, span, "the pixel at x = %zu, y = %zu is #%06x, which the key does not have", x, y, rgb);
    diag_note(diag, (struct span){0}, "x counts from 0 at the left, y from 0 at the top%s",
              more ? arena_printf(diag->arena, "; %lld more pixels are not in the key", more) : "");
    if (p[3] < 255)
        diag_hint(diag, "fill what is transparent with a colour");
    else
        diag_hint(diag, "`weft import` says what colours mean: `--key '#%06x=k,#ffffff=p'`", rgb);
}

struct pattern picture_read(struct arena *arena, struct diag *diag, const struct source *source,
                            const struct colour_key *key)
{
    struct pattern pattern = {.across = 1, .up = 1};
    png_image image = {.version = PNG_IMAGE_VERSION};
    const unsigned char *pixel = read_pixels(arena, diag, source, &image);
    if (!pixel)
        return pattern;

    stitch_id *cell;
    const struct grid *picture = grid_new(arena, (int)image.width, (int)image.height, &cell);
    size_t n = (size_t)image.width * image.height, first = n;
    for (size_t i = 0; i < n; i++) {
        cell[i] = stitch_at(key ? key : &black_and_white, pixel + 4 * i);
        first = cell[i] == UNKNOWN && first == n ? i : first;
    }
    if (first < n)
        unknown_colour(diag, pixel_span(arena, source->name, picture, first), pixel + 4 * first, first, image.width,
                       grid_count(picture, UNKNOWN) - 1);
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
