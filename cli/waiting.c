/* SPDX-License-Identifier: GPL-3.0-or-later
 * The program's arguments in; the same program with sleeping threads out. */
#include <config.h>

#include "cli/waiting.h"

#include <stdlib.h>
#include <unistd.h>

void waiting_sleep(char **argv)
{
    static const char policy[] = "OMP_WAIT_POLICY";
    if (getenv(policy) || setenv(policy, "passive", 1) != 0)
        return;
    setenv("OPENBLAS_NUM_THREADS", "1", 0);     /* it starts threads that nothing uses */
    char path[4096];    /* the name itself, so that the process keeps it */
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
    if (length <= 0)
        return;
    path[length] = 0;
    execv(path, argv);
}
