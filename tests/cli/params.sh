#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft params: what -D can set, as a table and as JSON.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cat >"$work/x.knit" <<'KNIT'
param half = 6 in 3..12 "stitches in half a repeat"
param scale = 0.1
swatch tile(K, half, ceil(10 * scale))
KNIT

exits 0 'table' "$WEFT" params "$work/x.knit"
out 'has the range' '^half *= 6 *in 3\.\.12 *stitches'
out 'or none' '^scale *= 0.1 *$'

printf 'param a = 3 cm in 1 mm..4 cm "a length"\nswatch tile(K, 2, 2)\ngauge { width = a }\n' >"$work/length.knit"
exits 0 'a length' "$WEFT" params "$work/length.knit"
out 'has its unit' '^a  *= 30 mm *in 1 mm\.\.40 mm *a length$'

exits 0 'JSON' "$WEFT" params "$work/x.knit" --json
cp "$work/out" "$work/x.json"
value() { tests/cli/json "$work/x.json" "$1"; }
check 'name' test "$(value params.0.name)" = half
check 'default' test "$(value params.0.default)" = 6
check 'range' test "$(value params.0.range)" = '{"low":3,"high":12}'
check 'text' test "$(value params.0.text)" = 'stitches in half a repeat'
check 'exact number' test "$(value params.1.default)" = 0.1
check 'no range' test "$(value params.1.range)" = null

printf 'param how = "newton"\nparam a = 3 cm\nswatch tile(K, 2, 2)\ngauge { width = a }\nsolve { method = how }\n' >"$work/text.knit"
exits 0 'a text' "$WEFT" params "$work/text.knit"
out 'as it stands' '^how  *= newton  *$'
exits 0 'a text, as JSON' "$WEFT" params "$work/text.knit" --json
cp "$work/out" "$work/x.json"
check 'is its default' test "$(value params.0.default)" = newton
check 'without a unit' test "$(value params.0.unit)" = ''
check 'a length has one' test "$(value params.1.unit)" = length
check 'and is counted in millimetres' test "$(value params.1.default)" = 30

echo 'swatch tile(K, 2, 2)' >"$work/none.knit"
exits 0 'none' "$WEFT" params "$work/none.knit" --json
cp "$work/out" "$work/x.json"
check 'is an empty list' test "$(value params)" = '[]'

finish
