# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the benchmarks: measured runs of weft, their figures taken from its own report.
# Times are CPU seconds (user + system, one thread unless said) and wall seconds; the
# median of BENCH_RUNS runs, of one run where that took longer than BENCH_ONCE seconds.
set -eu
: "${srcdir:=.}" "${BENCH_RUNS:=3}" "${BENCH_ONCE:=600}"
: "${BENCH_LIMIT:=$([ -n "${BENCH_LARGE:-}" ] && echo 3600 || echo 1800)}"
weft=${WEFT:-./weft}
bench=$srcdir/bench
scenes=$bench/scenes
results=bench/results
work=bench/results/work/$(basename "$0" .sh)
mkdir -p "$work"

report=$work/report.json

seconds_of()    # "0m1.5s 0m0.1s" -> 1.6
{
    awk '{ for (i = 1; i <= NF; i++) { split($i, t, /[ms]/); s += 60 * t[1] + t[2] } } END { printf "%.4f\n", s }'
}

once()          # weft's arguments -> sets cpu and ended; leaves a report
{
    rm -f "$report"
    cpu=$( (
        timeout "$BENCH_LIMIT" "$weft" "$@" >/dev/null 2>&1 && echo 0 >"$work/ended" || echo $? >"$work/ended"
        times) | tail -n 1 | seconds_of)
    ended=$(cat "$work/ended")
}

figure()        # name in the report, as energy.total
{
    [ -f "$report" ] && awk -f "$bench/report.awk" "$report" | awk -v name="$1" '$1 == name { print $2 }' || :
}

figures()       # names -> their values, comma-separated
{
    [ -f "$report" ] || { echo "$*" | sed 's/[^ ]*/,/g; s/ //g; s/,//'; return; }
    awk -f "$bench/report.awk" "$report" | awk -v names="$*" '
        { value[$1] = $2 }
        END { n = split(names, name, " "); for (i = 1; i <= n; i++) printf "%s%s", value[name[i]], i < n ? "," : "\n" }'
}

stolen()        # -> time that a virtual machine's host took from it, and all time, since it started
{
    awk '$1 == "cpu" { for (i = 2; i <= 9; i++) all += $i; print $9, all }' /proc/stat
}

median()        # numbers, one a line
{
    sort -g | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
}

measure()       # script, then weft's options -> sets cpu, wall, runs, ended
{
    script=$1
    shift
    : >"$work/cpu"
    : >"$work/wall"
    runs=0
    while [ "$runs" -lt "$BENCH_RUNS" ]; do
        once "$script" -q -o "report:$report" "$@"
        echo "$cpu" >>"$work/cpu"
        figure time.total_s >>"$work/wall"
        runs=$((runs + 1))
        if awk "BEGIN { exit !($cpu > $BENCH_ONCE) }"; then break; fi
    done
    cpu=$(median <"$work/cpu")
    wall=$(median <"$work/wall")
}

with_settings() # scene, lines to add -> the path of a copy
{
    copy=$work/$(basename "$1")
    { cat "$1"; shift; for line; do echo "$line"; done; } >"$copy"
    echo "$copy"
}

say()
{
    echo "$*" >&2
}
