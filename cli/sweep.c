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
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/script.h"
#include "cli/sweep_plan.h"
#include "cli/sweep_plot.h"
#include "cli/sweep_table.h"
#include "lang/names.h"

/* ---- the words of a point's own command ---- */

/* Is the word an option of the whole sweep alone (with its value in the next word: 2)? */
static int of_sweep_alone(const char *word)
{
    if (strcmp(word, "-j") == 0)
        return 2;
    return strncmp(word, "-j", 2) == 0 || strcmp(word, "--print") == 0;
}

/* weft sweep FILE ... --point NUMBER [--walk FROM] -j THREADS, ended by NULL; operands may follow "--". */
static const char **point_words(const struct options *o, int number, int from, int threads, struct arena *arena)
{
    const char *own[] = {"--point", arena_printf(arena, "%d", number), "-j", arena_printf(arena, "%d", threads),
                         "--walk", arena_printf(arena, "%d", from)};
    enum { OWN = sizeof own / sizeof *own };
    int nown = from > 0 ? OWN : OWN - 2;
    const char **words = arena_array(arena, const char *, (size_t)o->argc + OWN + 1);
    int n = 0, i = 0;
    for (; i < o->argc && strcmp(o->argv[i], "--") != 0; i++) {
        int skipped = i > 0 ? of_sweep_alone(o->argv[i]) : 0;
        if (skipped == 0)
            words[n++] = o->argv[i];
        else
            i += skipped - 1;
    }
    for (int k = 0; k < nown; k++)
        words[n++] = own[k];
    for (; i < o->argc; i++)
        words[n++] = o->argv[i];
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
        const char **word = point_words(sweep->options, number, 0, 1, &arena);
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
    pid_t              process;     /* 0: none */
    struct sweep_fold *fold;
};

struct crew {
    const struct sweep *sweep;
    int                 nworkers, threads;
    struct worker      *worker;         /* (nworkers) */
    struct sweep_plan   plan;
    int                 before;         /* points that are done */
    bool                stuck;          /* files cannot be written: no more points */
    bool                told;           /* those that run are to stop */
    struct progress     progress;
};

/* In the child: the point's log for a terminal, then this program again.  It
 * is to stop, too, where the whole sweep is killed. */
static _Noreturn void become(int log, const char **words)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    close(log);
    execv("/proc/self/exe", (char *const *)words);
    execvp(words[0], (char *const *)words);
    _exit(STATUS_FILES);
}

/* The point's folder and in it the log; -1: errno. */
static int open_log(const struct sweep_point *point, struct arena *arena)
{
    if (!file_make_folder(point->folder))
        return -1;
    return open(arena_printf(arena, "%s/log.txt", point->folder), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

static void start(struct crew *crew, struct worker *worker, struct sweep_fold *fold)
{
    struct arena arena = {0};
    struct sweep_point point = sweep_point(crew->sweep, fold->number, fold->from, &arena);
    const char **words = point_words(crew->sweep->options, fold->number, fold->from, crew->threads, &arena);
    int log = open_log(&point, &arena);
    fflush(NULL);
    pid_t process = log >= 0 ? fork() : -1;
    if (process == 0)
        become(log, words);
    if (process < 0) {
        progress_end(&crew->progress);
        fprintf(stderr, "weft: the point %s cannot be started: %s\n", point.folder, strerror(errno));
        crew->stuck = true;
    }
    if (log >= 0)
        close(log);
    *worker = (struct worker){process > 0 ? process : 0, fold};
    arena_free(&arena);
}

/* What an exit status says of a point. */
static const char *const endings[] = {
    [STATUS_DONE] = "converged",
    [STATUS_FAILED] = "not converged, or failed: see its log.txt",
    [STATUS_USAGE] = "the script does not take this value: see its log.txt",
    [STATUS_SCRIPT] = "an error in the script: see its log.txt",
    [STATUS_FILES] = "a file could not be read or written: see its log.txt",
};
enum { NENDINGS = sizeof endings / sizeof *endings };

static void say_end(struct crew *crew, const struct sweep_fold *fold, int how)
{
    struct arena arena = {0};
    struct sweep_point point = sweep_point(crew->sweep, fold->number, fold->from, &arena);
    int status = WIFEXITED(how) ? WEXITSTATUS(how) : -1;
    const char *ending = status >= 0 && status < NENDINGS ? endings[status]
                         : arena_printf(&arena, "killed by signal %d", WTERMSIG(how));
    bool stopped = status == STATUS_FAILED && interrupt_asked(), tried = status == STATUS_FAILED && fold->from > 0;
    progress_point(&crew->progress,
                   arena_printf(&arena, "[%d/%d] %s: %s", crew->before + crew->progress.done + 1,
                                crew->before + crew->progress.nsteps, point.name, stopped ? "stopped" : tried ? "no minimum from there; folds from flat" : ending),
                   status != STATUS_DONE && !stopped && !tried);
    crew->stuck = crew->stuck || status == STATUS_FILES;
    arena_free(&arena);
}

static int busy_workers(const struct crew *crew)
{
    int busy = 0;
    for (int i = 0; i < crew->nworkers; i++)
        busy += crew->worker[i].process != 0;
    return busy;
}

static void tell_all(const struct crew *crew, int number)
{
    for (int i = 0; i < crew->nworkers; i++)
        if (crew->worker[i].process)
            kill(crew->worker[i].process, number);
}

/* Folds that are to be run, as far as is known: one at least for each point that is not done. */
static int folds_known(const struct crew *crew)
{
    int points = crew->sweep->npoints - crew->before;
    return crew->plan.nwanted > points ? crew->plan.nwanted : points;
}

/* Waits until one point ends; passes a wish to stop on to all of them. */
static void wait_for_one(struct crew *crew)
{
    static const struct timespec moment = {.tv_nsec = 100000000};
    sigset_t ended;
    pid_t process;
    int how;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    while ((process = waitpid(-1, &how, WNOHANG)) == 0) {
        if (interrupt_asked() && !crew->told)
            tell_all(crew, SIGTERM);
        crew->told = interrupt_asked();
        progress_points(&crew->progress, busy_workers(crew));
        sigtimedwait(&ended, NULL, &moment);
    }
    for (int i = 0; i < crew->nworkers; i++)
        if (process > 0 && crew->worker[i].process == process) {
            crew->worker[i].process = 0;
            say_end(crew, crew->worker[i].fold, how);
            sweep_plan_look(&crew->plan, crew->worker[i].fold->number);
            crew->progress.nsteps = folds_known(crew);
        }
}

static struct worker *idle_worker(struct crew *crew)
{
    for (int i = 0; i < crew->nworkers; i++)
        if (!crew->worker[i].process)
            return &crew->worker[i];
    return NULL;
}

static void run_points(struct crew *crew)
{
    sigset_t ended, before;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    sigprocmask(SIG_BLOCK, &ended, &before);
    crew->progress = progress_begin(folds_known(crew), crew->sweep->options->quiet);
    do {
        struct worker *worker;
        struct sweep_fold *fold;
        while (!interrupt_asked() && !crew->stuck && (worker = idle_worker(crew)) && (fold = sweep_plan_next(&crew->plan)))
            start(crew, worker, fold);
        if (busy_workers(crew) > 0)
            wait_for_one(crew);
    } while (busy_workers(crew) > 0 || (crew->plan.next && !interrupt_asked() && !crew->stuck));
    progress_end(&crew->progress);
    sigprocmask(SIG_SETMASK, &before, NULL);
}

/* ---- the table ---- */

static void print_count(const struct sweep *sweep, const struct sweep_count *count, const struct file_log *log)
{
    printf("%d %s: %d converged, %d ended otherwise, %d missing", sweep->npoints, names_count(sweep->npoints, "point", "points"), count->good, count->other, count->missing);
    if (count->stale > 0)
        printf(" (%d of them of another script, other settings or outputs)", count->stale);
    for (int i = 0; i < log->nentries; i++)
        printf("%s %s", i == 0 ? "\nwrote" : ",", log->entry[i].path);
    printf("\n");
}

static enum status collect(const struct sweep *whole, const struct scene *scene)
{
    struct arena arena = {0};
    struct sweep kept = *whole;
    const struct sweep *sweep = &kept;
    struct sweep_plan plan;
    if (whole->options->warm) {
        sweep_plan_begin(&plan, whole, true);
        kept.from = plan.from;
    }
    struct file_log log = {0};
    struct sweep_count count;
    const char **table = arena_array(&arena, const char *, (size_t)scene->noutputs + 1);
    int ntables = 0;
    for (int i = 0; i < scene->noutputs; i++)
        if (scene->output[i].kind == OUTPUT_TABLE && outputs_of_sweep(scene, i))
            table[ntables++] = scene->output[i].path;
    bool written = sweep_table_write(sweep, table, ntables, &log, &count);
    for (int i = 0; i < scene->noutputs; i++)
        if (scene->output[i].kind == OUTPUT_PLOT && outputs_of_sweep(scene, i))
            written = written && sweep_plot_write(sweep, &scene->output[i], &log);
    if (!written)
        fprintf(stderr, "weft: %s\n", log.error);
    else if (!sweep->options->quiet)
        print_count(sweep, &count, &log);
    if (whole->options->warm)
        sweep_plan_free(&plan);
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
    sweep_plan_begin(&crew.plan, sweep, false);
    crew.before = sweep_plan_done(&crew.plan);
    if (crew.before > 0 && !sweep->options->quiet)
        printf("%d of %d points were done before\n", crew.before, sweep->npoints);
    run_points(&crew);
    sweep_plan_free(&crew.plan);
    free(crew.worker);
    enum status status = collect(sweep, scene);
    if (interrupt_asked())
        fprintf(stderr, "weft: stopped; the same command goes on with the points that are missing\n");
    return crew.stuck ? STATUS_FILES : interrupt_asked() ? STATUS_FAILED : status;
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

/* A param of the sweep that -D sets, too, or NULL. */
static const char *set_twice(const struct sweep *sweep)
{
    for (int i = 0; i < sweep->naxes; i++)
        for (int k = 0; k < sweep->options->ndefines; k++)
            if (strcmp(sweep->axis[i].param, sweep->options->define[k].name) == 0)
                return sweep->axis[i].param;
    return NULL;
}

static enum status run_sweep(const struct sweep *sweep, const struct scene *scene)
{
    const struct options *o = sweep->options;
    if (o->point > sweep->npoints)
        return options_wrong(o, "the sweep of %s has %d %s, there is no point %d", sweep->script, sweep->npoints,
                             names_count(sweep->npoints, "point", "points"), o->point);
    const char *twice = set_twice(sweep);
    if (twice)
        return options_wrong(o, "-D %s: the sweep of %s sets this param; `weft run` takes one value of it", twice, sweep->script);
    if (o->warm && (o->print || o->seeds > 1))
        return options_wrong(o, o->print ? "--warm: a point waits for its neighbours; --print lists commands that run in any order"
                                         : "--warm: a point with a neighbour to begin at has no use for --seeds");
    if (o->walk && !(o->warm && o->walk < o->point && (o->walk - 1) / sweep_chain(sweep) == (o->point - 1) / sweep_chain(sweep)))
        return options_wrong(o, "--walk goes with --warm and a later --point that differs in the last param alone");
    if (o->print + o->collect + (o->point > 0) > 1)
        return options_wrong(o, "of --print, --point and --collect a sweep takes one at a time");
    for (int i = 0; i < scene->noutputs; i++)
        if (scene->output[i].kind == OUTPUT_PLOT && outputs_of_sweep(scene, i) &&
            sweep_plot_check(sweep, &scene->output[i]) != STATUS_DONE)
            return STATUS_SCRIPT;
    if (o->print)
        return print_commands(sweep);
    if (!file_make_folder(sweep->folder)) {
        fprintf(stderr, "weft: the folder '%s' cannot be made: %s\n", sweep->folder, strerror(errno));
        return STATUS_FILES;
    }
    return o->collect ? collect(sweep, scene) : o->point ? sweep_point_run(sweep, o->point, o->walk) : run_all(sweep, scene);
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
        struct sweep sweep = {options, path, sweep_folder(options, path, &arena), script.scene, script.scene->naxes, script.scene->axis, 1, NULL};
        for (int i = 0; i < sweep.naxes; i++)
            sweep.npoints *= sweep.axis[i].npoints;
        status = run_sweep(&sweep, script.scene);
    }
    script_free(&script);
    arena_free(&arena);
    return status;
}
