#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft sweep --warm: the energies of the sweep from flat, with fewer iterations; a fabric that snaps is seen.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
here=$PWD
cd "$work" || exit 1
value() { "$here/tests/cli/json" "$1" "$2"; }

# column FOLDER NAME: of its table.
column() { awk -F , -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i } NR > 1 && at { print $at }' "$1/table.csv"; }

# one_minimum FOLDER FOLDER: do the tables have the same energies?
one_minimum() {
    column "$1" energy.total >one
    column "$2" energy.total >two
    paste one two | awk '{ d = $1 / $2 - 1; bad += d > 1e-8 || d < -1e-8; n++ } END { exit bad > 0 || n == 0 }'
}

# iterations FOLDER: of all its folds.
iterations() { for report in "$1"/*/report.json; do value "$report" solve.iterations; done | awk '{ n += $1 } END { print n }'; }

# tables FOLDER: what does not depend on threads.
tables() { (cd "$1" && cat table.csv table.jsonl && sha256sum ./*/fold.state); }

# ---- one shape from end to end ----

cat >rib.knit <<'KNIT'
param t = 0.4 in 0.1..1
material { thickness = t }
swatch tile(beside(tile(K, 2, 1), tile(P, 2, 1)), 3, 12)
mesh { per_stitch = 1 }
sweep t in 0.3..0.5 by 0.05
KNIT
exits 0 'a sweep' "$WEFT" sweep rib.knit -q -j 2 --into flat
check 'says nothing of starts' test -z "$(column flat start)"
check 'and leaves no state' test -z "$(find flat -name '*.state')"
exits 0 'with --warm' "$WEFT" sweep rib.knit --warm -j 2 --into warm
out 'has all points' '^5 points: 5 converged, 0 ended otherwise, 0 missing$'
check 'the same energies' one_minimum warm flat
check 'fewer iterations, checks included' test "$(iterations warm)" -lt "$(iterations flat)"
check 'the ends begin flat, the others at their neighbours' \
    test "$(column warm start | tr '\n' ' ')" = 'flat 1-t=0.3 2-t=0.35-from-1 3-t=0.4-from-1 flat '
check 'the ends alone are checked' test "$(column warm checked | tr '\n' ' ')" = 'true false false false true '
check 'the lines say so, too' grep -q '"folder":"3-t=0.4-from-1","params":{"t":0.4},"start":"2-t=0.35-from-1","checked":false,' warm/table.jsonl
exits 0 'again' "$WEFT" sweep rib.knit --warm -j 2 --into warm
out 'all are done' '^5 of 5 points were done before$'
empty 'and nothing runs' err
exits 0 'one at a time' "$WEFT" sweep rib.knit --warm -q -j 1 --into one.sweep
tables warm >wanted
tables one.sweep >got
check 'to the same bytes' diff wanted got
exits 0 'collected' "$WEFT" sweep rib.knit --warm --collect --into warm
tables warm >got
check 'to the same table' diff wanted got

# ---- a point begun at its neighbour, by its manifest ----

point=warm/3-t=0.4-from-1
is_command='["run","rib.knit","-D","t=0.4","-o","report:report.json","-o","state:fold.state","--start","warm/2-t=0.35-from-1/fold.state"]'
check 'it is a plain run' test "$(value $point/report.manifest.json command.arguments)" = "$is_command"
exits 0 'it is repeated' "$WEFT" run --from $point/report.manifest.json
out 'to the same bytes' '^all 2 outputs are identical$'
mv warm/2-t=0.35-from-1/fold.state kept
exits 4 'without the state' "$WEFT" run --from $point/report.manifest.json
err 'it is asked for' "the state 'warm/2-t=0.35-from-1/fold.state' that the run began from cannot be read"
cp $point/fold.state warm/2-t=0.35-from-1/
exits 4 'with another state' "$WEFT" run --from $point/report.manifest.json
err 'it is refused' 'is not the file the run was made with'
exits 1 'the table' "$WEFT" sweep rib.knit --warm --collect --into warm
out 'is not of it' '^5 points: 2 converged, 0 ended otherwise, 3 missing$'
exits 0 'the sweep' "$WEFT" sweep rib.knit --warm -q -j 2 --into warm
check 'folds it again' cmp kept warm/2-t=0.35-from-1/fold.state
tables warm >got
check 'to the same bytes' diff wanted got

# ---- a fabric that snaps ----

# The wider curvature wins: the roll turns by a right angle at 1, or, begun at a neighbour, later.
cat >snap.knit <<'KNIT'
param r = 1 in 0..3
stitch K { kx = -0.6; ky = 0.6 * r }
swatch tile(K, 8, 8)
mesh { per_stitch = 1 }
sweep r in 0.6..1.6 by 0.1
KNIT
exits 0 'a fabric with two shapes' "$WEFT" sweep snap.knit -q -j 2 --into snap.flat
exits 0 'warm' "$WEFT" sweep snap.knit --warm -q -j 2
check 'has the shapes it has from flat' one_minimum snap.sweep snap.flat
check 'and not all of the shapes it came to' awk "BEGIN { exit !($(value snap.sweep/07-r=1.2-from-1/report.json energy.total) > 1.2 * $(column snap.flat energy.total | sed -n 7p)) }"
check 'the one where it snapped is known' test "$(value snap.sweep/08-r=1.3-from-1/point.json leads_back) $(value snap.sweep/07-r=1.2-from-1/point.json leads_back)" = 'false true'
check 'some points begin at neighbours nevertheless' column snap.sweep start grep -q from

# ---- killed ----

if command -v setsid >/dev/null 2>&1; then
    setsid "$WEFT" sweep snap.knit --warm -q -j 2 --into killed >/dev/null 2>&1 &
    job=$!
    await sh -c 'test "$(ls killed/*-from-1/point.json 2>/dev/null | wc -l)" -ge 2'
    kill -s KILL -- "-$job"
    wait "$job" 2>/dev/null
    check 'killed' test ! -e killed/table.csv
    stat -c %Y.%i killed/02-*-from-1/report.json >kept
    exits 0 'it goes on' "$WEFT" sweep snap.knit --warm -q -j 2 --into killed
    check 'with what was done' test "$(cat kept)" = "$(stat -c %Y.%i killed/02-*-from-1/report.json)"
    tables snap.sweep | sed 's/snap.sweep/killed/' >wanted
    tables killed >got
    check 'to the same bytes' diff wanted got
else
    skip 'killed' 'no setsid'
fi

# ---- points that fail ----

cat >fails.knit <<'KNIT'
param limit = 100 in 1..10000
param n = 1 in 1..9
swatch tile(K, n == 6 ? z : 4, 4)
mesh { per_stitch = 1 }
solve { max_iterations = limit }
sweep n in [1, 6], limit in [900, 2, 800, 1000, 700]
KNIT
exits 1 'points that fail' "$WEFT" sweep fails.knit --warm -q -j 2
check 'leave the others, chain by chain' \
    test "$(column fails.sweep solve.status | tr '\n' ' ')" = 'converged iteration_limit converged converged converged error error error error error '
check 'which begin flat' test "$(column fails.sweep start | sort -u)" = flat
sed 's/tile(K.*/tile(K, n, 4)/; s/sweep n.*/sweep n in 1..5/' fails.knit | sed '/^solve/d' >sizes.knit
exits 0 'another size at each point' "$WEFT" sweep sizes.knit --warm -j 2
check 'is begun at a neighbour in vain' grep -q '2-n=2-from-1: no minimum from there; folds from flat$' err
check 'and then flat' test "$(column sizes.sweep start | sort -u)" = flat

# ---- what does not go together ----

exits 2 '--print' "$WEFT" sweep rib.knit --warm --print
err 'has no commands that run in any order' '^weft: --warm: a point waits for its neighbours; --print lists commands that run in any order$'
exits 2 '--seeds' "$WEFT" sweep rib.knit --warm --seeds 3
err 'has no use' 'has no use for --seeds'
exits 2 '--walk without --warm' "$WEFT" sweep rib.knit --point 3 --walk 1
exits 2 '--walk without --point' "$WEFT" sweep rib.knit --warm --walk 1
exits 2 '--walk from a later point' "$WEFT" sweep rib.knit --warm --point 1 --walk 3
exits 2 '--walk from another chain' "$WEFT" sweep fails.knit --warm --point 6 --walk 3
err 'is refused' '^weft: --walk goes with --warm and a later --point that differs in the last param alone$'

finish
