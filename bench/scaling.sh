#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Swatches of a hundred stitches and more: what time, memory and unknowns grow like.
. "${srcdir:-.}/bench/lib.sh"
table=$results/scaling.csv
echo "scene,columns,rows,stitches,unknowns,iterations,factorisations,cpu_s,wall_s,peak_mib,runs,status" >"$table"
BENCH_LIMIT=3600
sizes="10x10 18x18 32x32 56x57 100x100"
[ -z "${BENCH_LARGE:-}" ] || sizes="$sizes 178x178 300x333"
for pattern in stockinette rib_2x2; do
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
