/* SPDX-License-Identifier: GPL-3.0-or-later
 * The table of a sweep: the records and reports in its points' folders in; a
 * row for each point, as CSV and as JSON lines, out. */
#ifndef WEFT_SWEEP_TABLE_H
#define WEFT_SWEEP_TABLE_H

#include "cli/sweep_point.h"

/* How many points ended how. */
struct sweep_count {
    int good;           /* converged, to the tolerance or to rounding */
    int other;          /* ended some other way, or an error in the script there */
    int missing;        /* not run to an end, */
    int stale;          /* of these, run with another script, other settings or outputs */
};

/* Writes table.csv and table.jsonl into the sweep's folder, and the CSV to each
 * path of also (nalso), which are the script's own tables.  false: see log->error. */
bool sweep_table_write(const struct sweep *sweep, const char *const *also, int nalso, struct file_log *log,
                       struct sweep_count *count);

/* The numbers of a table by their place in the report, "energy.total"; NULL after the last. */
const char *sweep_table_field(int index);

/* The report of a point that is done, or NULL; did it converge; its number at a place, NAN if there is none. */
cJSON *sweep_table_report(const struct sweep *sweep, const struct sweep_point *point, struct arena *arena);
bool   sweep_table_converged(const cJSON *report);
double sweep_table_number(const cJSON *report, const char *field);

#endif
