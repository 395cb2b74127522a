#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What a scene does not need: each line of the table is a pair of runs, without and with.
. "${srcdir:-.}/bench/lib.sh"
table=$results/skip.csv
echo "what,without,with,unit,ratio" >"$table"

row()           # what, without, with, unit
{
    awk -v what="$1" -v a="$2" -v b="$3" -v unit="$4" \
        'BEGIN { printf "%s,%.5g,%.5g,%s,%s\n", what, a, b, unit, (a > 0 ? sprintf("%.4f", b / a) : "-") }' >>"$table"
    say "$(tail -n 1 "$table")"
}

# Instructions repeat where CPU seconds do not.  The policy is set here, or weft starts itself again to set it.
OMP_WAIT_POLICY=passive
export OMP_WAIT_POLICY
if command -v valgrind >/dev/null 2>&1; then
    unit="million instructions"
    cost()      # script, options -> sets spent
    {
        spent=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$weft" "$@" -q -j 1 2>&1 >/dev/null |
            awk '/Collected/ { printf "%.6f\n", $NF / 1e6 }')
    }
else
    unit="CPU seconds"
    cost() { measure "$@" -j 1; spent=$cpu; }
fi

rib=$scenes/rib_small.knit
one="--steps 1 --per-stitch 1"
cost "$rib" $one
plain=$spent
cost "$rib" $one
row "the same run again" "$plain" "$spent" "$unit"
cost "$(with_settings "$rib" "springs { stiffness = 0 }")" $one
row "a spring block of stiffness 0" "$plain" "$spent" "$unit"
cost "$(with_settings "$rib" "springs { stiffness = 1e-4 }")" $one
row "springs of 1e-4 on all edges" "$plain" "$spent" "$unit"
cost "$rib" $one -o "obj:$work/rib.obj"
row "a surface written (OBJ)" "$plain" "$spent" "$unit"
written=$spent
cost "$rib" $one -o "obj:$work/rib.obj" --cached
row "the same run --cached" "$written" "$spent" "$unit"
cost "$rib" --steps 10 --per-stitch 1
row "growth in ten steps" "$plain" "$spent" "$unit"
cost "$scenes/flat.knit" $one
row "no natural curvature at all" "$plain" "$spent" "$unit"
cost "$rib" $one --method lbfgs
row "no factors: plain libLBFGS" "$plain" "$spent" "$unit"

# Stitches that do not change along one side begin bent; one purl in the middle, and they begin flat.
echo 'swatch above(tile(K, 16, 7), above(beside(tile(K, 8, 1), beside(P, tile(K, 7, 1))), tile(K, 16, 8)))' >"$work/spot.knit"
echo 'swatch tile(K, 16, 16)' >"$work/plain.knit"
once "$work/spot.knit" -q -j 1 -o "report:$report" $one
flat=$(figure solve.iterations)
once "$work/plain.knit" -q -j 1 -o "report:$report" $one
row "stripes begin bent" "$flat" "$(figure solve.iterations)" iterations

# The answer without a solve, and one thread against two, on the full Miura of Fig. 3a.
once "$scenes/flat.knit" -q -o "report:$report" $one
row "iterations without natural curvature" 0 "$(figure solve.iterations)" iterations

full=$scenes/miura_4x4.knit
: >"$work/one"
: >"$work/two"
tries=0
while [ "$(wc -l <"$work/two")" -lt "$BENCH_RUNS" ] && [ $tries -lt $((5 * BENCH_RUNS)) ]; do
    before=$(stolen)
    once "$full" -q --steps 1 --per-stitch 1 -j 1 -o "report:$report"
    one_wall=$(figure time.total_s)
    energy_one=$(figures energy.total solve.iterations solve.gradient_max)
    once "$full" -q --steps 1 --per-stitch 1 -j 2 -o "report:$report"
    two_wall=$(figure time.total_s)
    energy_two=$(figures energy.total solve.iterations solve.gradient_max)
    tries=$((tries + 1))
    share=$(echo "$before $(stolen)" | awk '{ printf "%.1f", 100 * ($3 - $1) / ($4 - $2) }')
    say "pair $tries: $one_wall s and $two_wall s, $share % of the processors' time taken by the host"
    if awk "BEGIN { exit !($share > 2) }"; then continue; fi
    echo "$one_wall" >>"$work/one"
    echo "$two_wall" >>"$work/two"
done
[ -s "$work/two" ] || say "no pair had both processors to itself"
row "full Miura on two threads" "$(median <"$work/one")" "$(median <"$work/two")" "wall seconds"
[ "$energy_one" = "$energy_two" ] && same=1 || same=0
row "same bits on one thread and two" 1 $same "energy; iterations; gradient"

# The mean of so many runs of weft check, start to end.
checks()        # file, runs -> sets each, in milliseconds
{
    begin=$(date +%s%N)
    run=0
    while [ $run -lt "$2" ]; do
        "$weft" check "$1" >/dev/null
        run=$((run + 1))
    done
    each=$((($(date +%s%N) - begin) / 1000000 / $2))
}

largest=$(for f in "$srcdir"/examples/*.knit; do
    echo "$("$weft" chart "$f" 2>/dev/null | wc -c) $f"
done | sort -n | tail -n 1 | cut -d ' ' -f 2)
checks "$largest" 100
row "weft check $(basename "$largest"): bar 20" 20 "$each" milliseconds

# A thousand rows of a thousand stitches, each of them written.
awk 'BEGIN { print "Cast on 1000 sts"
    for (i = 1; i <= 1000; i++) { printf "Row %d: ", i; for (j = 0; j < 500; j++) printf "k1, p1, "; print "" } }' >"$work/million.knit"
checks "$work/million.knit" 10
row "weft check of a million stitches one by one: bar 200" 200 "$each" milliseconds
