#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The state of a fold, and the fold that begins there.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
here=$PWD
cd "$work" || exit 1
value() { "$here/tests/cli/json" "$1" "$2"; }

cat >rib.knit <<'KNIT'
param t = 0.5 in 0.1..1
param n = 8 in 1..20
param k = 1 in 0..1
stitch K { kx = -k; ky = k }
material { thickness = t }
swatch tile(beside(tile(K, 2, 1), tile(P, 2, 1)), 2, n)
mesh { per_stitch = 1 }
KNIT

exits 0 'a fold that leaves its state' "$WEFT" run rib.knit -q -j 1 -D t=0.4 -o near.state
check 'in a file that says what it is' test "$(head -c 13 near.state)" = 'weft state 1'
check 'listed in the manifest' test "$(value rib.manifest.json outputs.0.path)" = near.state
"$WEFT" run rib.knit -q -j 1 -o grown.json
exits 0 'a fold that begins there' "$WEFT" run rib.knit -j 1 --start near.state -o r.json -o r.pvd -o r.state
err 'does not grow' '^growth 1.00 '
out 'in one step' 'r.pvd and its 2 steps'
check 'is in the same minimum' awk "BEGIN { d = $(value r.json energy.total) / $(value grown.json energy.total) - 1; exit !(d * d < 1e-16) }"
check 'with fewer iterations' test "$(value r.json solve.iterations)" -lt "$(value grown.json solve.iterations)"
check 'its report says so' test "$(value r.json solve.growth_steps)" = 1

# ---- by its manifest ----

check 'the state is one of its sources' test "$(value r.manifest.json sources.1.path)" = near.state
check 'with its hash' test "$(value r.manifest.json sources.1.sha256)" = "$(sha256sum <near.state | sed 's/ .*//')"
exits 0 'it is repeated' "$WEFT" run --from r.manifest.json
out 'with all its outputs' '^all 5 outputs are identical$'
exits 0 'with nothing to do' "$WEFT" run rib.knit -j 1 --start near.state -o r.json -o r.pvd -o r.state --cached
out 'it does nothing' 'unchanged'
cp r.state near.state
exits 0 'with another state of that name' "$WEFT" run rib.knit -v -j 1 --start near.state -o r.json -o r.pvd -o r.state --cached
err 'it is run' "^weft: note: not cached: 'near.state' changed$"
echo more >>near.state
exits 4 'a state that was changed' "$WEFT" run --from r.manifest.json
err 'is named' "'near.state' is not the file the run was made with: its SHA-256 differs"
exits 4 'and cannot be started from' "$WEFT" run rib.knit -q --start near.state
err 'as it is damaged' "^weft: cannot start from 'near.state': this is no state of a fold, or a damaged one$"
rm near.state
exits 4 'a state that is gone' "$WEFT" run --from r.manifest.json
err 'is named, too' "the state 'near.state' that the run began from cannot be read: No such file or directory"

# ---- what is none ----

exits 4 'a state that is not there' "$WEFT" run rib.knit -q --start nowhere.state
err 'is said' "^weft: cannot start from 'nowhere.state': No such file or directory$"
: >empty.state
exits 4 'an empty one' "$WEFT" run rib.knit -q --start empty.state
printf 'weft state 1\n8 8 -1\n' >wrong.state
exits 4 'one of a negative size' "$WEFT" run rib.knit -q --start wrong.state
printf 'weft state 1\n8 8 2000000000\n' >wrong.state
exits 4 'one that is cut off' "$WEFT" run rib.knit -q --start wrong.state
exits 1 'a state of another swatch' "$WEFT" run rib.knit -D n=9 --start r.state
out 'fails with the reason' 'failed; the state to start from is of a flat sheet, or of another number of stitches or another mesh'
exits 1 'one of another mesh' "$WEFT" run rib.knit -q --discretisation triangle --start r.state
exits 0 'a flat sheet' "$WEFT" run rib.knit -q -D k=0 -o flat.state
exits 1 'is nowhere to start from' "$WEFT" run rib.knit -q --start flat.state
exits 0 'and needs no start' "$WEFT" run rib.knit -q -D k=0 --start r.state
exits 2 'to start and to go on' "$WEFT" run rib.knit --start r.state --resume
err 'are two things' '^weft: --start begins where another fold ended: --resume does not go with it$'
exits 2 'to start, from several seeds' "$WEFT" run rib.knit --start r.state --seeds 3
exits 2 'to start a repeated run elsewhere' "$WEFT" run --from r.manifest.json --start r.state

finish
