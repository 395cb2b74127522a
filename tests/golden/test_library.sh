#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library's motifs against facts from elsewhere: grids of the craft (right
# side, bottom row first) and sums over the published grids of the paper's Fig. 3.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"

# motif EXPRESSION ROWS
motif() {
    grid "use ${1%%[(]*} from std|swatch $1" "$2"
}

motif stockinette 'K K'
motif reverse_stockinette 'P P'
motif garter 'K P'
motif rib_1x1 'PK PK'
motif rib_2x1 'PKK PKK'
motif rib_2x2 'PPKK PPKK'
motif rib_3x1 'PKKK PKKK'
motif rib_3x3 'PPPKKK PPPKKK'
motif 'rib(4, 1)' 'PKKKK PKKKK'
motif seed 'PK KP'
motif seed_odd 'KPK PKP'
motif moss_us 'KPK KPK PKP PKP'
motif checkerboard 'KKKKPPPPKKKK KKKKPPPPKKKK KKKKPPPPKKKK KKKKPPPPKKKK PPPPKKKKPPPP PPPPKKKKPPPP PPPPKKKKPPPP PPPPKKKKPPPP'
ground=KKKKKKKKKKKKK
motif basketweave "$ground PPPPPKKKPPPPP PPPPPKKKPPPPP PPPPPKKKPPPPP $ground PKKKPPPPPKKKP PKKKPPPPPKKKP PKKKPPPPPKKKP"

# Edge stitches stay, repeats grow.
grid 'use seed_odd from std|swatch fill(seed_odd, 5, 2)' 'KPKPK PKPKP'
grid 'use checkerboard from std|swatch crop(fill(checkerboard, 20, 8), 0, 0, 20, 1)' 'KKKKPPPPKKKKPPPPKKKK'
size 'use basketweave from std|swatch fill(basketweave, 45, 20)' '45 x 20'
wrong E0401 'use basketweave from std|swatch fill(basketweave, 44, 20)' '44 is not a multiple of 8 + 5'
out 'the widths on both sides are named' 'hint: the nearest widths are 37 and 45'

# Fig. 3, tiled as there: columns x rows, how many purl stitches, the sum cksum
# makes of the lines of K and P.
figure() {
    script "use $1 from std|swatch $2"
    "$dump" "$work/x.knit" >"$work/out" 2>&1
    got="$(awk 'NR == 1 { w = length($0) } { p += gsub(/P/, "") } END { print w " x " NR ", " p " purl" }' "$work/out"), $(cksum <"$work/out")"
    check "Fig. 3: $1" test "$got" = "$3"
}
figure miura 'tile(miura, 4, 4)' '48 x 92, 2208 purl, 3717146476 4508'
figure chains 'tile(chains, 6, 6)' '48 x 36, 1152 purl, 3100113451 1764'
figure columns 'columns' '66 x 58, 1424 purl, 3541613456 3886'
figure peaks 'peaks' '80 x 79, 3161 purl, 3317124441 6399'
figure squiggles 'tile(squiggles, 2, 4)' '48 x 40, 960 purl, 1232478499 1960'
figure bars 'tile(bars, 2, 2)' '64 x 40, 928 purl, 2958328470 2600'
figure weave 'tile(weave, 2, 2)' '96 x 72, 3584 purl, 2293317365 6984'

# The Miura zigzag by its size: `half` stitches to a column, 4 half - 1 rows.
motif 'miura(2)' 'PPKK KPPK KPPK KKPP KKPP KPPK KPPK'
size 'use miura from std|swatch miura(3)' '6 x 11'

# Peaks equals none of its images, so a turned-around output cannot go unnoticed.
for image in mirror flip invert turn rotate; do
    script "use peaks from std|swatch $image(peaks)"
    "$dump" "$work/x.knit" >"$work/image"
    script "use peaks from std|swatch peaks"
    "$dump" "$work/x.knit" >"$work/out"
    if cmp -s "$work/image" "$work/out"; then
        fail "peaks is not its $image"
    else
        pass "peaks is not its $image"
    fi
done
check 'the lowest row of peaks begins with purl at the left' grep -q '^PPPPKKKKPPPPKKKK' "$work/out"
check 'and it is the first line' sh -c "head -n 1 '$work/out' | grep -q '^PPPPKKKK.*KPPPK\$'"

finish
