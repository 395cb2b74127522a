#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Swatches of a hundred stitches and more: what time, memory and unknowns grow like.
BENCH_LIMIT=${BENCH_LIMIT:-3600}
. "${srcdir:-.}/bench/lib.sh"
table=$results/scaling.csv
echo "scene,columns,rows,stitches,unknowns,iterations,factorisations,cpu_s,wall_s,peak_mib,runs,status" >"$table"
sizes="12x8 20x16 32x32 56x56 100x100"
[ -z "${BENCH_LARGE:-}" ] || sizes="$sizes 180x176 300x332"
for pattern in rib_2x2 stockinette; do
    for size in $sizes; do
        columns=${size%x*}
        rows=${size#*x}
        printf 'use %s from std\nswatch fill(%s, %s, %s)\n' $pattern $pattern "$columns" "$rows" >"$work/scaling.knit"
        measure "$work/scaling.knit" --steps 1 --per-stitch 1 -j 1
        echo "$pattern,$columns,$rows,$((columns * rows)),$(figures discretisation.unknowns solve.iterations \
            solve.factorisations),$cpu,$wall,$(figures memory.peak_bytes | awk '{ if ($1) printf "%.0f", $1 / 1048576 }'),$runs,$(figure solve.status)" >>"$table"
        say "$(tail -n 1 "$table")"
    done
done
