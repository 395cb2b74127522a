#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run time against error: scenes x (discretisation, cells a stitch, method), one thread.
# The true energy is extrapolated from independent tight runs of the patches, each level
# with the last ones' order: E4 - (E2 - E4)^2 / ((E1 - E2) - (E2 - E4)).
# The baseline is the paper's way: libLBFGS on triangles of one mesh, ten growth steps.
. "${srcdir:-.}/bench/lib.sh"
table=$results/accuracy.csv
echo "scene,discretisation,per_stitch,method,steps,tolerance,unknowns,energy,error,gradient,iterations,evaluations,factorisations,cpu_s,wall_s,peak_mib,runs,status" >"$table"
references=$results/references.csv
echo "scene,energy_1,energy_2,energy_4,limit" >"$references"

reference()     # scene -> sets limit
{
    : >"$work/levels"
    for cells in 1 2 4; do
        once "$(with_settings "$scenes/$1.knit" "solve { tolerance = 1e-11 }")" --steps 1 --per-stitch $cells --method newton \
            -q -o "report:$report"
        figure energy.total >>"$work/levels"
    done
    awk -v scene="$1" '{ e[NR] = $1 } END {
        a = e[1] - e[2]
        b = e[2] - e[3]
        limit = e[3]
        if (b > 0 && a > b)
            limit -= b * b / (a - b)
        printf "%s,%.8f,%.8f,%.8f,%.8f\n", scene, e[1], e[2], e[3], limit }' \
        "$work/levels" >>"$references"
    limit=$(tail -n 1 "$references" | cut -d , -f 5)
}

point()         # scene, discretisation, cells, method, steps, tolerance
{
    measure "$(with_settings "$scenes/$1.knit" "solve { tolerance = $6; max_iterations = 1000000 }")" --discretisation "$2" \
        --per-stitch "$3" --method "$4" --steps "$5" -j 1
    energy=$(figure energy.total)
    status=$(figure solve.status)
    [ "$ended" != 124 ] || status="time limit"
    echo "$1,$2,$3,$4,$5,$6,$(figures discretisation.unknowns energy.total),$(awk -v e="${energy:-nan}" -v l="$limit" \
        'BEGIN { if (e != "nan") printf "%.3e", (e > l ? e - l : l - e) / l }'),$(figures solve.gradient_max solve.iterations \
        solve.evaluations solve.factorisations),$cpu,$wall,$(figures memory.peak_bytes | awk '{ if ($1) printf "%.0f", $1 / 1048576 }'),$runs,$status" >>"$table"
    say "$(tail -n 1 "$table")"
}

for scene in ${BENCH_SCENES:-rib2x2 seed miura miura_2x2}; do
    reference "$scene"
    for cells in 1 2 4; do
        point "$scene" patch $cells auto 10 1e-8
    done
    point "$scene" patch 1 auto 1 1e-8
    for cells in 2 4 8; do
        point "$scene" triangle $cells auto 10 1e-8
    done
    for cells in 2 4; do
        point "$scene" triangle $cells lbfgs 10 1e-5
    done
    # At eight cells a stitch the converged baseline is within one percent of a Miura's energy, after many minutes.
    case $scene${BENCH_LARGE:-} in
    miura* | *1) point "$scene" triangle 8 lbfgs 10 1e-5 ;;
    esac
done
