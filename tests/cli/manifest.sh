#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The manifest beside a run, and the run that it repeats.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

json() { tests/cli/json "$@"; }
is() { check "$1" test "$(json "$2" "$3")" = "$4"; }

mkdir -p "$work/a/sub" "$work/tmp"
TMPDIR=$work/tmp
export TMPDIR
cat >"$work/a/sub/lib.knit" <<'KNIT'
motif ribs(w) = beside(tile(K, w, 1), tile(P, w, 1))
KNIT
printf 'k,p\n' >"$work/a/sub/chart.csv"
cat >"$work/a/sub/rib.knit" <<'KNIT'
use "lib.knit"
use "chart.csv"
param w = 2
swatch above(tile(ribs(w), 2, 6), tile(chart, 2 * w, 1))
solve { steps = 3 }
output "out/x.glb"
output "out/x.pvd"
output report "out/r.json"
output "c.txt"
KNIT
mkdir "$work/a/out"

# in FOLDER WORDS...: runs weft there.
in_folder() {
    folder=$1
    shift
    (cd "$folder" && "$WEFT" "$@")
}
m=$work/a/out/r.manifest.json

echo '{}' >"$work/empty.json"

# ---- what it says ----

exits 0 'a run' in_folder "$work/a" sub/rib.knit -q -D w=1 -j 2
holds 'its manifest stands beside the report' "$work/a/out" x.glb x.pvd x_00.vtp x_01.vtp x_02.vtp x_03.vtp r.json r.manifest.json
is 'version' "$m" weft "$("$WEFT" version | sed 's/weft //')"
check 'compiler' json "$m" compiler
check 'libraries' json "$m" libraries.cholmod
if LC_ALL=C readelf -n "$WEFT" >"$work/notes" 2>/dev/null && grep -q 'Build ID' "$work/notes"; then
    is 'the build' "$m" build_id "$(sed -n 's/.*Build ID: //p' "$work/notes")"
else
    skip 'the build' 'no readelf, or a linker without build ids'
fi
is 'the command' "$m" command.arguments '["sub/rib.knit","-q","-D","w=1","-j","2"]'
is 'its folder' "$m" command.folder ..
is 'threads' "$m" command.threads 2
is 'the script' "$m" sources.0.sha256 "$(sha256sum <"$work/a/sub/rib.knit" | sed 's/ .*//')"
is 'what it uses' "$m" sources.1.path sub/lib.knit
is 'a chart it uses' "$m" sources.2.path sub/chart.csv
is 'with its hash' "$m" sources.2.sha256 "$(sha256sum <"$work/a/sub/chart.csv" | sed 's/ .*//')"
is 'with its hash' "$m" sources.1.sha256 "$(sha256sum <"$work/a/sub/lib.knit" | sed 's/ .*//')"
is 'the grid' "$m" scene.grid_sha256 "$(in_folder "$work/a" chart --grid sub/rib.knit -D w=1 | sha256sum | sed 's/ .*//')"
is 'parameters' "$m" parameters.w.from 'command line'
is 'the seed' "$m" seed 1
is 'outputs' "$m" outputs.0.path c.txt
is 'with their hashes' "$m" outputs.0.sha256 "$(sha256sum <"$work/a/c.txt" | sed 's/ .*//')"
cp "$m" "$work/first.json"
exits 0 'again' in_folder "$work/a" sub/rib.knit -q -D w=1 -j 2
check 'the same run has the same manifest' cmp "$m" "$work/first.json"

mkdir "$work/b"
printf 'swatch tile(K, 3, 3)\n' >"$work/flat.knit"
exits 0 'a run without a report' in_folder "$work" flat.knit -o b/x.stl
holds 'its manifest is called like the script' "$work/b" x.stl flat.manifest.json
out 'and named' 'wrote b/x.stl; manifest b/flat.manifest.json$'
exits 0 'one without a manifest' in_folder "$work" flat.knit -q -o b/x.stl --no-manifest
exits 0 'one that writes nothing' in_folder "$work" flat.knit
check 'leaves none' test ! -e "$work/flat.manifest.json"

# ---- the same again ----

sums() { (cd "$work/a" && find . -type f -exec sha256sum {} + | sort); }
sums >"$work/before"
exits 0 'repeated' "$WEFT" run --from "$m"
out 'it says so of each' '^out/x_01.vtp: the same$'
out 'and of the report, with what is not compared' '^out/r.json: the same, but for time, memory, path and threads$'
out 'and in all' '^all 8 outputs are identical$'
sums >"$work/after"
check 'what the first run wrote is not touched' cmp "$work/before" "$work/after"
exits 0 'with another number of threads, into a folder' "$WEFT" run -q -j 1 --from "$m" --into "$work/c"
check 'which has them all' cmp "$work/a/out/x.glb" "$work/c/out/x.glb"
check 'and no second manifest' test ! -e "$work/c/out/r.manifest.json"
mkdir "$work/d"
cp "$m" "$work/a/sub/"* "$work/d"
exits 0 'elsewhere, the script beside it' "$WEFT" run -q --from "$work/d/r.manifest.json"
out 'the same' '^all 8 outputs are identical$'

# ---- and what is not the same ----

sed 's/"lasting_sha256":	"./"lasting_sha256":	"x/' "$m" >"$work/a/out/wrong.json"
exits 1 'a report that differs' "$WEFT" run --from "$work/a/out/wrong.json"
out 'is named' '^out/r.json: differs$'
out 'and counted' '^7 of 8 outputs are identical$'
sed 's,"path":	"c.txt",&x,;s,c.txt"x,d.txt",' "$m" >"$work/a/out/wrong.json"
exits 1 'an output that was not written' "$WEFT" run -q --from "$work/a/out/wrong.json"
out 'is named, too' '^d.txt: was not written$'
sed 's/"build_id":	"./&x/' "$m" >"$work/a/out/wrong.json"
exits 0 'another build' "$WEFT" run -q --from "$work/a/out/wrong.json"
err 'is said' 'made by another build'
sed 's/"cholmod":	"/&0./; s/"processor":	"/&z/' "$m" >"$work/a/out/wrong.json"
exits 0 'another library, another processor' "$WEFT" run -q --from "$work/a/out/wrong.json"
err 'is said' "^weft: note: made with cholmod '0.*', this is '.*'; bytes may differ$"
err 'of each' "^weft: note: made with processor 'z.*', this is"
check 'and nothing else' test "$(wc -l <"$work/err")" = 2
if objcopy --remove-section=.note.gnu.build-id "$WEFT" "$work/without" 2>/dev/null; then
    echo 'swatch K' >"$work/w.knit"
    exits 0 'a program without a build id' "$work/without" run "$work/w.knit" -q -o "$work/w.json"
    is 'is told by its own hash' "$work/w.manifest.json" build_id "$(sha256sum "$work/without" | sed 's/ .*//')"
else
    skip 'a program without a build id' 'no objcopy'
fi
echo '# more' >>"$work/d/lib.knit"
exits 4 'a file that was changed' "$WEFT" run --from "$work/d/r.manifest.json"
err 'is named' "'lib.knit' is not the file the run was made with"
echo 'Row 1: k1' >"$work/another.knit"
exits 4 'another script' "$WEFT" run --from "$m" "$work/another.knit"
err 'is seen before it is read' "another.knit' is not the file the run was made with"
check 'and its errors say nothing' test "$(wc -l <"$work/err")" = 1
for option in -Dw=2 --steps=3 -ox.stl --seeds=2 --resume --dry-run -Werror; do
    exits 2 "$option" "$WEFT" run --from "$m" "$option"
    err 'would make it another run' '^weft: --from repeats a run as it was: .* does not go with it$'
done
exits 4 'into a file' "$WEFT" run -q --from "$m" --into "$work/empty.json"
err 'is not possible' "cannot write into '.*empty.json': Not a directory"
rm "$work/d/rib.knit"
exits 4 'a script that is gone' "$WEFT" run --from "$work/d/r.manifest.json"
err 'is asked for' 'its script .sub/rib.knit. is neither where it was'
exits 0 'and may be named' "$WEFT" run -q --from "$work/d/r.manifest.json" "$work/a/sub/rib.knit"
exits 4 'no manifest' "$WEFT" run --from "$work/empty.json"
err 'is said' 'this is no manifest of weft'
exits 4 'none there' "$WEFT" run --from "$work/nowhere.json"
exits 2 '--into without --from' "$WEFT" run "$work/flat.knit" --into "$work/x"
holds 'nothing is left in the temporary folder' "$work/tmp"

finish
