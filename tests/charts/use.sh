#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Chart files as motifs of a script: `use "x.csv" as x`.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
cd "$work" || exit 1

# An asymmetric fabric in every format: the same motif.
printf 'use flag from std\nswatch flag\n' >flag.knit
"$WEFT" chart --grid flag.knit >wanted
"$WEFT" chart --grid flag.knit >flag.txt
for kind in csv k png; do
    [ $kind = png ] && as=pixels: || as=
    "$WEFT" chart -q flag.knit -o "${as}flag.$kind" 2>/dev/null
done
for kind in txt csv k png; do
    printf 'use "flag.%s" as f\nswatch f\n' "$kind" >use.knit
    exits 0 "$kind: is used" "$WEFT" chart --grid use.knit
    check "$kind: the same fabric" cmp -s wanted out
done

printf 'use "flag.csv"\nswatch tile(flag, 2, 1)\n' >use.knit
exits 0 'its name is the file'"'"'s' "$WEFT" check use.knit
out 'in the algebra' 'use.knit: 16 stitches x 6 rows'
printf '# 2 3\nKP\nPK\n' >twice.txt
printf 'use "twice.txt" as t\nswatch t\n' >use.knit
exits 0 'a header of repeats' "$WEFT" check use.knit
out 'all of them' 'use.knit: 6 stitches x 4 rows'
mkdir charts && cp flag.csv charts
printf 'use "charts/flag.csv" as f\nswatch f\n' >use.knit
exits 0 'in a folder' "$WEFT" check use.knit
printf 'motif m { Row 1: k2, p1 }\n' >script.txt
printf 'use "script.txt" as s\nswatch s.m\n' >use.knit
exits 0 'another text is a script still' "$WEFT" check use.knit

printf 'stitch K { kx = 3 }\nmotif m = K\n' >stitches.knit
printf 'use "stitches.knit" as s\nswatch s.m\n' >use.knit
exits 3 'a used file has no say in what knit is' "$WEFT" check use.knit
err 'at its place' 'stitches.knit:1:8: error: a file that is used cannot change K \[E0109\]'
err 'and where it is used' 'use.knit:1:1: note: in a file used here'

printf 'motif m {\n  Row 1: k1, p1\n  Row 2: k1, p1\n}\nmotif n = turn(m)\n' >rows.knit
printf 'use "rows.knit" as r\nuse n from "rows.knit"\nswatch above(r.m, n)\n' >use.knit
exits 0 'motifs of rows are no single pattern' "$WEFT" check use.knit

# Errors stand in the chart and at the place that uses it.
printf 'k,p\nk,q\n' >bad.csv
printf 'swatch b\nuse "bad.csv" as b\n' >use.knit
exits 3 'a wrong cell' "$WEFT" check use.knit
err 'at its place' 'bad.csv:2:3: error: .*\[E0803\]'
err 'and where it is used' 'use.knit:2:1: note: in a chart used here'
printf 'KP\nK\n' >bad.txt
printf 'use "bad.txt" as b\nswatch b\n' >use.knit
exits 3 'a ragged grid' "$WEFT" check use.knit
err 'at its row' 'bad.txt:2:.*\[E0801\]'
printf 'use f from "flag.csv"\nswatch f\n' >use.knit
exits 3 'no names in a chart' "$WEFT" check use.knit
err 'is said' 'use.knit:1:5: error: a chart file has no names to choose from \[E0601\]'
cp flag.csv 2-flag.csv
printf 'use "2-flag.csv"\nswatch K\n' >use.knit
exits 3 'a file whose name is none' "$WEFT" check use.knit
err 'what to write' 'hint: `use "2-flag.csv" as NAME`'
printf 'use "flag.csv" as f\nuse "flag.png" as f\nswatch f\n' >use.knit
exits 3 'a name twice' "$WEFT" check use.knit
err 'has its place' 'use.knit:2:.*\[E0202\]'
mkdir folder.csv
printf 'use "folder.csv" as f\nswatch f\n' >use.knit
exits 3 'a folder' "$WEFT" check use.knit
err 'cannot be read' "use.knit:1:5: error: cannot read 'folder.csv': Is a directory \[E0601\]"
printf 'use "none.csv" as f\nswatch f\n' >use.knit
exits 3 'no such chart' "$WEFT" check use.knit
err 'is said, too' "there is no file 'none.csv'"
finish
