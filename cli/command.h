/* SPDX-License-Identifier: GPL-3.0-or-later
 * The table of subcommands: a name in, its function out. */
#ifndef WEFT_COMMAND_H
#define WEFT_COMMAND_H

#include "cli/options.h"

struct command {
    const char *name;
    const char *operands;               /* as the help shows them */
    int         least, most;            /* how many operands it takes */
    enum status (*run)(const struct options *options);
    const char *summary;                /* one line */
    const char *about;                  /* paragraphs for `weft help NAME` */
};

extern const struct command command_table[];    /* ends with name = NULL; the first is what `weft FILE` means */

const struct command *command_find(const char *name);

enum status command_run(const struct options *options);
enum status command_sweep(const struct options *options);
enum status command_check(const struct options *options);
enum status command_chart(const struct options *options);
enum status command_write(const struct options *options);
enum status command_fmt(const struct options *options);
enum status command_import(const struct options *options);
enum status command_params(const struct options *options);
enum status command_list(const struct options *options);
enum status command_version(const struct options *options);
enum status command_help(const struct options *options);

#endif
