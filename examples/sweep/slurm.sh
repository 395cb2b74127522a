#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# All points of a sweep as an array of Slurm jobs, and a job after them that
# makes its table.
#
#     sh slurm.sh FILE [OPTION of weft sweep]...
#
# Give the options of your cluster in Slurm's own variables: SBATCH_PARTITION,
# SBATCH_TIMELIMIT, SBATCH_ACCOUNT.  TASKS is the most that the cluster allows in
# an array; where there are more points, each task runs several.  What the jobs
# say is in slurm-NUMBER.out.  Submitted again, it runs what is not done.
set -eu
weft=${WEFT:-weft}

case ${WEFT_JOB:-submit} in
submit)
    points=$("$weft" sweep "$@" --print | wc -l)
    tasks=${TASKS:-1000}
    [ "$tasks" -le "$points" ] || tasks=$points
    array=$(sbatch --parsable --export="ALL,WEFT_JOB=points,POINTS=$points" --array="1-$tasks" \
        --job-name=weft-points --output=slurm-%A.out --open-mode=append "$0" "$@")
    table=$(sbatch --parsable --export=ALL,WEFT_JOB=table --dependency="afterany:$array" \
        --job-name=weft-table --output=slurm-%j.out "$0" "$@")
    echo "$points points in job $array, their table in job $table"
    ;;
points)
    status=0
    for point in $(seq "$SLURM_ARRAY_TASK_ID" "$SLURM_ARRAY_TASK_MAX" "$POINTS"); do
        "$weft" sweep "$@" --point "$point" -j "${SLURM_CPUS_PER_TASK:-1}" || status=$?
    done
    exit "$status"
    ;;
table)
    exec "$weft" sweep "$@" --collect
    ;;
esac
