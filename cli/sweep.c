/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft sweep`: a script with a sweep in; each of its points run by a process of
 * its own in a folder of its own, and one table of all, out. */
#include <config.h>

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/script.h"
#include "cli/sweep_table.h"

/* ---- the words of a point's own command ---- */

/* Is the word an option of the whole sweep alone (with its value in the next word: 2)? */
static int of_sweep_alone(const char *word)
{
    if (strcmp(word, "-j") == 0)
        return 2;
    return strncmp(word, "-j", 2) == 0 || strcmp(word, "--print") == 0;
}

/* weft sweep FILE ... --point NUMBER -j THREADS, ended by NULL. */
static const char **point_words(const struct options *o, int number, int threads, struct arena *arena)
{
    const char **words = arena_array(arena, const char *, (size_t)o->argc + 5);
    int n = 0;
    for (int i = 0; i < o->argc; i++) {
        int skipped = i > 0 ? of_sweep_alone(o->argv[i]) : 0;
        if (skipped == 0)
            words[n++] = o->argv[i];
        else
            i += skipped - 1;
    }
    words[n++] = "--point";
    words[n++] = arena_printf(arena, "%d", number);
    words[n++] = "-j";
    words[n++] = arena_printf(arena, "%d", threads);
    words[n] = NULL;
    return words;
}

/* A word as a shell reads it back. */
static void print_word(const char *word)
{
    if (*word && strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%@") == strlen(word)) {
        printf("%s", word);
        return;
    }
    putchar('\'');
    for (; *word; word++)
        printf(*word == '\'' ? "'\\''" : "%c", *word);
    putchar('\'');
}

static enum status print_commands(const struct sweep *sweep)
{
    for (int number = 1; number <= sweep->npoints; number++) {
        struct arena arena = {0};
        const char **word = point_words(sweep->options, number, 1, &arena);
        for (int i = 0; word[i]; i++) {
            printf("%s", i > 0 ? " " : "");
            print_word(word[i]);
        }
        printf("\n");
        arena_free(&arena);
    }
    return STATUS_DONE;
}

/* ---- many points ---- */

/* A point that is running. */
struct worker {
    pid_t process;      /* 0: none */
    int   number;
};

struct crew {
    const struct sweep *sweep;
    int                 nworkers, threads;
    int                 done;           /* points that are, before and now */
    struct worker      *worker;         /* (nworkers) */
};

/* In the child: the point's log for a terminal, then this program again. */
static _Noreturn void become(const struct sweep_point *point, const char **words, struct arena *arena)
{
    int log = open(arena_printf(arena, "%s/log.txt", point->folder), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (log >= 0) {
        dup2(log, STDOUT_FILENO);
        dup2(log, STDERR_FILENO);
        close(log);
        execv("/proc/self/exe", (char *const *)words);
        execvp(words[0], (char *const *)words);
    }
    _exit(STATUS_FILES);
}

static void start(struct crew *crew, struct worker *worker, int number)
{
    struct arena arena = {0};
    struct sweep_point point = sweep_point(crew->sweep, number, &arena);
    const char **words = point_words(crew->sweep->options, number, crew->threads, &arena);
    bool made = mkdir(point.folder, 0777) == 0 || errno == EEXIST;
    fflush(NULL);
    pid_t process = made ? fork() : -1;
    if (process == 0)
        become(&point, words, &arena);
    if (process < 0)
        fprintf(stderr, "weft: %s cannot be started: %s\n", point.folder, strerror(errno));
    *worker = (struct worker){process > 0 ? process : 0, number};
    arena_free(&arena);
}

static void say_end(const struct crew *crew, int number, int how)
{
    struct arena arena = {0};
    struct sweep_point point = sweep_point(crew->sweep, number, &arena);
    if (crew->sweep->options->quiet && how == 0)
        ;
    else if (WIFSIGNALED(how))
        fprintf(stderr, "[%d/%d] %s: killed by signal %d\n", crew->done, crew->sweep->npoints, point.name, WTERMSIG(how));
    else
        fprintf(stderr, "[%d/%d] %s: %s\n", crew->done, crew->sweep->npoints, point.name,
                WEXITSTATUS(how) == 0 ? "converged" : "not converged or failed, see its log.txt");
    arena_free(&arena);
}

/* Waits until one point ends; passes a wish to stop on to all of them. */
static void wait_for_one(struct crew *crew)
{
    static const struct timespec moment = {.tv_nsec = 5000000};
    bool told = false;
    pid_t process;
    int how;
    while ((process = waitpid(-1, &how, WNOHANG)) == 0) {
        for (int i = 0; interrupt_asked() && !told && i < crew->nworkers; i++)
            if (crew->worker[i].process)
                kill(crew->worker[i].process, SIGTERM);
        told = interrupt_asked();
        nanosleep(&moment, NULL);
    }
    for (int i = 0; i < crew->nworkers; i++)
        if (process > 0 && crew->worker[i].process == process) {
            crew->worker[i].process = 0;
            crew->done++;
            say_end(crew, crew->worker[i].number, how);
        }
}

static struct worker *idle_worker(struct crew *crew)
{
    for (int i = 0; i < crew->nworkers; i++)
        if (!crew->worker[i].process)
            return &crew->worker[i];
    return NULL;
}

static int busy_workers(const struct crew *crew)
{
    int busy = 0;
    for (int i = 0; i < crew->nworkers; i++)
        busy += crew->worker[i].process != 0;
    return busy;
}

/* Runs all points that are not done; returns how many were. */
static int run_points(struct crew *crew)
{
    int before = 0;
    for (int number = 1; number <= crew->sweep->npoints && !interrupt_asked(); number++) {
        if (sweep_point_is_done(crew->sweep, number)) {
            before++, crew->done++;
            continue;
        }
        while (!idle_worker(crew))
            wait_for_one(crew);
        start(crew, idle_worker(crew), number);
    }
    while (busy_workers(crew) > 0)
        wait_for_one(crew);
    return before;
}

/* ---- the table ---- */

static enum status collect(const struct sweep *sweep, const struct scene *scene)
{
    struct arena arena = {0};
    struct file_log log = {0};
    struct sweep_count count;
    const char **table = arena_array(&arena, const char *, (size_t)scene->noutputs + 1);
    int ntables = 0;
    for (int i = 0; i < scene->noutputs; i++)
        if (scene->output[i].kind == OUTPUT_TABLE)
            table[ntables++] = scene->output[i].path;
    bool written = sweep_table_write(sweep, table, ntables, &log, &count);
    if (!written)
        fprintf(stderr, "weft: %s\n", log.error);
    else if (!sweep->options->quiet)
        printf("%d points: %d converged, %d ended otherwise, %d missing\nwrote %s/table.csv, %s/table.jsonl\n",
               sweep->npoints, count.good, count.other, count.missing, sweep->folder, sweep->folder);
    file_log_free(&log);
    arena_free(&arena);
    return !written ? STATUS_FILES : count.good == sweep->npoints ? STATUS_DONE : STATUS_FAILED;
}

static enum status run_all(const struct sweep *sweep, const struct scene *scene)
{
    int processors = (int)sysconf(_SC_NPROCESSORS_ONLN), wanted = sweep->options->threads;
    struct crew crew = {.sweep = sweep, .nworkers = wanted ? wanted : processors > 0 ? processors : 1};
    crew.threads = processors > crew.nworkers ? processors / crew.nworkers : 1;
    crew.worker = calloc((size_t)crew.nworkers, sizeof *crew.worker);
    if (!crew.worker)
        return STATUS_FAILED;
    interrupt_ask_first();
    int before = run_points(&crew);
    if (before > 0 && !sweep->options->quiet)
        printf("%d of %d points were done before\n", before, sweep->npoints);
    free(crew.worker);
    return collect(sweep, scene);
}

/* ---- the command ---- */

/* --into DIR, or the script's name without its extension and ".sweep". */
static const char *sweep_folder(const struct options *options, const char *script, struct arena *arena)
{
    const char *slash = strrchr(script, '/'), *name = slash ? slash + 1 : script, *dot = strrchr(name, '.');
    if (options->into)
        return options->into;
    return arena_printf(arena, "%.*s.sweep", dot && dot > name ? (int)(dot - name) : (int)strlen(name), name);
}

static enum status run_sweep(const struct sweep *sweep, const struct scene *scene)
{
    const struct options *o = sweep->options;
    if (o->point > sweep->npoints)
        return options_wrong(o, "the sweep of %s has %d points, there is no point %d", sweep->script, sweep->npoints, o->point);
    if (o->print)
        return print_commands(sweep);
    if (mkdir(sweep->folder, 0777) != 0 && errno != EEXIST) {
        fprintf(stderr, "weft: the folder '%s' cannot be made: %s\n", sweep->folder, strerror(errno));
        return STATUS_FILES;
    }
    return o->collect ? collect(sweep, scene) : o->point ? sweep_point_run(sweep, o->point) : run_all(sweep, scene);
}

enum status command_sweep(const struct options *options)
{
    struct arena arena = {0};
    struct script script;
    const char *path = options->operand[0];
    if (strcmp(path, "-") == 0)
        return options_wrong(options, "a sweep reads its script once for each point: it cannot be standard input");
    enum status status = script_load(&script, path, options);
    if (status == STATUS_DONE && script.scene->naxes == 0) {
        fprintf(stderr, "weft: %s: there is no sweep in this script; one is `sweep NAME in 1..3`, NAME a param\n", path);
        status = STATUS_SCRIPT;
    }
    if (status == STATUS_DONE) {
        struct sweep sweep = {options, path, sweep_folder(options, path, &arena), script.scene->naxes, script.scene->axis, 1};
        for (int i = 0; i < sweep.naxes; i++)
            sweep.npoints *= sweep.axis[i].npoints;
        status = run_sweep(&sweep, script.scene);
    }
    script_free(&script);
    arena_free(&arena);
    return status;
}
