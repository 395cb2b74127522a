/* SPDX-License-Identifier: GPL-3.0-or-later
 * A sheet that may have several minima in; folds from several seeds, the
 * lowest found out. */
#include <config.h>

#include "cli/seeds.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/interrupt.h"
#include "solver/memory.h"
#include "solver/sheet.h"

static const double AGREEMENT = 1e-8;   /* of the energy */

static bool is_minimum(const struct report_seed *r)
{
    return r->status == FOLD_CONVERGED || r->status == FOLD_PRECISION;
}

/* Is a the one to keep, rather than b?  Minima before other ends, failures last. */
static bool better(const struct report_seed *a, const struct report_seed *b)
{
    if (is_minimum(a) != is_minimum(b))
        return is_minimum(a);
    if ((a->status == FOLD_FAILED) != (b->status == FOLD_FAILED))
        return b->status == FOLD_FAILED;
    return a->energy < b->energy;
}

static void compare(struct seeds *seeds)
{
    const struct report_seed *lowest = &seeds->result[seeds->kept];
    for (int i = 0; i < seeds->nresults; i++)
        if (is_minimum(&seeds->result[i]) && seeds->result[i].energy != lowest->energy)
            seeds->spread = fmax(seeds->spread, (seeds->result[i].energy - lowest->energy) / fabs(lowest->energy));
}

bool seeds_try(struct seeds *seeds, int count, struct sheet *sheet, const struct fold_options *options,
               const struct fold_observer *observer)
{
    uint64_t first = sheet->solve.seed;
    *seeds = (struct seeds){.result = MEMORY_ARRAY(struct report_seed, count)};
    bool going_on = true;
    for (int i = 0; i < count && going_on; i++) {
        struct fold_record record;
        sheet->solve.seed = first + (uint64_t)i;
        struct fold_state *state = fold_run(sheet, options, observer, &record);
        going_on = !interrupt_asked();
        fold_free(state);
        seeds->result[i] = (struct report_seed){sheet->solve.seed, record.energy.total, record.status};
        seeds->nresults++;
        if (better(&seeds->result[i], &seeds->result[seeds->kept]))
            seeds->kept = i;
        fold_record_free(&record);
    }
    compare(seeds);
    sheet->solve.seed = seeds->result[seeds->kept].seed;
    return going_on;
}

void seeds_free(struct seeds *seeds)
{
    free(seeds->result);
}

void seeds_print(const struct seeds *seeds)
{
    int minima = 0;
    for (int i = 0; i < seeds->nresults; i++) {
        const struct report_seed *r = &seeds->result[i];
        printf("seed %" PRIu64 ": energy %.12g, %s\n", r->seed, r->energy, fold_status_name(r->status));
        minima += is_minimum(r);
    }
    if (minima < seeds->nresults)
        printf("%d of %d seeds found a minimum; ", minima, seeds->nresults);
    if (minima > 1 && seeds->spread <= AGREEMENT)
        printf("the energies agree to 1e-8");
    else if (minima > 1)
        printf("the energies differ by up to %.2g of the lowest: there are several minima", seeds->spread);
    else
        printf("nothing to compare");
    printf("; kept seed %" PRIu64 "\n", seeds->result[seeds->kept].seed);
}
