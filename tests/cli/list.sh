#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft list: every motif it names can be shown.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

exits 0 'list' "$WEFT" list
out 'has a heading' '^motif  *multiple  *rows'
out 'has the Miura motif' '^miura(half = 6)  *12  *23 '
names=$(sed '1d; s/[ (].*//' "$work/out")

for motif in $names; do
    exits 0 "list $motif" "$WEFT" list "$motif"
    out "$motif: what it is" "^$motif\((.*)\)*: "
    out "$motif: its chart" '  1$'
done

# The whole comment: the first line behind the name, the others below it.
exits 0 'a motif of several lines' "$WEFT" list miura
check 'has them all' test "$(head -4 "$work/out" | tr '\n' '|')" = \
    'miura(half = 6): Zigzag columns (Fig. 3a)|Folds like the Miura map fold.|`half` is the width of a column in stitches, and half the height of a zigzag in rows.|multiple of 12, 23 rows, in std/miura.knit|'
exits 0 'other names' "$WEFT" list ladder
out 'are told' '^Also: gansey ladder\.$'
exits 0 'a name that begins another' "$WEFT" list rib
out 'has its own text' '^rib(k = 2, p = 2): Columns of k knit and p purl stitches$'

exits 2 'a motif that is not there' "$WEFT" list miurra
err 'is like another' "no motif 'miurra'; did you mean miura?"
exits 2 'a motif by another name' "$WEFT" list 'Spot'
err 'is told' "no motif 'Spot'; the library calls it dot$"
exits 2 'a motif like no other' "$WEFT" list wxyzwxyz
err 'is said' "no motif 'wxyzwxyz'$"

finish
