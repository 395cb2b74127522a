/* SPDX-License-Identifier: GPL-3.0-or-later
 * Random scripts: a seed in, a program in wild spellings and layout out. */
#ifndef WEFT_TEST_PROGRAM_H
#define WEFT_TEST_PROGRAM_H

#include <stddef.h>

enum { PROGRAM_MOST = 1 << 16 };

/* Writes the program of a seed, NUL-terminated, into text (PROGRAM_MOST); most compile. */
size_t program_write(unsigned seed, char *text);

#endif
