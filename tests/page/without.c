/* SPDX-License-Identifier: GPL-3.0-or-later
 * No page, as where npm is missing: in the place of viewer/embedded.c. */
#include <stddef.h>

extern const char *const page_template[];
const char *const page_template[] = {NULL};
