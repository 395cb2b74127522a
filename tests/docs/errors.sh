#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The error index has a section for each code there is, and no other, with an
# example of it (tests/docs/blocks.sh runs them).
. "${WEFT_SOURCE:-.}/tests/tap.sh"
index=$WEFT_SOURCE/docs/errors.md

sed -n 's/^ *X(CODE_[A-Z_]*, *\([0-9]*\), *"\(.*\)").*/\1 \2/p' "$WEFT_SOURCE/lang/codes.h" |
    while read -r number about; do
        [ "$number" -lt 900 ] && letter=E || letter=W
        echo "$letter$(printf %04d "$number") $about"
    done >"$work/codes"
check 'codes were found' test "$(wc -l <"$work/codes")" -gt 50

# What stands under a code's heading.
section() {
    awk -v code="$1" '/^#/ && !inside { in_section = $2 == code ":" } /^```/ { inside = !inside } in_section' "$index"
}

while read -r code about; do
    section "$code" >"$work/section"
    check "$code: $about" grep -q "^### $code: " "$work/section"
    check "$code has an example" grep -Eq '^```(knit|sh) bad' "$work/section"
    check "$code is explained" test "$(grep -c '^[A-Z].*\.' "$work/section")" -ge 1
done <"$work/codes"

sed -n 's/^### \([EW][0-9]*\):.*/\1/p' "$index" >"$work/headings"
sed 's/ .*//' "$work/codes" >"$work/known"
check 'no other code, each once, in order' diff "$work/known" "$work/headings"
finish
