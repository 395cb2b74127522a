#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft check: exit status and messages; what is on which stream.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

printf 'Cast on 6 sts\nRow 1: *k2, p1; rep from * to end\n' >"$work/good.knit"
printf 'Cast on 6 sts\nRow 1: k5\n' >"$work/short.knit"
printf 'swatch nothing\n' >"$work/name.knit"

exits 0 'a good script' "$WEFT" check "$work/good.knit"
out 'says the size of its swatch' ': 6 stitches x 1 rows, 4 knit, 2 purl$'
empty 'and no message' "$work/err"

exits 0 'quietly' "$WEFT" check -q "$work/good.knit"
empty 'prints nothing' "$work/out"

exits 3 'a bad script' "$WEFT" check "$work/short.knit"
err 'its error has a place' 'short.knit:2:.*error'
empty 'and no result' "$work/out"

exits 3 'a good and a bad one' "$WEFT" check "$work/good.knit" "$work/name.knit"
out 'the good one has its line' 'good.knit: 6 stitches'
err 'the bad one its error' 'name.knit:1:'

exits 4 'a file that is not there' "$WEFT" check "$work/none.knit"
err 'is named' "cannot read '.*none.knit': No such file"
exits 4 'a folder' "$WEFT" check "$work/."
err 'is not a script' "cannot read '.*': Is a directory"

exits 0 'standard input' sh -c '"$1" check - <"$2"' - "$WEFT" "$work/good.knit"
exits 3 'a bad standard input' sh -c '"$1" check - <"$2"' - "$WEFT" "$work/short.knit"

# Every line of --diagnostics json is an object by itself, or all are one value.
exits 3 'messages as JSON' "$WEFT" check --diagnostics json "$work/short.knit"
check 'are JSON' tests/cli/json "$work/err"

exits 3 'colour on request' "$WEFT" check --color always "$work/short.knit"
check 'has escapes' grep -q "$(printf '\033')" "$work/err"
exits 3 'no colour in a pipe' "$WEFT" check "$work/short.knit"
check 'has none' sh -c '! grep -q "$(printf "\033")" "$1"' - "$work/err"

finish
