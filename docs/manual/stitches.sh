#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# stitches.sh WEFT: the chapter on the stitch library, on standard output.
# stitches.sh WEFT FOLDER: a picture of the chart and of the fold of each
# motif into FOLDER; what stands there and is newer than WEFT stays.
set -eu
LC_ALL=C
export LC_ALL
weft=$1
folder=${2-}

names() { "$weft" list | sed '1d; s/[( ].*//'; }

# name(arguments): first line, other lines, multiple, blank, chart.
section() {
    "$weft" list "$1" | awk -v name="$1" '
        NR == 1 {
            head = $0
            sub(/: .*/, "", head)
            sub(/^[^:]*: /, "")
            print "## " name "\n\n" $0 (/[.!?]$/ ? "" : ".")
            next
        }
        /^multiple of / && !chart {
            sub(/, in std\/.*/, "")
            if (head != name) print "\nAs a script calls it: `" head "`."
            print "\nA " $0 ".\n\n```chart"
            chart = 1
            blank = 1
            next
        }
        blank && !NF { blank = 0; next }
        { print }
        END { print "```\n" }'
}

chapter() {
    cat <<'TEXT'
# The stitch library

These motifs are built in. In a script, `use NAME from std` takes one and `tile(NAME, columns, rows)` or `fill(NAME,
stitches, rows)` covers an area with it:

```knit
use basketweave from std
swatch fill(basketweave, 21, 16)
```

*Multiple of 8 + 5* means that it fits 13, 21, 29, ... stitches. Charts show the right side, the first row at the bottom: `k` is
knit and `p` purl as seen from there. Row numbers stand where the row begins. Words in brackets behind a name are arguments with
their defaults: `rib(k = 3, p = 1)`.

This chapter is made from the library itself, by `make stitches`. With `make docs` each motif has a drawn chart and a
picture of its fold.

TEXT
    for name in $(names); do
        section "$name"
    done
}

# About two dozen stitches each way, and one repeat at least.
script() {
    "$weft" list "$1" | awk -v name="$1" '
        /^multiple of / {
            gsub(/,/, "")
            of = $3; plus = $4 == "+" ? $5 : 0
            for (i = 4; i <= NF; i++) if ($i == "rows" || $i == "row") rows = $(i - 1)
            across = int(24 / of + 0.5); up = int(24 / rows + 0.5)
            print "use " name " from std"
            print "swatch tile(" name ", " (across < 1 ? 1 : across) ", " (up < 1 ? 1 : up) ")"
            print "solve { steps = 1; accuracy = 10% }"
            exit
        }'
}

pictures() {
    mkdir -p "$folder"
    for name in $(names); do
        script "$name" >"$folder/$name.knit"
        if [ ! "$folder/$name.png" -nt "$weft" ]; then
            echo "output \"$folder/$name-wide.png\" { width = 400 }" >>"$folder/$name.knit"
            "$weft" run -q --no-manifest "$folder/$name.knit" 2>/dev/null ||
                echo "docs: $name does not converge" >&2
            mv "$folder/$name-wide.png" "$folder/$name.png" || :
        fi
        rm -f "$folder/$name.knit"
        printf 'use %s from std\nswatch %s\n' "$name" "$name" >"$folder/chart.knit"
        "$weft" chart -q "$folder/chart.knit" -o "chart:$folder/$name.svg" 2>/dev/null || rm -f "$folder/$name.svg"
        rm -f "$folder/chart.knit"
    done
}

if [ -n "$folder" ]; then pictures; else chapter; fi
