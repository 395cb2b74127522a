#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft import: charts of signs with their key, as pages and messages have them.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# imports NAME ROWS: the chart on standard input comes to these rows, the bottom one first.
imports() {
    cat >"$work/x.txt"
    "$WEFT" import "$work/x.txt" >"$work/x.knit" 2>"$work/err"
    "$WEFT" chart --grid "$work/x.knit" 2>&1 | grep -E '^[KP ]+$' | tr -d ' ' | tr '\n' ' ' >"$work/got"
    check "$1" test "$(cat "$work/got")" = "$2 "
}

# refuses NAME TEXT
refuses() {
    cat >"$work/x.txt"
    "$WEFT" import "$work/x.txt" >"$work/x.knit" 2>"$work/err"
    check "$1: is refused" test $? = 3
    check "$1" grep -q -e "$2" "$work/err"
}

imports 'numbers at either side' 'KKKKPP KKKPPP KKPPPP KPPPPP' <<'CHART'
Little flag
. = purl on RS, knit on WS
| = knit on RS, purl on WS

4 | . . . . .
  | | . . . . 3
2 | | | . . .
  | | | | . . 1
CHART
imports 'squares, the key on one line' 'KKKP KKPP KPPP' <<'CHART'
Key: □ = knit, ■ = purl
□■■■ 3
□□■■ 2
□□□■ 1
CHART
imports 'a dash as it is seen, bars between' 'KPP KKP' <<'CHART'
x: knit
-: purl
| x | x | - |
| x | - | - |
CHART
imports 'as it is worked on the wrong side' 'PK' <<'CHART'
o = knit on WS, purl on RS
x = purl on WS, knit on RS
1 o x
CHART
imports 'row 1 at the top' 'PPK KKP' <<'CHART'
. = knit
# = purl
1 ##.
2 ..#
CHART
imports 'figures' 'KKP PPK' <<'CHART'
0 = purl
1 = knit
0 0 1
1 1 0
CHART
refuses 'right-side rows alone' 'wrong-side rows, too' <<'CHART'
. = knit
x = purl
3 . x
1 x .
CHART
refuses 'a row too long' 'this row has 3 stitches, but the first has 2' <<'CHART'
. = knit
x = purl
. x
x . .
CHART
refuses 'numbers that jump' 'row 1 follows row 5' <<'CHART'
. = knit
x = purl
5 . x
1 x .
CHART

# In a script it is named.
printf '. = knit\nx = purl\n2 . . x\n1 x . .\n' >"$work/page.knit"
"$WEFT" check "$work/page.knit" >"$work/out" 2>"$work/err"
check 'pasted as a script' grep -q 'this is a chart with its key, not a script' "$work/err"
finish
