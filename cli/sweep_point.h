/* SPDX-License-Identifier: GPL-3.0-or-later
 * One point of a sweep: a script and a number in; the run's outputs, its report
 * and a record in a folder of the point's own out. */
#ifndef WEFT_SWEEP_POINT_H
#define WEFT_SWEEP_POINT_H

#include <cjson/cJSON.h>

#include "cli/options.h"
#include "output/file.h"

#define SWEEP_REPORT "report.json"      /* in every point's folder */
#define SWEEP_STATE "fold.state"        /* too, with --warm: where the next one may begin */
#define SWEEP_RECORD "point.json"       /* written last: the point is finished */
#define SWEEP_ERROR_STATUS "error"      /* in it, where there was nothing to fold */

struct sweep {
    const struct options *options;      /* of `weft sweep` */
    const char           *script;       /* path */
    const char           *folder;       /* of all points */
    const struct scene   *scene;        /* at the params' defaults */
    int                   naxes;
    const struct sweep_axis *axis;      /* (naxes), the first varies slowest */
    int                   npoints;
    const int            *from;         /* (npoints) the fold each point keeps (sweep_plan.h), NULL: that from flat */
};

/* Points in a row that share all but the last param; 1 where none begins at another. */
int sweep_chain(const struct sweep *sweep);

/* A fold of a point, and what tells it from the others; everything in an arena. */
struct sweep_point {
    int          number;                /* 1 to npoints */
    int          from;                  /* the point where its row of folds began, each from the one before; 0: the flat sheet */
    const char  *start;                 /* the name of the one before, NULL: the flat sheet */
    const char **value;                 /* (naxes) texts that read back exactly */
    const char  *name;                  /* "03-c=0.25-n=2", "03-c=0.25-n=2-from-1" */
    const char  *folder;
};

struct sweep_point sweep_point(const struct sweep *sweep, int number, int from, struct arena *arena);

/* The fold the point keeps; one that is always missing where that is not known. */
struct sweep_point sweep_point_kept(const struct sweep *sweep, int number, struct arena *arena);

enum sweep_state {
    SWEEP_MISSING,      /* never run to an end */
    SWEEP_STALE,        /* run with another script, other settings or outputs */
    SWEEP_ERROR,        /* its script has an error there */
    SWEEP_DONE
};

enum sweep_state sweep_point_state(const struct sweep *sweep, const struct sweep_point *point);

#define SWEEP_BACK "leads_back"         /* in the record of a fold that began at a neighbour */

/* A file of the point's folder, or NULL. */
cJSON *sweep_point_json(const struct sweep_point *point, const char *name, struct arena *arena);

/* Runs it, unless it is done.  The run's status. */
enum status sweep_point_run(const struct sweep *sweep, int number, int from);

#endif
