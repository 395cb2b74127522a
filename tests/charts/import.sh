#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft import: grids of K and P become scripts of the same grid; what is wrong
# with one is shown at its place.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/charts/grids.sh"

# same NAME FILE: the script made of FILE has the grid of $work/wanted.
same() {
    check "$1" sh -c '"$1" import "$2" >"$3/again.knit" && "$1" chart --grid "$3/again.knit" | diff "$3/wanted" -' - \
        "$WEFT" "$2" "$work"
}

# ---- what comes out ----

exits 0 'the flag' "$WEFT" import "$work/flag.txt"
check 'is a chart, row 1 at the bottom' diff - "$work/out" <<'KNIT'
# A grid of K and P, from flag.txt: 4 stitches x 3 rows
motif flag multiple of 4 {
  chart (x = P, . = K) {
    ...x  3
    ..xx  2
    .xxx  1
  }
}
swatch flag
KNIT

{
    echo '# 2 3'
    echo 'KKKKPPPP'
    echo 'KKKKPPPP'
    echo 'KKKKPPPP'
    echo 'KKKKPPPP'
} >"$work/row.txt"
exits 0 'a name that the language has taken' "$WEFT" import "$work/row.txt" -o "$work/row.knit"
empty 'a file instead of standard output' "$work/out"
check 'equal rows stand together' diff - "$work/row.knit" <<'KNIT'
# A grid of K and P, from row.txt: 8 stitches x 4 rows
motif row_chart multiple of 8 {
  Rows 1-4: *p4, k4; rep from * to end
}
swatch tile(row_chart, 3, 2)
KNIT
exits 0 'compiles' "$WEFT" check "$work/row.knit"
out 'repeats across and up' '24 stitches x 8 rows'

printf '# 12 10\nKP\nPPP\n' | sed 's/PPP/PP/' >"$work/x.txt"
"$WEFT" import "$work/x.txt" >"$work/x.knit"
exits 0 'repeats of several digits' "$WEFT" check "$work/x.knit"
out 'count' '20 stitches x 24 rows'

# Rows have sides: an odd number of them, which could be written shorter, stays a chart where it repeats.
printf '# 3 2\nKKKKKKKKPPPPPPPPPPPPP\n' >"$work/odd.txt"
exits 0 'a repeat of one row' "$WEFT" import "$work/odd.txt" -o "$work/odd.knit"
check 'is a chart' grep -q '  \.\.\.\.\.\.\.\.xxxxxxxxxxxxx  1$' "$work/odd.knit"
"$WEFT" chart --grid "$work/odd.knit" >"$work/out"
check 'and has every row as it was' test "$(sed 1d "$work/out" | sort -u | tr -d ' ')" = KKKKKKKKPPPPPPPPPPPPPKKKKKKKKPPPPPPPPPPPPP
for n in 1 2 3; do printf 'KKKKKP\nKKKKPP\nKKPPPP\n'; done >"$work/odd.txt"
exits 0 'three repeats of three rows' "$WEFT" import "$work/odd.txt"
out 'are a chart of three' '^swatch tile(odd, 1, 3)$'
for n in 1 2 3; do printf 'KP\nPP\nKP\nPP\n'; done >"$work/even.txt"
exits 0 'six repeats of two' "$WEFT" import "$work/even.txt"
out 'are a repeat of two' '^swatch tile(even, 1, 6)$'

# ---- ways to write it ----

cp "$work/flag.txt" "$work/wanted"
printf '\357\273\277# 1 1\r\nK P P P\r\n  KKPP  \r\nK\tK K P\r\n\r\n\n' >"$work/windows.txt"
same 'a byte order mark, line ends of two bytes, tabs, empty lines at the end' "$work/windows.txt"
printf '# 1 1\rKPPP\rKKPP\rKKKP\r' >"$work/mac.txt"
same 'line ends of old Macs' "$work/mac.txt"
printf 'KPPP\nKKPP\nKKKP' >"$work/bare.txt"
same 'no header, no last line end' "$work/bare.txt"
name=$(printf 'two\nlines.txt')
cp "$work/flag.txt" "$work/$name"
same 'a file whose name has a line break' "$work/$name"
check 'which the comment has not' grep -q '^# A grid of K and P, from two?lines.txt: ' "$work/again.knit"
for name in 3d-shape.txt each.txt k.txt .txt 'a b.txt' tile.txt; do
    cp "$work/flag.txt" "$work/$name"
    same "a file called '$name'" "$work/$name"
done
check 'standard input' sh -c '"$1" import - <"$2/flag.txt" >"$2/x.knit" && "$1" chart --grid "$2/x.knit" | diff "$2/wanted" -' - \
    "$WEFT" "$work"

# ---- what is wrong ----

# wrong NAME TEXT: exit status 3; the messages are standard input.
wrong() {
    printf "$2" >"$work/w.txt"
    refused "$1" w.txt
}

wrong 'a row too short' 'KPK\nKP\n' <<'TEXT'
w.txt:2:3: error: this row has 2 stitches, but the first has 3 [E0801]
   2 | KP
     |   ^
w.txt:1:1: note: the first row
   1 | KPK
     | ^~~
TEXT
wrong 'a row too long' 'K P\nK P P P\n' <<'TEXT'
w.txt:2:5: error: this row has 4 stitches, but the first has 2 [E0801]
   2 | K P P P
     |     ^~~
w.txt:1:1: note: the first row
   1 | K P
     | ^~~
TEXT
wrong 'a blank row' '# 1 1\nKP\n\nPK\n' <<'TEXT'
w.txt:3:1: error: an empty line stands between two rows [E0802]
   3 | 
     | ^
TEXT
wrong 'a blank row before the first' '# 1 1\n\nPK\n' <<'TEXT'
w.txt:2:1: error: an empty line stands before the first row [E0802]
   2 | 
     | ^
TEXT
wrong 'other letters, each in its row' 'K Q P\nK P x\n' <<'TEXT'
w.txt:1:3: error: 'Q' stands for no stitch; stitches are K and P [E0803]
   1 | K Q P
     |   ^
hint: a written pattern needs no import: try `weft check`
w.txt:2:5: error: 'x' stands for no stitch; stitches are K and P [E0803]
   2 | K P x
     |     ^
hint: a written pattern needs no import: try `weft check`
TEXT
wrong 'a byte that is no letter' 'KP\nK\001\n' <<'TEXT'
w.txt:2:2: error: the byte 0x01 stands for no stitch; stitches are K and P [E0803]
   2 | K?
     |  ^
TEXT
wrong 'small letters' 'KP\nKp\n' <<'TEXT'
w.txt:2:2: error: the small letter 'p': stitches are K and P here [E0804]
   2 | Kp
     |  ^
TEXT
wrong 'a header of words' '# my chart\nKP\n' <<'TEXT'
w.txt:1:1: error: a header is two numbers: how often the rows and the stitches repeat [E0805]
   1 | # my chart
     | ^~~~~~~~~~
hint: `# 4 2` repeats four times up and two times across; without a header it is once
TEXT
for header in '#' '# 4' '# 4 2 1' '# -1 2' '# 4.5 2' '# 4,2' '# 42k'; do
    printf '%s\nKP\n' "$header" >"$work/w.txt"
    exits 3 "the header '$header'" "$WEFT" import "$work/w.txt"
    err 'is refused' 'w.txt:1:1: error: a header is two numbers.*E0805'
done
for header in '0 2' '2 0'; do
    wrong "no repeat, $header" "# $header\nKP\n" <<TEXT
w.txt:1:1: error: a repeat is at least 1 [E0805]
   1 | # $header
     | ^~~~~
TEXT
done
wrong 'a header further down' '# 1 1\nKP\n# 2 2\n' <<'TEXT'
w.txt:3:1: error: a header stands in the first line alone [E0805]
   3 | # 2 2
     | ^~~~~
TEXT
wrong 'a fabric too large' '# 99999 99999\nKP\n' <<'TEXT'
w.txt:1:1: error: this makes 199998 x 99999 stitches; a fabric may have 4000000 [E0707]
   1 | # 99999 99999
     | ^~~~~~~~~~~~~
TEXT
exits 3 'repeats without end' sh -c 'printf "# 99999999999999999999 1\nK\n" | "$1" import -' - "$WEFT"
err 'are too large' 'E0707'
exits 3 'an empty file' "$WEFT" import /dev/null
err 'has no stitch' 'no stitch in this file.*E0806'
exits 3 'messages for programs' sh -c 'printf "KQ\n" | "$1" import - --diagnostics json' - "$WEFT"
err 'are objects' '"code": *"E0803"'

exits 4 'a file that is not there' "$WEFT" import "$work/none.txt"
err 'is named' 'cannot read .*none.txt'
exits 4 'a folder that is not there' "$WEFT" import "$work/flag.txt" -o "$work/none/x.knit"
exits 2 'no file' "$WEFT" import
exits 2 'an option of others' "$WEFT" import --grid "$work/flag.txt"

# Long lines and many rows fit the script's own limits.
awk 'BEGIN { for (i = 0; i < 1000000; i++) printf i * i % 7 < 3 ? "K" : "P" }' >"$work/wide.txt"
check 'a million stitches wide' sh -c '"$1" import "$2/wide.txt" | "$1" check - >"$2/out"' - "$WEFT" "$work"
out 'all of them' '1000000 stitches x 1 row,'
awk 'BEGIN { for (i = 0; i < 110000; i++) print i * i % 7 < 3 ? "K" : "P" }' >"$work/high.txt"
check 'a hundred thousand rows' sh -c '"$1" import "$2/high.txt" | "$1" check - >"$2/out"' - "$WEFT" "$work"
out 'all of them' '1 stitch x 110000 rows'

# ---- what is no chart ----

printf '<?xml version="1.0"?>\n<svg>\n</svg>\n' >"$work/drawn.svg"
exits 3 'a drawing' "$WEFT" import "$work/drawn.svg"
err 'is named' 'this is an XML or HTML file, not a chart'
check 'once' test "$(grep -c 'error' "$work/err")" = 1
printf '%%PDF-1.5\n1 0 obj\n' >"$work/page.pdf"
exits 3 'a PDF' "$WEFT" import "$work/page.pdf"
err 'is named, too' 'this is a PDF file, not a chart'

# other NAME BYTES WHAT HINT: a file of this name that begins so.
other() {
    printf "$2" >"$work/$1"
    exits 3 "$1" "$WEFT" import "$work/$1"
    err 'is named' ":1:1: error: this is $3, not a chart"
    err 'with what to do' "^hint: .*$4"
    check 'once' test "$(grep -c 'error' "$work/err")" = 1
}
other photo.jpg '\377\330\377\340\000\020JFIF' 'a JPEG picture' 'save it as PNG, with a pixel for each stitch'
other moving.gif 'GIF89a\003\000' 'a GIF picture' 'save it as PNG, with a pixel for each stitch'
other table.xlsx 'PK\003\004\024\000' 'a spreadsheet or another packed file' 'save the chart in it as CSV'
other script.knit '# mine\nuse miura from std\nswatch miura\n' 'a script' 'it needs no import: `weft check`'
printf 'K P\nP P\n' >"$work/grid.knit"
exits 0 'a grid with the ending of a script' "$WEFT" import "$work/grid.knit"
exits 3 'a photograph as a script' "$WEFT" check "$work/photo.jpg"
err 'is named, too' 'photo.jpg:1:1: error: this is a JPEG picture, not a script'
err 'with what to do' '^hint: save it as PNG, with a pixel for each stitch'
printf 'k\tp\np\tp\n' >"$work/tabs.tsv"
exits 0 'a table with tabs, by its ending' "$WEFT" import "$work/tabs.tsv"
out 'is one' '^    xx  1$'

# ---- there and back ----

mkdir "$work/random" "$work/library"
random_grids "$work/random" 60
bad=0
for file in "$work"/random/*.txt; do
    "$WEFT" import "$file" >"$work/x.knit" && "$WEFT" chart "$work/x.knit" -o "$work/x.txt" && cmp "$file" "$work/x.txt" ||
        bad=$((bad + 1))
done
check 'random grids come back' test "$bad" = 0

library_scripts "$work/library"
for file in "$work"/library/*.knit; do
    "$WEFT" chart -q "$file" -o "$work/wanted.txt"
    cp "$work/wanted.txt" "$work/wanted"
    same "$(basename "$file" .knit)" "$work/wanted.txt"
done

printf 'KP\nPK\n' >"$work/kind.txt"
no_kind import kind.txt

finish
