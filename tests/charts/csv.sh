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

# table NAME TEXT: the flag, as a program for tables may write it.
table() {
    printf '%b' "$2" >"$work/t.csv"
    same "$1" "$work/t.csv"
}
table 'words' 'knit,Knit,K,Purl\nk,k,purl,p\nKNIT,p,p,p\n'
table 'a first line that names the separator' 'sep=;\r\nk;k;k;p\r\nk;k;p;p\r\nk;p;p;p\r\n'
table 'empty columns and rows at the edges' ',,,,,,\n,k,k,k,p,,\n,k,k,p,p\n,k,p,p,p,\n,,,,,,\n,,,\n'
table 'row numbers at the left' '3,k,k,k,p\n2,k,k,p,p\n1,k,p,p,p\n'
table 'row numbers at the right, stitch numbers below' 'k,k,k,p,3\nk,k,p,p,2\nk,p,p,p,1\n4,3,2,1,\n'
table 'each where its row begins' ',k,k,k,p,3\n2,k,k,p,p,\n,k,p,p,p,1\n,4,,,1,\n'
table 'stitches counted from the left, above ones and noughts' ',1,2,3,4\n3,1,1,1,0\n2,1,1,0,0\n1,1,0,0,0\n'
table 'rows with a name' 'Row 3,k,k,k,p\nRow 2:,k,k,p,p\nR1.,k,p,p,p\n'
for sign in - . • –; do
    table "$sign for purl, nothing for knit" ",,,$sign\\n,,$sign,$sign\\n,$sign,$sign,$sign\\n"
    exits 0 'that is' "$WEFT" import "$work/t.csv"
    err 'said' "weft: $work/t.csv: an empty cell is taken as knit, '$sign' as purl"
done
table 'with tabs and numbers' '\t\t\t-\t3\n\t\t-\t-\t2\n\t-\t-\t-\t1\n4\t3\t2\t1\t\n'

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
wrong 'a first row without a stitch' '3\n,p,k,k,k,p,p,p,p,p,p,k,\r,' <<'TEXT'
w.csv:1:1: error: this row has no stitch [E0801]
   1 | 3
     | ^
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
wrong 'empty cells that may be knit' ',p\n,p\n' <<'TEXT'
w.csv:1:1: error: this cell is empty [E0803]
   1 | ,p
     | ^
w.csv:2:1: error: this cell is empty [E0803]
   2 | ,p
     | ^
TEXT
wrong 'row numbers from the top' '1,k,p\n2,k,p\n3,p,k\n' <<'TEXT'
w.csv:2:1: error: this cell holds no stitch [E0803]
   2 | 2,k,p
     | ^
hint: numbers of rows count from 1 at the bottom, those of stitches from 1 at one end
w.csv:3:1: error: this cell holds no stitch [E0803]
   3 | 3,p,k
     | ^
hint: numbers of rows count from 1 at the bottom, those of stitches from 1 at one end
TEXT
wrong 'numbers that count nothing, below' '1,0,0\n0,1,1\n0,11,1\n' <<'TEXT'
w.csv:3:3: error: this cell holds no stitch [E0803]
   3 | 0,11,1
     |   ^~
hint: numbers of rows count from 1 at the bottom, those of stitches from 1 at one end
TEXT
wrong 'a second sign' ',-\n.,-\n' <<'TEXT'
w.csv:2:1: error: this cell holds no stitch [E0803]
   2 | .,-
     | ^
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

printf 'k,p\n' | iconv -f ASCII -t UTF-16 >"$work/u.csv" 2>/dev/null || printf '\377\376k\000\n\000' >"$work/u.csv"
exits 3 'another encoding' "$WEFT" import "$work/u.csv"
err 'is named' 'this is a text in UTF-16, not a chart'
err 'with what to do' '^hint: save it as UTF-8'
awk 'BEGIN { for (i = 0; i < 1500000; i++) printf ","; print "k"; for (i = 0; i < 90000; i++) print "k,,,,,,,,," }' >"$work/wide.csv"
exits 3 'a line of many empty cells above many lines' sh -c 'ulimit -t 10; exec "$1" import -q "$2"' - "$WEFT" "$work/wide.csv"
err 'takes no long time' 'error: this cell is empty'

# ---- there and back ----

# back FILE: the table of a script's chart gives the script's grid.
back() {
    "$WEFT" chart -q --grid "$1" >"$work/wanted"
    "$WEFT" chart -q "$1" -o "$work/x.csv" && "$WEFT" import "$work/x.csv" >"$work/x.knit" &&
        "$WEFT" chart --grid "$work/x.knit" | cmp "$work/wanted" -
}

all_back 40

finish
