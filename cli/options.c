/* SPDX-License-Identifier: GPL-3.0-or-later
 * The command line: argv in, a command with its operands and options out. */
#include <config.h>

#include "cli/options.h"

#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/import.h"
#include "lang/limits.h"
#include "lang/names.h"

enum { THREADS_MAX = 1024, SEEDS_MAX = 1000, POINTS_MAX = LIMIT_POINTS };

/* ---- messages ---- */

enum status options_wrong(const struct options *options, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "weft: ");
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\nTry `weft help%s%s`.\n", options->command ? " " : "", options->command ? options->command->name : "");
    va_end(arguments);
    return STATUS_USAGE;
}

/* ---- what an option does with its value ---- */

static bool take_override(struct options *o, const struct option *option, const char *value)
{
    o->set[o->nsets++] = (struct compile_override){option->key, value};
    return true;
}

static bool take_define(struct options *o, const struct option *option, const char *value)
{
    (void)option;
    const char *equals = strchr(value, '=');
    if (!equals || equals == value) {
        options_wrong(o, "-D takes name=value, not '%s'", value);
        return false;
    }
    const char *name = arena_copy(&o->arena, value, (size_t)(equals - value));
    o->define[o->ndefines++] = (struct compile_override){name, equals + 1};
    return true;
}

static bool take_include(struct options *o, const struct option *option, const char *value)
{
    (void)option;
    o->include[o->nincludes++] = value;
    return true;
}

bool options_names_kind(const char *path)
{
    size_t length = strspn(path, "abcdefghijklmnopqrstuvwxyz");
    return length > 0 && path[length] == ':';
}

static bool take_output(struct options *o, const struct option *option, const char *value)
{
    (void)option;
    o->output[o->noutputs++] = value;
    return true;
}

/* A number of things from 1 to most; 0 after saying what is wrong. */
static int count_of(const struct options *o, const struct option *option, const char *value, const char *things, int most)
{
    char *end;
    long n = strtol(value, &end, 10);
    if (end != value && !*end && n >= 1 && n <= most)
        return (int)n;
    options_wrong(o, "%s takes a number of %s from 1 to %d, not '%s'", option->name ? option->name : option->letter,
                  things, most, value);
    return 0;
}

static bool take_threads(struct options *o, const struct option *option, const char *value)
{
    o->threads = count_of(o, option, value, "threads", THREADS_MAX);
    return o->threads > 0;
}

static bool take_seeds(struct options *o, const struct option *option, const char *value)
{
    o->seeds = count_of(o, option, value, "seeds", SEEDS_MAX);
    return o->seeds > 0;
}

static bool take_point(struct options *o, const struct option *option, const char *value)
{
    int point = count_of(o, option, value, "a point", POINTS_MAX);
    *(int *)((char *)o + option->place) = point;
    return point > 0;
}

static bool take_flag(struct options *o, const struct option *option, const char *value)
{
    (void)value;
    *(bool *)((char *)o + option->place) = true;
    return true;
}

static bool take_text(struct options *o, const struct option *option, const char *value)
{
    *(const char **)((char *)o + option->place) = value;
    return true;
}

/* Is word one of the words of a list separated by blanks? */
static bool in_list(const char *list, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = list; length && (at = strstr(at, word)); at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || !at[length]))
            return true;
    return false;
}

static bool take_word(struct options *o, const struct option *option, const char *value)
{
    if (!in_list(option->key, value)) {
        options_wrong(o, "%s takes one of: %s; not '%s'", option->name ? option->name : option->letter, option->key, value);
        return false;
    }
    *(const char **)((char *)o + option->place) = value;
    return true;
}

/* ---- the table ---- */

#define SCRIPT "run sweep check chart write params"
#define RUN "run sweep"
#define READER SCRIPT " fmt import"

const struct option option_table[] = {
    {"-o", NULL, "[KIND:]PATH", "run sweep chart write import", take_output, NULL, 0, "a file to write (may be repeated)"},
    {"-D", NULL, "NAME=VALUE", "run sweep check chart write", take_define, NULL, 0, "set a param of the script"},
    {"-I", NULL, "DIR", SCRIPT, take_include, NULL, 0, "look for used files here, too (and in $WEFT_PATH)"},
    {NULL, "--accuracy", "PERCENT", RUN, take_override, "solve.accuracy", 0, "wanted error of the energy, like 1%"},
    {NULL, "--method", "NAME", RUN, take_override, "solve.method", 0, "auto, newton, plbfgs or lbfgs"},
    {NULL, "--discretisation", "NAME", RUN, take_override, "mesh.discretisation", 0, "patch or triangle"},
    {NULL, "--per-stitch", "N", RUN, take_override, "mesh.per_stitch", 0, "cells along a stitch's side: auto, 1, 2, 4"},
    {NULL, "--steps", "N", RUN, take_override, "solve.steps", 0, "growth steps"},
    {NULL, "--seed", "N", RUN, take_override, "solve.seed", 0, "seed of the starting noise"},
    {NULL, "--seeds", "N", RUN, take_seeds, NULL, 0, "fold from N seeds, list all, keep the lowest"},
    {"-j", NULL, "N", RUN, take_threads, NULL, 0, "threads, or points at a time (default: all)"},
    {NULL, "--dry-run", NULL, "run", take_flag, NULL, offsetof(struct options, dry_run), "say what would be done, and stop"},
    {NULL, "--no-manifest", NULL, RUN, take_flag, NULL, offsetof(struct options, no_manifest), "no .manifest.json beside what is written"},
    {NULL, "--resume", NULL, "run", take_flag, NULL, offsetof(struct options, resume), "go on where a run was stopped or killed"},
    {NULL, "--cached", NULL, "run", take_flag, NULL, offsetof(struct options, cached), "fold nothing if all is as the last run left it"},
    {NULL, "--start", "STATE", "run", take_text, NULL, offsetof(struct options, start), "begin at the state of another fold, do not grow"},
    {NULL, "--from", "MANIFEST", "run", take_text, NULL, offsetof(struct options, from), "repeat that run, compare what it wrote"},
    {NULL, "--into", "DIR", RUN, take_text, NULL, offsetof(struct options, into), "where --from or a sweep writes"},
    {NULL, "--print", NULL, "sweep", take_flag, NULL, offsetof(struct options, print), "a command for each point, run nothing"},
    {NULL, "--point", "K", "sweep", take_point, NULL, offsetof(struct options, point), "run point K alone, the first is 1"},
    {NULL, "--warm", NULL, "sweep", take_flag, NULL, offsetof(struct options, warm), "begin at neighbours where ends of a row agree"},
    {NULL, "--walk", "A", "sweep", take_point, NULL, offsetof(struct options, walk), "--point of a --warm row that began at A"},
    {NULL, "--collect", NULL, "sweep", take_flag, NULL, offsetof(struct options, collect), "make the table of the points there are"},
    {NULL, "--grid", NULL, "chart", take_flag, NULL, offsetof(struct options, grid), "names of stitches, bottom row first"},
    {NULL, "--key", "COLOURS", "import", take_text, NULL, offsetof(struct options, key), "what they mean: '#000000=k,#ffffff=p'"},
    {NULL, "--round", NULL, "write", take_flag, NULL, offsetof(struct options, round), "worked in the round"},
    {NULL, "--check", NULL, "fmt", take_flag, NULL, offsetof(struct options, check), "change nothing, name the files not formatted"},
    {NULL, "--json", NULL, "params version", take_flag, NULL, offsetof(struct options, json), "as JSON"},
    {"-W", NULL, "error", SCRIPT, take_word, "error", offsetof(struct options, warnings), "treat warnings as errors"},
    {"-q", "--quiet", NULL, READER, take_flag, NULL, offsetof(struct options, quiet), "print errors alone"},
    {"-v", "--verbose", NULL, RUN, take_flag, NULL, offsetof(struct options, verbose), "say more about the solve"},
    {NULL, "--color", "WHEN", READER, take_word, "auto always never", offsetof(struct options, color), "auto, always or never (and $NO_COLOR)"},
    {NULL, "--diagnostics", "FORM", READER, take_word, "human json", offsetof(struct options, diagnostics), "errors in a script: human or json"},
    {"-h", "--help", NULL, NULL, take_flag, NULL, offsetof(struct options, help), "explain the command"},
    {NULL, "--version", NULL, NULL, take_flag, NULL, offsetof(struct options, version), "print the version"},
    {0},
};

bool options_belong(const struct option *option, const struct command *command)
{
    return !option->commands || in_list(option->commands, command->name);
}

/* ---- parsing ---- */

/* The option called by the first length characters of word, or NULL. */
static const struct option *find_option(const char *word, size_t length)
{
    for (const struct option *o = option_table; o->help; o++) {
        const char *names[] = {o->letter, o->name};
        for (int i = 0; i < 2; i++)
            if (names[i] && strlen(names[i]) == length && memcmp(names[i], word, length) == 0)
                return o;
    }
    return NULL;
}

static enum status unknown_option(const struct options *options, const char *word, size_t length)
{
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)length, word);
    struct nearest nearest = nearest_to(name);
    for (const struct option *o = option_table; o->help; o++)
        if (o->name)
            nearest_offer(&nearest, o->name);
    if (length > 2 && nearest.best)
        return options_wrong(options, "unknown option '%s'; did you mean %s?", name, nearest.best);
    return options_wrong(options, "unknown option '%s'", name);
}

/* What is being parsed: where in argv, and which options were seen. */
struct parse {
    int                    argc, at;
    char                 **argv;
    const struct option  **seen;        /* (nseen) */
    int                    nseen;
};

/* Gives an option its value: the rest of its word, or the next word. */
static enum status take(struct options *options, struct parse *parse, const struct option *option, const char *rest)
{
    const char *called = option->name ? option->name : option->letter;
    if (option->argument && !rest) {
        if (parse->at + 1 == parse->argc)
            return options_wrong(options, "%s wants a value: %s %s", called, called, option->argument);
        rest = parse->argv[++parse->at];
    } else if (!option->argument && rest) {
        return options_wrong(options, "%s takes no value", called);
    }
    parse->seen[parse->nseen++] = option;
    return option->take(options, option, rest) ? STATUS_DONE : STATUS_USAGE;
}

/* --name, --name=value */
static enum status parse_long(struct options *options, struct parse *parse, const char *word)
{
    const char *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const struct option *option = find_option(word, length);
    return option ? take(options, parse, option, equals ? equals + 1 : NULL) : unknown_option(options, word, length);
}

/* -q, -qv, -j4, -o path */
static enum status parse_letters(struct options *options, struct parse *parse, const char *word)
{
    enum status status = STATUS_DONE;
    for (const char *letter = word + 1; *letter && status == STATUS_DONE; letter++) {
        const char name[2] = {'-', *letter};
        const struct option *option = find_option(name, 2);
        if (!option)
            return unknown_option(options, name, 2);
        if (option->argument)
            return take(options, parse, option, letter[1] ? letter + 1 : NULL);
        status = take(options, parse, option, NULL);
    }
    return status;
}

static enum status parse_words(struct options *options, struct parse *parse)
{
    bool only_operands = false;
    enum status status = STATUS_DONE;
    for (parse->at = 1; parse->at < parse->argc && status == STATUS_DONE; parse->at++) {
        const char *word = parse->argv[parse->at];
        if (only_operands || word[0] != '-' || !word[1])
            options->operand[options->noperands++] = word;
        else if (strcmp(word, "--") == 0)
            only_operands = true;
        else if (word[1] == '-')
            status = parse_long(options, parse, word);
        else
            status = parse_letters(options, parse, word);
    }
    return status;
}

/* ---- the command ---- */

/* A first operand that is neither a command nor a file: which is it meant to be? */
static enum status unknown_command(const struct options *options, const char *word)
{
    struct nearest nearest = nearest_to(word);
    struct arena arena = {0};
    const char *file = source_nearest(&arena, word);
    for (const struct command *c = command_table; c->name; c++)
        nearest_offer(&nearest, c->name);
    bool is_file = file && !(nearest.best && nearest.distance <= 1);
    enum status status = is_file || nearest.best ? options_wrong(options, "there is no command or file '%s'; did you mean %s?", word,
                                                                 is_file ? file : nearest.best)
                                                 : options_wrong(options, "there is no command or file '%s'", word);
    arena_free(&arena);
    return status;
}

/* Does the word look like a command rather than a file that is missing? */
static bool looks_like_command(const char *word)
{
    return strcmp(word, "-") != 0 && !strpbrk(word, "./") && access(word, F_OK) != 0;
}

/* Takes the command off the operands; `weft FILE` is `weft run FILE`. */
static enum status find_command(struct options *options)
{
    if (options->version || (options->noperands == 0 && options->help)) {
        options->command = command_find(options->version ? "version" : "help");
        return STATUS_DONE;
    }
    if (options->noperands == 0 && options->from) {
        options->command = &command_table[0];
        return STATUS_DONE;
    }
    if (options->noperands == 0)
        return options_wrong(options, "nothing to do: a FILE or a COMMAND is wanted");
    const struct command *named = command_find(options->operand[0]);
    if (!named && looks_like_command(options->operand[0]))
        return unknown_command(options, options->operand[0]);
    options->command = named ? named : &command_table[0];
    if (named) {
        options->operand++;
        options->noperands--;
    }
    return STATUS_DONE;
}

/* A repeated run is as it was: what could change it is refused rather than passed over. */
static enum status check_from(const struct options *options, const struct parse *parse)
{
    static const char *const with[] = {"-j", "--from", "--into", "--quiet", "--verbose", "--color", "--diagnostics"};
    for (int i = 0; i < parse->nseen; i++) {
        const char *called = parse->seen[i]->name ? parse->seen[i]->name : parse->seen[i]->letter;
        bool fits = false;
        for (size_t k = 0; k < sizeof with / sizeof *with; k++)
            fits = fits || strcmp(with[k], called) == 0;
        if (!fits)
            return options_wrong(options, "--from repeats a run as it was: %s does not go with it", called);
    }
    return STATUS_DONE;
}

/* Do operands and options fit the command? */
static enum status check_command(const struct options *options, const struct parse *parse)
{
    const struct command *command = options->command;
    for (int i = 0; i < parse->nseen; i++) {
        const struct option *o = parse->seen[i];
        if (!options_belong(o, command))
            return options_wrong(options, "%s has no option %s (it belongs to: %s)", command->name,
                                 o->name ? o->name : o->letter, o->commands);
    }
    if (options->help)
        return STATUS_DONE;
    if (options->from && check_from(options, parse) != STATUS_DONE)
        return STATUS_USAGE;
    if (options->into && !options->from && command->run != command_sweep)
        return options_wrong(options, "--into goes with --from");
    if (options->cached && options->no_manifest)
        return options_wrong(options, "--cached goes by the manifest: --no-manifest does not go with it");
    if (options->start && (options->resume || options->seeds > 1))
        return options_wrong(options, "--start begins where another fold ended: %s does not go with it",
                             options->resume ? "--resume" : "--seeds");
    if (options->noperands < command->least && !options->from)
        return options_wrong(options, "%s wants a FILE", command->name);
    if (options->noperands > command->most)
        return options_wrong(options, "%s takes no further operand '%s'", command->name, options->operand[command->most]);
    return STATUS_DONE;
}

/* ---- the whole ---- */

/* Room for as many of each as argv can hold: every option of one letter or more. */
static void make_room(struct options *options, struct parse *parse)
{
    size_t n = 1;
    for (int i = 1; i < parse->argc; i++)
        n += strlen(parse->argv[i]) + 1;
    options->operand = arena_array(&options->arena, const char *, n);
    options->define = arena_array(&options->arena, struct compile_override, n);
    options->set = arena_array(&options->arena, struct compile_override, n);
    options->include = arena_array(&options->arena, const char *, n);
    options->output = arena_array(&options->arena, const char *, n);
    parse->seen = arena_array(&options->arena, const struct option *, n);
}

enum status options_parse(struct options *options, int argc, char **argv)
{
    struct parse parse = {.argc = argc, .argv = argv};
    *options = (struct options){.color = "auto", .diagnostics = "human", .argc = argc, .argv = argv};
    make_room(options, &parse);
    enum status status = parse_words(options, &parse);
    if (status == STATUS_DONE)
        status = find_command(options);
    if (status == STATUS_DONE)
        status = check_command(options, &parse);
    return status;
}

void options_free(struct options *options)
{
    arena_free(&options->arena);
}

struct compile_options options_compile(const struct options *o)
{
    return (struct compile_options){
        .define = o->define,   .ndefines = o->ndefines,
        .set = o->set,         .nsets = o->nsets,
        .include = o->include, .nincludes = o->nincludes,
        .output = o->output,   .noutputs = o->noutputs,
        .warnings_are_errors = o->warnings,
        .chart = import_chart,
    };
}

bool options_colored(const struct options *options)
{
    const char *no = getenv("NO_COLOR"), *terminal = getenv("TERM");
    if (strcmp(options->color, "auto") != 0)
        return strcmp(options->color, "always") == 0;
    return !(no && *no) && isatty(STDERR_FILENO) && terminal && strcmp(terminal, "dumb") != 0;
}
