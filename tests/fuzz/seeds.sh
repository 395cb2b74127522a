#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What the fuzzers begin with: seeds.sh FOLDER makes FOLDER/script, FOLDER/kp ..
# from the examples, the library and the tests' own inputs.
set -eu
weft=${WEFT:-./weft} source=${WEFT_SOURCE:-.}
for target in script format kp csv knitout png; do
    mkdir -p "$1/$target"
    for file in "$source"/tests/fuzz/found/"$target"-*; do
        [ ! -e "$file" ] || cp "$file" "$1/$target/"
    done
done
for file in "$source"/examples/*.knit "$source"/stdlib/*.knit "$source"/tests/golden/*.knit \
    "$source"/tests/golden/pasted/*.knit "$source"/tests/format/*.knit; do
    [ -f "$file" ] || continue
    name=$(basename "$(dirname "$file")")-$(basename "$file" .knit)
    cp "$file" "$1/script/$name"
    cp "$file" "$1/format/$name"
done

# Every case of the language's tables.
mkdir -p "$1/case"
awk -v folder="$1/case/" -v wanted="$1/wanted" -f "$source/tests/golden/cases.awk" \
    "$source/tests/golden/grammar.txt" "$source/tests/golden/books.txt" "$source/tests/golden/web.txt" "$source/tests/golden/ways.txt"
for file in "$1"/case/*.knit; do
    cp "$file" "$1/script/case-$(basename "$file" .knit)"
    cp "$file" "$1/format/case-$(basename "$file" .knit)"
done
rm -r "$1/case" "$1/wanted"

# Every one-line program of the shell tests.
sed -n "s/^\(grid\|size\|wrong E[0-9]*\) '\([^']*\)'.*/\2/p" "$source"/tests/golden/test_*.sh | {
    n=0
    while IFS= read -r line; do
        n=$((n + 1))
        printf '%s\n' "$line" | tr '|' '\n' >"$1/script/line-$n"
    done
}

# Small charts, as every format writes them.
for name in seed_even flag basketweave diagonal_check box waffle; do
    "$weft" list "$name" >/dev/null 2>&1 || continue
    printf 'use %s from std\nswatch %s\n' "$name" "$name" >"$1/chart.knit"
    "$weft" chart --grid "$1/chart.knit" >"$1/kp/$name"
    for kind in csv:csv k:knitout png:png; do
        as=$([ "${kind%:*}" != png ] || echo pixels:)
        "$weft" chart -q "$1/chart.knit" -o "$as$1/chart.${kind%:*}" 2>/dev/null &&
            mv "$1/chart.${kind%:*}" "$1/${kind#*:}/$name" || :
    done
done
printf '# 2 3\nKP\nPK\n' >"$1/kp/header"
rm -f "$1/chart.knit"
