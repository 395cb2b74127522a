#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft write: the words a knitter would use, and the same grid when they are read again.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/charts/grids.sh"

# writes NAME SCRIPT [OPTION]...: lines of the script are separated by |; the text is standard input.
writes() {
    cat >"$work/wanted"
    name=$1
    printf '%s\n' "$2" | tr '|' '\n' >"$work/x.knit"
    shift 2
    exits 0 "$name" "$WEFT" write "$work/x.knit" "$@"
    check 'word for word' diff "$work/wanted" "$work/out"
}

rib='Cast on 22|Row 1: *k2, p2; rep from * to last 2 sts, k2|Row 2: *p2, k2; rep from * to last 2 sts, p2'
writes 'a rib' "$rib|Repeat rows 1-2 14 times" <<'TEXT'
Multiple of 4 sts + 2.
Cast on 22 sts.
Row 1 (RS): *k2, p2; rep from * to last 2 sts, k2. (22 sts)
Row 2 (WS): *p2, k2; rep from * to last 2 sts, p2. (22 sts)
Repeat rows 1-2 14 more times.
Bind off.
TEXT
writes 'a rib in the round' "$rib|Repeat rows 1-2 14 times" --round <<'TEXT'
Multiple of 4 sts + 2.
Cast on 22 sts; join to work in the round.
Rnds 1-30: *k2, p2; rep from * to last 2 sts, k2. (22 sts)
Bind off.
TEXT
writes 'a remainder' "$rib|Row 3: purl|Row 4: p2, k20|Repeat rows 1-4 twice|Row 13: k2, (p2, k2) to end|Row 14: as row 2" <<'TEXT'
Cast on 22 sts.
Row 1 (RS): *k2, p2; rep from * to last 2 sts, k2. (22 sts)
Row 2 (WS): *p2, k2; rep from * to last 2 sts, p2. (22 sts)
Row 3 (RS): purl. (22 sts)
Row 4 (WS): p2, k20. (22 sts)
Repeat rows 1-4 until piece has 14 rows.
Bind off.
TEXT
writes 'equal rows' 'Cast on 3|Rows 1 and 3: k1, p2|Rows 2 and 5: p1, k2|Row 4: purl' <<'TEXT'
Cast on 3 sts.
Rows 1 and 3 (RS): k1, p2. (3 sts)
Rows 2 and 5: p1, k2. (3 sts)
Row 4 (WS): purl. (3 sts)
Bind off.
TEXT
writes 'garter' 'use garter from std|swatch tile(garter, 5, 10)' <<'TEXT'
Cast on 5 sts.
Rows 1-20: knit. (5 sts)
Bind off.
TEXT
writes 'one text for all WS rows' \
    'Cast on 6|Rows 2, 4 and 6: purl|Row 1: *k2, p1; rep from *|Row 3: k1, p1, k4|Row 5: p2, k4|Repeat rows 1-6 twice' <<'TEXT'
Cast on 6 sts.
Row 1 (RS): *k2, p1; rep from * to end. (6 sts)
Row 2 and all WS rows: purl. (6 sts)
Row 3 (RS): k1, p1, k4. (6 sts)
Row 5 (RS): p2, k4. (6 sts)
Repeat rows 1-6 2 more times.
Bind off.
TEXT
writes 'a row of several kinds of stripes, none of them the most of it' 'Row 1: (k1, p1) 3 times, (k6, p1) twice, k7, p1, k1, p1' <<'TEXT'
Cast on 30 sts.
Row 1 (RS): [k1, p1] 3 times, k6, p1, k6, p1, k7, p1, k1, p1. (30 sts)
Bind off.
TEXT
writes 'edges on both sides' 'use basketweave from std|swatch fill(basketweave, 29, 16)' <<'TEXT'
Multiple of 8 sts + 5.
Cast on 29 sts.
Rows 1 and 5 (RS): knit. (29 sts)
Rows 2 and 4 (WS): *k5, p3; rep from * to last 5 sts, k5. (29 sts)
Row 3 (RS): *p5, k3; rep from * to last 5 sts, p5. (29 sts)
Rows 6 and 8 (WS): k1, *p3, k5; rep from * to last 4 sts, p3, k1. (29 sts)
Row 7 (RS): p1, *k3, p5; rep from * to last 4 sts, k3, p1. (29 sts)
Repeat rows 1-8 once more.
Bind off.
TEXT
writes 'a repeat that is cut within a run' 'Cast on 48|Row 1: *k7, p12, k5; rep from * to end' <<'TEXT'
Multiple of 24 sts.
Cast on 48 sts.
Row 1 (RS): *k7, p12, k5; rep from * to end. (48 sts)
Bind off.
TEXT
writes 'two repeats in a row' 'Row 1: (k1, p1) 6 times, k10, (p1, k1) 6 times, p1' <<'TEXT'
Cast on 35 sts.
Row 1 (RS): [k1, p1] 6 times, k10, [p1, k1] 6 times, p1. (35 sts)
Bind off.
TEXT
writes 'one stitch left' 'Row 1: (k1, p1) 6 times, k1' <<'TEXT'
Multiple of 2 sts + 1.
Cast on 13 sts.
Row 1 (RS): *k1, p1; rep from * to last st, k1. (13 sts)
Bind off.
TEXT
writes 'one stitch' 'swatch K' <<'TEXT'
Cast on 1 st.
Row 1 (RS): knit. (1 st)
Bind off.
TEXT
writes 'a long row, with breaks behind commas' \
    'Row 1: k1, p2, k3, p4, k5, p6, k7, p8, k9, p10, k11, p12, k13, p14, k15, p16, k17, p18' <<'TEXT'
Cast on 171 sts.
Row 1 (RS): k1, p2, k3, p4, k5, p6, k7, p8, k9, p10, k11, p12, k13,
    p14, k15, p16, k17, p18. (171 sts)
Bind off.
TEXT
writes 'a repeat behind a group that is no part of it' 'Row 1: (p1, k1) 3 times, *p2, k1, p1, k1, p1, k1; rep from *|Cast on 48' <<'TEXT'
Multiple of 7 sts + 6.
Cast on 48 sts.
Row 1 (RS): [p1, k1] 3 times, *p2, k1, p1, k1, p1,
    k1; rep from * to end. (48 sts)
Bind off.
TEXT
writes 'a long repeat, whose end stays with its last stitches' \
    'Cast on 147|Row 1: *k1, p2, k3, p4, k5, p6, k7, p8, k9, p10, k8; rep from * to last 21 sts, p1, k20' <<'TEXT'
Cast on 147 sts.
Row 1 (RS): *k1, p2, k3, p4, k5, p6, k7, p8, k9, p10,
    k8; rep from * to last 21 sts, p1, k20. (147 sts)
Bind off.
TEXT
writes 'a group at the end of a line' \
    'Row 1: k11, p12, k13, p14, k15, p16, k17, p18, k19, (p20, k21) 3 times, p22, k23' <<'TEXT'
Cast on 303 sts.
Row 1 (RS): k11, p12, k13, p14, k15, p16, k17, p18, k19,
    [p20, k21] 3 times, p22, k23. (303 sts)
Bind off.
TEXT
writes 'parts of the height repeated each for itself' 'use weave from std|swatch weave' <<'TEXT'
Cast on 48 sts.
Row 1 (RS): k10, p28, k10. (48 sts)
Row 2 (WS): p10, k28, p10. (48 sts)
Repeat rows 1-2 7 more times.
Row 17 (RS): knit. (48 sts)
Row 18 (WS): purl. (48 sts)
Row 19 (RS): p14, k20, p14. (48 sts)
Row 20 (WS): k14, p20, k14. (48 sts)
Repeat rows 19-20 7 more times.
Row 35 (RS): knit. (48 sts)
Row 36 (WS): purl. (48 sts)
Bind off.
TEXT

exits 0 'to a file' "$WEFT" write "$work/x.knit" -o "$work/pattern.knit"
check 'the same text' sh -c '"$1" write "$2/x.knit" | diff - "$2/pattern.knit"' - "$WEFT" "$work"
exits 3 'a script with an error' "$WEFT" write "$work/flag.txt"

# Stitches of the script's own come with their definitions.
writes 'an own stitch' 'stitch T { kx = -0.2 / 3; ky = 1.4; symbol = "t" }|Cast on 12|Row 1: *t2, p1; rep from *|Row 2: *T, k2; rep from *|Row 3: t' <<'TEXT'
stitch T { kx = -0.06666666666666667; ky = 1.4; symbol = "t" }
Multiple of 3 sts.
Cast on 12 sts.
Row 1 (RS): *T 2, p1; rep from * to end. (12 sts)
Row 2 (WS): *T 1, k2; rep from * to end. (12 sts)
Row 3 (RS): T. (12 sts)
Bind off.
TEXT

writes 'knit and purl of other curvatures' 'stitch K { kx = -0.5; twist = 0.1; symbol = "v" }|stitch P { ky = -2; twist = 0 }|Row 1: k2, p1' <<'TEXT'
stitch K { kx = -0.5; ky = 1; twist = 0.1; symbol = "v" }
stitch P { kx = 0.5; ky = -2; twist = 0 }
Cast on 3 sts.
Row 1 (RS): k2, p1. (3 sts)
Bind off.
TEXT
writes 'purl that follows knit needs no words' 'stitch K { kx = -0.5 }|Row 1: k2, p1' <<'TEXT'
stitch K { kx = -0.5; ky = 1 }
Cast on 3 sts.
Row 1 (RS): k2, p1. (3 sts)
Bind off.
TEXT

# ---- there and back ----

# back SCRIPT OPTION...: the written text of the script gives its grid.
back() {
    "$WEFT" chart --grid "$1" >"$work/wanted"
    "$WEFT" write "$@" >"$work/written.knit" && "$WEFT" chart --grid "$work/written.knit" | cmp "$work/wanted" - &&
        awk 'length($0) > 80 { print; wide = 1 } END { exit wide }' "$work/written.knit"
}

mkdir "$work/random" "$work/library"
library_scripts "$work/library"
for file in "$work"/library/*.knit; do
    check "$(basename "$file" .knit) flat" back "$file"
    check "$(basename "$file" .knit) in the round" back "$file" --round
done

random_grids "$work/random" 60
bad=0
for file in "$work"/random/*.txt "$work/flag.txt"; do
    "$WEFT" import "$file" >"$work/x.knit"
    back "$work/x.knit" && back "$work/x.knit" --round || bad=$((bad + 1))
done
check 'random grids come back' test "$bad" = 0

# Own stitches, also one called as knit is, one with a number in its name, ones that change on the wrong side.
own='stitch T { kx = 1; ws = S }|stitch S { ky = 2; twist = 1e-9; ws = T; symbol = "k" }|stitch purl { kx = 3 }|stitch T2 { symbol = "#" }'
for formula in '(x * x + 3 * y * y + x * y) mod 6' '(x + y) mod 6' '(x + 2 * floor(y / 4)) mod 6'; do
    printf '%s\n' "$own" 'stitch K { ws = K }|stitch P { ws = P }' "swatch each (x, y) in 18 by 16 : [K, P, T, S, purl, T2][$formula]" | tr '|' '\n' >"$work/own.knit"
    check "own stitches flat: $formula" back "$work/own.knit"
    check 'their symbols, too' sh -c '"$1" chart "$2/own.knit" >"$2/a" && "$1" chart "$2/written.knit" | diff "$2/a" -' - "$WEFT" "$work"
    check "own stitches in the round: $formula" back "$work/own.knit" --round
done
printf 'stitch T { ws = S }\nstitch S { }\nswatch above(S, S, S)\n' >"$work/own.knit"
exits 0 'a stitch that shows itself, and shows for another, too' "$WEFT" write "$work/own.knit"
out 'is worked as itself' '^Rows 1-3: S\. (1 st)$'
printf 'stitch T { ws = S }\nstitch S { }\nswatch above(K, T)\n' >"$work/own.knit"
exits 3 'a stitch that no row of the wrong side can show' "$WEFT" write "$work/own.knit"
err 'is named' 'no stitch worked on the wrong side shows the stitch T'
check 'rounds can' back "$work/own.knit" --round

# Neither a wide nor a high fabric takes long.
printf 'swatch each (x, y) in 900 by 900 : (x * x + 3 * y * y + x * y) mod 7 < 3 ? P : K\n' >"$work/large.knit"
check 'a large fabric' back "$work/large.knit"
printf 'swatch each (x, y) in 4 by 100000 : (x * x + 3 * y * y) mod 7 < 3 ? P : K\n' >"$work/high.knit"
check 'a high fabric' back "$work/high.knit"
awk 'BEGIN { srand(5); for (i = 0; i < 110000; i++) print rand() < 0.5 ? "KP" : "PK" }' >"$work/noise.txt"
"$WEFT" import "$work/noise.txt" >"$work/noise.knit"
exits 3 'one that has too many rows of its own' "$WEFT" write "$work/noise.knit"
err 'is refused with the reason' 'noise.knit: this fabric cannot be written as a script: a row number is'
empty 'and nothing comes out' "$work/out"

# Rounds stay rounds.
printf 'Cast on 4\nRnd 1: *k2, p2; rep from *\nRnd 2: knit\n' >"$work/rounds.knit"
exits 0 'a script of rounds' "$WEFT" write "$work/rounds.knit"
out 'is written as rounds' '^Rnd 2: knit'
printf 'Cast on 4\nRow 1: knit\nRow 2: purl\n' >"$work/rows.knit"
exits 0 'a script of rows' "$WEFT" write "$work/rows.knit"
out 'is written as rows' '^Row 2 (WS): purl'

printf 'Row 1: k2, p2\n' >"$work/kind.knit"
no_kind write kind.knit

finish
