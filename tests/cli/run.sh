#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft run: what is written, what is said, and how it ends.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cat >"$work/rib.knit" <<'KNIT'
param n = 4 in 2..8 "stitches"
motif rib { Row 1: *k2, p2; rep from * to end }
swatch fill(rib, n, 3)
solve { steps = 3 }
KNIT
here=$PWD
value() { "$here/tests/cli/json" "$1" "$2"; }

# ---- outputs ----

mkdir "$work/all"
exits 0 'every kind of output' "$WEFT" run "$work/rib.knit" -o "$work/all/x.pvd" -o "$work/all/y.vtp" \
    -o "$work/all/z.obj" -o "$work/all/r.json" -o chart:"$work/all/c.txt" -j 1
out 'says how it ended' ': converged'
out 'says the energy' '^energy [0-9.]'
out 'says what was written' '^wrote .*x.pvd and its 4 steps, .*y.vtp, .*z.obj, .*r.json, .*c.txt; manifest .*r.manifest.json$'
err 'says how far it is' '^growth 1.00 '
check 'a few lines of progress' test "$(wc -l <"$work/err")" -le 10
holds 'all that and no more is there' "$work/all" x.pvd x_00.vtp x_01.vtp x_02.vtp x_03.vtp y.vtp z.obj z.mtl r.json r.manifest.json c.txt
check 'the report is JSON' value "$work/all/r.json" schema
check 'of a fold that converged' test "$(value "$work/all/r.json" solve.status)" = converged
check 'in three steps' test "$(value "$work/all/r.json" solve.growth_steps)" = 3
check 'with one thread' test "$(value "$work/all/r.json" solve.threads)" = 1
check 'that names the other files' test "$(value "$work/all/r.json" outputs.0.path)" = "$work/all/c.txt"
check 'with their hashes' test "$(value "$work/all/r.json" outputs.0.sha256)" = "$(sha256sum <"$work/all/c.txt" | cut -d ' ' -f 1)"
check "the script's hash" test "$(value "$work/all/r.json" scene.sha256)" = "$(sha256sum <"$work/rib.knit" | cut -d ' ' -f 1)"
"$WEFT" chart --grid "$work/rib.knit" >"$work/grid"
check "the grid's hash" test "$(value "$work/all/r.json" scene.grid_sha256)" = "$(sha256sum <"$work/grid" | cut -d ' ' -f 1)"
check 'the chart is the grid' diff "$work/grid" "$work/all/c.txt"
check 'the last step is the final state' cmp "$work/all/x_03.vtp" "$work/all/y.vtp"

# The same again elsewhere: the same bytes, but for the report's times.
mkdir "$work/again"
(cd "$work/again" && "$WEFT" "$work/rib.knit" -q -j1 -o x.pvd -o y.vtp -o z.obj -o r.json -o chart:c.txt) >"$work/out" 2>"$work/err"
empty 'quiet run prints nothing' "$work/out"
empty 'and says nothing' "$work/err"
for file in x.pvd x_00.vtp x_03.vtp y.vtp z.obj z.mtl c.txt; do
    check "$file is the same twice" cmp "$work/all/$file" "$work/again/$file"
done
for key in scene parameters discretisation energy solve shape steps; do
    check "the report's $key is the same twice" test "$(value "$work/all/r.json" $key)" = "$(value "$work/again/r.json" $key)"
done

# ---- what the command line changes ----

mkdir "$work/set"
report=$work/set/r.json
exits 0 'options of the solve' "$WEFT" run "$work/rib.knit" -q -D n=8 --steps 2 --seed 7 --per-stitch 1 \
    --accuracy 5% --method newton -o "$report"
check 'param' test "$(value "$report" parameters.n.value)" = 8
check 'where it is from' test "$(value "$report" parameters.n.from)" = 'command line'
check 'columns' test "$(value "$report" scene.columns)" = 8
check 'steps' test "$(value "$report" solve.growth_steps)" = 2
check 'seed' test "$(value "$report" solve.seed)" = 7
check 'per stitch' test "$(value "$report" discretisation.per_stitch)" = 1
check 'method' test "$(value "$report" parameters.method.value)" = newton
check 'accuracy' test "$(value "$report" parameters.accuracy.value)" = 0.05
check 'a default says so' test "$(value "$report" parameters.thickness.from)" = default

exits 2 'an unknown param' "$WEFT" run "$work/rib.knit" -D m=3 -o "$work/set/no.json"
err 'is named' "'m'"
exits 2 'a param out of range' "$WEFT" run "$work/rib.knit" -D n=9
err 'says the range' '2.*8'
exits 2 'no step at all' "$WEFT" run "$work/rib.knit" --steps 0
exits 2 'a method that is not there' "$WEFT" run "$work/rib.knit" --method magic
exits 3 'an error in the script' sh -c 'echo "swatch nothing" | "$1" run -' - "$WEFT"
exits 4 'a script that is not there' "$WEFT" "$work/none.knit"
holds 'none of these wrote anything' "$work/set" r.json r.manifest.json

# ---- outputs that cannot be written: said before any work ----

exits 2 'a chart that there is not' "$WEFT" run "$work/rib.knit" -o "chart:$work/set/x.dxf"
err 'says which there are' 'its extension is one of: .txt, .svg'
empty 'before it starts' "$work/out"
printf 'output chart "x.dxf"\n' | cat "$work/rib.knit" - >"$work/chart.knit"
exits 3 'a chart that there is not, in the script' "$WEFT" run "$work/chart.knit"
err 'has its place' "chart.knit:5:14: error: a chart cannot be written as 'x.dxf'"
exits 4 'a folder that is not there' "$WEFT" run "$work/rib.knit" -o "$work/none/x.pvd"
err 'is named' "there is no folder '.*/none'"
exits 4 'a folder that is a file' "$WEFT" run "$work/rib.knit" -o "$work/rib.knit/x.vtp"
mkdir "$work/folder.json"
exits 4 'an output that is a folder' "$WEFT" run "$work/rib.knit" -o "$work/folder.json"
holds 'and nothing was written' "$work/set" r.json r.manifest.json

# ---- outputs that fail later ----

mkdir "$work/full"
echo old >"$work/full/x.vtp"
if sanitized "$WEFT"; then
    skip 'under a limit of memory' 'the address sanitizer needs more'
else
    exits 1 'under a limit of memory' timeout -s KILL 60 sh -c 'ulimit -v 200000; exec "$@"' - "$WEFT" run "$work/x.knit" -q -j 1
    err 'says how much is needed' 'limited to 195 MB (ulimit -v); to fold on 1 thread takes 384 MB'
fi

exits 4 'a disk that gets full' sh -c 'ulimit -f 4; trap "" XFSZ; exec "$1" run "$2" -q -o "$3/x.vtp"' - \
    "$WEFT" "$work/rib.knit" "$work/full"
err 'is said' "cannot write '.*x.vtp': File too large"
holds 'nothing half-written is left' "$work/full" x.vtp
check 'the old file stands' test "$(cat "$work/full/x.vtp")" = old
exits 4 'a summary that cannot be printed' sh -c '"$1" run "$2" >&-' - "$WEFT" "$work/rib.knit"

# ---- devices, and a run that writes nothing ----

ln -s /dev/null "$work/null.vtp"
exits 0 'a device' "$WEFT" run "$work/rib.knit" -q -o "$work/null.vtp"
check 'stays a device' test -c "$work/null.vtp"
if [ -e /dev/stdout ]; then
    ln -s /dev/stdout "$work/stdout.json"
    exits 0 'report to standard output' "$WEFT" run "$work/rib.knit" -q -o "$work/stdout.json"
    cp "$work/out" "$work/r.json"
    check 'is JSON' value "$work/r.json" schema
else
    skip 'report to standard output' 'no /dev/stdout'
fi
exits 0 'nothing to write' "$WEFT" run "$work/rib.knit"
out 'is said' 'nothing written'
exits 0 'dry run' "$WEFT" run "$work/rib.knit" --dry-run -o "$work/set/dry.vtp"
out 'says the size' '4 stitches x 3 rows, 3 growth steps'
out 'guesses time and memory' '^about [0-9.]* s, [0-9.]* GB$'
exits 0 'dry run of the run above' "$WEFT" run "$work/rib.knit" --dry-run -D n=8 --per-stitch 1
out 'knows the unknowns' "^1 per stitch: $(value "$report" discretisation.unknowns) unknowns, $(value "$report" discretisation.elements) elements"
holds 'writes nothing' "$work/set" r.json r.manifest.json
printf 'use seed from std\nswatch fill(seed, 8, 8)\n' >"$work/seed.knit"
exits 0 'fine seed stitch' "$WEFT" run "$work/seed.knit" -q --steps 1 --accuracy 3% -o "$work/seed.json"
exits 0 'dry run of it' "$WEFT" run "$work/seed.knit" --steps 1 --accuracy 3% --dry-run
out 'foresees the finer mesh' "^2 per stitch (as a sample of the swatch takes): $(value "$work/seed.json" discretisation.unknowns) unknowns"

finish
