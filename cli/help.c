/* SPDX-License-Identifier: GPL-3.0-or-later
 * Help: the tables of commands and options in, text of 80 columns out. */
#include <config.h>

#include <stdio.h>

#include "cli/command.h"
#include "lang/names.h"

static void print_option(const struct option *o)
{
    char left[40];
    snprintf(left, sizeof left, "%s%s%s%s%s", o->letter ? o->letter : "   ", o->letter && o->name ? ", " : o->name ? " " : "",
             o->name ? o->name : "", o->argument ? " " : "", o->argument ? o->argument : "");
    printf("  %-27s %s\n", left, o->help);
}

static void print_overview(void)
{
    printf("weft computes how a knitted fabric folds.\n\nUsage: weft [COMMAND] FILE [OPTION]...\n\nCommands:\n");
    for (const struct command *c = command_table; c->name; c++)
        printf("  %-8s %-10s %s\n", c->name, c->operands, c->summary);
    printf("\nFILE may be - for standard input. Options of a command: weft help COMMAND.\n"
           "\nExit status: 0 done; 1 the run failed or did not converge; 2 wrong usage;\n"
           "3 an error in a script; 4 a file could not be read or written.\n");
}

static void print_command(const struct command *command)
{
    printf("Usage: weft %s%s%s [OPTION]...\n\n%s\nOptions:\n", command->name, *command->operands ? " " : "", command->operands, command->about);
    for (const struct option *o = option_table; o->help; o++)
        if (options_belong(o, command))
            print_option(o);
}

static enum status unknown_command(const struct options *options, const char *name)
{
    struct nearest nearest = nearest_to(name);
    for (const struct command *c = command_table; c->name; c++)
        nearest_offer(&nearest, c->name);
    return nearest.best ? options_wrong(options, "there is no command '%s'; did you mean %s?", name, nearest.best)
                        : options_wrong(options, "there is no command '%s'", name);
}

enum status command_help(const struct options *options)
{
    /* `weft help run` and `weft run --help` are the same question. */
    const char *name = options->command->run != command_help ? options->command->name
                     : options->noperands > 0                ? options->operand[0]
                                                             : NULL;
    const struct command *command = name ? command_find(name) : NULL;
    if (name && !command)
        return unknown_command(options, name);
    if (command)
        print_command(command);
    else
        print_overview();
    return STATUS_DONE;
}
