#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Charts as tables: which way up, which cells, and there and back.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/charts/grids.sh"

"$WEFT" import "$work/flag.txt" >"$work/flag.knit"
exits 0 'a chart as a table' "$WEFT" chart "$work/flag.knit" -o "$work/flag.csv"
check 'the top row first' diff - "$work/flag.csv" <<'TEXT'
k,k,k,p
k,k,p,p
k,p,p,p
TEXT
printf 'motif flag { chart { kp } }\nswatch flag\noutput chart "%s/run.csv"\nsolve { steps = 1 }\n' "$work" >"$work/run.knit"
exits 0 'as an output of a run' "$WEFT" "$work/run.knit"
check 'is the same' sh -c 'echo k,p | diff - "$1/run.csv"' - "$work"

# same NAME FILE: the script made of FILE has the flag's grid.
same() {
    check "$1" sh -c '"$1" import "$2" >"$3/again.knit" && "$1" chart --grid "$3/again.knit" | diff "$3/flag.txt" -' - \
        "$WEFT" "$2" "$work"
}
same 'back again' "$work/flag.csv"
printf '1,1,1,0\n1,1,0,0\n1,0,0,0\n' >"$work/a.csv"
same 'ones and noughts' "$work/a.csv"
printf '\357\273\277"k";"k";"K";"p"\r\n1; k ;P;p\r\nk;p;0;p\r\n\r\n' >"$work/a.CSV"
same 'semicolons, quotes, blanks, capitals, line ends of two bytes, a byte order mark' "$work/a.CSV"
tr '\n' '\r' <"$work/flag.csv" >"$work/mac.csv"
same 'line ends of old Macs' "$work/mac.csv"
tr , '\t' <"$work/flag.csv" >"$work/b.csv"
same 'tabs' "$work/b.csv"

# wrong NAME TEXT: exit status 3; the messages are standard input.
wrong() {
    printf "$2" >"$work/w.csv"
    refused "$1" w.csv
}
wrong 'ragged rows' 'k,p\nk\nk,p,k\n' <<'TEXT'
w.csv:2:2: error: this row has 1 stitch, but the first has 2 [E0801]
   2 | k
     |  ^
w.csv:1:1: note: the first row
   1 | k,p
     | ^~~
w.csv:3:5: error: this row has 3 stitches, but the first has 2 [E0801]
   3 | k,p,k
     |     ^
w.csv:1:1: note: the first row
   1 | k,p
     | ^~~
TEXT
wrong 'an empty cell' 'k,p\nk,\n' <<'TEXT'
w.csv:2:3: error: this cell is empty [E0803]
   2 | k,
     |   ^
TEXT
wrong 'other words' 'k,yo\n' <<'TEXT'
w.csv:1:3: error: this cell holds no stitch [E0803]
   1 | k,yo
     |   ^~
hint: a stitch is k or 1 (knit), p or 0 (purl)
TEXT
wrong 'stitches without a separator, and one with a number' 'k,p\nkp,p\nk,k1\n' <<'TEXT'
w.csv:2:1: error: this cell holds no stitch [E0803]
   2 | kp,p
     | ^~
hint: a stitch is k or 1 (knit), p or 0 (purl)
w.csv:3:3: error: this cell holds no stitch [E0803]
   3 | k,k1
     |   ^~
hint: a stitch is k or 1 (knit), p or 0 (purl)
TEXT
wrong 'an empty line' 'k,p\n\nk,p\n' <<'TEXT'
w.csv:2:1: error: an empty line stands between two rows [E0802]
   2 | 
     | ^
TEXT
wrong 'nothing' '\n\n' <<'TEXT'
w.csv:1:1: error: there is no stitch in this file [E0806]
   1 | 
     | ^
TEXT

# ---- there and back ----

# back FILE: the table of a script's chart gives the script's grid.
back() {
    "$WEFT" chart -q --grid "$1" >"$work/wanted"
    "$WEFT" chart -q "$1" -o "$work/x.csv" && "$WEFT" import "$work/x.csv" >"$work/x.knit" &&
        "$WEFT" chart --grid "$work/x.knit" | cmp "$work/wanted" -
}

all_back 40

finish
