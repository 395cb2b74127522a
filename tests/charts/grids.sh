# SPDX-License-Identifier: GPL-3.0-or-later
# For the tests of charts: grids to send around. Sourced behind tests/tap.sh.
# shellcheck shell=sh disable=SC2154

# Every motif of the library, twice across and three times up.
library_scripts() {
    "$WEFT" list | sed '1d;s/[ (].*//' | while read -r motif; do
        printf 'use %s from std\nswatch tile(%s, 2, 3)\n' "$motif" "$motif" >"$1/$motif.knit"
    done
}

# random_grids FOLDER COUNT: of many sizes; some of noise, some of rows and
# columns that repeat, some with a stitch out of order.
random_grids() {
    awk -v folder="$1" -v count="$2" '
        function below(n) { return int(n * rand()) }
        BEGIN {
            srand(7)
            for (n = 1; n <= count; n++) {
                columns = 1 + below(n % 3 ? 12 : 60)
                rows = 1 + below(n % 4 ? 9 : 40)
                across = n % 2 ? columns : 1 + below(columns)
                up = n % 5 ? 1 + below(rows) : rows
                for (y = 0; y < up; y++)
                    for (x = 0; x < across; x++)
                        cell[y, x] = below(2) ? "K" : "P"
                odd = n % 7 ? -1 : below(columns)
                file = folder "/" n ".txt"
                print "# 1 1" >file
                for (y = 0; y < rows; y++)
                    for (x = 0; x < columns; x++)
                        printf "%s%s", y == rows - 1 && x == odd ? "K" : cell[y % up, x % across],
                            x < columns - 1 ? " " : "\n" >file
                close(file)
            }
        }'
}

# all_back COUNT: the test's own `back FILE` holds for every motif of the library and so many random grids.
all_back() {
    mkdir "$work/random" "$work/library"
    library_scripts "$work/library"
    for file in "$work"/library/*.knit; do
        check "$(basename "$file" .knit)" back "$file"
    done
    random_grids "$work/random" "$1"
    bad=0
    for file in "$work"/random/*.txt; do
        "$WEFT" import "$file" >"$work/y.knit"
        back "$work/y.knit" || bad=$((bad + 1))
    done
    check 'random grids come back' test "$bad" = 0
}

# refused NAME FILE: a file of $work is not imported; the messages are standard input.
refused() {
    cat >"$work/wanted.err"
    exits 3 "$1" sh -c 'cd "$2" && "$1" import "$3"' - "$WEFT" "$work" "$2"
    check 'is shown' diff "$work/wanted.err" "$work/err"
    empty 'nothing comes out' "$work/out"
}

# A motif that equals none of its images.
cat >"$work/flag.txt" <<'TEXT'
# 1 1
K P P P
K K P P
K K K P
TEXT
