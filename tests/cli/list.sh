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

exits 2 'a motif that is not there' "$WEFT" list miurra
err 'is like another' "no motif 'miurra'; did you mean miura?"
exits 2 'a motif like no other' "$WEFT" list wxyzwxyz
err 'is said' "no motif 'wxyzwxyz'$"

finish
