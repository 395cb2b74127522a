#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A run that is killed goes on where it was, to the same bytes.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# Every growth step takes a while.
cat >"$work/x.knit" <<'KNIT'
motif checks { Row 1: *k2, p2; rep from * to end
  Row 2: *k2, p2; rep from * to end
  Row 3: *p2, k2; rep from * to end
  Row 4: *p2, k2; rep from * to end }
param half = 1
swatch fill(checks, 12, 12)
mesh  { per_stitch = 1 }
solve { steps = 30 }
output "x.pvd"
output "x.vtp"
output "x.glb"
output "r.json"
KNIT
[ ! -s "$WEFT_SOURCE/viewer/template.html" ] || echo 'output "x.html"' >>"$work/x.knit"
mkdir "$work/whole" "$work/killed"

# in FOLDER WORDS...: runs weft there, with two threads.
in_folder() {
    folder=$1
    shift
    (cd "$work/$folder" && exec "$WEFT" run ../x.knit -j 2 "$@")
}

# sums FOLDER: all files but the report, and what of that is not time or memory.
sums() {
    (
        cd "$work/$1" || exit 1
        find . -type f ! -name r.json -exec sha256sum {} + | sort
        grep -v -e '_s":' -e peak_bytes r.json
    )
}

exits 0 'a run to its end' in_folder whole
check 'leaves no checkpoint' test ! -e "$work/whole/r.checkpoint"

# Killed once the fifth step stands.
(cd "$work/killed" && exec "$WEFT" run ../x.knit -j 2 >/dev/null 2>&1) &
job=$!
await test -e "$work/killed/x_05.vtp"
kill -s KILL "$job"
wait "$job" 2>/dev/null
check 'killed' test ! -e "$work/killed/r.json"
check 'its checkpoint stays' test -s "$work/killed/r.checkpoint"
find "$work/killed" -name '.weft-*' -exec rm {} +
cp "$work/killed/r.checkpoint" "$work/kept"

exits 4 'with another param it is refused' in_folder killed --resume -D half=2
err 'with the reason' "cannot go on from 'r.checkpoint': it is of another script, other parameters"
exits 4 'with another number of threads, too' in_folder killed --resume -j 1
check 'and stays as it was' cmp "$work/kept" "$work/killed/r.checkpoint"

exits 0 'it goes on' in_folder killed --resume
err 'from the last step' '^weft: going on after growth 0.[0-9]*, from r.checkpoint$'
sums whole >"$work/wanted"
sums killed >"$work/got"
check 'to the same bytes' diff "$work/wanted" "$work/got"
check 'and the checkpoint is gone' test ! -e "$work/killed/r.checkpoint"

# The last record cut off: from the step before, to the same bytes.
head -c -100 "$work/kept" >"$work/killed/r.checkpoint"
exits 0 'cut off half-way' in_folder killed --resume
err 'it goes on, too' '^weft: going on after growth 0.[0-9]*, from r.checkpoint$'
sums killed >"$work/got"
check 'to the same bytes again' diff "$work/wanted" "$work/got"
: >"$work/killed/r.checkpoint"
exits 0 'an empty one' in_folder killed --resume
sums killed >"$work/got"
check 'is none' diff "$work/wanted" "$work/got"
exits 0 'none there' in_folder killed --resume
err 'is said' 'there is no r.checkpoint to go on from: the run begins anew'

# Stopped politely it says what can be done.
(cd "$work/killed" && exec "$WEFT" run ../x.knit -j 2 -q --steps 2000 2>"$work/err") &
job=$!
await test -e "$work/killed/x_0003.vtp"
kill -s TERM "$job"
status=0
wait "$job" || status=$?
check 'stopped: exit status 1' test "$status" = 1
err 'stopped: says so' 'stopped after [0-9]* of 2000 growth steps; .*; --resume goes on from there'
check 'stopped: keeps the checkpoint' test -s "$work/killed/r.checkpoint"

finish
