#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Inputs that no sheet can have are refused by the language, before any iteration.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# refused WHAT BLOCK
refused() {
    printf 'swatch K\n%s\n' "$2" >"$work/x.knit"
    exits 3 "$1" "$WEFT" run "$work/x.knit" -o "$work/x.json"
    err "$1: has its place" 'x.knit:2:.*error'
    check "$1: nothing is written" test ! -e "$work/x.json"
}

refused 'no thickness' 'material { thickness = 0 }'
refused 'a negative thickness' 'material { thickness = -0.5 }'
refused 'a thickness that overflows' 'material { thickness = 1e999 }'
refused 'a huge thickness' 'material { thickness = 1e300 }'
refused 'a thickness that is no number' 'material { thickness = 0/0 }'
refused 'a thickness without end' 'material { thickness = 1/0 }'
refused 'Poisson -1' 'material { poisson = -1 }'
refused 'Poisson beyond a half' 'material { poisson = 0.51 }'
refused 'no stiffness' 'material { young = 0 }'
refused 'a stitch without width' 'gauge { width = 0 }'
refused 'a stitch too wide for the square of it' 'gauge { width = 1e200 }'
refused 'a negative spring' 'springs { stiffness = -1 }'
refused 'negative noise' 'solve { noise = -1 }'
refused 'endless noise' 'solve { noise = 1e308 * 10 }'
refused 'no steps' 'solve { steps = 0 }'
refused 'no tolerance' 'solve { tolerance = 0 }'
refused 'a curvature that overflows' 'stitch K { kx = 1e308 * 1e308 }'

finish
