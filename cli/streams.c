/* SPDX-License-Identifier: GPL-3.0-or-later
 * The standard streams: open before anything else is, and checked at the end. */
#include <config.h>

#include "cli/streams.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/options.h"

void streams_open(void)
{
    signal(SIGPIPE, SIG_IGN);   /* a write that fails says so itself, */
    signal(SIGXFSZ, SIG_IGN);   /* as does one beyond the size a file may have */
    /* A stream that was closed becomes one on which every use fails. */
    for (int fd = 0; fd <= 2; fd++)
        if (fcntl(fd, F_GETFD) < 0)
            (void)!open("/dev/null", fd == 0 ? O_WRONLY : O_RDONLY);
}

int streams_close(int status)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout))
        return status;
    if (errno && errno != EPIPE)
        fprintf(stderr, "weft: cannot write to standard output: %s\n", strerror(errno));
    return status == STATUS_DONE ? STATUS_FILES : status;
}
