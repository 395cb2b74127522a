/* SPDX-License-Identifier: GPL-3.0-or-later
 * Colours by name: pairs for knit and purl, and scales for numbers. */
#ifndef WEFT_COLOURS_H
#define WEFT_COLOURS_H

struct rgb { double red, green, blue; };        /* sRGB, each in [0, 1] */

/* The colours of a drawing of stitches. */
enum { PALETTE_OTHERS = 6 };

struct palette {
    const char *name;
    struct rgb  knit, purl;
    struct rgb  other[PALETTE_OTHERS];          /* of own stitches, in turn */
};

/* "paper": knit red, purl blue, as the paper prints them; "safe": the pair
 * keeps apart in lightness and hue for every kind of colour vision, and on a
 * grey printer.  NULL: there is none of that name. */
const struct palette *colours_palette(const char *name);

/* 0 .. 255, rounded. */
void colours_bytes(struct rgb, unsigned char bytes[3]);

/* The colour of a stitch: 0 is knit, 1 is purl, own stitches follow. */
struct rgb colours_stitch(const struct palette *palette, int stitch);

/* The colour of the i-th line of a plot on white; they repeat after six. */
struct rgb colours_line(int i);

/* Scales: sequential from dark (low) to light, diverging from blue (low) over
 * light grey (the middle) to red.  Equal steps of t look equally far apart:
 * t is the length along a line in Oklab (Björn Ottosson, "A perceptual color
 * space for image processing", 2020). */
enum colours_scale { COLOURS_SEQUENTIAL, COLOURS_DIVERGING };

/* The colour at t in [0, 1]; what lies outside has the end's colour. */
struct rgb colours_at(enum colours_scale scale, double t);

#endif
