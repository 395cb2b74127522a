/* SPDX-License-Identifier: GPL-3.0-or-later
 * The report: a scene, the record of its fold and the files written in; one
 * JSON object out. */
#ifndef WEFT_REPORT_H
#define WEFT_REPORT_H

#include <cjson/cJSON.h>

#include "lang/scene.h"
#include "output/file.h"
#include "solver/surface.h"

enum { REPORT_SCHEMA = 1 };     /* changes when a reader of reports must */

/* How a fold from one of several seeds ended. */
struct report_seed {
    uint64_t         seed;
    double           energy;        /* force * length */
    enum fold_status status;
};

struct report {
    const struct scene       *scene;
    const struct fold_record *record;
    const char               *source;               /* the script's text */
    size_t                    source_size;          /* bytes */
    double                    total_s, compile_s, write_s;      /* wall seconds */
    int                       nseeds;               /* tried; 0: the scene's own alone */
    const struct report_seed *seed;                 /* (nseeds) */
    uint64_t                  kept_seed;            /* that this is the fold of */
    long                      peak_bytes;           /* of memory, the whole process */
};

/* Adds "scene" and "parameters", as the report has them, to an object. */
void report_describe(cJSON *root, struct file_log *log, const struct report *report);

/* Takes out of a report what differs from run to run, or with the machine: "time", "memory", "outputs", the
 * script's path, the number of threads. */
void report_keep_lasting(cJSON *root);

/* The log's lasting hash, of a report that was read by json_parse; takes out of it what does not last. */
void report_hash_lasting(struct file_log *log, cJSON *root, char sha256[FILE_HASH]);

/* Writes the report; its "outputs" are what log holds so far.  Every number
 * reads back exactly; a value that is not known (no error estimate, not finite)
 * is null.  Apart from "time" and "memory" the bytes depend only on the binary,
 * the script, the seed and the number of threads; the log's lasting hash is that
 * of what report_keep_lasting leaves.  false: see log->error. */
bool report_write(struct file_log *log, const char *path, const struct report *report);

#endif
