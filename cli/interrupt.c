/* SPDX-License-Identifier: GPL-3.0-or-later
 * Ctrl-C and termination: signals in, a clean stop out. */
#include <config.h>

#include "cli/interrupt.h"

#include <signal.h>
#include <stddef.h>
#include <time.h>

#include "output/file.h"

/* All that a signal handler may know. */
static volatile sig_atomic_t ask_first;
static _Atomic time_t asked;            /* when, in seconds; 0: not yet */

enum { PATIENCE = 2 };                  /* seconds in which signals count as one: some programs send each twice */

static void handle(int number)
{
    time_t now = time(NULL);
    if (ask_first && !asked)
        asked = now;
    if (ask_first && now - asked < PATIENCE)
        return;
    file_remove_unfinished();
    signal(number, SIG_DFL);
    raise(number);
}

void interrupt_install(void)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = handle, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        struct sigaction before;
        if (sigaction(signals[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(signals[i], &action, NULL);
    }
}

void interrupt_ask_first(void)
{
    ask_first = 1;
}

bool interrupt_asked(void)
{
    return asked;
}
