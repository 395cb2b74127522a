#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft run --cached: a run whose outputs stand as they were is skipped, any other is not.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cd "$work" || exit 1
echo 'motif ribs = beside(tile(K, 1, 1), tile(P, 1, 1))' >lib.knit
cat >x.knit <<'KNIT'
use "lib.knit"
param n = 2
swatch tile(ribs, n, 3)
solve { steps = 2 }
output "x.vtp"
output "x.pvd"
output "x.json"
KNIT
x() { "$WEFT" run x.knit -j 1 --cached "$@"; }
marks() { stat -c '%n %.9Y %.9Z %s %i' x.vtp x.pvd x_0?.vtp x.json x.manifest.json; }

# skips NAME OPTION...: nothing is folded, nothing written.
skips() {
    what=$1
    shift
    marks >before
    exits 0 "$what" x "$@"
    marks >after
    check "$what: nothing is written" cmp before after
}

# runs REASON NAME OPTION...: it is folded, all is written, and the reason said.
runs() {
    reason=$1
    what=$2
    shift 2
    marks >before 2>/dev/null
    exits 0 "$what" x -v "$@"
    err "$what: the reason" "^weft: note: not cached: $reason$"
    marks >after
    check "$what: all is written" test -z "$(cut -d ' ' -f 1,2 before after | sort | uniq -d)"
}

# ---- skipped ----

runs 'there is no x.manifest.json' 'the first run'
cp -p x.json first.json
skips 'the same again'
out 'it says so' '^x.knit: unchanged, its 6 outputs are as they were (x.manifest.json)$'
check 'and nothing else' test "$(cat out err | wc -l)" = 1
skips 'quietly' -q
empty 'says nothing' out
skips 'what changes no output may differ' -v --color never --diagnostics json -W error
out 'skipped still' 'unchanged'
exits 0 'without --cached it is folded' "$WEFT" run x.knit -qj1
skips 'and skipped after that'
sed 's/"total_s":	/&1/' x.json >y && mv y x.json
skips 'the time in a report is not compared'
mkdir elsewhere
exits 0 'from another folder it is another run' sh -c "cd elsewhere && \"$WEFT\" ../x.knit -qj1 --cached"
check 'with outputs of its own' test -s elsewhere/x.json
exits 0 'its manifest' "$WEFT" run -q --from x.manifest.json
out 'is good for --from' '^all 6 outputs are identical$'

# ---- not skipped: the script ----

echo '# a word more' >>x.knit
runs "'x.knit' changed" 'a comment more'
echo '# here, too' >>lib.knit
runs "'lib.knit' changed" 'a used file changed'
cp x.knit x.was
sed 's/, n, 3)/, n, 4)/' x.was >x.knit
runs "'x.knit' changed" 'other stitches'
cp x.was x.knit
runs "'x.knit' changed" 'as it was before'

# ---- the command ----

runs 'other parameters' 'another -D' -D n=1
runs 'other parameters' 'the value of the script again'
runs 'other parameters' 'another --steps' --steps 3
rm x_03.vtp
runs 'other parameters' 'back again'
runs 'other parameters' 'another --seed' --seed 7
runs 'another number of threads' 'another -j' --seed 7 -j 2
runs 'another number of seeds' '--seeds' --seed 7 -j 2 --seeds 2
skips '--seeds again' --seeds=2 --seed=7 -qj2
runs 'other outputs (-o)' 'one output more' --seed 7 -j 2 --seeds 2 -o one.obj
runs 'other outputs (-o)' 'another output' --seed 7 -j 2 --seeds 2 -o one.stl
runs 'other outputs (-o)' 'without it' --seed 7 -j 2 --seeds 2
runs 'other parameters' 'as at first'

# ---- the outputs ----

sed '3s/^/ /' x_01.vtp >y && mv y x_01.vtp
runs "'x_01.vtp' changed" 'an output edited'
rm x.vtp
runs "'x.vtp' is missing" 'an output removed'
sed 's/"unknowns":	/&1/' x.json >y && mv y x.json
runs "'x.json' changed" 'a number in the report edited'
sed 's/"total":	-*\(.*\),$/"total":	\11,/' x.json >y
check 'another last digit' test "$(cmp -s x.json y; echo $?)" = 1
mv y x.json
runs "'x.json' changed" 'the last digit of the energy edited'
echo '{}' >>x.json
runs "'x.json' changed" 'a report with more behind it'
: >x.json
runs "'x.json' changed" 'an empty report'

# ---- the manifest ----

cp x.manifest.json good
# damaged SCRIPT REASON NAME: the manifest edited by sed.
damaged() {
    sed "$1" good >x.manifest.json
    check "$3: differs" test "$(cmp -s good x.manifest.json; echo $?)" = 1
    runs "$2" "$3"
    check "$3: a good one stands there" cmp good x.manifest.json
}
damaged 's/"build_id":	"./&0/' 'it was another build of weft' 'another build'
damaged 's/"cholmod":	"/&0./' 'other libraries' 'another library'
damaged 's/"processor":	"/&z/' 'another machine' 'another machine'
damaged 's/"manifest":	1/"manifest":	0/' 'x.manifest.json: .* of another form (0) than .*' 'another form of manifest'
damaged '20,$d' 'x.manifest.json: this is no manifest of weft' 'a manifest cut off'
damaged 's/.*//' 'x.manifest.json: this is no manifest of weft' 'an empty manifest'
damaged 's/"status":	"[a-z]*"/"status":	"saddle"/' 'it did not converge' 'a bad status'
damaged 's/"outputs":/"elsewhere":/' "'x.vtp' is not in x.manifest.json" 'no outputs'
damaged 's/"path":	"x_01.vtp"/"path":	0/' "'' is missing" 'an output without a path'
damaged 's/"lasting_sha256":/"lasting":/' "'x.json' changed" 'an output without a hash'
damaged 's/"sources":/"springs":/' 'it uses other files' 'no sources'
damaged 's/"threads":	1/"threads":	"1"/' 'another number of threads' 'threads in words'
damaged 's/"arguments":	\[/&4, /' 'x.manifest.json: its command is damaged' 'a word that is none'
skips 'undamaged it is skipped'

# ---- what is never cached ----

cat >bad.knit <<'KNIT'
use rib_2x2 from std
swatch fill(rib_2x2, 4, 4)
solve { max_iterations = 1; steps = 1 }
mesh { per_stitch = 1 }
output "bad.json"
KNIT
exits 1 'a run that does not converge' "$WEFT" run bad.knit --cached
exits 1 'does not converge again' "$WEFT" run bad.knit --cached -v
err 'and is not skipped' '^weft: note: not cached: it did not converge$'
exits 0 'a script that writes nothing' sh -c 'echo "swatch K" >none.knit; "$0" run none.knit --cached -v' "$WEFT"
err 'runs' '^weft: note: not cached: nothing is written$'
ln -s /dev/null null.obj
for time in first second; do
    exits 0 "a script from standard input, the $time time" sh -c '"$0" run - --cached -v -o s.obj <none.knit' "$WEFT"
    err 'runs' '^weft: note: not cached: the script is standard input$'
    exits 0 "an output that is no plain file, the $time time" "$WEFT" run none.knit --cached -v -o n.obj -o null.obj
    out 'runs' '^none.knit: converged'
done
err 'and says so' "^weft: note: not cached: 'null.obj' is no plain file$"
exits 0 'the same' "$WEFT" run none.knit -o n.stl
exits 0 'without it' "$WEFT" run none.knit --cached -o n.stl
out 'is skipped' '^none.knit: unchanged, its output is as it was (none.manifest.json)$'
exits 0 'with --dry-run' "$WEFT" run none.knit --cached -o n.stl --dry-run
out 'nothing would be done' 'unchanged'
exits 3 'a script with an error' sh -c 'echo "swatch Q" >none.knit; "$0" run none.knit --cached -o n.obj' "$WEFT"
exits 2 'without a manifest' "$WEFT" run x.knit --cached --no-manifest
err 'there is nothing to go by' '^weft: --cached goes by the manifest: --no-manifest does not go with it$'
exits 2 'with --from' "$WEFT" run --from x.manifest.json --cached
err 'it is refused' '^weft: --from repeats a run as it was: --cached does not go with it$'

finish
