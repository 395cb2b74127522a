#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# All benchmarks, their plots and a summary; tables go to bench/results of the build tree.
#   BENCH_RUNS=3      runs of which a median is taken
#   BENCH_LARGE=1     scaling up to a hundred thousand stitches
#   BENCH="a b"       these parts alone
set -eu
srcdir=${srcdir:-.}
export srcdir
begin=$(date +%s)
for part in ${BENCH:-limits skip estimate converge scaling gradient accuracy warm write}; do
    [ -f "$srcdir/bench/$part.sh" ] || continue
    echo "== $part" >&2
    sh "$srcdir/bench/$part.sh"
done
if [ -f "$srcdir/bench/plot.sh" ]; then sh "$srcdir/bench/plot.sh"; fi
if [ -f "$srcdir/bench/summary.sh" ]; then sh "$srcdir/bench/summary.sh"; fi
echo "bench: $(($(date +%s) - begin)) seconds" >&2
