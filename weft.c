/* SPDX-License-Identifier: GPL-3.0-or-later
 * weft: a command line in, what the command does and its exit status out. */
#include <config.h>

#include <unistd.h>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/streams.h"
#include "cli/waiting.h"
#include "solver/fold.h"
#include "solver/memory.h"

int main(int argc, char **argv)
{
    struct options options;
    streams_open();
    interrupt_install();
    enum status status = options_parse(&options, argc, argv);
    if (status == STATUS_DONE && !options.help && (options.command->run == command_run || options.command->run == command_sweep)) {
        waiting_sleep(argv);
        status = memory_suffices(fold_threads(options.threads)) ? STATUS_DONE : STATUS_FAILED;
    }
    if (status == STATUS_DONE)
        status = options.help ? command_help(&options) : options.command->run(&options);
    options_free(&options);
    status = streams_close(status);
    /* OpenBLAS would wait for its threads here, which under a limit of memory ask for some without end. */
    _exit((int)status);
}
