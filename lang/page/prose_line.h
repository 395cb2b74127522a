/* SPDX-License-Identifier: GPL-3.0-or-later
 * What a line of text can be, by its words alone: each is read from a place of the text to the end of its line. */
#ifndef WEFT_PROSE_LINE_H
#define WEFT_PROSE_LINE_H

#include <stdbool.h>

const char *prose_line_next(const char *text);          /* the next line that is not empty */
bool prose_line_is_mistyped(const char *text);          /* `Casst on 22`, `swach tile(..)` */
bool prose_line_is_keyword(const char *text);           /* `let`, `swatch`, .. and no sentence that begins so */
bool prose_line_is_heading(const char *text);           /* `Ribbing` alone above a row, `Section B` */
bool prose_line_is_copyright(const char *text);         /* `(c) 2011`, `Copyright ..` */
bool prose_line_is_abbreviation(const char *text);      /* `CO  cast on` */
bool prose_line_is_explained(const char *text);         /* `YF = yarn forward` */
bool prose_line_is_rule(const char *text);              /* `- * -`: no letter and no figure */
bool prose_line_is_idle(const char *text);              /* `(16 + 4 = 20)`, `Stem`: no word of work, on a page */

#endif
