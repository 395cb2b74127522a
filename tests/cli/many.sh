#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The example scripts that run a sweep by GNU parallel and by Slurm: each gives
# the table of `weft sweep`.  For Slurm a cluster of this one machine is started
# in the test's folder, and stopped.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

examples=$(cd "$WEFT_SOURCE/examples/sweep" && pwd)
export WEFT
cd "$work" || exit 1
mkdir plain parallel slurm
cd plain || exit 1
exits 0 'the sweep itself' "$WEFT" sweep "$examples/sweep.knit" -j 2
cd ..
same_table() { cmp "$1/rib.csv" plain/rib.csv && cmp "$1/sweep.sweep/table.jsonl" plain/sweep.sweep/table.jsonl; }

# ---- GNU parallel ----

if parallel --version 2>/dev/null | grep -q '^GNU parallel'; then
    HOME=$work
    export HOME
    cd parallel || exit 1
    exits 0 'by GNU parallel' sh "$examples/parallel.sh" "$examples/sweep.knit" -q
    cd ..
    check 'the table is the same' same_table parallel
    cd parallel || exit 1
    rm sweep.sweep/2-*/point.json
    touch sweep.sweep/began
    exits 0 'again' sh "$examples/parallel.sh" "$examples/sweep.knit" -q
    check 'runs what is not done' test sweep.sweep/2-thick=0.3-curl=0.8/report.json -nt sweep.sweep/began
    check 'and nothing else' test ! sweep.sweep/1-thick=0.3-curl=0.4/report.json -nt sweep.sweep/began
    cd ..
else
    skip 'by GNU parallel' 'no parallel program'
fi

# ---- Slurm ----

slurm=$work/cluster

# start_cluster PORT: the keeper of keys, the controller and the node; their processes are $daemons.
start_cluster() {
    mkdir -p "$slurm/spool" "$slurm/state" && chmod 755 "$work" "$slurm" || return 1
    node=$(hostname -s)
    cat >"$slurm/slurm.conf" <<CONF
ClusterName=weft
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$slurm/munge.socket
CredType=cred/munge
SlurmctldPort=$1
SlurmdPort=$(($1 + 1))
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
SlurmdSpoolDir=$slurm/spool
StateSaveLocation=$slurm/state
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES State=UP
CONF
    SLURM_CONF=$slurm/slurm.conf
    export SLURM_CONF
    (umask 077 && head -c 1024 /dev/urandom >"$slurm/munge.key")
    munged --foreground --force --key-file="$slurm/munge.key" --socket="$slurm/munge.socket" --pid-file="$slurm/munged.pid" \
        --log-file="$slurm/munged.log" --seed-file="$slurm/munged.seed" >"$slurm/out" 2>&1 &
    daemons=$!
    within 10 test -S "$slurm/munge.socket" || return 1
    slurmctld -D >>"$slurm/out" 2>&1 &
    daemons="$daemons $!"
    slurmd -D >>"$slurm/out" 2>&1 &
    daemons="$daemons $!"
    within 20 sh -c 'sinfo -h -o %t 2>/dev/null | grep -q idle'
}

# within SECONDS COMMAND...: the command succeeds before they are over.
within() {
    turns=$(($1 * 5))
    shift
    while ! "$@"; do
        turns=$((turns - 1))
        [ "$turns" -gt 0 ] || return 1
        sleep 0.2
    done
}

# shellcheck disable=SC2086
stop_cluster() {
    kill $daemons
    (sleep 10 && kill -s KILL $daemons) >/dev/null 2>&1 &
    late=$!
    wait $daemons
    kill "$late"
} 2>/dev/null

missing=
for program in munged slurmctld slurmd sbatch sinfo hostname; do
    command -v "$program" >/dev/null 2>&1 || missing="$missing $program"
done
[ "$(id -u)" = 0 ] || missing=' the rights to start one'
PATH=$PATH:/usr/sbin:/sbin

table_is_made() { [ -s slurm/sweep.sweep/table.csv ] && [ -s slurm/rib.csv ]; }

if [ -n "$missing" ]; then
    skip 'by Slurm' "no cluster: there is no$missing"
else
    daemons=
    trap 'stop_cluster; chmod -R u+w "$work"; rm -rf "$work"' EXIT
    trap 'exit 1' INT TERM HUP
    if start_cluster $((20000 + $$ % 10000 * 2)); then
        cd slurm || exit 1
        TASKS=4
        export TASKS
        exits 0 'by Slurm' sh "$examples/slurm.sh" "$examples/sweep.knit" -q
        out 'an array and a job for the table' '^6 points in job 1, their table in job 2$'
        cd ..
        check 'the table is made once all have run' within 60 table_is_made
        check 'it is the same' same_table slurm
    else
        skip 'by Slurm' 'no cluster: it did not start here'
        sed 's/^/# /' "$slurm/out"
    fi
fi

finish
