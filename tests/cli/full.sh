#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A full disk: an error with a reason, exit status 4, nothing half-written, what was there stays.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
cd "$work" || exit 1

cat >a.knit <<'KNIT'
swatch tile(beside(K, P), 4, 8)
solve { steps = 2; accuracy = 50%; tolerance = 0.001 }
KNIT

# Outputs of more than 512 bytes.
kinds='vtp:x.vtp pvd:x.pvd ply:x.ply obj:x.obj stl:x.stl glb:x.glb picture:x.png picture:x.svg picture:x.pdf plot:x.svg plot:x.pdf
    plot:x.png report:x.json chart:x.k chart:x.svg chart:x.png chart:x.pdf'
[ ! -s "$WEFT_SOURCE/viewer/template.html" ] || kinds="$kinds html:x.html"

# ---- files that may not grow: what comes first is written, what comes then is not ----

limited() { prlimit --fsize="$1" "$WEFT" "$2" a.knit -q -o "$3"; }

if ldd "$WEFT" 2>/dev/null | grep -q libomp; then
    skip 'files that may not grow' "LLVM's OpenMP keeps a file of its own"
elif prlimit --fsize=512 true 2>/dev/null; then
    for output in $kinds; do
        path=${output#*:}
        rm -rf x*
        exits 4 "no room for $output" limited 512 run "$output"
        err "$output: says so" "cannot write 'x[_0-9]*[.][a-z]*': File too large"
        check "$output: is not there" test ! -e "$path" -a -z "$(find . -name '.weft-*' -o -name '*.checkpoint' -o -name '*.manifest.json')"
    done
    rm -rf x*

    # What stood there stays.
    echo old >x.vtp
    exits 4 'no room for a new version' limited 512 run vtp:x.vtp
    check 'the old one stays' test "$(cat x.vtp)" = old
    exits 4 'no room for a chart' limited 512 chart x.svg
    check 'none is there' test ! -e x.svg
    echo 'swatch   tile( beside(K,P),6,   12 )' | tee untidy.knit >copy
    exits 4 'no room to lay out a script' prlimit --fsize=30 "$WEFT" fmt untidy.knit
    check 'it stays as it was' cmp copy untidy.knit

    # The outputs fit, the checkpoint does not.
    exits 0 'no room for a checkpoint' limited 3900 run x.csv
    err 'is said' "cannot write 'a.checkpoint': File too large; the run goes on, but could not be resumed"
    check 'and the run is complete' test -s x.csv -a -s a.manifest.json -a ! -e a.checkpoint

    # A sweep stops, and goes on once there is room.
    printf 'param c = 1\nstitch K { kx = -c; ky = c }\n%s\nsweep c in [0, 1]\noutput "x.vtp"\n' "$(cat a.knit)" >s.knit
    exits 4 'no room for the points of a sweep' prlimit --fsize=512 "$WEFT" sweep s.knit -j 1
    check 'their logs say so' grep "cannot write 'x.vtp': File too large" s.sweep/1-c=0/log.txt
    check 'none counts as done' test -z "$(find s.sweep -name point.json -o -name x.vtp -o -name '.weft-*')"
    exits 0 'with room again' "$WEFT" sweep s.knit -q -j 1
    check 'all are there' test "$(find s.sweep -name point.json | wc -l)" = 2
else
    skip 'files that may not grow' 'no prlimit'
fi

# ---- a device that is full ----

if [ -c /dev/full ]; then
    for output in $kinds; do
        case $output in pvd:* | obj:*) continue ;; esac     # more files beside the named one
        path=full.${output##*.}
        ln -sf /dev/full "$path"
        exits 4 "onto a full device: $output" "$WEFT" run a.knit -q --no-manifest -o "${output%%:*}:$path"
        err "$output: says so" "cannot write '$path': No space left on device"
    done
    for command in 'run a.knit' 'chart a.knit' 'write a.knit' 'list' 'check a.knit' 'version --json' 'help'; do
        # shellcheck disable=SC2086
        printing() { "$WEFT" $command >/dev/full; }
        exits 4 "standard output full: $command" printing
        err "$command: says so" 'cannot write to standard output: No space left on device'
    done
else
    skip 'a device that is full' 'no /dev/full'
fi

finish
