#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The stated error estimate of each scene against its true error, at one and at
# two patches a stitch; the true energy is extrapolated from four (order two at
# the least: a quarter of the last change is left, so a third of it is taken off).
. "${srcdir:-.}/bench/lib.sh"
table=$results/estimate.csv
echo "scene,energy_1,energy_2,energy_4,limit,true_1,stated_1,ratio_1,true_2,stated_2,ratio_2,status_4,cpu_1_s,cpu_2_s,cpu_4_s" >"$table"
BENCH_RUNS=1
for scene in bars basketweave chains checkerboard columns garter miura peaks rib2x2 seed squiggles stockinette weave; do
    : >"$work/levels"
    for cells in 1 2 4; do
        measure "$scenes/$scene.knit" --steps 1 --per-stitch $cells -j 1
        echo "$cpu $(figure energy.total) $(figure energy.error_estimate) $(figure solve.status)" >>"$work/levels"
    done
    awk -v scene=$scene '
        { t[NR] = $1; e[NR] = $2; stated[NR] = $3; status = $4 }
        END {
            limit = e[3] - (e[2] - e[3]) / 3
            true1 = (e[1] - limit) / e[1]
            true2 = (e[2] - limit) / e[2]
            printf "%s,%.6f,%.6f,%.6f,%.6f,%.3e,%.3e,%.2f,%.3e,%.3e,%.2f,%s,%.2f,%.2f,%.2f\n", scene, e[1], e[2], e[3], limit,
                true1, stated[1], stated[1] / true1, true2, stated[2], stated[2] / true2, status, t[1], t[2], t[3]
        }' "$work/levels" >>"$table"
    say "$(tail -n 1 "$table")"
done
