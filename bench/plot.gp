# SPDX-License-Identifier: GPL-3.0-or-later
# The benchmarks' tables in, SVG plots out: gnuplot -e "results='bench/results'; form='svg'" plot.gp
set datafile separator ","
if (form eq "png") set terminal pngcairo size 720,480 font "Sans,11"; else set terminal svg size 720,480 font "Sans,12" background "white"
file(name) = results . "/" . name . "." . form
set grid lw 0.5 lc rgb "#dddddd"
set format x "10^{%L}"
set format y "10^{%L}"
set logscale xy
set key outside right top vertical samplen 2 spacing 1.2
set tics nomirror
set border 3

# rows of a table with these words in it, as a path
rows(table, words) = "< awk -F, -v words='" . words . "' 'BEGIN { n = split(words, w, \" \") } { for (i = 1; i <= n; i++) { split(w[i], c, \"=\"); if ($c[1] != c[2]) next } print }' " . results . "/" . table . ".csv"

blue = "#1b6ca8"; red = "#c0392b"; green = "#2e8b57"; grey = "#666666"

set output file("accuracy")
set xlabel "CPU seconds, one thread"
set ylabel "relative error of the energy"
set title "Miura, 12 x 23 stitches, and its 2 x 2 tiling"
set xrange [0.05:*]
plot rows("accuracy", "1=miura 2=patch 4=auto 5=10") using 14:9 with linespoints lc rgb blue pt 7 title "patches", \
     rows("accuracy", "1=miura 2=triangle 4=auto") using 14:9 with linespoints lc rgb green pt 5 title "triangles", \
     rows("accuracy", "1=miura 2=triangle 4=lbfgs") using 14:9 with linespoints lc rgb red pt 9 title "plain libLBFGS", \
     rows("accuracy", "1=miura_2x2 2=patch 4=auto 5=10") using 14:9 with linespoints lc rgb blue pt 6 dt 2 title "2 x 2: patches", \
     rows("accuracy", "1=miura_2x2 2=triangle 4=auto") using 14:9 with linespoints lc rgb green pt 4 dt 2 title "2 x 2: triangles", \
     rows("accuracy", "1=miura_2x2 2=triangle 4=lbfgs") using 14:9 with linespoints lc rgb red pt 8 dt 2 title "2 x 2: plain libLBFGS", \
     0.01 with lines lc rgb grey dt 3 title "1 %"
set xrange [*:*]

set output file("gradient")
set xlabel "CPU seconds, one thread"
set ylabel "largest gradient component / (Y h^2)"
set title "Miura, 12 x 23 stitches, triangles, two cells a stitch"
plot for [m = 1:4] rows("gradient", "1=miura 2=triangle 3=2 4=" . word("lbfgs plbfgs newton auto", m)) using 11:6 with linespoints \
     lc rgb word(red . " " . blue . " " . green . " " . grey, m) pt 6 + m title word('"plain libLBFGS" preconditioned Newton auto', m)

set output file("scaling")
set xlabel "stitches"
set ylabel "CPU seconds; MiB"
set title "One patch a stitch, one growth step, one thread"
plot rows("scaling", "1=stockinette") using 4:8 with linespoints lc rgb blue pt 7 title "stockinette, s", \
     rows("scaling", "1=rib_2x2") using 4:8 with linespoints lc rgb green pt 5 title "2x2 rib, s", \
     rows("scaling", "1=stockinette") using 4:10 with linespoints lc rgb blue pt 6 dt 2 title "stockinette, MiB", \
     rows("scaling", "1=rib_2x2") using 4:10 with linespoints lc rgb green pt 4 dt 2 title "2x2 rib, MiB", \
     6e-4 * x with lines lc rgb grey dt 3 title "n", \
     1e-5 * x ** 1.5 with lines lc rgb grey dt 4 title "n^{1.5}"

set output file("estimate")
unset logscale
set logscale xy
set xlabel "true relative error of the energy"
set ylabel "stated"
set title "Stated error against true error, thirteen scenes"
set key left top inside
set xrange [5e-5:0.2]
set yrange [5e-5:0.2]
plot rows("estimate", "") using 6:7 with points lc rgb blue pt 7 title "one patch a stitch", \
     rows("estimate", "") using 9:10 with points lc rgb green pt 5 title "2 x 2 patches a stitch", \
     x with lines lc rgb grey dt 3 title "equal"
set output

set output file("converge")
set xlabel "cells along a stitch's side"
set ylabel "relative error of the energy"
set title "Patches (filled) and triangles (open) come to one energy"
unset format x
set xtics (1, 2, 4, 8)
set key outside right top
set xrange [0.9:9]
set yrange [1e-4:2]
plot for [k = 1:4] rows("converge", "1=" . word("rib2x2 checks seed miura", k) . " 2=patch") using 3:7 with linespoints \
     lc rgb word(blue . " " . green . " " . red . " " . grey, k) pt 7 title word("rib2x2 checks seed miura", k) . ", patches", \
     for [k = 1:4] rows("converge", "1=" . word("rib2x2 checks seed miura", k) . " 2=triangle") using 3:($3 > 1 ? $7 : NaN) with linespoints \
     lc rgb word(blue . " " . green . " " . red . " " . grey, k) pt 6 dt 2 title word("rib2x2 checks seed miura", k) . ", triangles"
set output
