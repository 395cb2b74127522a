/* SPDX-License-Identifier: GPL-3.0-or-later
 * The manifest: a run in; beside what it wrote, a JSON file with all that is
 * needed to repeat it out. */
#ifndef WEFT_MANIFEST_H
#define WEFT_MANIFEST_H

#include "cli/run.h"

enum { MANIFEST_SCHEMA = 1 };       /* changes when a reader of manifests must */

/* Where the files beside a run are: x.manifest.json for x.json where it has a
 * report, else NAME.manifest.json for NAME.knit beside its first output.  NULL
 * where no output is a plain file.  Free it. */
char *manifest_path(const struct scene *scene, const char *extension);

/* All that can be said before the fold: without seed, status and outputs.  Delete it. */
cJSON *manifest_begin(const struct run *run);

/* Writes the manifest after all outputs:
 *   weft ... machine  what ran (build.h), build_id
 *   command           arguments, folder (the working folder, from the manifest's), weft_path, threads
 *   sources           path and sha256 of the script, of what it uses, of the state it starts from
 *   scene, parameters as in the report
 *   seed, status
 *   outputs           path, sha256, and lasting_sha256 where part of a file differs from run to run
 * No time, no name of a machine: the same run gives the same bytes.  false: see
 * the log's error. */
bool manifest_write(struct run *run);

#endif
