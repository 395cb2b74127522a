#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Written rows against grids worked out by hand (bottom row first).
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"

# An RS row is worked from the right: the text reversed. A WS row from the left,
# every stitch from behind.
grid 'Row 1 (RS): k1, p2, k3' 'KKKPPK'
grid 'Row 1 (WS): k1, p2, k3' 'PKKPPP'
grid 'Cast on 6|Row 1: k1, p2, k3|Row 2: k1, p2, k3' 'KKKPPK PKKPPP'
grid 'Cast on 6|Row 1 (WS): k1, p2, k3|Row 2 (RS): k1, p2, k3' 'PKKPPP KKKPPK'
grid 'Cast on 6|Row 1: k1, p2, k3|Row 2 (RS): k1, p2, k3' 'PKKPPP KKKPPK'
grid 'Cast on 6|Rnd 1: k1, p2, k3|Rnd 2: k1, p2, k3' 'KKKPPK KKKPPK'
grid 'Cast on 3|Rows 1-4: knit' 'KKK PPP KKK PPP'
grid 'Cast on 3|Rounds 1-2: purl' 'PPP PPP'

# Many in a row, however they are set apart.
grid 'Row 1: k1,p1 k1 , p2,,k1, p1' 'PKPPKPK'
grid "$(printf 'Row 1: k2, p1,\302\240k1, p1, k3,&nbsp;p1, k1, p1, k2')" 'KKPKPKKKPKPKK'
grid 'Row 1 (WS): K1, P2, k1, p1, k1, p2' 'PKKPKPKK'
wrong E0309 'Cast on 9|Row 1: p2, k1, p1, k1, p1, k1 4 times' 'what is worked 4 times can be read in two ways'
wrong E0313 'Cast on 12|Row 1: p1, k1, p1, k1, k1, p1 rib to end' 'a rib over a part of a row'
grid 'stitch k3 { kx = 1; symbol = "x" }|Row 1: p1, k1, k3, p1, k2, p1, k1' 'KPKKPxKP'

# Repeats.
grid 'Cast on 10|Row 1: *k2, p2; rep from * to last 2 sts, k2' 'KKPPKKPPKK'
grid 'Cast on 10|Row 1: k1, *p2, k1; rep from * to end' 'KPPKPPKPPK'
grid 'Cast on 9|Row 1: *k2, p1; rep from *' 'PKKPKKPKK'
grid 'Cast on 10|Row 1: *k2, p1; rep from *, k1' 'KPKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1* to end' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1* 3 times' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1* repeat across' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; repeat from * across' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; rep from * to end of row' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; rep from *to*' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; rep from * 2 more times' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; rep from * twice more' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; rep from * 2 times' 'PKKPKKPKK'
grid 'Cast on 9|Row 1: *k2, p1; rep from * 3 times' 'PKKPKKPKK'
grid 'Cast on 10|Row 1: *k2, p1; rep from * until 1 st remains, k1' 'KPKKPKKPKK'
grid 'Cast on 10|Row 1: *k2, p1; rep from * to last st, end k1' 'KPKKPKKPKK'
grid 'Cast on 7|Row 1: knit to last 2 sts, p2' 'PPKKKKK'
grid 'Cast on 7|Row 1: p1, k to last st, p1' 'PKKKKKP'
grid 'Cast on 7|Row 1: k until 3 sts rem, p3' 'PPPKKKK'
grid 'Cast on 7|Row 1: k2, p to end' 'PPPPPKK'
grid 'Cast on 12|Row 1: k2, (p1, k1) to last 6 sts, k to last 2 sts, p2' 'PPKKKKKPKPKK'
grid 'Row 1: (k1, p1) 3 times, k1' 'KPKPKPK'
grid 'Row 1: [k1, p1] twice, k1' 'KPKPK'
grid 'Row 1: (k1, p1) x 3' 'PKPKPK'
grid 'Row 1: ((k1, p1) twice, p1) 2 times' 'PPKPKPPKPK'
grid 'Row 1: [(k1, p1) 2 times, [k2] x2] twice' 'KKKKPKPKKKKKPKPK'

# The words of knitters.
grid 'ROW 1 (RS): K2,P2' 'PPKK'
grid 'R1: k2 p2' 'PPKK'
grid '1st row: k2, p2' 'PPKK'
grid '1st row (right side): k2, p2|2nd row: k2, p2' 'PPKK PPKK'
grid 'Row 1 k2, p2' 'PPKK'
grid 'Row 1. K2, P2.' 'PPKK'
grid 'Row 1 - k2, p2' 'PPKK'
grid 'Row 1: knit 2, purl 2' 'PPKK'
grid 'Row 1: knit 2 sts, purl 2 stitches' 'PPKK'
grid 'Row 1: k2, p2 (4 sts)' 'PPKK'
grid 'Row 1: k2, p2 [4 sts]' 'PPKK'
grid 'Row 1: k2, p2 -- 4 sts' 'PPKK'
grid 'Cast on 3|Row 1: knit|Row 2: purl' 'KKK KKK'
grid 'Cast on 3 sts.|Row 1: knit all sts|Row 2: purl across' 'KKK KKK'
grid 'CO 3|Row 1: k|Row 2: p' 'KKK KKK'
grid 'Cast on 3|Row 1: k across row|Row 2: purl the whole row' 'KKK KKK'
grid 'Row 1: k2,|  p2' 'PPKK'
grid 'Row 1: *k2, p2;|rep from * 2 more times' 'PPKKPPKKPPKK'
grid 'Cast on 4|Row 1: *k1, p1|rep from * to end' 'PKPK'
grid 'Row 1: k2, p2; Row 2: p2, k2' 'PPKK KKPP'

# Which rows.
grid 'Cast on 2|Rows 1, 3 and 4: k1, p1|Row 2: k2' 'PK PP PK PK'
grid 'Cast on 2|Row 1 and all RS rows: knit|Row 2: k1, p1|Row 4: p1, k1' 'KK PK KK KP'
grid 'Cast on 2|All WS rows: purl|Row 1: k1, p1|Row 3: p1, k1' 'PK KK KP KK'
grid 'Cast on 2|Row 2 and every alternate row: p2|Row 1: k1, p1|Row 3: p1, k1' 'PK KK KP KK'
grid 'Cast on 2|Row 1: k1, p1|Row 2: k1, p1|Row 3: as row 1' 'PK PK PK'
grid 'Cast on 2|Row 1: k1, p1|Row 2: rep row 1' 'PK PK'
grid 'Cast on 2|1st row: k1, p1|2nd row: As 1st row|3rd row: Rep 1st row' 'PK PK PK'
grid 'Cast on 8|Row 1: [k2, p2] rep to end|Row 2: (k2, p2) across' 'PPKKPPKK PPKKPPKK'
grid 'Cast on 2|Row 1: k1, p1|Bind off all sts in pattern.' 'PK'
grid 'Cast on 2|Row 1: k1, p1|BO.' 'PK'
grid 'Cast on 3|Row 1: k1, p2|Row 2: knit the knits and purl the purls' 'PPK PPK'
grid 'Cast on 3|Row 1: k1, p2|Row 2: k the k sts and p the p sts' 'PPK PPK'
grid 'Cast on 2|Next row: k1, p1|Row 2: k2' 'PK PP'
grid 'Cast on 2|Row 1: k1, p1|Row 2: knit|Repeat rows 1-2 once' 'PK PP PK PP'
grid 'Cast on 2|Row 1: k1, p1|Row 2: knit|Rep rows 1 and 2 2 more times' 'PK PP PK PP PK PP'
grid 'Cast on 2|Row 1: k1, p1|Row 2: knit|Repeat rows 1-2 twice more.|Row 3: p2' 'PK PP PK PP PK PP PP'
grid 'Cast on 2|Row 1: k1, p1|Row 2: knit|Repeat rows 1-2 once|Row 5: p2' 'PK PP PK PP PP'
grid 'Cast on 2|Row 1: knit|Repeat row 1 three times' 'KK PP KK PP'
grid 'Cast on 2|Row 1: k2|Row 2: p2|Row 3: p2|Repeat the last 2 rows once' 'KK KK PP KK PP'
grid 'Cast on 2|Row 1: k1, p1|Row 2: knit|Repeat rows 1-2 until piece has 5 rows' 'PK PP PK PP PK'

# Before row 1.
grid 'Cast on 2|Set-up row 1: k1, p1|Set-up row 2: p2|Row 1: k2|Row 2: k1, p1|Repeat rows 1-2 once' 'PK KK KK PK KK PK'
grid 'Cast on 2|Foundation rows 1-2: k1, p1|Rows 1 and 2: knit' 'PK PK KK PP'
grid 'Cast on 2|Set-up (WS): k1, p1|Row 1 (RS): knit' 'PK KK'
grid 'Cast on 2|Setup: p1, k1|Row 1: knit' 'KP PP'
grid 'Cast on 2|Purl 1 row (WS)|Row 1 (RS): k1, p1' 'KK PK'
grid 'Cast on 2|Set-up (WS): knit 3 rows|Row 1 (RS): k1, p1' 'PP KK PP PK'
grid 'Cast on 2|Row 1 (set-up row): k1, p1|Row 2 (WS, pattern row): knit' 'PK PP'
grid 'Cast on 2|Row 1: knit|Repeat row 1 once|Row 1: k1, p1' 'KK PP PK'
wrong E0306 'Cast on 2|Set-up row 2: knit' 'set-up row 2 comes behind 0'
wrong E0204 'Cast on 2|Row 0: knit' 'a row number is 0'

# One row repeated right behind itself has the same words on both sides, whatever its mark.
grid 'Cast on 4|Row 1 (RS): k1, p3|Repeat row 1 three times' 'PPPK PKKK PPPK PKKK'
grid 'Cast on 4|Row 1 (RS): *K2, p2; rep from * to end. Repeat this row once more.' 'PPKK PPKK'
grid 'Cast on 4|Row 1 (WS): k1, p3|Repeat this row until piece has 3 rows' 'PKKK PPPK PKKK'
grid 'Cast on 2|Row 1 (RS): k2|Row 2 (WS): k1, p1|Repeat the last row twice' 'KK PK PK PK'
grid 'Cast on 2|Row 1 (RS): k2|Row 2 (WS): k1, p1|Repeat row 2 once' 'KK PK PK'
grid 'Cast on 2|Row 1 (RS): k2|Row 2 (WS): k1, p1|Repeat row 1 once' 'KK PK KK'
grid 'motif m multiple of 2 { Row 1 (RS): k1, p1. Repeat this row for pattern. }|swatch fill(m, 2, 3)' 'PK PK PK'

# Numbers worked out.
grid 'let n = 3|Row 1: k{n}, p{n - 1}' 'PPKKK'
grid 'let n = 2|Cast on {2 * n}|Row {n - 1}: [k1, p1] {n} times' 'PKPK'
grid 'for i in 1..3 {|Row {i}: k{i}, p{4 - i}|}' 'PPPK PPKK PKKK'
grid 'for i in [1, 2] { if i == 1 { Row 1: k2 } else { Row 2: k2 } }' 'KK PP'
grid 'Cast on 2|Row 1: k0, p2' 'PP'
grid 'Cast on 2|Row 1: (k0) twice, p2, (k1) 0 times' 'PP'
wrong E0303 'Cast on 2|Row 1: p0' 'row 1 works 0 stitches'
wrong E0404 'Row 1: p0' 'have no stitch'
wrong E0309 'Cast on 2|Row 1: *p0; rep from *' 'nothing to work'
wrong E0309 'Cast on 2|Row 1: *(k1) 0 times; rep from *' 'nothing to work'

# Own stitches: their names, their symbols, what they show from behind.
grid 'stitch T { kx = 1; symbol = "t" }|Row 1: t2, p1|Row 2: T1, k2' 'Ptt tPP'
grid 'stitch A { symbol = "a"; ws = B }|stitch B { symbol = "b"; ws = A }|Row 1: a2, b1|Row 2: a2, b1' 'baa bba'

grid 'Multiple of 2 sts plus 1|Cast on 5 sts|Row 1: *k1, p1; rep from * to last st, k1' 'KPKPK'
wrong E0401 'Multiple of 2 + 1|Cast on 4|Row 1: k4' '4 is not a multiple of 2 + 1'
size 'Multiple of 2 + 1|Row 1: k1, p1, k1' '3 x 1'

# What does not come out.
wrong E0303 'Cast on 24|Row 1: k23' 'row 1 works 23 stitches, but 24 are cast on'
wrong E0303 'Row 1: k24|Row 2: p23' 'row 2 works 23 stitches, but row 1 left 24'
wrong E0304 'Cast on 10|Row 1: *k2, p2; rep from * to end' 'fits a multiple of 4, but'
wrong E0304 'Cast on 10|Row 1: *k2, p2; rep from * to last st, k1' 'a multiple of 4 + 1'
wrong E0303 'Cast on 10|Row 1: k to last 2 sts, p1' 'leaves stitches unworked: 1 more'
wrong E0303 'Cast on 10|Row 1: k to last 2 sts, p3' 'works 1 stitch more'
wrong E0303 'Cast on 4|Row 1: k to last 6 sts, p6' 'needs 6 stitches at least'
wrong E0305 'Cast on 4|Row 1: k2, p2 (5 sts)' 'ends with 4 stitches, not 5'
wrong E0306 'Cast on 2|Row 1: k2|Row 3: k2' 'row 2 is missing'
wrong E0306 'Cast on 2|Row 1: k2|Row 1: p2' 'row 1 is written twice'
wrong E0306 'Cast on 2|Rows 3-1: k2' 'backwards'
wrong E0307 'Cast on 2|Row 1 (RS): k2|Row 2 (RS): p2' 'row 2 is marked RS'
wrong E0307 'Cast on 2|Row 1 (RS): k2|Row 2 (WS): k2|Repeat row 1 twice' 'row 1 is marked RS'
wrong E0307 'Cast on 2|Row 1 (RS): k2|Row 2: k2|Row 3: p2|Repeat rows 1-3 once' 'row 1 is marked RS'
wrong E0307 'Cast on 2|Rnd 1 (WS): k2' 'right side'
wrong E0308 'Cast on 2|Row 1: k2|Rnd 2: k2' 'rows and rounds'
wrong E0309 'Cast on 10|Row 1: *k2, p2; rep from * 3 times' 'two ways'
wrong E0309 'Row 1: *k2, p2; rep from * 3 times' 'two ways'
wrong E0309 'Cast on 9|Row 1: *k1; rep from *, *p1; rep from *' 'is open'
wrong E0309 'Row 1: (k1, p1) 3 more times' 'in all'
wrong E0309 'Cast on 9|Row 1: (k1, p1 to last 2 sts) twice, k2' 'number of times must be given'
wrong E0309 'Row 1: k2 3' 'has a number already'
wrong E0310 'Row 1: *k2, p2; rep from * to end|Row 2: *k3, p3; rep from * to end' 'not said'
wrong E0310 'Row 1: *k2, p2; rep from * to end|Row 2: k5' 'fits 5 stitches'
wrong E0311 'Row 1: k2|Cast on 2|Row 2: k2' 'before the first row'
wrong E0311 'Cast on 2|Cast on 3|Row 1: k2' 'already'
wrong E0312 'Cast on 2|Row 1: as row 3' 'no row 3'
wrong E0312 'Cast on 2|Row 1: k2|Repeat rows 1-3 once' 'no row 2'
wrong E0312 'Cast on 2|Row 1: knit the knits and purl the purls' 'below the first'
wrong E0404 'Cast on 2' 'no row'

# Refused by their names, with the reason; not read as something else.
for word in k2tog p2tog ssk skp yo yfwd m1 M1L kfb sl1 sl k1tbl c4f C6B T2F tw2 bo2 k3togtbl inc1 dec 2/2RC; do
    wrong E0302 "Row 1: k2, $word, k2" "'$word' (.*) changes the stitch count or the topology"
done
wrong E0301 'Row 1: k2, q3' "'q3' is no stitch"
wrong E0301 'Row 1: kinit 3' "'kinit' is no stitch"
out 'a near word is offered' "hint: did you mean 'knit'?"

finish
