/* SPDX-License-Identifier: GPL-3.0-or-later
 * How far a fold is: steps and energies in; a bar on a terminal, a few lines
 * elsewhere, out. */
#include <config.h>

#include "cli/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "solver/surface.h"

enum { BAR_WIDTH = 16, LINES_MAX = 10 };

double progress_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool has_cursor(void)
{
    const char *terminal = getenv("TERM");
    return isatty(STDERR_FILENO) && terminal && strcmp(terminal, "dumb") != 0;
}

struct progress progress_begin(int nsteps, bool quiet)
{
    return (struct progress){
        .style = quiet ? PROGRESS_NONE : has_cursor() ? PROGRESS_BAR : PROGRESS_LINES,
        .nsteps = nsteps,
        .begun = progress_clock(),
    };
}

/* "1:05 left" if the steps to come take as long as those so far; nothing
 * before there is one. */
static void print_time_left(char *text, size_t size, const struct progress *p)
{
    text[0] = '\0';
    if (p->done < 1)
        return;
    double a_step = (p->stepped - p->begun) / p->done, since = progress_clock() - p->stepped;
    double left = a_step * (p->nsteps - p->done) - since;
    if (left > 0 && left < 360000)
        snprintf(text, size, "%d:%02d left", (int)(left / 60), (int)left % 60);
}

static void print_bar(char bar[BAR_WIDTH + 1], const struct progress *p)
{
    for (int i = 0; i < BAR_WIDTH; i++)
        bar[i] = i < (long)p->done * BAR_WIDTH / p->nsteps ? '#' : '-';
    bar[BAR_WIDTH] = '\0';
}

/* One line of less than 80 characters. */
static void draw(struct progress *p, double growth, double energy, int iterations)
{
    char bar[BAR_WIDTH + 1], left[40];
    print_bar(bar, p);
    print_time_left(left, sizeof left, p);
    fprintf(stderr, "\r[%s] growth %.2f  energy %-10.6g %6d it.  %s\033[K", bar, growth, energy, iterations, left);
    p->drawn = progress_clock();
}

void progress_step(struct progress *p, const struct fold_step *step)
{
    if (step->growth > 0 && p->done < p->nsteps) {
        p->done++;
        p->stepped = progress_clock();
    }
    if (p->style == PROGRESS_BAR)
        draw(p, step->growth, step->energy.total, step->iterations);

    /* Of many steps only every so-manieth gets a line, and the last. */
    int every = (p->nsteps + LINES_MAX - 1) / LINES_MAX;
    if (p->style == PROGRESS_LINES && step->growth > 0 && (p->done % every == 0 || p->done == p->nsteps))
        fprintf(stderr, "growth %.2f  energy %.6g  %d iterations\n", step->growth, step->energy.total, step->iterations);
}

void progress_iteration(struct progress *p, double growth, int iterations, double energy)
{
    if (p->style == PROGRESS_BAR && progress_clock() - p->drawn > 0.1)
        draw(p, growth, energy, iterations);
}

void progress_point(struct progress *p, const char *line, bool news)
{
    p->done++;
    p->stepped = progress_clock();
    p->drawn = 0;
    if (p->style == PROGRESS_LINES || news)
        fprintf(stderr, "%s%s\n", p->style == PROGRESS_BAR ? "\r\033[K" : "", line);
}

void progress_points(struct progress *p, int running)
{
    char bar[BAR_WIDTH + 1], left[40];
    if (p->style != PROGRESS_BAR || progress_clock() - p->drawn < 0.1)
        return;
    print_bar(bar, p);
    print_time_left(left, sizeof left, p);
    fprintf(stderr, "\r[%s] %d of %d points, %d running  %s\033[K", bar, p->done, p->nsteps, running, left);
    p->drawn = progress_clock();
}

void progress_end(struct progress *p)
{
    if (p->style == PROGRESS_BAR)
        fprintf(stderr, "\r\033[K");
}
