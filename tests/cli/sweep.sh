#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft sweep: a folder for each point, one table, points that are done, points that fail.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cat >"$work/s.knit" <<'KNIT'
param c = 0.5 in 0..2
param n = 2 in 1..4
param high = 2 in 1..4
stitch K { kx = -c; ky = c }
swatch each (x, y) in 2*n by high : x < n ? K : P
sweep c in [0, 0.5], n in 1..2
solve { steps = 2 }
output "s-{n}.stl"
KNIT
here=$PWD
cd "$work" || exit 1
value() { "$here/tests/cli/json" "$1" "$2"; }
column() { awk -F , -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i } NR > 1 { print $at }' s.sweep/table.csv; }

# ---- all points ----

exits 0 'a sweep' "$WEFT" sweep s.knit -j 2
out 'counts its points' '^4 points: 4 converged, 0 ended otherwise, 0 missing$'
check 'a line for each' test "$(grep -c '^\[[1-4]/4\] .*: converged$' err)" = 4
holds 'a folder for each, and the table' s.sweep table.csv table.jsonl \
    1-c=0-n=1 2-c=0-n=2 3-c=0.5-n=1 4-c=0.5-n=2 \
    1-c=0-n=1/log.txt 1-c=0-n=1/point.json 1-c=0-n=1/report.json 1-c=0-n=1/report.manifest.json 1-c=0-n=1/s-1.stl \
    2-c=0-n=2/log.txt 2-c=0-n=2/point.json 2-c=0-n=2/report.json 2-c=0-n=2/report.manifest.json 2-c=0-n=2/s-2.stl \
    3-c=0.5-n=1/log.txt 3-c=0.5-n=1/point.json 3-c=0.5-n=1/report.json 3-c=0.5-n=1/report.manifest.json \
    3-c=0.5-n=1/s-1.stl 4-c=0.5-n=2/log.txt 4-c=0.5-n=2/point.json 4-c=0.5-n=2/report.json \
    4-c=0.5-n=2/report.manifest.json 4-c=0.5-n=2/s-2.stl
check 'the last param varies fastest' test "$(column c | tr '\n' ' ')$(column n | tr '\n' ' ')" = '0 0 0.5 0.5 1 2 1 2 '
"$WEFT" run s.knit -q -D c=0.5 -D n=2 -j 1 --no-manifest -o one.json -o one.stl
check 'a point is the run with its params' cmp one.stl s.sweep/4-c=0.5-n=2/s-2.stl
check 'its energy stands in the table' test "$(column energy.total | sed -n 4p)" = "$(value one.json energy.total)"
check 'and in the lines' grep -q "^{\"point\":4,.*\"c\":0.5,\"n\":2.*\"status\":\"converged\"" s.sweep/table.jsonl

# ---- a point is repeated like any run ----

exits 0 'a point by its manifest' "$WEFT" run --from s.sweep/4-c=0.5-n=2/report.manifest.json
out 'comes out the same' '^all 2 outputs are identical$'
mkdir sub
sed 's/^output.*/output table "t.csv"/' s.knit >sub/t.knit
exits 0 'a point of a script elsewhere, with options' "$WEFT" sweep sub/t.knit -q --point 2 --seed 3 --steps=4 -D high=3 -o x.obj -j1 --into o
exits 0 'by its manifest' "$WEFT" run --from o/2-c=0-n=2/report.manifest.json
out 'with all its outputs' '^all 3 outputs are identical$'
is_command='["run","sub/t.knit","-D","high=3","-D","c=0","-D","n=2","--seed","3","--steps","4","-o","x.obj","-o","report:report.json"]'
check 'it is a plain run' test "$(value o/2-c=0-n=2/report.manifest.json command.arguments)" = "$is_command"

exits 0 'a plain run of a script with a table' "$WEFT" run sub/t.knit -j 1
out 'says whose it is' '^t.csv is of `weft sweep`$'
check 'and leaves it' test ! -e t.csv
exits 0 'a run asked for one' "$WEFT" run s.knit -q -j 1 -o t.csv
check 'writes its own steps' grep -q '^growth,energy,' t.csv

# ---- what is done is not done again ----

cp -r s.sweep before
exits 0 'the same sweep again' "$WEFT" sweep s.knit -j 2
out 'finds all done' '^4 of 4 points were done before$'
check 'and the same table' cmp s.sweep/table.csv before/table.csv
check 'nothing is touched' test ! s.sweep/1-c=0-n=1/report.json -nt before/table.csv
rm s.sweep/3-*/point.json
exits 0 'a point that is not finished' "$WEFT" sweep s.knit -j 2
check 'is the only one to run' test "$(grep -c converged err)" = 1
check 'to the same lines' cmp s.sweep/table.jsonl before/table.jsonl
exits 0 'with other threads, from another folder' sh -c 'mkdir there && cd there && "$1" sweep ../s.knit -q -j 1' - "$WEFT"
check 'to the same lines, too' cmp there/s.sweep/table.jsonl before/table.jsonl
: >plain
exits 4 'into a file' "$WEFT" sweep s.knit --into plain
err 'is not possible' "^weft: the folder 'plain' cannot be made: Not a directory$"
exits 0 'another setting' "$WEFT" sweep s.knit -q -j 2 --seed 7
check 'runs all again' test "$(column solve.seed | sort -u)" = 7

# ---- on many machines ----

rm -rf s.sweep
exits 0 'commands' "$WEFT" sweep s.knit --print --into 'two words'
cp out commands
check 'one for each point' test "$(wc -l <commands)" = 4
check 'nothing is made' test ! -e s.sweep
exits 1 'nothing to collect yet' "$WEFT" sweep s.knit --collect --into 'two words'
out 'all are missing' '^4 points: 0 converged, 0 ended otherwise, 4 missing$'
check 'they run in any order' sh -c 'sort -r commands | sh -e >log 2>&1'
exits 0 'collected' "$WEFT" sweep s.knit --collect --into 'two words'
check 'into the same table' cmp 'two words/table.csv' before/table.csv

# ---- what goes wrong ----

sed 's/sweep c.*/sweep n in 1..3/; s/2\*n by high/(n == 2 ? 5 : 2*n) by high/; s/x < n/(n == 3 \&\& x == 1 ? z : x < n)/' s.knit >bad.knit
exits 1 'a point with an error in the script' "$WEFT" sweep bad.knit -j 2
out 'ends otherwise, the others are there' '^3 points: 2 converged, 1 ended otherwise, 0 missing$'
check 'is an error in the table' grep -q '^3,3,error,' bad.sweep/table.csv
check 'and in the lines' grep -q '"status":"error","report":null' bad.sweep/table.jsonl
check 'its log says why' grep -q 'error:' bad.sweep/3-n=3/log.txt
sed 's/steps = 2/steps = 2; max_iterations = 3/' s.knit >short.knit
exits 1 'points that do not converge' "$WEFT" sweep short.knit -q -j 2
check 'are recorded as such' test "$(cut -d , -f 4 short.sweep/table.csv | sort -u | tr '\n' ' ')" = 'converged iteration_limit solve.status '
sed '/^sweep/d' s.knit >none.knit
exits 3 'no sweep' "$WEFT" sweep none.knit
err 'is said' 'there is no sweep in this script'
exits 2 'standard input' "$WEFT" sweep -
exits 2 'a point that is not there' "$WEFT" sweep s.knit --point 5
err 'says how many there are' 'has 4 points, there is no point 5'
exits 2 'a point that is none' "$WEFT" sweep s.knit --point 0
exits 4 'a folder that cannot be made' "$WEFT" sweep s.knit --into missing/folder
exits 2 'a param that -D sets, too' "$WEFT" sweep s.knit -D c=1
err 'is said to be of the sweep' '-D c: the sweep of s.knit sets this param'
exits 2 'two things at a time' "$WEFT" sweep s.knit --print --collect
err 'are too many' 'of --print, --point and --collect a sweep takes one'
rm -rf s.sweep && mkdir s.sweep && touch s.sweep/1-c=0-n=1
exits 4 'a folder that is none' "$WEFT" sweep s.knit -j 1
err 'stops the sweep' 'the point s.sweep/1-c=0-n=1 cannot be started: Not a directory'
check 'at once' test ! -e s.sweep/2-c=0-n=2

# ---- tables of the script's own; what changes a result and what does not ----

sed 's/^output.*/output table "own.csv"/' s.knit >own.knit
exits 0 'a table of its own' "$WEFT" sweep own.knit -j 2
check 'is the table' cmp own.csv own.sweep/table.csv
sed '1i # The same with a comment, and its table elsewhere.
    s/own.csv/other.csv/' own.knit >changed && mv changed own.knit
exits 0 'a comment and another table' "$WEFT" sweep own.knit -j 2
out 'change no point' '^4 of 4 points were done before$'
check 'and write the table' cmp own.csv other.csv
echo 'output "s.stl"' >>own.knit
exits 1 'another output' "$WEFT" sweep own.knit --collect
out 'is another sweep' '4 missing (4 of them of another script, other settings or outputs)$'
exits 0 'a run of a script with a sweep' "$WEFT" run own.knit
err 'says what it is not' 'own.knit has a sweep of 4 points.*`weft sweep own.knit` runs all'
rm own.csv other.csv
exits 0 'no words' "$WEFT" run own.knit -q
empty 'where none are wanted' err
check 'and no table of one point' test ! -e other.csv

# ---- names of folders ----

sed 's/^sweep.*/sweep c in 0.4..0.8 by 0.1/' s.knit >tenths.knit
exits 0 'steps of a tenth' "$WEFT" sweep tenths.knit --print
exits 0 'the fourth' "$WEFT" sweep tenths.knit -q --point 4
check 'is 0.7' test -d tenths.sweep/4-c=0.7

# ---- plots of the script's own ----

sed 's/^output.*/output plot "x.svg"\noutput plot "y.svg" { field = "shape.extent_x"; kind = curves }/' s.knit >drawn.knit
exits 0 'plots' "$WEFT" sweep drawn.knit -q -j 2
check 'two params are a map' grep -q '<svg' x.svg
check 'or curves' sh -c 'grep -q "<svg" y.svg && ! cmp -s x.svg y.svg'
sed -i 's/extent_x/extend_x/' drawn.knit
exits 3 'a field that is none' "$WEFT" sweep drawn.knit
err 'is seen before any work' "drawn.knit:[0-9]*: error: a report has no number 'shape.extend_x'; did you mean shape.extent_x?"
sed -i 's/^sweep.*/sweep c in [0, 0.5]/; s/shape.extend_x"; kind = curves/energy.bending"; kind = map/' drawn.knit
exits 3 'a map of one param' "$WEFT" sweep drawn.knit
err 'is none' 'a plot shows two params as a map, and the sweep has 1'
sed -i 's/kind = map/scale = linear/' drawn.knit
exits 0 'a curve of one' "$WEFT" sweep drawn.knit -q -j 2

# ---- files elsewhere ----

mkdir -p lib motifs elsewhere
echo 'motif small = each (x, y) in 4 by 2 : x < 2 ? K : P' >lib/small.knit
echo 'KKPP' >motifs/grid.txt
printf 'use "small.knit"\nuse "grid.txt" as g\nparam t = 1 in 0..2\nmaterial { thickness = t }\nswatch above(g, small)\nsweep t in 0.5..1 by 0.5\n' \
    >motifs/used.knit
cd elsewhere || exit 1
exits 0 'script, used files and results in other folders' "$WEFT" sweep ../motifs/used.knit -I ../lib --into ../results -o sub/x.stl
check 'are found from here' test -s ../results/2-t=1/sub/x.stl -a -s ../results/table.csv
check 'and nothing is written here' test -z "$(ls)"
cd ..

# ---- progress ----

on_terminal() {
    TERM=xterm script -q -e -c "'$WEFT' sweep s.knit -j 1 --into shown.sweep" typescript >shown 2>&1 </dev/null
}
if command -v script >/dev/null 2>&1 && TERM=xterm script -q -e -c true /dev/null >/dev/null 2>&1 </dev/null; then
    check 'on a terminal' on_terminal
    tr '\r' '\n' <shown | grep '^\[#*-*\]' | sed "s/$(printf '\033')\[K.*//" >bars
    check 'a bar shows how many points are done' grep '^\[-*\] 0 of 4 points, 1 running' bars
    check 'of 80 columns at most' awk 'length > 79 { bad = 1 } END { exit bad }' bars
    check 'points that are well need no line' sh -c '! grep "converged$" shown'
else
    skip 'on a terminal' 'no script program'
fi

finish
