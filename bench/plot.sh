#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the tables, once all are there.
. "${srcdir:-.}/bench/lib.sh"
command -v gnuplot >/dev/null 2>&1 || {
    echo "bench: no gnuplot, so no plots (Debian: gnuplot-nox); the tables are in $results" >&2
    exit 0
}
for table in accuracy converge estimate gradient scaling; do
    [ -f "$results/$table.csv" ] || { say "bench: no plots, as $table.csv is not there yet"; exit 0; }
done
gnuplot -e "results='$results'; form='${BENCH_FORM:-svg}'" "$bench/plot.gp"
