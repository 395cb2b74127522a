/* SPDX-License-Identifier: GPL-3.0-or-later
 * The table of subcommands: a name in, its function out. */
#include "cli/command.h"

#include <string.h>

enum { ANY_NUMBER = 1 << 30 };

const struct command command_table[] = {
    {"run", "FILE", 1, 1, command_run, "fold a swatch and write what the file and -o ask for",
     "Compiles FILE, folds its swatch and writes its outputs and those of -o. The\n"
     "kind of an output follows from its extension, or is named: KIND:PATH. An\n"
     "existing file is replaced only by a complete one. Ctrl-C stops the run and\n"
     "keeps the growth steps that are complete. `weft FILE` is the same.\n"
     "A manifest beside the outputs says how they were made; with --from such a\n"
     "manifest the run is repeated elsewhere and its outputs are compared. --resume\n"
     "goes on with a run that was stopped or killed. --cached goes by the manifest,\n"
     "too: it skips a run whose script, options and outputs are as they were.\n"},
    {"sweep", "FILE", 1, 1, command_sweep, "run every point of a script's sweep",
     "Runs FILE once for each point of its `sweep`, several at a time, each in a\n"
     "folder of its own below FILE.sweep (or --into DIR), and writes a table of all\n"
     "as table.csv and table.jsonl there, and the script's own tables and plots. A\n"
     "point that fails is recorded and the rest go on. Called again it runs only what\n"
     "is not done: a point is done when it came to an end with the same fabric,\n"
     "params, settings and outputs.\n"
     "With --warm, points along the last param begin at their neighbours where the\n"
     "folds from flat at both ends of a row agree with that, and no step snaps.\n"
     "On many machines: --print lists independent commands, one for each point, as\n"
     "GNU parallel wants them; in an array of jobs each runs --point K; --collect\n"
     "then makes the table.\n"},
    {"check", "FILE...", 1, ANY_NUMBER, command_check, "check scripts, fold nothing",
     "Compiles each FILE, reports every error at its place and prints the size of\n"
     "the swatch.\n"},
    {"chart", "FILE", 1, 1, command_chart, "print the stitch chart (--grid: plain rows of letters)",
     "Prints the right side of the fabric, top row first, with the row numbers at the\n"
     "right of right-side rows and rounds, at the left of wrong-side rows. With\n"
     "--grid: for programs, after a header \"# 1 1\" a line of stitch names for each\n"
     "row, the bottom row first; -o x.txt writes this form to a file. Others are:\n"
     "  x.csv         a table for spreadsheets: a cell with k or p for each stitch,\n"
     "                the top row first\n"
     "  x.k           knitout 2, for a knitting machine with two beds\n"
     "  x.svg         a drawing with numbers, repeat and key; or x.pdf, x.png\n"
     "  pixels:x.png  a pixel for each stitch, knit black and purl white\n"},
    {"write", "FILE", 1, 1, command_write, "print written instructions",
     "Prints the swatch of FILE as written rows, from the cast-on to the last row:\n"
     "runs of a stitch and repeats folded, equal rows named together. Rows go back\n"
     "and forth; with --round they are rounds. The text is a script: it can be\n"
     "compiled again and gives the same fabric. -o writes it to a file.\n"},
    {"fmt", "FILE...", 1, ANY_NUMBER, command_fmt, "lay scripts out evenly",
     "Rewrites each FILE in the canonical layout: the same fabric and settings, with\n"
     "its comments, evenly spelled, indented and aligned. Formatting again changes\n"
     "nothing. A file that is formatted is not touched; one with an error is left\n"
     "alone, and so is one that would read otherwise in another layout, with a word\n"
     "about it. With - the script is read from standard input and printed. With\n"
     "--check nothing is written: files that would change are named, and the exit\n"
     "status is then 1.\n"},
    {"import", "PATH", 1, 1, command_import, "make a script of a chart from elsewhere",
     "Reads the chart in PATH and prints a script with the same stitches; -o writes\n"
     "it to a file. What PATH is follows from its extension:\n"
     "  .csv      a line for each row, the top row first, with a cell for each\n"
     "            stitch: k, knit or 1 is knit, p, purl or 0 is purl, or without any k\n"
     "            and p - or a dot is purl, nothing knit; commas, semicolons or tabs\n"
     "            between them (also .tsv); numbers around the stitches are left out\n"
     "  .png      a pixel for each stitch, the top row first; black is knit, white is\n"
     "            purl, unless --key says what the colours mean\n"
     "  .k        knitout: plain knit and purl with one yarn; a stitch of the front\n"
     "            bed is knit, one of the back bed purl\n"
     "  .ks       written rows, as a knitter would read them; they stay as they are,\n"
     "            behind a cast-on where they have none. Known in any file by a line\n"
     "            that begins with Row 1, Rnd 1, 1st row, Cast on .. or the like\n"
     "  others    a line of the letters K and P for each row, the bottom row first,\n"
     "            blanks between them or not. Above them may stand \"# 4 2\": repeat\n"
     "            this four times up and two times across.\n"},
    {"params", "FILE", 1, 1, command_params, "list the parameters a script can be given",
     "Prints each param of FILE with its value, range and text: what -D can set.\n"},
    {"list", "[NAME]", 0, 1, command_list, "list the built-in motifs",
     "Prints the motifs that `use ... from std` knows: the multiple of stitches and\n"
     "the rows they repeat over, and what they are. With NAME: one, and its chart.\n"},
    {"version", "", 0, 0, command_version, "print the version", "Prints the version of weft and of its report's schema.\n"},
    {"help", "[COMMAND]", 0, 1, command_help, "explain weft or one of its commands", "Prints this.\n"},
    {0},
};

const struct command *command_find(const char *name)
{
    for (const struct command *c = command_table; c->name; c++)
        if (strcmp(c->name, name) == 0)
            return c;
    return NULL;
}
