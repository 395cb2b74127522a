/* SPDX-License-Identifier: GPL-3.0-or-later
 * The driver: growth on the coarsest level, then level by level to the one
 * asked for, the last to the full tolerance. */
#include "solver/fold.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "solver/cross_check.h"
#include "solver/descent.h"
#include "solver/estimate.h"
#include "solver/fold_state.h"
#include "solver/levels.h"
#include "solver/memory.h"
#include "solver/noise.h"
#include "solver/shape.h"
#include "solver/sheet.h"
#include "solver/stripes.h"

static const double GROWING = 1e-4;     /* tolerance of a growth step, young * thickness^2 */
static const double COARSE = 1e-5;      /* tolerance of a level that is refined further */

struct fold {
    const struct sheet         *sheet;
    const struct fold_observer *observer;
    struct fold_record         *record;
    struct fold_state          *state;
    struct problem              problem;
    struct effort               effort;
    const struct fold_options  *options;
    int                         threads;
    long                        most_factored;
    struct {
        struct discretisation *d;
        double                *x;
        struct factor         *factor;
    } kept;                                     /* the last level that was factored, once one is too large */
    int                         pushes;     /* saddles left on all levels */
};

/* ---- levels ---- */

static bool progress(void *self, double growth, int iterations, double energy)
{
    const struct fold *fold = self;
    const struct fold_observer *o = fold->observer;
    return !o || !o->progress || o->progress(o->self, growth, iterations, energy * fold->sheet->young);
}

/* Makes the state's level the one that is minimised on. */
static void open_level(struct fold *fold, double growth)
{
    problem_open(&fold->problem, fold->state->d, &fold->effort);
    fold->problem.limit = fold->sheet->solve.max_iterations;
    fold->problem.progress = progress;
    fold->problem.progress_self = fold;
    fold->problem.growth = fold->state->growth = growth;
}

static void start_level(struct fold *fold)
{
    const struct sheet *sheet = fold->sheet;
    struct fold_state *state = fold->state;
    state->d = levels_first(sheet, fold->threads);
    state->x = MEMORY_ARRAY(double, state->d->n);
    state->d->op->flat(state->d, state->x);
    open_level(fold, 0);
    uint64_t seed = sheet->solve.seed;
    for (int i = 0; i < state->d->nnodes; i++)
        state->x[state->d->node[i] + 2] += sheet->solve.noise * sheet->thickness * noise_next(&seed);
}

/* This level and its factor precondition the next ones, too large to factor. */
static void keep_level(struct fold *fold)
{
    fold->kept.d = fold->state->d;
    fold->kept.x = fold->state->x;
    fold->kept.factor = fold->problem.factor;
    fold->problem.factor = NULL;
}

static void close_level(struct fold *fold)
{
    two_level_free(fold->problem.two_level);
    problem_close(&fold->problem);
}

/* The state x of a finer level, taken over, is where the fold goes on. */
static void replace_level(struct fold *fold, struct discretisation *finer, double *x)
{
    struct fold_state *state = fold->state;
    if (finer->n > fold->most_factored && finer->op->restrict_gradient && fold->problem.factor)
        keep_level(fold);
    close_level(fold);
    if (state->d != fold->kept.d) {
        state->d->op->free(state->d);
        free(state->x);
    }
    state->d = finer;
    state->x = x;
    open_level(fold, state->growth);
    if (fold->kept.d)
        fold->problem.two_level = two_level_make(fold->kept.d, fold->kept.x, fold->kept.factor, finer);
}

/* ---- record ---- */

static struct fold_energy scaled(struct fold_energy e, double young)
{
    return (struct fold_energy){e.total * young, e.stretching * young, e.bending * young, e.springs * young};
}

static double square(double a)
{
    return a * a;
}

/* Appends a step and tells the observer; false when it asks to stop. */
static bool append_step(struct fold *fold, const struct fold_step *step)
{
    struct fold_record *record = fold->record;
    const struct fold_observer *o = fold->observer;
    if (step->growth > 0) {
        record->step = memory_grow(record->step, (size_t)record->nsteps + 1, sizeof *record->step);
        record->step[record->nsteps++] = *step;
    }
    return !o || !o->step || o->step(o->self, step, fold->state);
}

/* A fold that begins elsewhere has but the last. */
static int growth_steps(const struct fold *fold)
{
    return fold->options->start ? 1 : fold->sheet->solve.steps;
}

/* The state as it is now is a step. */
static bool record_step(struct fold *fold, int iterations)
{
    const struct fold_step step = {.growth = fold->state->growth, .iterations = iterations,
                                   .energy = scaled(fold->problem.energy, fold->sheet->young),
                                   .gradient_max = fold->problem.gradient_max / square(fold->sheet->thickness)};
    return append_step(fold, &step);
}

struct fold_mark fold_mark(const struct fold_step *step, const struct fold_state *state)
{
    return (struct fold_mark){*step, state->effort->iterations, state->effort->evaluations,
                              state->effort->factorisations, state->d->n, state->x};
}

struct fold_start fold_start(const struct fold_state *state)
{
    const struct sheet *sheet = state->d->sheet;
    return (struct fold_start){sheet->columns, sheet->rows, state->grown_energy, state->ngrown, state->grown};
}

static void record_shape(struct fold *fold)
{
    const struct sheet *sheet = fold->sheet;
    struct surface surface = surface_make(sheet->columns, sheet->rows, fold->state->d->per_stitch);
    fold_sample(fold->state, &surface);
    shape_measure(&surface, sheet->columns * sheet->dx, sheet->rows * sheet->dy, fold->record);
    surface_free(&surface);
}

static double flat_energy(const struct fold *fold)
{
    const struct discretisation *d = fold->state->d;
    double *x = MEMORY_ARRAY(double, d->n);
    d->op->flat(d, x);
    double energy = d->op->energy(d, x, 1, NULL).total;
    free(x);
    return energy;
}

static const char *method_name(enum method method)
{
    static const char *const name[] = {"plbfgs+newton", "newton", "plbfgs", "lbfgs"};
    return name[method];
}

static const char *doubt_of(const struct fold *fold)
{
    const struct discretisation *d = fold->state->d;
    return d->op->doubt ? d->op->doubt(d, fold->state->x) : NULL;
}

static enum fold_status status_of(const struct fold *fold, struct descent end)
{
    if (doubt_of(fold))
        return FOLD_FAILED;
    switch (end.outcome) {
    case OUTCOME_CONVERGED: return end.minimum ? FOLD_CONVERGED : FOLD_SADDLE;
    case OUTCOME_PRECISION: return end.minimum ? FOLD_PRECISION : FOLD_SADDLE;
    case OUTCOME_LIMIT: return FOLD_ITERATION_LIMIT;
    default: return FOLD_FAILED;
    }
}

/* A start of this sheet's stitches and unknowns, or none. */
static bool start_fits(const struct fold *fold)
{
    const struct fold_start *start = fold->options->start;
    const struct sheet *sheet = fold->sheet;
    return !start || fold->state->grown ||
           (start->columns == sheet->columns && start->rows == sheet->rows && start->n == fold->state->d->n);
}

static const char *remark_of(const struct fold *fold, struct descent end)
{
    if (!start_fits(fold))
        return "the state to start from is of a flat sheet, or of another number of stitches or another mesh";
    if (doubt_of(fold))
        return doubt_of(fold);
    switch (end.outcome) {
    case OUTCOME_STOPPED: return "stopped on request";
    case OUTCOME_STALLED: return "no descent direction was found at a gradient above the tolerance";
    case OUTCOME_FAILED: return "the energy is not finite, or its factor does not fit in memory";
    default: break;
    }
    if (!end.minimum && (end.outcome == OUTCOME_CONVERGED || end.outcome == OUTCOME_PRECISION))
        return "the state is a saddle that pushing did not leave";
    return fold->pushes ? "a saddle was met on the way and left to its lower side" : NULL;
}

static void finish_record(struct fold *fold, struct descent end)
{
    const struct discretisation *d = fold->state->d;
    const struct effort *effort = &fold->effort;
    struct fold_record *record = fold->record;
    double young = fold->sheet->young;
    record->kind = fold->sheet->mesh.discretisation == DISCRETISATION_PATCH ? "patch" : "triangle";
    record->per_stitch = d->per_stitch;
    record->unknowns = d->n;
    record->elements = d->elements;
    record->energy = scaled(fold->problem.energy, young);
    record->energy_flat = flat_energy(fold) * young;
    record->status = status_of(fold, end);
    record->remark = remark_of(fold, end);
    record->method = method_name(fold->sheet->solve.method);
    record->growth_steps = growth_steps(fold);
    record->iterations = effort->iterations;
    record->evaluations = effort->evaluations;
    record->factorisations = effort->factorisations;
    record->gradient_max = fold->problem.gradient_max / square(fold->sheet->thickness);
    record->positive_definite = end.minimum;
    record->threads = fold->threads;
    record->assemble_s = effort->assemble_s;
    record->factor_s = effort->factor_s;
    record->evaluate_s = effort->evaluate_s;
    record->solve_s = effort->solve_s;
    record_shape(fold);
}

/* ---- growth and refinement ---- */

static double tolerance_of(const struct fold *fold, double loose)
{
    return fmax(loose, fold->sheet->solve.tolerance) * square(fold->sheet->thickness);
}

static bool may_go_on(enum outcome outcome)
{
    return outcome != OUTCOME_STOPPED && outcome != OUTCOME_LIMIT && outcome != OUTCOME_FAILED;
}

/* Goes through the steps of a fold that was broken off; false when the observer asks to stop. */
static bool replay(struct fold *fold)
{
    const struct fold_options *options = fold->options;
    struct fold_state *state = fold->state;
    for (const struct fold_mark *m = options->mark; m < options->mark + options->nmarks; m++) {
        if (m->n != state->d->n)
            return false;
        memcpy(state->x, m->x, (size_t)m->n * sizeof *state->x);
        state->growth = m->step.growth;
        fold->effort.iterations = m->iterations;
        fold->effort.evaluations = m->evaluations;
        fold->effort.factorisations = m->factorisations;
        if (!append_step(fold, &m->step))
            return false;
    }
    return true;
}

/* The flat sheet; then the start there is, or, where noise may break its symmetry, bent to the stripes it has; or all
 * that was grown before. */
static bool begin_growth(struct fold *fold)
{
    if (fold->options->nmarks > 0)
        return replay(fold);
    problem_evaluate(&fold->problem, fold->state->x);
    if (!record_step(fold, 0))
        return false;
    const struct solve *solve = &fold->sheet->solve;
    const struct fold_start *start = fold->options->start;
    if (start)
        memcpy(fold->state->x, start->x, (size_t)start->n * sizeof *start->x);
    else if (solve->method != METHOD_LBFGS && solve->noise > 0)
        stripes_bend(fold->state->d, 1.0 / solve->steps, fold->state->x);
    return true;
}

/* All growth steps but the last, whose end is polished later. */
static enum outcome grow(struct fold *fold)
{
    const struct solve *solve = &fold->sheet->solve;
    if (!start_fits(fold))
        return OUTCOME_FAILED;
    if (!begin_growth(fold))
        return OUTCOME_STOPPED;
    fold->problem.tolerance = tolerance_of(fold, GROWING);
    for (int step = fold->record->nsteps + 1; step < growth_steps(fold); step++) {
        int before = fold->effort.iterations;
        fold->problem.growth = fold->state->growth = (double)step / solve->steps;
        enum outcome outcome = descent_settle(&fold->problem, solve->method, fold->state->x);
        if (!may_go_on(outcome))
            return outcome;
        if (!record_step(fold, fold->effort.iterations - before))
            return OUTCOME_STOPPED;
    }
    fold->problem.growth = fold->state->growth = 1;
    return OUTCOME_CONVERGED;
}

/* Errors are relative to the total energy, or to the flat one's where the sheet has lost nearly all. */
static double energy_scale(const struct fold *fold)
{
    double total = fabs(fold->problem.energy.total), flat = flat_energy(fold);
    return total > flat / 100 ? total : flat;
}

static double sheet_size(const struct sheet *sheet)
{
    return hypot(sheet->columns * sheet->dx, sheet->rows * sheet->dy);
}

static void state_error(struct fold *fold, struct estimate error)
{
    double scale = energy_scale(fold);
    fold->record->energy_error = scale > 0 ? error.energy / scale : 0;
    fold->record->shape_error = error.shape < 0 ? -1 : error.shape / sheet_size(fold->sheet);
}

/* The error of a minimum with the help of the next level; x (its n) becomes a start there. */
static struct estimate estimate_ahead(struct fold *fold, const struct discretisation *finer, double *x)
{
    struct discretisation *coarse = fold->kept.d ? fold->kept.d : fold->state->d;
    struct factor *factor = fold->kept.d ? fold->kept.factor : fold->problem.factor;
    return estimate_error(&fold->problem, coarse, factor, fold->state->x, finer, x);
}

/* Is this level the last: as fine as asked for, or accurate enough, or all that fits? */
static bool fine_enough(const struct fold *fold)
{
    const struct discretisation *d = fold->state->d;
    const struct sheet *sheet = fold->sheet;
    double error = fold->record->energy_error;
    if (sheet->mesh.per_stitch || sheet->solve.method == METHOD_LBFGS)
        return true;
    return (error >= 0 && error <= sheet->solve.accuracy) || d->n > LEVELS_MOST_UNKNOWNS / 4;
}

/* Keeps where the fold is on the level it grew on, once it is there. */
static void keep_grown(struct fold *fold)
{
    struct fold_state *state = fold->state;
    if (state->grown)
        return;
    state->grown_energy = fold->problem.energy.total * fold->sheet->young;
    state->ngrown = state->d->n;
    state->grown = MEMORY_ARRAY(double, state->ngrown);
    memcpy(state->grown, state->x, (size_t)state->ngrown * sizeof *state->grown);
}

/* One level at the full curvature; true when it is the last. */
static bool settle_level(struct fold *fold, struct descent *end)
{
    const struct discretisation *d = fold->state->d;
    bool passing = levels_passing(d);
    fold->problem.tolerance = tolerance_of(fold, passing ? COARSE : 0);
    *end = descent_to_minimum(&fold->problem, fold->sheet->solve.method, fold->state->x);
    fold->pushes += end->pushes;
    keep_grown(fold);
    if (fold->options->coarse || !may_go_on(end->outcome) || (!passing && !end->minimum))
        return true;
    bool ahead = !passing && d->op->restrict_gradient;
    if (!passing && !ahead) {
        state_error(fold, cross_check(&fold->problem, fold->state->x));
        if (fine_enough(fold))
            return true;
    }
    struct discretisation *finer = levels_next(d, fold->threads);
    double *x = MEMORY_ARRAY(double, finer->n);
    if (ahead)
        state_error(fold, estimate_ahead(fold, finer, x));
    else
        d->op->prolong(d, fold->state->x, finer, x);
    if (ahead && fine_enough(fold)) {
        finer->op->free(finer);
        free(x);
        return true;
    }
    replace_level(fold, finer, x);
    return false;
}

/* The full curvature, from the level of the growth to the last. */
static struct descent refine(struct fold *fold)
{
    struct descent end;
    while (!settle_level(fold, &end))
        continue;
    return end;
}

static bool has_curvature(const struct sheet *sheet)
{
    for (size_t i = 0; i < (size_t)sheet->columns * (size_t)sheet->rows; i++)
        if (sheet->kx[i] != 0 || sheet->ky[i] != 0 || sheet->twist[i] != 0)
            return true;
    return false;
}

/* Without natural curvature the flat sheet is the minimum: nothing is solved. */
static struct descent stay_flat(struct fold *fold)
{
    struct fold_state *state = fold->state;
    state->d = levels_flat(fold->sheet, fold->threads);
    state->x = MEMORY_ARRAY(double, state->d->n);
    state->d->op->flat(state->d, state->x);
    open_level(fold, 1);
    problem_evaluate(&fold->problem, state->x);
    fold->record->energy_error = fold->record->shape_error = 0;
    record_step(fold, 0);
    return (struct descent){.outcome = OUTCOME_CONVERGED, .minimum = true};
}

static struct descent grow_and_refine(struct fold *fold)
{
    start_level(fold);
    struct descent end = {.outcome = grow(fold)};
    if (end.outcome != OUTCOME_CONVERGED)
        return end;
    int before = fold->effort.iterations;
    end = refine(fold);
    if (may_go_on(end.outcome))
        record_step(fold, fold->effort.iterations - before);
    return end;
}

static void close_fold(struct fold *fold)
{
    close_level(fold);
    factor_free(fold->kept.factor);
    free(fold->kept.x);
    if (fold->kept.d)
        fold->kept.d->op->free(fold->kept.d);
}

int fold_threads(int asked)
{
#ifdef _OPENMP
    return asked > 0 ? asked : omp_get_num_procs();
#else
    (void)asked;
    return 1;
#endif
}

struct fold_state *fold_run(const struct sheet *sheet, const struct fold_options *options,
                            const struct fold_observer *observer, struct fold_record *record)
{
    *record = (struct fold_record){.status = FOLD_FAILED, .energy_error = -1, .shape_error = -1};
    struct fold fold = {.sheet = sheet, .observer = observer, .record = record,
                        .state = MEMORY_ARRAY(struct fold_state, 1), .options = options, .threads = fold_threads(options->threads),
                        .most_factored = options->most_factored ? options->most_factored : FOLD_MOST_FACTORED};
    fold.state->effort = &fold.effort;
    finish_record(&fold, has_curvature(sheet) ? grow_and_refine(&fold) : stay_flat(&fold));
    close_fold(&fold);
    fold.state->effort = NULL;
    return fold.state;
}

void fold_free(struct fold_state *state)
{
    if (!state)
        return;
    state->d->op->free(state->d);
    free(state->x);
    free(state->grown);
    free(state);
}

void fold_sample(const struct fold_state *state, struct surface *surface)
{
    const struct sheet *sheet = state->d->sheet;
    state->d->op->sample(state->d, state->x, state->growth, surface);
    if (sheet->spring <= 0)
        shape_align(surface);
    size_t cells = (size_t)surface->nx * (size_t)surface->ny;
    for (size_t i = 0; i < cells; i++) {
        surface->stretching[i] *= sheet->young;
        surface->bending[i] *= sheet->young;
    }
}
