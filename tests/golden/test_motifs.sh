#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Motifs from rows, charts, formulas and other motifs, against small grids.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"

# One motif in three forms.
flag='motif f multiple of 3 + 1 { chart (x = P, o = K) {| o x x o 2| o o x o 1| } }'
rows='motif f multiple of 3 + 1 {|Row 1: k1, *p1, k2; rep from * to end|Row 2: *p1, k2; rep from * to last st, p1|}'
formula='motif f = each (x, y) in 4 by 2 : x > 1 - y && x < 3 ? P : K'
for motif in "$flag" "$rows" "$formula"; do
    grid "$motif|swatch f" 'KKPK KPPK'
done
for motif in "$flag" "$rows"; do
    grid "$motif|swatch tile(f, 2, 2)" 'KKPKKPK KPPKPPK KKPKKPK KPPKPPK'
    grid "$motif|swatch fill(f, 10, 3)" 'KKPKKPKKPK KPPKPPKPPK KKPKKPKKPK'
    wrong E0401 "$motif|swatch fill(f, 9, 3)" '9 is not a multiple of 3 + 1'
    out 'the nearest widths are given' 'hint: the nearest widths are 7 and 10'
    wrong E0401 "$motif|swatch fill(f, 3, 3)" '3 is not a multiple of 3 + 1'
    out 'or the smallest' 'hint: the smallest width is 4'
done

# An x to the right, y upwards from the first row worked.
grid 'swatch each (x, y) in 3 by 2 : x == 0 && y == 0 ? P : K' 'PKK KKK'
grid 'swatch each (x, y) in 3 by 2 : x == 2 && y == 1 ? P : K' 'KKK KKP'

# The algebra, on a motif that equals none of its images.
m='let m = each (x, y) in 3 by 2 : x == y ? P : K'
grid "$m|swatch m" 'PKK KPK'
grid "$m|swatch mirror(m)" 'KKP KPK'
grid "$m|swatch flip(m)" 'KPK PKK'
grid "$m|swatch invert(m)" 'KPP PKP'
grid "$m|swatch turn(m)" 'PPK PKP'
grid "$m|swatch rotate(m)" 'KPK KKP'
grid "$m|swatch tile(m, 2, 1)" 'PKKPKK KPKKPK'
grid "$m|swatch tile(m, rows = 2, columns = 1)" 'PKK KPK PKK KPK'
grid "$m|swatch fill(m, 6, 3)" 'PKKPKK KPKKPK PKKPKK'
grid "$m|swatch beside(m, mirror(m))" 'PKKKKP KPKKPK'
grid "$m|swatch above(m, flip(m))" 'PKK KPK KPK PKK'
grid "$m|swatch shift(m, 1, 0)" 'KPK KKP'
grid "$m|swatch shift(m, 0, 1)" 'KPK PKK'
grid "$m|swatch shift(m, -1, -3)" 'PKK KKP'
grid "$m|swatch crop(m, 0, 1, 2, 1)" 'KP'
grid "$m|swatch inset(P, m, 2, 1)" 'PKK KPP'
grid "$m|swatch border(m, 1, 1, P)" 'PPPPP PPKKP PKPKP PPPPP'
grid "$m|swatch border(K, sts = 2, rows = 1, with = m)" 'PKKPK KPKKP PKKPK'
size "$m|swatch tile(P, width(m), height(m))" '3 x 2'
size "$m|swatch tile(P, count(m, P), count(m))" '2 x 6'
grid "$m|swatch each (x, y) in 2 by 2 : at(m, x + 3, y - 2)" 'PK KP'
wrong E0402 "$m|swatch beside(m, K)" 'the height is 1 here, but 2 in the first'
wrong E0402 "$m|swatch above(m, K)" 'the width is 1 here, but 3 in the first'
wrong E0409 "$m|swatch crop(m, 1, 0, 3, 1)" 'do not lie inside 3 x 2'
wrong E0409 "$m|swatch inset(m, m, 1, 0)" 'do not lie inside'

# Arguments, defaults, motifs of motifs.
grid 'motif r(a, b = 1) { Row 1: k{a}, p{b} }|swatch r(2)' 'PKK'
grid 'motif r(a, b = a) { Row 1: k{a}, p{b} }|swatch r(2)' 'PPKK'
grid 'motif r(a, b = 1) { Row 1: k{a}, p{b} }|swatch r(b = 2, a = 1)' 'PPK'
grid 'motif r(m) = above(m, invert(m))|swatch r(each (x, y) in 2 by 1 : x ? P : K)' 'KP PK'
grid 'motif stairs(n) = n < 2 ? P : beside(tile(K, 1, 1), stairs(n - 1))|swatch stairs(4)' 'KKKP'
grid 'let a = b|let b = 2|swatch tile(K, a, 1)' 'KK'
wrong E0207 'motif r(a) { Row 1: k{a} }|swatch r(1, 2)' 'takes 1 argument'
wrong E0207 'motif r(a) { Row 1: k{a} }|swatch r(q = 1)' "has no argument 'q'"
wrong E0207 'motif r(a) { Row 1: k{a} }|swatch r()' "needs its argument 'a'"
wrong E0207 'motif r(a) { Row 1: k{a} }|swatch r' 'needs its arguments'
wrong E0207 'motif r(a) { Row 1: k{a} }|swatch r(1, a = 1, a = 2)' 'given twice'
wrong E0207 'swatch tile(K, 2)' "tile needs 'rows'"
wrong E0207 'swatch tile(K, 2, 2, 2)' 'takes 3 arguments'
wrong E0207 'swatch tile(K, cols = 2, rows = 2)' "no argument 'cols'"

# Rows that go on: an odd number of rows is worked on from the other side.
grid 'motif g multiple of 2 { Row 1: *k1, p1; rep from * }|swatch tile(g, 1, 3)' 'PK PK PK'
grid 'motif g { Row 1: knit }|swatch tile(g, 2, 3)' 'KK PP KK'
grid 'motif g { Row 1: k2, p1 }|swatch tile(g, 2, 2)' 'PKKPKK PPKPPK'
wrong E0307 'motif g { Row 1 (RS): knit }|swatch tile(g, 1, 2)' 'row 1 is marked RS'

# Multiples worked out from the rows.
size 'motif r { Row 1: *k2, p2; rep from * to last 2 sts, k2 }|swatch tile(r, 3, 1)' '14 x 1'
size 'motif r {|Row 1: *k2, p2; rep from *|Row 2: *k3, p3; rep from *|}|swatch r' '12 x 2'
wrong E0310 'motif r {|Row 1: *k2, p2; rep from *|Row 2: *k2, p2; rep from * to last st, k1|}|swatch r' 'a multiple of 4 + 1'
wrong E0304 'motif r multiple of 6 { Row 1: *k2, p2; rep from * }|swatch r' "the motif's multiple makes 6"
wrong E0404 'motif r { }|swatch r' "'r' has no row"
wrong E0405 'motif r {|Row 1: k2|chart {|K|}|}|swatch r' 'one chart, or rows'
wrong E0109 'motif r {|Row 1: k2|gauge { width = 1 }|}|swatch r' 'cannot stand inside a motif'

# Charts.
grid 'motif c { chart {|P k|K p|} }|swatch c' 'KP PK'
grid 'motif c { chart {|PK|KP|} }|swatch c' 'KP PK'
grid 'chart (. = K, - = P) {|- .|. .|}' 'KK PK'
grid 'stitch T { kx = 1; symbol = "t" }|chart (/ = T, . = K) {|/ .|. .|}' 'KK tK'
grid 'stitch T { kx = 1; symbol = "t" }|chart {|t K|K T|}' 'Kt tK'
grid 'chart ("=" = P, 0 = K) {|= 0 0 2|0 0 = 1|}' 'KKP PKK'
grid 'chart {|2 P K|  K P 1|}' 'KP PK'
# `|` in a chart marks the repeat; here it ends lines, so these come from a file.
bars() {
    printf 'motif c multiple of 2 + 2 {\n  chart {\n    P | P K | K\n  }\n}\nswatch %s\n' "$1" >"$work/x.knit"
    "$dump" "$work/x.knit" >"$work/out" 2>&1
    same "bars: $1" "$2"
}
bars 'tile(c, 1, 1)' 'PPKK'
bars 'tile(c, 3, 1)' 'PPKPKPKK'
bars 'fill(c, 6, 2)' 'PPKPKK PPKPKK'
grid 'motif c multiple of 2 + 1 { chart {|P K P K P|} }|swatch tile(c, 1, 1)' 'PKP'
wrong E0408 'motif c multiple of 2 + 1 { chart {|P K K|} }|swatch c' 'its edges differ'
wrong E0408 'motif c multiple of 2 + 1 { chart {|P K K P P|} }|swatch c' 'does not repeat after 2'
wrong E0408 'motif c multiple of 4 + 1 { chart {|P K K|} }|swatch c' 'no multiple of 4 + 1'
wrong E0403 'chart {|P K K|P K|}' 'this line has 3 stitches, the one below it 2'
wrong E0403 'chart {|P K 1|P K 2|}' 'this is row 1 of the chart, not 2'
wrong E0403 'chart {|P q|P K|}' "does not know 'q'"
wrong E0301 'chart (x = Q) {|x x|}' "'Q' is no stitch"
wrong E0202 'chart (x = K, x = P) {|x x|}' 'has a meaning already'
wrong E0404 'chart {|}' 'no line'

# Values.
size 'swatch tile(K, 7 mod 4, -7 mod 4)' '3 x 1'
size 'swatch tile(K, min(3, 2, 5), max(1, 4))' '2 x 4'
size 'swatch tile(K, [4, 5, 6][1], 2 > 1 ? 3 : 4)' '5 x 3'
size 'swatch tile(K, 1 + 2 * 3, (1 + 2) * 3)' '7 x 9'
size 'swatch tile(K, 10 - 4 - 3, 12 / 2 / 3)' '3 x 2'
size 'swatch tile(K, !0 + !5 + 1, (1 && 0) + (2 && 3))' '2 x 1'
size 'swatch tile(K, floor(7 / 2), ceil(7 / 2))' '3 x 4'
size 'swatch tile(K, gcd(12, 18), pow(2, 3))' '6 x 8'
size 'swatch tile(K, 2cm / 5mm, 1in / 25.4mm + 1)' '4 x 2'
size 'swatch tile(K, 200%, 3)' '2 x 3'
size 'swatch tile(K,|  2,|  3)' '2 x 3'
size 'swatch tile(K, 2|  + 1, 3)' '3 x 3'
wrong E0205 'let a = 1 / 0|swatch K' 'division by zero'
wrong E0205 'let a = sqrt(-1)|swatch K' 'no finite result'
wrong E0205 'let a = 1e300 * 1e300|swatch K' 'no finite result'
wrong E0206 'let a = 1mm + 1|swatch K' 'a length'
wrong E0209 'swatch tile(K, 1.5, 2)' 'whole number'
wrong E0204 'swatch tile(K, 0, 2)' 'must lie in 1..'
wrong E0204 'let a = [1, 2][2]|swatch K' 'must lie in 0..1'
wrong E0203 'let a = K + 1|swatch K' 'a stitch'
wrong E0203 'let a = 1 == K|swatch K' 'cannot be compared'
wrong E0203 'swatch 3' 'a fabric or a motif is needed here, this is a number'
wrong E0203 'swatch each (x, y) in 2 by 2 : x' 'this is a number'
wrong E0201 'swatch tile(K, nn, 2)' "nothing here is called 'nn'"
wrong E0208 'let a = b|let b = a|swatch K' 'needs itself'
wrong E0202 'let a = 1|let a = 2|swatch K' 'already the name'
wrong E0406 'let a = 1' 'no fabric'
wrong E0407 'swatch K|swatch P' 'already'
wrong E0407 'Row 1: k2|swatch P' 'already'

finish
