#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Plots and the table of the growth, from outside: every format opens, the table is the report's steps.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
cd "$work" || exit 1

rib_script >rib.knit
cat >>rib.knit <<'TEXT'
solve { steps = 3; accuracy = 5% }
output report "r.json"
output plot "a.svg"
output plot "a.pdf" { show = convergence; width = 400 }
output plot "a.png" { scale = log }
output "t.csv"
TEXT
exits 0 'plots and a table' "$WEFT" -q rib.knit
check 'the report names them' sh -c 'for f in a.svg a.pdf a.png t.csv; do grep -q "\"$f\"" r.json || exit 1; done'
same_again 'a.svg a.pdf a.png t.csv' "$WEFT" -q rib.knit

# The report's own digits, seven numbers a step.
sed -n '/"steps":[[:space:]]*\[/,/\]/s/.*":[[:space:]]*\([-0-9][^,]*\),*$/\1/p' r.json | paste -d , - - - - - - - >steps
check 'there are three steps' test "$(wc -l <steps)" -eq 3
check 'the table has their names' sh -c 'head -n 1 t.csv | grep -qx "$1"' - \
    'growth,energy,stretching,bending,springs,iterations,gradient_max'
check 'and their numbers' sh -c 'tail -n +2 t.csv | cmp - steps'

opens a.pdf pdftoppm -r 20 -png a.pdf page
opens a.svg rsvg-convert a.svg -o svg.png
opens a.png pngtopnm a.png

# ---- what a plot does not know, and runs that end early ----

sed 's/scale = log/shows = energy/' rib.knit >wrong.knit
exits 3 'another key' "$WEFT" check wrong.knit
err 'is not known' "output plot of a run has no key 'shows'"
err 'with the nearest' "did you mean 'show'"
sed 's/steps = 3/steps = 3; max_iterations = 2/' rib.knit >short.knit
exits 1 'a run that does not converge' "$WEFT" -q short.knit -o plot:short.svg
check 'is plotted, too' test -s short.svg

# ---- a script with a sweep ----

{ printf 'param c = 0.2 in 0..1\nstitch K { kx = -c; ky = c }\nsweep c in [0.1, 0.2]\n'; grep -v '^output report' rib.knit | sed 's/show = convergence; //'; } >s.knit
rm a.svg t.csv
exits 0 'a plain run of it' "$WEFT" s.knit -o own.csv
out 'leaves the plots to the sweep' 'a.svg is of `weft sweep`'
check 'and does not write them' test ! -e a.svg -a ! -e t.csv
check 'but what it is asked for' test -s own.csv

finish
