#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Both discretisations, finer and finer: the energy's true error and the stated one. The true energy is extrapolated
# from two and four patches a stitch's side (order two at the least: a third of the last change is taken off).
. "${srcdir:-.}/bench/lib.sh"
table=$results/converge.csv
echo "scene,discretisation,cells,unknowns,energy,limit,true,stated,ratio,cpu_s,status" >"$table"
BENCH_RUNS=1
for scene in rib2x2 checks seed miura basketweave garter chains stockinette; do
    : >"$work/levels"
    for level in "patch 1" "patch 2" "patch 4" "triangle 1" "triangle 2" "triangle 4" "triangle 8"; do
        measure "$scenes/$scene.knit" --steps 1 --discretisation "${level% *}" --per-stitch "${level#* }" -j 1
        echo "$level $(figure discretisation.unknowns) $(figure energy.total) $(figure energy.error_estimate) $cpu $(figure solve.status)" >>"$work/levels"
    done
    awk -v scene=$scene '
        { line[NR] = $0; energy[$1 $2] = $4 }
        END {
            limit = energy["patch4"] - (energy["patch2"] - energy["patch4"]) / 3
            for (k = 1; k <= NR; k++) {
                split(line[k], f, " ")
                true = f[4] > limit ? (f[4] - limit) / f[4] : f[4] ? (limit - f[4]) / f[4] : 0
                printf "%s,%s,%s,%s,%.6f,%.6f,%.3e,%.3e,%.2f,%s,%s\n", scene, f[1], f[2], f[3], f[4], limit, true,
                    f[5], true ? f[5] / true : 0, f[6], f[7]
            }
        }' "$work/levels" >>"$table"
    say "$scene"
done
