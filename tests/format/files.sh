#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft fmt on every script there is: the fabric, the settings and the messages
# stay, formatting again changes nothing, and our own scripts are formatted.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"
dump=$(cd "$(dirname "$dump")" && pwd)/knit_dump

# What a script means: its grid and settings, or its messages without their places.
meaning() {
    # shellcheck disable=SC2086
    { "$dump" $options "$1"; "$dump" $options --settings "$1"; } 2>&1 |
        grep -av '^ *[0-9]* |' | sed 's/^[^ ]*:[0-9]*:[0-9]*: //; s/ line=[0-9]*$//'
}

same_meaning() {
    (cd "$work/was" && meaning "$1") >"$work/before"
    meaning "$1" >"$work/after"
    diff "$work/before" "$work/after"
}

# Two copies of all, so that what a script uses is found and called the same.
mkdir "$work/was"
cp -r "$WEFT_SOURCE"/tests/golden/* "$WEFT_SOURCE"/stdlib/*.knit "$work/was"
for file in "$WEFT_SOURCE"/examples/*.knit; do
    cp "$file" "$work/was/example_$(basename "$file")"
done
chmod -R u+w "$work/was"
cp -r "$work/was" "$work/now"
cd "$work/now" || exit 1
formatted=0
for file in *.knit; do
    options=$(sed -n '1s/^# options: //p' "$file" | tr -d '\000' | sed 's/--[a-z]*//g')
    if "$WEFT" fmt "$file" 2>"$work/err"; then
        formatted=$((formatted + 1))
        exits 0 "$file: formatted twice" "$WEFT" fmt --check "$file"
        check "$file: the same fabric" same_meaning "$file"
    else
        check "$file: is refused for its errors" grep -q 'error: .* \[E' "$work/err"
    fi
done
check 'most could be formatted' test "$formatted" -ge 45

exits 0 'the library is formatted' "$WEFT" fmt --check "$WEFT_SOURCE"/stdlib/*.knit
exits 0 'and the examples' "$WEFT" fmt --check "$WEFT_SOURCE"/examples/*.knit

# What weft writes is formatted already.
for stem in rib seed; do
    "$WEFT" write "$WEFT_SOURCE/examples/$stem.knit" >once.knit
    exits 0 "weft write $stem" "$WEFT" fmt --check once.knit
    "$WEFT" chart --grid "$WEFT_SOURCE/examples/$stem.knit" >"$stem.txt"
    "$WEFT" import "$stem.txt" >once.knit
    exits 0 "weft import $stem" "$WEFT" fmt --check once.knit
done

finish
