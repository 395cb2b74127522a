/* SPDX-License-Identifier: GPL-3.0-or-later
 * The standard streams: open before anything else is, and checked at the end. */
#ifndef WEFT_STREAMS_H
#define WEFT_STREAMS_H

/* Makes sure that descriptors 0, 1 and 2 are taken (no output file may get one
 * of them) and that a closed pipe is an error to handle, not the end. */
void streams_open(void);

/* Flushes standard output.  Returns status, or STATUS_FILES where all went well
 * until now but the results could not be printed. */
int streams_close(int status);

#endif
