#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of a fold, from outside: every format opens, and is the same again.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
cd "$work" || exit 1

rib_script >rib.knit
cat >>rib.knit <<'TEXT'
solve { steps = 1; accuracy = 5% }
output "a.png" { width = 200 }
output "a.svg" { view = (200, 20); color = bending; width = 200; chart = on }
output "a.pdf" { view = side; color = mean; palette = safe; width = 200; background = transparent }
TEXT
exits 0 'all formats are written' "$WEFT" -q rib.knit
same_again 'a.png a.svg a.pdf' "$WEFT" -q rib.knit
exits 0 'a picture asked for on the command line' "$WEFT" -q rib.knit -o picture:b.png
check 'is there' test -s b.png

opens a.pdf pdftoppm -r 20 -png a.pdf page
opens a.svg rsvg-convert a.svg -o svg.png
opens a.png pngtopnm a.png

finish
