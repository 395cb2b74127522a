#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library's motifs against stitches.txt, grids from outside the program.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"
facts=$WEFT_SOURCE/tests/golden/stitches.txt
library=$WEFT_SOURCE/tests/golden/test_library.sh

# Lines of stitches.txt in; the motif and its rows out, each row in full.
# shellcheck disable=SC2016
expand='
function letters(row,   out, n) {
    for (out = ""; row != ""; row = substr(row, 1 + n)) {
        n = match(substr(row, 2), /^[0-9]+/) ? 1 + RLENGTH : 1
        out = out repeated(substr(row, 1, 1), "", n > 1 ? substr(row, 2, n - 1) : 1)
    }
    return out
}
function repeated(text, between, n,   out) {
    for (out = text; n > 1; n--)
        out = out between text
    return out
}
!/^#/ {
    rows = group = ""
    for (name in named)
        delete named[name]
    for (i = 3; i <= NF; i++) {
        word = $i
        if (word ~ /^[A-Z]=/) {
            named[substr(word, 1, 1)] = letters(substr(word, 3))
            continue
        }
        if (word ~ /^\(/) {
            before = rows
            rows = ""
            word = substr(word, 2)
        }
        times = word ~ /[*]/ ? word : 1
        sub(/.*[*]/, "", times)
        closes = word ~ /[)]/
        sub(/[)*].*/, "", word)
        row = word in named ? named[word] : letters(word)
        if (closes)
            rows = before " " repeated(substr(rows " " row, 2), " ", times)
        else
            rows = rows " " repeated(row, " ", times)
    }
    print $1 rows
}'

awk "$expand" "$facts" >"$work/facts"
while read -r motif rows; do
    script "use ${motif%%[(]*} from std|swatch $motif"
    "$dump" "$work/x.knit" 2>&1 | sed '/warning: .moss. is two patterns/,/^hint: /d' >"$work/out"
    same "$motif" "$rows"
done <"$work/facts"

# Edge stitches belong to the repeat: one repeat cut from a piece of three by two,
# at any corner, is the motif itself.
"$WEFT" list >"$work/list"
sed '1d; s/[ (].*//' "$work/list" >"$work/names"
right='width(tile(m, 3, 1)) - width(m)'
while read -r motif; do
    script "use $motif from std|swatch $motif"
    "$dump" "$work/x.knit" >"$work/one" 2>&1
    for corner in '0, 0' "$right, 0" '0, height(m)' "$right, height(m)"; do
        script "use $motif from std|let m = $motif|swatch crop(tile(m, 3, 2), $corner, width(m), height(m))"
        "$dump" "$work/x.knit" >"$work/out" 2>&1
        check "$motif: its repeats are alike, from $corner" cmp "$work/one" "$work/out"
    done
    check "$motif: a grid is known" grep -q -e "^${motif}[( ]" -e "^figure $motif " "$facts" "$library"
done <"$work/names"

# shellcheck disable=SC2016
check 'the list fits a terminal' awk 'length($0) > 78 { print; wide = 1 } END { exit wide }' "$work/list"
finish
