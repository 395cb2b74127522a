#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft run --seeds: what is listed, what is kept, what is written.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cat >"$work/rib.knit" <<'KNIT'
motif rib { Row 1: *k2, p2; rep from * to end }
swatch fill(rib, 4, 3)
solve { steps = 2; seed = 5 }
KNIT
here=$PWD
value() { "$here/tests/cli/json" "$1" "$2"; }

# ---- one minimum ----

mkdir "$work/set"
report=$work/set/r.json
exits 0 'three seeds' "$WEFT" run "$work/rib.knit" --seeds 3 -j 1 -o "$report" -o "$work/set/x.pvd"
check 'a line for each' test "$(grep -c '^seed [567]: energy [0-9.]*, converged$' "$work/out")" = 3
out 'they agree' '^the energies agree to 1e-8; kept seed [567]$'
kept=$(sed -n 's/.*kept seed //p' "$work/out")
check 'the report lists them' test "$(value "$report" seeds.2.seed)" = 7
check 'with their energies' test "$(value "$report" seeds.$((kept - 5)).energy)" = "$(value "$report" energy.total)"
check 'with their status' test "$(value "$report" seeds.0.status)" = converged
check 'the report is of the kept one' test "$(value "$report" solve.seed)" = "$kept"
check 'the setting stays the one in the file' test "$(value "$report" parameters.seed.value)" = 5
holds 'the outputs are of one run' "$work/set" r.json r.manifest.json x.pvd x_00.vtp x_01.vtp x_02.vtp

exits 0 'the kept seed alone' "$WEFT" run "$work/rib.knit" --seed "$kept" -q -j 1 -o "$work/one.vtp"
check 'folds to the same bytes' cmp "$work/one.vtp" "$work/set/x_02.vtp"
exits 0 'quiet' "$WEFT" run "$work/rib.knit" --seeds 2 -q
empty 'prints no list' "$work/out"
exits 0 'one seed' "$WEFT" run "$work/rib.knit" --seeds 1 -j 1 -o "$work/r1.json"
check 'is a plain run' test "$(grep -c '^seed' "$work/out")" = 0

# ---- none ----

cat >"$work/no.knit" <<'KNIT'
motif rib { Row 1: *k2, p2; rep from * to end }
swatch fill(rib, 8, 8)
solve { steps = 1; max_iterations = 3 }
KNIT
exits 1 'no seed ends in a minimum' "$WEFT" run "$work/no.knit" --seeds 2 -o "$work/no.json"
out 'is said' '^0 of 2 seeds found a minimum'
check 'the report says so' test "$(value "$work/no.json" seeds.1.status)" = iteration_limit

# ---- wrong ----

exits 2 'no seeds' "$WEFT" run "$work/rib.knit" --seeds 0
err 'says the range' 'seeds from 1 to 1000'
exits 2 'not a number' "$WEFT" run "$work/rib.knit" --seeds many
exits 2 'of another command' "$WEFT" check "$work/rib.knit" --seeds 2
exits 0 'dry run' "$WEFT" run "$work/rib.knit" --seeds 4 --dry-run
out 'says how many' '^4 seeds$'

finish
