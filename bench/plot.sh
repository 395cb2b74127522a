#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws what tables there are.
. "${srcdir:-.}/bench/lib.sh"
command -v gnuplot >/dev/null 2>&1 || {
    echo "bench: no gnuplot, so no plots (Debian: gnuplot-nox); the tables are in $results" >&2
    exit 0
}
gnuplot -e "results='$results'; form='${BENCH_FORM:-svg}'" "$bench/plot.gp"
