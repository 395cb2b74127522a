/* SPDX-License-Identifier: GPL-3.0-or-later
 * Ctrl-C and termination: signals in, a clean stop out. */
#ifndef WEFT_INTERRUPT_H
#define WEFT_INTERRUPT_H

#include <stdbool.h>

/* From now on SIGINT, SIGTERM and SIGHUP remove unfinished output files before
 * they end the program.  Signals that are ignored stay so. */
void interrupt_install(void);

/* From now on the first signal only asks, for someone looks at
 * interrupt_asked; one that comes seconds later ends the program. */
void interrupt_ask_first(void);

bool interrupt_asked(void);

#endif
