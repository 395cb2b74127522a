/* SPDX-License-Identifier: GPL-3.0-or-later
 * Text without a font: letters as strokes of a round pen, the same on every
 * machine. */
#ifndef WEFT_LETTERING_H
#define WEFT_LETTERING_H

#include <stdbool.h>

#include <cairo.h>

enum lettering_align { LETTERING_LEFT, LETTERING_CENTRE, LETTERING_RIGHT };

/* Height of capitals and digits, depth of descenders and the distance of lines,
 * over the size. */
#define LETTERING_CAPITAL 0.7
#define LETTERING_DEPTH   0.25
#define LETTERING_LINE    1.3

/* Length of a line of text (UTF-8: ASCII, letters with accents and what else lettering.c's tables have; a
 * box stands for the rest), in the size's unit. */
double lettering_width(const char *text, double size);

/* Whether all characters have letters of their own, no box among them. */
bool lettering_knows(const char *text);

/* Draws a line of text in cairo's present colour: its left end, middle or right
 * end at x, its baseline at y.  Line width and path are left as they were found
 * and empty. */
void lettering_draw(cairo_t *cairo, double x, double y, double size, enum lettering_align align, const char *text);

#endif
