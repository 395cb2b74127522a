#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Progress: a bar on a terminal, a few lines elsewhere, nothing if quiet.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

printf 'swatch tile(beside(tile(K, 2, 1), tile(P, 2, 1)), 2, 8)\nsolve { steps = 25 }\n' >"$work/rib.knit"

exits 0 'no terminal' "$WEFT" run "$work/rib.knit"
check 'gives ten lines at most' test "$(wc -l <"$work/err")" -le 10
err 'the last at full growth' '^growth 1.00 '
check 'without escapes' sh -c '! grep -q "$(printf "\033")" "$1"' - "$work/err"
exits 0 'quiet' "$WEFT" run -q "$work/rib.knit"
empty 'gives none' "$work/err"

# `script` runs a command on a terminal of its own and keeps what that shows.
on_terminal() {
    TERM=$1 script -q -e -c "'$WEFT' run '$work/rib.knit'" "$work/typescript" >"$work/shown" 2>&1 </dev/null
}

if command -v script >/dev/null 2>&1 && TERM=xterm script -q -e -c true /dev/null >/dev/null 2>&1 </dev/null; then
    check 'on a terminal' on_terminal xterm
    tr '\r' '\n' <"$work/shown" | grep '^\[' | sed "s/$(printf '\033')\[K.*//" >"$work/bars"
    check 'is a bar' grep '^\[#*-*\] growth 0.[0-9]*  energy [0-9.e-]* ' "$work/bars"
    check 'with the time left' grep '[0-9]:[0-9][0-9] left' "$work/bars"
    check 'of 80 columns at most' awk 'length > 79 { print; bad = 1 } END { exit bad }' "$work/bars"
    check 'taken away in the end' sh -c 'tr "\r" "\n" <"$1" | grep -A 1 "^\[" | tail -n 1 | grep -q "^$(printf "\033")\[K"' - "$work/shown"
    check 'on a terminal without a cursor' on_terminal dumb
    check 'are lines' grep '^growth 1.00 ' "$work/shown"
else
    skip 'on a terminal' 'no script program'
fi

finish
