#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A run that is stopped keeps what is complete and leaves nothing else.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# Large enough to be in the middle when the signal comes.
cat >"$work/slow.knit" <<'KNIT'
motif checks { Row 1: *k2, p2; rep from * to end
  Row 2: *k2, p2; rep from * to end
  Row 3: *p2, k2; rep from * to end
  Row 4: *p2, k2; rep from * to end }
swatch fill(checks, 40, 40)
solve { steps = 500 }
KNIT

# whole FOLDER: its collection names files that are there, all others are gone.
whole() {
    (
        cd "$1" || exit 1
        names=$(sed -n 's/.* file="\(.*\)".*/\1/p' x.pvd)
        [ -n "$names" ] && grep -q '</VTKFile>' x.pvd || exit 1
        for name in $names; do
            tail -c 11 "$name" | grep -q '</VTKFile>' || exit 1
        done
        # A step may be complete that the collection does not name yet.
        [ -z "$(find . -name '.*' -type f)" ] && [ ! -e r.json ] && [ ! -e y.vtp ]
    )
}

# Under nohup a hang-up is ignored, and stays so in what is started; undo that for the runs below.
listening=
env --default-signal=HUP true 2>/dev/null && listening='env --default-signal=HUP'

template=$WEFT_SOURCE/viewer/template.html

# stop SIGNAL: starts a run, sends the signal once the second step stands.
stop() {
    folder=$work/$1
    mkdir "$folder"
    set -- "$1" -o "$folder/x.pvd" -o "$folder/x.glb" -o "$folder/y.vtp" -o "$folder/r.json"
    [ ! -s "$template" ] || set -- "$@" -o "$folder/x.html"
    signal=$1
    shift
    $listening "$WEFT" run "$work/slow.knit" --steps 40 "$@" >"$work/out" 2>"$work/err" &
    job=$!
    await test -e "$folder/x_01.vtp"
    kill -s "$signal" "$job"
    status=0
    wait "$job" || status=$?
    check "$signal: exit status 1" test "$status" = 1
    err "$signal: says so" 'stopped after [0-9]* of 40 growth steps; .*x.pvd holds what is complete'
    check "$signal: what is complete is kept, nothing else" whole "$folder"
    check "$signal: the animation has its steps" sh -c 'head -c 4 "$1" | grep -q glTF && grep -aq "\"growth 0\"" "$1"' - "$folder/x.glb"
    if [ -s "$template" ]; then
        check "$signal: the page, too" grep -q '"status":"stopped".*"growth":0,.*"growth":0.025,' "$folder/x.html"
        check "$signal: and is whole" sh -c 'tail -n 1 "$1" | grep "</html>"' - "$folder/x.html"
    else
        skip "$signal: the page, too" 'built without npm'
    fi
}

stop TERM
stop HUP

# SIGINT by way of a program that is not a shell's background job.
if command -v timeout >/dev/null 2>&1; then
    mkdir "$work/int"
    exits 1 'INT' timeout --preserve-status -s INT 3 "$WEFT" run "$work/slow.knit" -o "$work/int/x.pvd" -o "$work/int/r.json"
    err 'INT: says so' 'stopped after'
    check 'INT: what is complete is kept, nothing else' whole "$work/int"
else
    skip 'INT' 'no timeout program'
fi

finish
