#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What each file of the full Miura costs to write.
. "${srcdir:-.}/bench/lib.sh"
program=$PWD/bench/write
table=$PWD/$results/write.csv
cat >"$work/scene.knit" <<'KNIT'
use miura from std
swatch tile(miura, 4, 4)
solve { steps = 10; accuracy = 50%; tolerance = 0.001 }
output "binary.vtp"
output "ascii.vtp" { format = ascii }
output "steps.pvd"
output "miura.glb"
output "miura.ply"
output "miura.stl"
output "miura.obj"
output "iso.png"
output "chart.png" { chart = on; color = mean; edges = on }
output "iso.svg"
output "iso.pdf"
output "miura.html"
output chart "chart.svg"
output chart "chart.pdf"
output chart "chart.k"
KNIT
[ -s "$srcdir/viewer/template.html" ] || sed -i '/html/d' "$work/scene.knit"
(cd "$work" && "$program" scene.knit >"$table")
cat "$table" >&2
