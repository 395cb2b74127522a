#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep that is stopped or killed keeps what is complete, and goes on to the same bytes.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
cd "$work" || exit 1

for program in setsid pgrep; do
    command -v $program >/dev/null 2>&1 && continue
    skip 'a sweep that is stopped' "no $program"
    finish
    exit
done

# Points one and two are flat and done at once; of the others every growth step takes a while.
cat >s.knit <<'KNIT'
param c = 0.5 in 0..2
stitch K { kx = -c; ky = c }
motif checks { Row 1: *k2, p2; rep from * to end
  Row 2: *k2, p2; rep from * to end
  Row 3: *p2, k2; rep from * to end
  Row 4: *p2, k2; rep from * to end }
swatch c < 0.1 ? K : fill(checks, 12, 12)
mesh  { per_stitch = 1 }
solve { steps = 250 }
sweep c in [0.01, 0.02, 0.5, 0.6]
output "x.pvd"
output "x.glb"
KNIT

# begin WORDS...: starts the sweep in a group of its own, until short points are done and a long one is under way.
begin() {
    setsid "$@" "$WEFT" sweep s.knit -j 2 >out 2>err &
    job=$!
    await sh -c 'test "$(ls s.sweep/[12]-*/point.json s.sweep/3-*/x_005.vtp 2>/dev/null | wc -l)" -ge 3'
}

# gone: no process works on the sweep any more.
gone() {
    tries=0
    while pgrep -g "$job" >/dev/null && [ "$tries" -lt 100 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    ! pgrep -g "$job"
}

# ends_with STATUS: waits for the job.
ends_with() {
    status=0
    wait "$job" 2>/dev/null || status=$?
    test "$status" = "$1"
}

# sums FOLDER: of all files but the logs, and of the reports what is not time or memory.
sums() {
    (
        cd "$1" || exit 1
        find . -type f ! -name report.json ! -name log.txt -exec sha256sum {} + | sort
        cat ./*/report.json | grep -v -e '_s":' -e peak_bytes
    )
}

exits 0 'a sweep to its end' "$WEFT" sweep s.knit -q -j 2 --into whole
sums whole >wanted
check 'leaves no checkpoint' test -z "$(find whole -name '*.checkpoint')"

# goes_on NAME: the same command comes to what a sweep in one go came to.
goes_on() {
    find s.sweep -name '.weft-*' -exec rm {} +
    check "$1: a point under way has its steps" test -s s.sweep/3-c=0.5/report.checkpoint
    exits 0 "$1: the same command again" "$WEFT" sweep s.knit -j 2
    check "$1: goes on from them" grep -q '^weft: going on after growth 0.*, from s.sweep/3-c=0.5/report.checkpoint$' s.sweep/3-c=0.5/log.txt
    sums s.sweep >got
    check "$1: to the same bytes" diff wanted got
    check "$1: complete points are not run again" test "$(cat kept)" = "$(stat -c %Y.%i s.sweep/1-c=0.01/report.json)"
    rm -r s.sweep
}

# stopped NAME: what a sweep that was told to stop leaves and says.
stopped() {
    check "$1: exit status 1" ends_with 1
    err "$1: says how to go on" 'stopped; the same command goes on'
    out "$1: and what is there" '^4 points: 2 converged, 0 ended otherwise, 2 missing$'
    check "$1: its points are stopped, too" gone
    check "$1: they say so" grep -q 'stopped after.*; the sweep goes on from there' s.sweep/3-c=0.5/log.txt
    check "$1: nothing is half-written" test -z "$(find s.sweep -name '.*' -type f)"
    check "$1: the table has what is complete" test "$(cut -d , -f 1,3 s.sweep/table.csv | tr '\n' ' ')" = 'point,solve.status 1,converged 2,converged 3,missing 4,missing '
    stat -c %Y.%i s.sweep/1-c=0.01/report.json >kept
}

begin
kill "$job"
stopped TERM
goes_on TERM

# Ctrl-C goes to all processes of a terminal's group; a shell's background jobs ignore it.
if env --default-signal=INT true 2>/dev/null; then
    begin env --default-signal=INT
    kill -s INT -- "-$job"
    stopped INT
    goes_on INT
else
    skip INT 'env cannot undo that it is ignored'
fi

begin
kill -s KILL "$job"
check 'KILL: the sweep is gone' ends_with 137
check 'KILL: its points stop of their own accord' gone
stat -c %Y.%i s.sweep/1-c=0.01/report.json >kept
goes_on KILL

begin
kill -s KILL -- "-$job"
check 'KILL of all: they are gone' ends_with 137
stat -c %Y.%i s.sweep/1-c=0.01/report.json >kept
cp -r s.sweep other
goes_on 'KILL of all'

# What others began is begun anew.
touch other/3-c=0.5/.weft-1-0.part
exits 0 'with other settings' "$WEFT" sweep s.knit --into other -j 2 --steps 20
check 'it is begun anew' test "$(grep -c 'going on' other/3-c=0.5/log.txt)" = 0
check 'and leaves no rests' test -z "$(find other -name '.*' -type f -o -name '*.checkpoint')"
check 'all rows are there' test "$(cut -d , -f 3 other/table.csv | sort | uniq -c | tr -d ' \n')" = 4converged1solve.status

finish
