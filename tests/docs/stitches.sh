#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The chapter on the stitch library is what `make stitches` makes of the library now.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
"$WEFT_SOURCE/docs/manual/stitches.sh" "$WEFT" >"$work/stitches.md"
check 'docs/stitches.md is current (make stitches)' diff "$WEFT_SOURCE/docs/stitches.md" "$work/stitches.md"
check 'and has all motifs' test "$(grep -c '^## ' "$work/stitches.md")" = "$(($("$WEFT" list | wc -l) - 1))"
finish
