/* SPDX-License-Identifier: GPL-3.0-or-later
 * The page to look at a swatch: growth steps in as they are reached, one
 * self-contained .html out.  The page itself is made in viewer/ and embedded
 * in the binary; here the swatch's data are put into it.
 *
 * The data are one JSON object in <script id="weft-data">: the report's words
 * for scene, energies, steps ("every": one in so many is there) and parameters;
 * the colours that pictures have ("palettes": of each stitch, "scales": from low to high, "colorings": fields
 * with their scale and its ends); and "blob", which holds, packed (page_pack.h),
 * the grid's stitches (a byte each) and then the fields that "fields" lists,
 * each over all steps between its own low and high: x, y, z at points, mean,
 * gauss, bending and stretching at cells. */
#ifndef WEFT_PAGE_H
#define WEFT_PAGE_H

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

struct page;

/* Was the page embedded in this binary? */
bool page_is_there(void);

/* Samples along a stitch's side that keep the page small: 1 to 6. */
int page_per_stitch(const struct scene *scene);

/* Begins a page; out of memory does not return.  Free with page_end. */
struct page *page_begin(const struct scene *scene);
void         page_end(struct page *page);

/* Up to PAGE_STEPS growth steps a page keeps all; of more every second, third,
 * ..., and the final one.  To be asked once a step: is this one to be added? */
enum { PAGE_STEPS = 50 };
int  page_nsteps(const struct page *page);      /* added so far */
bool page_wants(struct page *page, const struct fold_step *step);
void page_add(struct page *page, const struct fold_step *step, const struct surface *surface);

/* Writes the page of one step or more; record NULL: of a run that was stopped.
 * false: see log->error. */
bool page_write(const struct page *page, struct file_log *log, const char *path, const struct fold_record *record);

#endif
