/* SPDX-License-Identifier: GPL-3.0-or-later
 * The pixels of a PNG file in, the pattern they show out. */
#include "charts/picture.h"

#include <png.h>
#include <string.h>
#include <strings.h>

#include "lang/limits.h"

enum { BLACK = 0x000000, WHITE = 0xFFFFFF, SIGNATURE = 8, KEYS = 256 };

static const struct colour black_and_white[] = {{BLACK, STITCH_K}, {WHITE, STITCH_P}};
const struct colour_key picture_black_and_white = {2, black_and_white};

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

/* A picture has no lines to point at. */
static const struct span nowhere = {0};

static bool check_size(struct diag *diag, const struct source *source, const png_image *image)
{
    if (image->height > LIMIT_ROWS)
        diag_error(diag, CODE_LIMIT_ROWS, nowhere, "%s: the picture is %u pixels high; a fabric may have %d rows",
                   source->name, image->height, LIMIT_ROWS);
    else if (image->width > LIMIT_STITCHES / image->height)
        diag_error(diag, CODE_LIMIT_STITCHES, nowhere, "%s: the picture is %u x %u pixels; a fabric may have %d stitches",
                   source->name, image->width, image->height, LIMIT_STITCHES);
    return !diag->nerrors;
}

/* The pixels, four bytes each: red, green, blue, opacity; the top row first. NULL after an error. */
static const unsigned char *read_pixels(struct arena *arena, struct diag *diag, const struct source *source,
                                        png_image *image)
{
    const unsigned char *pixel = NULL;
    if (png_image_begin_read_from_memory(image, source->text, source->size)) {
        image->format = PNG_FORMAT_RGBA;
        if (check_size(diag, source, image)) {
            unsigned char *room = arena_array(arena, unsigned char, PNG_IMAGE_SIZE(*image));
            pixel = png_image_finish_read(image, NULL, room, 0, NULL) ? room : NULL;
        }
    }
    if (!pixel && !diag->nerrors)
        diag_error(diag, CODE_PICTURE, nowhere, "%s: this picture cannot be read: %s", source->name, image->message);
    png_image_free(image);
    return pixel;
}

/* The first pixel the key does not know, and how many more there are. */
static void unknown_colour(struct diag *diag, const struct source *source, const unsigned char *p, size_t at,
                           unsigned width, long long more)
{
    unsigned x = (unsigned)(at % width), y = (unsigned)(at / width), colour = p[0] * 0x10000u + p[1] * 0x100u + p[2];
    if (p[3] < 255)
        diag_error(diag, CODE_COLOUR, nowhere, "%s: the pixel at x = %u, y = %u is transparent", source->name, x, y);
    else
        diag_error(diag, CODE_COLOUR, nowhere, "%s: the pixel at x = %u, y = %u is #%06x, which the key does not have",
                   source->name, x, y, colour);
    diag_note(diag, nowhere, "x counts from 0 at the left, y from 0 at the top%s",
              more ? arena_printf(diag->arena, "; %lld more pixels are not in the key", more) : "");
    diag_hint(diag, "`--key '#000000=k,#ffffff=p'` says what the colours mean");
}

struct pattern picture_read(struct arena *arena, struct diag *diag, const struct source *source,
                            const struct colour_key *key)
{
    struct pattern pattern = {NULL, 1, 1};
    png_image image = {.version = PNG_IMAGE_VERSION};
    const unsigned char *pixel = read_pixels(arena, diag, source, &image);
    if (!pixel)
        return pattern;

    stitch_id *cell;
    const struct grid *grid = grid_new(arena, (int)image.width, (int)image.height, &cell);
    size_t n = (size_t)image.width * image.height, first = n;
    long long unknown = 0;
    for (size_t i = 0; i < n; i++) {
        const unsigned char *p = pixel + 4 * i;
        int stitch = p[3] < 255 ? -1 : stitch_of(key, p[0] * 0x10000u + p[1] * 0x100u + p[2]);
        first = stitch < 0 && first == n ? i : first;
        unknown += stitch < 0;
        cell[i] = (stitch_id)(stitch < 0 ? STITCH_K : stitch);
    }
    if (unknown)
        unknown_colour(diag, source, pixel + 4 * first, first, image.width, unknown - 1);
    else
        pattern.grid = grid_flip(arena, grid);
    return pattern;
}
